"""Quick estimates of overturning by formulas, to stand beside a simulation.

All are for a uniform rectangle of width B (along the shaking) and height H that does not slide, without
walls or devices: of a body they take these two sizes alone, neither its mass nor its centre of gravity. Units
are SI; the sources' centimetres are converted.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from stayput.errors import finite, instance_of, not_allowed, within
from stayput.model.body import Body
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY

LOSS_MODEL_RATIO = 0.79
"""Median velocities of unanchored furniture in FEMA P-58's fragility library over Kaneko and Hayashi's.

The library's notes call them "calculated as a function of the aspect ratio"; over its nine sizes the ratio is
this, within 6 %. So they are a formula with a margin, not observations.
"""

SCATTER = 0.5
"""ζ of Kaneko and Hayashi: standard deviation of ln A at overturning, for the scatter of records, furniture
and contact together (common knowledge, not re-checked)."""


def _ratio(body: Body, gravity: float = STANDARD_GRAVITY) -> float:
    """Return B/H, after checks of both arguments."""
    instance_of("body", body, Body)
    GRAVITY.check(gravity)
    return body.width / body.height


def rocking_acceleration(body: Body, gravity: float = STANDARD_GRAVITY) -> float:
    """Return the floor's acceleration a₀ = (B/H) g at which rocking starts [m/s²].

    Statics, attributed to West (Milne 1885). A body whose friction is below B/H slides instead.

    Parameters
    ----------
    body : Body
        What stands.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A gravity out of range.

    Examples
    --------
    >>> from stayput import Body
    >>> round(rocking_acceleration(Body(0.4, 1.8, mass=100.0)), 3)
    2.179
    """
    return _ratio(body, gravity) * gravity


def ishiyama_velocity(body: Body, gravity: float = STANDARD_GRAVITY) -> float:
    """Return the floor's velocity v₀ = 0.4 √(8gR(1 − cos α) / (3 cos²α)) needed to overturn [m/s].

    With R half the diagonal and tan α = B/H (Ishiyama 1982). Overturning needs both this velocity and
    `rocking_acceleration`; each is a lower limit, from many simulations of sines and records. For a slender
    body it is nearly 10 B/√H in centimetres, which is B/√H in metres.

    Parameters
    ----------
    body : Body
        What stands.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A gravity out of range.

    Examples
    --------
    >>> from stayput import Body
    >>> round(ishiyama_velocity(Body(0.4, 1.8, mass=100.0)), 3)
    0.31
    """
    alpha = math.atan(_ratio(body, gravity))
    r = 0.5 * math.hypot(body.width, body.height)
    # 1 − cos α, without the loss of digits
    raised = 2.0 * math.sin(0.5 * alpha) ** 2
    return 0.4 * math.sqrt(8.0 * gravity * r * raised / (3.0 * math.cos(alpha) ** 2))


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

    Examples
    --------
    >>> import stayput as sp
    >>> found = sp.kaneko_hayashi(sp.Body(0.4, 1.8, mass=100.0), pga=2.0, pgv=0.6)
    >>> found.equivalent_frequency < found.branch_frequency  # the acceleration counts
    True
    """

    ratio: float
    median: float
    equivalent_frequency: float
    branch_frequency: float


def kaneko_hayashi_branch(body: Body) -> float:
    """Return the frequency Fb = (1.56/√H)(1 + B/H)^−1.5 at which the two branches meet [Hz].

    Parameters
    ----------
    body : Body
        What stands.

    References
    ----------
    Kaneko and Hayashi (2004), see `kaneko_hayashi`.

    Examples
    --------
    >>> import stayput as sp
    >>> round(sp.kaneko_hayashi_branch(sp.Body(0.4, 1.8, mass=100.0)), 2)
    0.86
    """
    ratio = _ratio(body)
    return 1.56 / math.sqrt(body.height) * (1.0 + ratio) ** -1.5


