# Every target sets up what it needs: Python 3.11 or later, make and git are enough.

PYTHON ?= python3
VENV   ?= .venv
JOBS   ?= 2
# The scripts of the pages come by npm, and are tested in node: from PyPI where there is none.
EXTRAS := book,test,browser$(shell command -v npm >/dev/null || echo ,web)

# Empty, the newest versions are installed instead of the locked ones.
LOCKED ?= -c requirements.lock

BIN    := $(VENV)/$(if $(filter Windows_NT,$(OS)),Scripts,bin)
READY  := $(VENV)/.ready
BOOK   := $(BIN)/jupyter-book build -W -n --keep-going .
FAILED := echo "The build stopped. Above, WARNING or ERROR names the page and the cause."; exit 1
PYTEST := $(BIN)/python -m pytest

# Two notebooks run side by side: one thread each is faster than two that compete.
export OMP_NUM_THREADS      ?= 1
export OPENBLAS_NUM_THREADS ?= 1
export MKL_NUM_THREADS      ?= 1
export PIP_DISABLE_PIP_VERSION_CHECK := 1

.NOTPARALLEL:
.PHONY: help book lab test style unit notebooks-tested strict-book browser-tested notebooks lock clean
.PHONY: coverage fuzz mutants certificates random oldest bench bench-book calibration stated-errors refined
.PHONY: slides student pdf figures site debian-latex linkcheck lint-workflows newest dist

help:
	@echo "make book       build the book; prints where to open it"
	@echo "make lab        open the notebooks in JupyterLab"
	@echo "make test       run everything: style, tests, doctests, notebooks, strict book, browser"
	@echo "make browser-tested  the last of these alone (needs Chromium and the built book)"
	@echo
	@echo "make slides     each chapter as slides; prints where to open them"
	@echo "make student    the book without solutions, in _build/student"
	@echo "make pdf        the book on paper (needs LaTeX)"
	@echo "make figures    every figure as SVG and PNG"
	@echo "make site       all that is published: pages, slides, PDF, figures"
	@echo
	@echo "make notebooks  execute all notebooks and store their outputs in normal form"
	@echo "make coverage   refuse if there is a line of the core that no test runs"
	@echo "make fuzz       10,000 texts from a grammar, altered files: right or refused, in time"
	@echo "make mutants    change copies of the core in many places; the tests should notice"
	@echo "make random     N=2000 random problems against independent truth, as a table"
	@echo "make certificates  alter certificates in thousands of ways; none may state what is not true"
	@echo "make oldest     the tests with the oldest versions that pyproject.toml allows"
	@echo "make bench      measure this package and its peers, and renew the chapter on it"
	@echo "make bench-book measure the builds and the tests of the book"
	@echo "make calibration  how often evaluate is wrong in silence, and warns in vain: a table"
	@echo "make stated-errors  true errors over those that series, sums and radii state: a table"
	@echo "make refined    random problems refined, and their families followed by other code"
	@echo "make lock       renew requirements.lock with the newest versions that fit"
	@echo "make newest     make test with the newest versions of everything"
	@echo "make linkcheck  ask every link of the book whether it still leads somewhere"
	@echo "make lint-workflows  check the workflows of GitHub (needs npm)"
	@echo "make dist       the package as it goes to PyPI"
	@echo "make clean      delete what the other targets made, $(VENV) and _build among it"
	@echo
	@echo "PYTHON=python3.12 chooses the interpreter, JOBS=4 the number of test processes."

# --- set-up -----------------------------------------------------------------------------------

$(READY): requirements.lock pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	{ echo "Python 3.11 or later is needed: try make PYTHON=python3.12"; exit 1; }
	@echo "==> installing the package and its tools into $(VENV): about 1 GB, some minutes"
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet $(LOCKED) -e ".[$(EXTRAS)]"
	@touch $@

# --- the book ---------------------------------------------------------------------------------

# A build that failed must not leave half of itself: the next one would not see the warnings.
book: $(READY)
	@echo "==> building the book (the first time every notebook is executed: some minutes)"
	@$(BOOK) || { rm -rf _build/.doctrees; $(FAILED); }
	@echo
	@echo "The book is built. Open it in a browser:"
	@echo "    file://$(CURDIR)/_build/html/index.html"
	@echo "or serve it:"
	@echo "    $(BIN)/python -m http.server --directory _build/html"

lab: $(READY)
	$(BIN)/jupyter lab book

