# Every target sets up what it needs: Python 3.11 or later, make and git are enough.

PYTHON ?= python3
VENV   ?= .venv
JOBS   ?= 2
# The scripts of the pages come by npm, and are tested in node: from PyPI where there is none.
EXTRAS := book,test,browser$(shell command -v npm >/dev/null || echo ,web)

BIN    := $(VENV)/bin
READY  := $(VENV)/.ready
BOOK   := $(BIN)/jupyter-book build -W -n --keep-going .
PYTEST := $(BIN)/python -m pytest

# Two notebooks run side by side: one thread each is faster than two that compete.
export OMP_NUM_THREADS      ?= 1
export OPENBLAS_NUM_THREADS ?= 1
export MKL_NUM_THREADS      ?= 1
export PIP_DISABLE_PIP_VERSION_CHECK := 1

.NOTPARALLEL:
.PHONY: help book test style unit notebooks-tested strict-book browser-tested notebooks lock clean

help:
	@echo "make book       build the book; prints where to open it"
	@echo "make test       run everything: style, tests, doctests, notebooks, strict book, browser"
	@echo "make browser-tested  the last of these alone (needs Chromium and the built book)"
	@echo "make notebooks  execute all notebooks and store their outputs in normal form"
	@echo "make lock       renew requirements.lock with the newest versions that fit"
	@echo "make clean      delete what the other targets made"
	@echo
	@echo "PYTHON=python3.12 chooses the interpreter, JOBS=4 the number of test processes."

# --- set-up -----------------------------------------------------------------------------------

$(READY): requirements.lock pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	{ echo "Python 3.11 or later is needed: try make PYTHON=python3.12"; exit 1; }
	@echo "==> installing the package and its tools into $(VENV)"
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install -c requirements.lock -e ".[$(EXTRAS)]"
	@touch $@

# --- the book ---------------------------------------------------------------------------------

# A build that failed must not leave half of itself: the next one would not see the warnings.
book: $(READY)
	@echo "==> building the book (the first time, every notebook is executed)"
	@$(BOOK) || { rm -rf _build/.doctrees; exit 1; }
	@echo
	@echo "The book is built. Open it in a browser:"
	@echo "    file://$(CURDIR)/_build/html/index.html"
	@echo "or serve it:"
	@echo "    $(BIN)/python -m http.server --directory _build/html"

# --- the tests --------------------------------------------------------------------------------

test: style unit notebooks-tested strict-book browser-tested
	@echo "==> all tests passed"

style: $(READY)
	@echo "==> 1/5 style, imports, form of the notebooks"
	$(BIN)/ruff check .
	$(BIN)/lint-imports
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
	$(PYTEST) -n $(JOBS) --dist loadfile tests/browser

notebooks: $(READY)
	$(BIN)/python tools/normalise_notebooks.py

# --- housekeeping -----------------------------------------------------------------------------

lock:
	$(PYTHON) -m venv _build/lock
	_build/lock/bin/python -m pip install --quiet uv
	{ sed -n '/^#/p' requirements.lock && _build/lock/bin/uv pip compile pyproject.toml --quiet \
	--upgrade --all-extras --universal --python-version 3.11 --fork-strategy fewest \
	--no-annotate --no-header --no-emit-index-url; } > _build/lock/requirements.lock
	mv _build/lock/requirements.lock requirements.lock

clean:
	rm -rf $(VENV) _build build *.egg-info .pytest_cache .ruff_cache .import_linter_cache .hypothesis
	find ftseries book tests tools -name __pycache__ -type d -prune -exec rm -rf {} +
