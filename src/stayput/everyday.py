"""Tip-over without an earthquake: open drawers, a load on them, a pull at the top, carpet under the back.

Moments about the front edge of the base, at rest; the front is on the right, as for `Room.right_wall`. The
cases are like those of the US stability rule for clothing storage units (16 CFR 1261, ASTM F2057-23): all
drawers open and loaded, 60 lb on an open one, a pull, carpet that tilts the piece. It is no test by that rule
and no certificate: but for the 60 lb its numbers are common knowledge, not re-checked.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from stayput.errors import instance_of
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
