"""One profile for all property tests: no time limits, the same examples in every run."""

from hypothesis import HealthCheck, settings

settings.register_profile("house", deadline=None, derandomize=True, max_examples=15,
                          # the rings that fixtures give have no state that an example could change
                          suppress_health_check=[HealthCheck.function_scoped_fixture,
                                                 HealthCheck.too_slow])
settings.load_profile("house")
