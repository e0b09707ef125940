"""Quick estimates by formulas, to stand beside a simulation: overturning by shaking, everyday tip-over.

Those of overturning are for a uniform rectangle of width B (along the shaking) and height H that does not
slide, without walls or devices: of a body they take these two sizes alone, neither its mass nor its centre of
gravity. Units are SI; the sources' centimetres are converted.

Tip-over is by moments about the front edge of the base, at rest; the front is on the right, as for
`Room.right_wall`. The cases are like those of the US stability rule for clothing storage units (16 CFR 1261,
ASTM F2057-23): all drawers open and loaded, 60 lb on an open one, a pull, carpet that tilts the piece. It is
no test by that rule and no certificate: but for the 60 lb its numbers are common knowledge, not re-checked.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from stayput.errors import finite, instance_of, not_allowed, within
from stayput.model.body import Body
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY, check_fields, parameter
from stayput.uncertainty import Confidence

PULL, LOAD, ONE_DRAWER, ALL_DRAWERS = "pull", "load", "one_drawer", "all_drawers"
"""Cases: a pull at the top; the load on the front edge; the load on one open drawer; on one of all, open."""

CARPET = 0.011
"""By how much the rule's carpet lifts the back: 0.43 in [m]."""

PRESET_DRAWERS = {"chest": 4}
"""Drawers of presets that have some (a guess, low confidence)."""


@dataclass(frozen=True, slots=True)
class Everyday:
    """What people do to a piece: drawers that open, a load, a pull, the carpet.

    Parameters
    ----------
    drawers : int
        Drawers that can be open at once; with none the load stands on the front edge.
    drawer_share : float
        Share of the piece's mass that is in all drawers together, with what is in them.
    drawer_extension : float
        How far an open drawer and what is in it move forward [m].
    load : float
        Mass on an open drawer's front [kg]; the default is 60 lb.
    pull : float
        Horizontal pull forward [N]; the default is 10 lbf.
    pull_height : float
        Height of the pull above the floor, or the top where that is lower [m]; the default is 56 in.
    carpet : float
        By how much the back stands higher than the front [m]; `CARPET` is that of the rule.

    Raises
    ------
    InputError
        A value out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> chest = sp.Body(width=0.45, height=1.2, mass=50.0)
    >>> for carpet in (0.0, 0.011):  # by which the back stands higher [m]; below 1 the chest tips over
    ...     habits = sp.Everyday(drawers=4, drawer_share=0.35, carpet=carpet)
    ...     print(carpet, round(min(case.margin for case in sp.tip_over(chest, habits)), 2))
    0.0 1.01
    0.011 0.88
    """

    drawers: int = parameter(0, "", 0, 30, ("Number of drawers", "引き出しの数"), decides=True)
    drawer_share: float = parameter(
        0.5, "", 0.0, 0.95, ("Share of the mass in drawers", "引き出しの質量の割合")
    )
    drawer_extension: float = parameter(0.25, "m", 0.0, 2.0, ("Drawer extension", "引き出しの引き出し長さ"))
    load: float = parameter(
        27.2,
        "kg",
        0.0,
        500.0,
        ("Load on an open drawer", "引き出しにかかる荷重"),
        confidence=Confidence.MEDIUM,
    )
    pull: float = parameter(45.0, "N", 0.0, 1e4, ("Horizontal pull", "水平に引く力"))
    pull_height: float = parameter(1.42, "m", 0.01, 100.0, ("Height of the pull", "引く高さ"))
    carpet: float = parameter(0.0, "m", 0.0, 0.5, ("Lift by carpet", "カーペットによる浮き"))

    def __post_init__(self) -> None:
        check_fields(self)
        object.__setattr__(self, "drawers", int(self.drawers))


@dataclass(frozen=True, slots=True)
class TipOverCase:
    """Moments about the front edge in one case.

    Parameters
    ----------
    name : str
        `PULL`, `LOAD`, `ONE_DRAWER` or `ALL_DRAWERS`.
    restoring : float
        Moment of the closed piece's weight as it stands, tilted by the carpet [N m]; negative where that tips
        it.
    overturning : float
        What the open drawers take off it, and the moments of load and pull [N m].
    """

    name: str
    restoring: float
    overturning: float

    @property
    def margin(self) -> float:
        """Restoring over overturning moment: it tips over below 1; infinite where nothing overturns it."""
        if self.overturning > 0.0:
            return max(0.0, self.restoring / self.overturning)
        return math.inf if self.restoring > 0.0 else 0.0

    @property
    def tips(self) -> bool:
        """Whether it tips over."""
        return self.margin < 1.0


def tip_over(
    body: Body, everyday: Everyday | None = None, gravity: float = STANDARD_GRAVITY
) -> tuple[TipOverCase, ...]:
    """Return the static stability of a piece in every case that it has, the smallest margin first.

    With the closed piece's weight W, its centre of gravity l behind the front edge of the base and h above
    the floor, and the tilt θ of the carpet, the restoring moment is W (l cos θ − h sin θ). Against it: s W e
    cos θ by drawers of a share s that move e forward; and the load's moment L (a cos θ + z sin θ) at the open
    drawer's front, a in front of the edge, and at the top z = H (the worst drawer), or the pull's F z: the
    margin of a pull is by how many times it may grow.

    Parameters
    ----------
    body : Body
        The piece, closed, with what is in it.
    everyday : Everyday, optional
        What people do to it; default `Everyday` without drawers.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        Something else than a body or than what people do, or a gravity out of range.

    Examples
    --------
    >>> from stayput import Body
    >>> chest = Body(0.45, 1.2, 40.0)
    >>> [(case.name, round(case.margin, 2)) for case in tip_over(chest, Everyday(drawers=4))]
    [('all_drawers', 0.76), ('one_drawer', 1.12), ('pull', 1.63)]
    """
    conditions = Everyday() if everyday is None else instance_of("everyday", everyday, Everyday)
    instance_of("body", body, Body)
    GRAVITY.check(gravity)
    _, (lever, below), *_ = body.corners_at_rest
    weight = body.mass * gravity
    tilt = math.atan2(conditions.carpet, body.base_width)
    cos, sin = math.cos(tilt), math.sin(tilt)
    restoring = weight * (lever * cos + below * sin)  # the base lies below the centre: below < 0
    load, overhang = conditions.load * gravity, body.base_insets[1]

    def with_drawers(name: str, share: float, extension: float) -> TipOverCase:
        by_drawers = share * weight * extension * cos
        by_load = load * ((overhang + extension) * cos + body.height * sin)
        return TipOverCase(name, restoring, by_drawers + by_load)

    pull = conditions.pull * min(conditions.pull_height, body.height)
    cases = [TipOverCase(PULL, restoring, pull)]
    if conditions.drawers:
        share, extension = conditions.drawer_share, conditions.drawer_extension
        cases.append(with_drawers(ONE_DRAWER, share / conditions.drawers, extension))
        cases.append(with_drawers(ALL_DRAWERS, share, extension))
    else:
        cases.append(with_drawers(LOAD, 0.0, 0.0))
    return tuple(sorted(cases, key=lambda case: case.margin))


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
