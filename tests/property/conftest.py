"""Profiles of the property tests: quick and repeatable, or by HYPOTHESIS_PROFILE=thorough or soak."""

from __future__ import annotations

import os

from hypothesis import HealthCheck, settings

PATIENT = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.filter_too_much]

settings.register_profile(
    "quick", deadline=None, derandomize=True, max_examples=20, suppress_health_check=PATIENT, database=None
)
settings.register_profile("thorough", deadline=None, max_examples=400, suppress_health_check=PATIENT)
settings.register_profile(  # of `make soak`: other examples in each round
    "soak", deadline=None, max_examples=500, suppress_health_check=PATIENT, print_blob=True
)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "quick"))
