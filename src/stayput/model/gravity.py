"""The acceleration of gravity."""

from stayput.model.parameters import Parameter

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s²]: one "g" of a record, and the default of a simulation."""

GRAVITY = Parameter("gravity", STANDARD_GRAVITY, "m/s²", 0.01, 1e3, ("Gravity", "重力加速度"))
"""Acceleration of gravity where a function asks for it."""
