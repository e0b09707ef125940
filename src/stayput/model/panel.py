"""A wall that gives: the restitution of a rigid wall that returns as much of the speed.

A piece that turns about the far base edge meets the wall, at height h, with the effective mass
m = J_O/h². The wall is a panel that swings in its first mode: a mass M on a spring with the damping ratio ζ.
Where they meet dead, or bounce by no more than gypsum board lets them, they soon move together, at m/(m + M)
of the speed, and part where nothing presses any more. Together they are damped by ζ' = ζ √(M/(m + M)), so
that the wall returns

    e_w = m/(m + M) · exp(−ζ' φ/√(1 − ζ'²)),    φ = π − atan2(2ζ' √(1 − ζ'²), 1 − 2ζ'²)

of the speed, whatever its stiffness. A heavy wall returns what the crushing of its surface leaves, 0.2 to
0.4 of gypsum board, of which this says nothing.

Derived here; `tests/validation/test_panel.py` sets it beside two masses stepped in time.
"""

from __future__ import annotations

import math

from stayput.errors import within


def panel_restitution(effective: float, panel: float, damping: float) -> float:
    """Return e_w, the part of its speed that a panel returns to what hits it.

    Parameters
    ----------
    effective : float
        m, of the piece at the height of the impact [kg].
    panel : float
        M, of the panel's first mode at the place of the impact [kg].
    damping : float
        ζ, 0 to 0.99.

    Raises
    ------
    InputError
        A mass that is not above 0, or a damping out of range.

    Examples
    --------
    >>> round(panel_restitution(36.0, 45.0, 0.05), 2)
    0.4
    """
    m = within("model.effective_mass", effective, 1e-3, 1e6, "kg")
    together = m + within("model.panel_mass", panel, 1e-3, 1e6, "kg")
    zeta = within("model.panel_damping", damping, 0.0, 0.99) * math.sqrt(panel / together)
    root = math.sqrt(1.0 - zeta * zeta)
    phase = math.pi - math.atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta)
    return m / together * math.exp(-zeta * phase / root)
