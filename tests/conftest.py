"""Profiles of all property tests: no time limits, the same examples in every run.

With FTSERIES_FUZZ=1 in the environment there are a thousand examples, others in every run.
"""

import os

from hypothesis import HealthCheck, settings

settings.register_profile("house", deadline=None, derandomize=True, max_examples=15,
                          # the rings that fixtures give have no state that an example could change
                          suppress_health_check=[HealthCheck.function_scoped_fixture,
                                                 HealthCheck.too_slow])
settings.register_profile("fuzz", settings.get_profile("house"), derandomize=False,
                          max_examples=1000)
settings.load_profile("fuzz" if os.environ.get("FTSERIES_FUZZ") else "house")
