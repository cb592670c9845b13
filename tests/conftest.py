"""One profile for all property tests: no time limits, the same examples in every run."""

from hypothesis import settings

settings.register_profile("house", deadline=None, derandomize=True, max_examples=25)
settings.load_profile("house")