def kaneko_hayashi_median(body: Body, frequency: float, gravity: float = STANDARD_GRAVITY) -> float:
    """Return the peak acceleration A₅₀ at which half of such pieces overturn [m/s²].

    A₅₀ = g (B/H)(1 + B/H) up to Fb, and 2π Fe (B/√H)(1 + B/H)^2.5 above it (Kaneko and Hayashi 2004, see
    `kaneko_hayashi`). Above Fb it is a limit on the velocity alone.

    Parameters
    ----------
    body : Body
        What stands.
    frequency : float
        Equivalent frequency Fe of the floor's motion [Hz].
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A frequency out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> bookcase = sp.Body(0.4, 1.8, mass=100.0)
    >>> [round(sp.kaneko_hayashi_median(bookcase, frequency), 2) for frequency in (0.5, 2.0)]
    [2.66, 6.19]
    """
    ratio = _ratio(body, gravity)
    fe = within("model.equivalent_frequency", frequency, 0.0, 1000.0, "Hz")
    if fe <= kaneko_hayashi_branch(body):
        return gravity * ratio * (1.0 + ratio)
    return 2.0 * math.pi * fe * kaneko_hayashi_velocity(body)


def kaneko_hayashi_velocity(body: Body) -> float:
    """Return the peak velocity V₅₀ = (B/√H)(1 + B/H)^2.5 at which half of such pieces overturn [m/s].

    The branch above Fb of `kaneko_hayashi_median`, where the velocity alone counts.

    Parameters
    ----------
    body : Body
        What stands.

    References
    ----------
    Kaneko and Hayashi (2004), see `kaneko_hayashi`.

    Examples
    --------
    >>> import stayput as sp
    >>> round(sp.kaneko_hayashi_velocity(sp.Body(0.4, 1.8, mass=100.0)), 3)
    0.492
    """
    ratio = _ratio(body)
    return body.width / math.sqrt(body.height) * (1.0 + ratio) ** 2.5


def kaneko_hayashi(
    body: Body, pga: float, pgv: float, gravity: float = STANDARD_GRAVITY, *, scatter: float = SCATTER
) -> OverturningRatio:
    """Return the overturning ratio R = Φ[(ln A − ln A₅₀)/ζ] of Kaneko and Hayashi.

    A suite of like motions and one piece of furniture scatter less than ζ: compare medians, not ζ.

    Parameters
    ----------
    body : Body
        What stands.
    pga, pgv : float
        Peak acceleration A [m/s²] and velocity V [m/s] of the floor, larger than 0.
    gravity : float
        g [m/s²].
    scatter : float
        ζ.

    Raises
    ------
    InputError
        A peak or ζ out of range.

    References
    ----------
    Kaneko, M. and Hayashi, Y. (2004). A proposal for simple equations to express a relation between
    overturning ratios of rigid bodies and input excitations. 13th World Conference on Earthquake Engineering.
    The coefficients are common knowledge and were not re-checked against the paper.

    Examples
    --------
    >>> import stayput as sp
    >>> found = sp.kaneko_hayashi(sp.Body(0.4, 1.8, mass=100.0), pga=8.0, pgv=0.6)
    >>> print(f"{found.ratio:.0%} overturn; half do at {found.median:.1f} m/s²")
    65% overturn; half do at 6.6 m/s²
    """
    a, v, zeta = (finite(name, value) for name, value in (("PGA", pga), ("PGV", pgv), ("ζ", scatter)))
    for name, value, unit in (("PGA", a, " m/s²"), ("PGV", v, " m/s"), ("ζ", zeta, "")):
        if not value > 0.0:
            raise not_allowed(name, f"{value:g}{unit}", "common.above_zero")
    fe = a / (2.0 * math.pi * v)
    median = kaneko_hayashi_median(body, fe, gravity)
    ratio = 0.5 * math.erfc(-math.log(a / median) / (zeta * math.sqrt(2.0)))
    return OverturningRatio(ratio, median, fe, kaneko_hayashi_branch(body))
