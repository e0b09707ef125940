"""Quick estimates of overturning by formulas, to stand beside a simulation.

All are for a uniform rectangle of width B (along the shaking) and height H that does not slide, without
walls or devices. Units are SI; the sources' centimetres are converted.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from stayput.errors import InputError, finite, within
from stayput.model.gravity import GRAVITY, STANDARD_GRAVITY

LOSS_MODEL_RATIO = 0.79
"""Median velocities of unanchored furniture in FEMA P-58's fragility library over Kaneko and Hayashi's.

The library's notes call them "calculated as a function of the aspect ratio"; over its nine sizes the ratio is
this, within 6 %. So they are a formula with a margin, not observations.
"""

SCATTER = 0.5
"""ζ of Kaneko and Hayashi: standard deviation of ln A at overturning, for the scatter of records, furniture
and contact together (common knowledge, not re-checked)."""


def _ratio(width: float, height: float, gravity: float = STANDARD_GRAVITY) -> float:
    """Return B/H, after checks of both and of g."""
    GRAVITY.check(gravity)
    within("model.estimate_width", width, 0.01, 100.0, "m")
    within("model.estimate_height", height, 0.01, 100.0, "m")
    return width / height


def rocking_acceleration(width: float, height: float, gravity: float = STANDARD_GRAVITY) -> float:
    """Return the floor's acceleration a₀ = (B/H) g at which rocking starts [m/s²].

    Statics, attributed to West (Milne 1885). A body whose friction is below B/H slides instead.

    Parameters
    ----------
    width, height : float
        B and H [m].
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A size or a gravity out of range.

    Examples
    --------
    >>> round(rocking_acceleration(0.4, 1.8), 3)
    2.179
    """
    return _ratio(width, height, gravity) * gravity


def ishiyama_velocity(width: float, height: float, gravity: float = STANDARD_GRAVITY) -> float:
    """Return the floor's velocity v₀ = 0.4 √(8gR(1 − cos α) / (3 cos²α)) needed to overturn [m/s].

    With R half the diagonal and tan α = B/H (Ishiyama 1982). Overturning needs both this velocity and
    `rocking_acceleration`; each is a lower limit, from many simulations of sines and records. For a slender
    body it is nearly 10 B/√H in centimetres, which is B/√H in metres.

    Parameters
    ----------
    width, height : float
        B and H [m].
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A size or a gravity out of range.

    Examples
    --------
    >>> round(ishiyama_velocity(0.4, 1.8), 3)
    0.31
    """
    alpha = math.atan(_ratio(width, height, gravity))
    r = 0.5 * math.hypot(width, height)
    # 1 − cos α, without the loss of digits
    raised = 2.0 * math.sin(0.5 * alpha) ** 2
    return 0.4 * math.sqrt(8.0 * gravity * r * raised / (3.0 * math.cos(alpha) ** 2))


def ishiyama_overturns(
    width: float, height: float, pga: float, pgv: float, gravity: float = STANDARD_GRAVITY
) -> bool:
    """Return whether overturning is possible: both peaks reach Ishiyama's limits.

    Parameters
    ----------
    width, height : float
        B and H [m].
    pga, pgv : float
        Peak acceleration [m/s²] and velocity [m/s] of the floor.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A size or a peak out of range.
    """
    within("model.peak_acceleration", pga, 0.0, math.inf, "m/s²")
    within("model.peak_velocity", pgv, 0.0, math.inf, "m/s")
    return pga >= rocking_acceleration(width, height, gravity) and pgv >= ishiyama_velocity(
        width, height, gravity
    )


@dataclass(frozen=True, slots=True)
class OverturningRatio:
    """What the formula of Kaneko and Hayashi says.

    Parameters
    ----------
    ratio : float
        Share R of pieces that overturn.
    median : float
        Peak floor acceleration A₅₀ at which half overturn, for this motion's ratio of peaks [m/s²].
    equivalent_frequency : float
        Fe = A/(2πV) of the motion [Hz].
    branch_frequency : float
        Fb from which on the velocity counts, not the acceleration [Hz].
    """

    ratio: float
    median: float
    equivalent_frequency: float
    branch_frequency: float


def kaneko_hayashi_branch(width: float, height: float) -> float:
    """Return the frequency Fb = (1.56/√H)(1 + B/H)^−1.5 at which the two branches meet [Hz].

    Raises
    ------
    InputError
        A size or a gravity out of range.
    """
    ratio = _ratio(width, height)
    return 1.56 / math.sqrt(height) * (1.0 + ratio) ** -1.5


def kaneko_hayashi_median(
    width: float, height: float, frequency: float, gravity: float = STANDARD_GRAVITY
) -> float:
    """Return the peak acceleration A₅₀ at which half of such pieces overturn [m/s²].

    A₅₀ = g (B/H)(1 + B/H) up to Fb, and 2π Fe (B/√H)(1 + B/H)^2.5 above it (Kaneko and Hayashi 2004;
    coefficients common knowledge, not re-checked). Above Fb it is a limit on the velocity alone.

    Parameters
    ----------
    width, height : float
        B and H [m].
    frequency : float
        Equivalent frequency Fe of the floor's motion [Hz].
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A size or a frequency out of range.

    Examples
    --------
    >>> round(kaneko_hayashi_median(0.4, 1.8, 0.5), 2), round(kaneko_hayashi_median(0.4, 1.8, 2.0), 2)
    (2.66, 6.19)
    """
    ratio = _ratio(width, height, gravity)
    fe = within("model.equivalent_frequency", frequency, 0.0, 1000.0, "Hz")
    if fe <= kaneko_hayashi_branch(width, height):
        return gravity * ratio * (1.0 + ratio)
    return 2.0 * math.pi * fe * kaneko_hayashi_velocity(width, height)


def kaneko_hayashi_velocity(width: float, height: float) -> float:
    """Return the peak velocity V₅₀ = (B/√H)(1 + B/H)^2.5 at which half of such pieces overturn [m/s].

    The branch above Fb of `kaneko_hayashi_median`, where the velocity alone counts.

    Parameters
    ----------
    width, height : float
        B and H [m].

    Raises
    ------
    InputError
        A size or a gravity out of range.

    Examples
    --------
    >>> round(kaneko_hayashi_velocity(0.4, 1.8), 3)
    0.492
    """
    ratio = _ratio(width, height)
    return width / math.sqrt(height) * (1.0 + ratio) ** 2.5


def kaneko_hayashi(
    width: float,
    height: float,
    pga: float,
    pgv: float,
    gravity: float = STANDARD_GRAVITY,
    *,
    scatter: float = SCATTER,
) -> OverturningRatio:
    """Return the overturning ratio R = Φ[(ln A − ln A₅₀)/ζ] of Kaneko and Hayashi.

    A suite of like motions and one piece of furniture scatter less than ζ: compare medians, not ζ.

    Parameters
    ----------
    width, height : float
        B and H [m].
    pga, pgv : float
        Peak acceleration A [m/s²] and velocity V [m/s] of the floor, larger than 0.
    gravity : float
        g [m/s²].
    scatter : float
        ζ.

    Raises
    ------
    InputError
        A size, a peak or ζ out of range.
    """
    a, v, zeta = (finite(name, value) for name, value in (("PGA", pga), ("PGV", pgv), ("ζ", scatter)))
    for name, value, unit in (("PGA", a, " m/s²"), ("PGV", v, " m/s"), ("ζ", zeta, "")):
        if not value > 0.0:
            raise InputError("model.not_positive", name=name, value=value, unit=unit)
    fe = a / (2.0 * math.pi * v)
    median = kaneko_hayashi_median(width, height, fe, gravity)
    ratio = 0.5 * math.erfc(-math.log(a / median) / (zeta * math.sqrt(2.0)))
    return OverturningRatio(ratio, median, fe, kaneko_hayashi_branch(width, height))
