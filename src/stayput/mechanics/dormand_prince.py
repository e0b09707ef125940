"""The method of Dormand and Prince, of order 5(4) (1980): its times and weights.

A stage is at the state that the rates of those before it give; the last one is at the end of the step, and is
the first of the next.
"""

import numpy as np

STAGES = 7

TIMES = np.array([0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0])
"""When in a step the stages are, over its length (the c_i)."""

RATES = np.zeros((STAGES, STAGES))
"""Weights of the stages' rates in the state of each (the a_ij; the last row is also the solution's)."""

RATES[1, :1] = 1 / 5
RATES[2, :2] = 3 / 40, 9 / 40
RATES[3, :3] = 44 / 45, -56 / 15, 32 / 9
RATES[4, :4] = 19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729
RATES[5, :5] = 9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656
RATES[6, :6] = 35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84

ERROR = np.array([71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])
"""Weights of the rates in the difference from the solution of fourth order."""