# The decks are cut from the pages, in the same build.
slides: book
	@echo
	@echo "The slides (S speaker's view, F full screen, O overview, D light or dark, ? more keys):"
	@for deck in _build/html/book/*-slides.html; do echo "    file://$(CURDIR)/$$deck"; done

# A book of its own, executed without the solutions: it must not need them.
student: $(READY)
	@echo "==> the book without solutions"
	$(BIN)/python tools/student_book.py
	cd _build/student && FTSERIES_REPOSITORY= $(abspath $(BIN))/jupyter-book build -W -n --keep-going .
	@echo "Notebooks for the class: _build/student/book, pages: _build/student/_build/html"

pdf: $(READY)
	@command -v latexmk xelatex >/dev/null || \
	{ echo "make pdf needs LaTeX; on Debian: apt install $(LATEX)"; exit 1; }
	@echo "==> the book on paper"
	@$(BOOK) --builder latex || { rm -rf _build/.doctrees; $(FAILED); }
	cd _build/latex && latexmk -xelatex -interaction=nonstopmode -halt-on-error -quiet \
	fourier-taylor-series.tex
	@! grep "^Missing character" _build/latex/fourier-taylor-series.log
	@echo "The book is in _build/latex/fourier-taylor-series.pdf"

LATEX := latexmk texlive-latex-recommended texlive-latex-extra texlive-fonts-recommended \
	texlive-xetex fonts-freefont-otf fonts-dejavu-core

debian-latex:
	sudo apt-get update && sudo apt-get install -y --no-install-recommends $(LATEX)

figures: $(READY)
	@echo "==> every figure as SVG and PNG"
	$(BIN)/python tools/draw_figures.py

# The pages link what is in _build/download.
site: pdf figures
	rm -rf _build/download && mkdir _build/download
	cp _build/latex/fourier-taylor-series.pdf _build/download
	$(BIN)/python -m zipfile -c _build/download/figures.zip _build/figures
	$(MAKE) book

# --- the tests --------------------------------------------------------------------------------

test: style unit notebooks-tested strict-book browser-tested
	@echo "==> all tests passed"

style: $(READY)
	@echo "==> 1/5 style, imports, form of the notebooks"
	$(BIN)/ruff check .
	$(BIN)/lint-imports
	$(BIN)/mypy
	$(BIN)/python tools/normalise_notebooks.py --check

unit: $(READY)
	@echo "==> 2/5 unit tests and doctests"
	$(PYTEST) -n $(JOBS) --dist loadfile tests ftseries --ignore=tests/browser

notebooks-tested: $(READY)
	@echo "==> 3/5 every notebook, executed and compared with its stored outputs"
	$(PYTEST) -n $(JOBS) --dist loadfile book

strict-book: $(READY)
	@echo "==> 4/5 the book from nothing, warnings are errors"
	rm -rf _build/html _build/.doctrees _build/.jupyter_cache _build/jupyter_execute
	$(BOOK)

browser-tested: $(READY)
	@echo "==> 5/5 every page of the built book in a browser without a network"
	$(PYTEST) -n $(JOBS) --dist worksteal tests/browser

notebooks: $(READY)
	$(BIN)/python tools/normalise_notebooks.py

linkcheck: $(READY)
	$(BIN)/jupyter-book build --builder linkcheck .

lint-workflows: $(READY)
	$(BIN)/python tools/lint_workflows.py

newest:
	$(MAKE) test VENV=_build/newest LOCKED=

# --- how well tested, how fast ----------------------------------------------------------------

CORE := $(wildcard ftseries/*.py)

coverage: $(READY)
	$(PYTEST) -n $(JOBS) --dist loadfile --cov --cov-report= --doctest-modules \
	tests/test_*.py tests/problems tests/analysis $(CORE)
	$(BIN)/python -m coverage report --include="ftseries/*.py" --omit="ftseries/*/*" \
	--fail-under=100

fuzz: $(READY)
	FTSERIES_FUZZ=$(or $(TRIES),10000) $(PYTEST) -s tests/test_fuzz.py tests/test_fuzz_files.py

mutants: $(READY)
	$(BIN)/python -m pip install $(LOCKED) -e ".[mutants]"
	$(BIN)/mutmut run --max-children $(JOBS)
	$(BIN)/mutmut results

N ?= 2000
random: $(READY)
	PYTHONPATH=tests $(BIN)/python -m random_problems $(N)

certificates: $(READY)
	$(BIN)/python tests/certify/mutants.py

oldest:
	$(PYTHON) -m venv _build/oldest
	_build/oldest/bin/python -m pip install --quiet uv
	_build/oldest/bin/uv pip compile pyproject.toml --quiet --resolution lowest-direct \
	--no-emit-index-url --output-file _build/oldest/requirements.txt
	_build/oldest/bin/uv pip install --quiet --python _build/oldest/bin/python \
	--constraint _build/oldest/requirements.txt -e ".[test]"
	_build/oldest/bin/python -m pytest -n $(JOBS) --dist loadfile \
	tests/test_*.py tests/problems tests/analysis

bench: $(READY)
	$(BIN)/python -m pip install $(LOCKED) -e ".[bench]"
	$(PYTEST) -c benchmarks/pytest.ini benchmarks --benchmark-json=benchmarks/results.json
	$(BIN)/python tools/normalise_notebooks.py book/how_fast.ipynb

bench-book: $(READY)
	PYTHONPATH=tests $(BIN)/python benchmarks/book.py

calibration: $(READY)
	PYTHONPATH=tests $(BIN)/python benchmarks/calibration.py

stated-errors: $(READY)
	PYTHONPATH=tests $(BIN)/python benchmarks/stated_errors.py

refined: $(READY)
	$(BIN)/python benchmarks/refined.py $(or $(TRIES),200)

# --- housekeeping -----------------------------------------------------------------------------

lock:
	$(PYTHON) -m venv _build/lock
	_build/lock/bin/python -m pip install --quiet uv
	{ sed -n '/^#/p' requirements.lock && _build/lock/bin/uv pip compile pyproject.toml --quiet \
	--upgrade --all-extras --universal --python-version 3.11 --fork-strategy fewest \
	--no-annotate --no-header --no-emit-index-url; } > _build/lock/requirements.lock
	mv _build/lock/requirements.lock requirements.lock

# TAG, if given, must be that of the version.
dist: $(READY)
	@version=v$$($(BIN)/python -c 'import importlib.metadata as m; print(m.version("ftseries"))'); \
	test "$${TAG:-$$version}" = "$$version" || { echo "$$TAG is not $$version"; exit 1; }
	rm -rf dist
	$(BIN)/python -m pip install $(LOCKED) build
	$(BIN)/python -m build

clean:
	rm -rf $(VENV) _build build dist *.egg-info .pytest_cache .ruff_cache .import_linter_cache .hypothesis \
	.mypy_cache .coverage mutants
	find ftseries book tests tools -name __pycache__ -type d -prune -exec rm -rf {} +
