"""Butcher tableau of the Dormand–Prince method of order 5(4) (1980), with its embedded error weights."""

from __future__ import annotations

import numpy as np

STAGES = 7

TIMES = np.array([0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0])

RATES = np.zeros((STAGES, STAGES))
"""Weights of the stage accelerations in the rates (the a_ij; its last row is also the solution's)."""

RATES[1, :1] = 1 / 5
RATES[2, :2] = 3 / 40, 9 / 40
RATES[3, :3] = 44 / 45, -56 / 15, 32 / 9
RATES[4, :4] = 19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729
RATES[5, :5] = 9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656
RATES[6, :6] = 35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84

POSITIONS = RATES @ RATES
"""Weights of the stage accelerations in the positions: the method applied to the rates."""

RATES_ERROR = np.array([71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])
POSITIONS_ERROR = RATES_ERROR @ RATES
