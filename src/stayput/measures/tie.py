"""Belts and chains between the top of the furniture and the wall."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.element import Element, Line, at_rest, damper
from stayput.measures.fixing import BELT, CHAIN, FASTENINGS, SCREWS, TOPS, in_series, panel
from stayput.measures.measure import BadlyInstalled, Held, wall_behind
from stayput.measures.wall import WallDevice, height_of
from stayput.model.parameters import other_default, parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.measures.fixing import Link
    from stayput.model.body import Body
    from stayput.model.room import Room


MORE_SLACK = 0.05
"""What a tie that was put up carelessly hangs through more [m]: an assumption."""

ANGLE = ("rise of the line towards the wall", "壁側への上がり角度")


@dataclass(frozen=True, slots=True)
class Tie(WallDevice):
    """Something that only pulls, along the line between a point of the piece and one on the wall."""

    itself: ClassVar[Link]
    """What it is without what it is fixed to."""

    slack: float = parameter(0.01, "m", 0.0, 0.5, ("slack", "たるみ"), decides=True)
    setback: float = parameter(0.1, "m", 0.02, 5.0, ("distance from the back of the piece", "背面からの距離"))
    angle: float = parameter(0.5, "rad", -1.4, 1.4, ANGLE)

    def where(self) -> Phrase | None:
        """Return the height on the wall."""
        return phrase("measures.tied", height=self.height)

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it with more slack."""
        slack = max(self.slack, min(0.5, self.slack + MORE_SLACK))
        return BadlyInstalled(replace(self, slack=slack), phrase("measures.hangs_loose"))

    def drawn(self, wall: str, height: float, span: float) -> Link:
        """Return one of them with what it is fixed to, by plates at either end; see `WallDevice.drawn`."""
        ends = FASTENINGS[wall].pull.times(SCREWS), TOPS[self.top].pull.times(SCREWS)
        return self._as_given(in_series(*ends, self.itself, panel(wall, height, span)))

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its top to the wall."""
        wall = wall_behind(self, room)
        if self.setback > body.width:
            raise InputError(
                "measures.setback", "setback", measure=self.label, setback=self.setback, width=body.width
            )
        point = (-body.width / 2 + self.setback, self.height * body.height)
        x, z = at_rest(body, point)
        away = x - _left(body) + wall.gap
        rise = away * math.tan(self.angle)
        top = math.inf if room.ceiling is None else room.ceiling.height
        if not 0.0 <= z + rise <= top:
            raise InputError(
                "measures.anchor", "angle", measure=self.label, angle=self.angle, height=z + rise
            )
        link = self.drawn(self.fixed_to(wall), z + rise, height_of(room))
        k = self.count * link.stiffness
        pulls = Line(
            k,
            damper(self.damping, k, body.mass),
            self.slack,
            limit_plus=self.count * link.strength,
            ultimate=link.ultimate,
            weakest=link.fails,
        )
        tie = Element(self.kind, point, pulls, to_anchor=(-away, rise), count=self.count)
        return Held(body, room, (tie,), (self,))


def _left(body: Body) -> float:
    """Return the leftmost place of the body at rest [m]."""
    back = -body.width / 2
    return min(at_rest(body, (back, body.base_heights[0]))[0], at_rest(body, (back, body.height))[0])


@dataclass(frozen=True, slots=True)
class Belt(Tie):
    """Belts from the top of the piece to the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt
    >>> bookcase, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.05))
    >>> for slack in (0.0, 0.03):  # m; the looser, the harder the jerk
    ...     device = sp.simulate(bookcase, room, sp.near_fault(), [Belt(slack=slack)]).devices[0]
    ...     print(f"{slack}: {device.peak_pull:.0f} N, {device.utilisation:.0%} of its strength")
    0.0: 1077 N, 54% of its strength
    0.03: 1235 N, 62% of its strength
    """

    kind: ClassVar[str] = "belt"
    label: ClassVar[tuple[str, str]] = ("Belts", "ベルト式")
    about: ClassVar[tuple[str, str]] = (
        (
            "Belts to the wall stop the piece once they are taut; they act only in tension, and a jerk after "
            "slack may tear them or their anchors."
        ),
        (
            "壁とつないだベルトが張ると転倒を止めるが、引張りにしか効かず、たるみがあると急な力で破損または脱"
            "落することがある。"
        ),
    )

    itself: ClassVar[Link] = BELT

    count: int = parameter(2, "", 1, 20, ("number of belts", "本数"))


@dataclass(frozen=True, slots=True)
class Chain(Tie):
    """Chains from the top of the piece to the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt, Chain, hold
    >>> body, room = sp.Body(0.4, 1.8, 80.0), sp.Room(left_wall=sp.Wall(0.05))
    >>> for tie in (Chain(), Belt()):  # how far it gives before it pulls: a chain hangs more loosely
    ...     print(f"{tie.kind}: {1000 * hold(body, room, [tie]).elements[0].normal.slack_plus:.0f} mm")
    chain: 20 mm
    belt: 10 mm
    """

    kind: ClassVar[str] = "chain"
    label: ClassVar[tuple[str, str]] = ("Chains", "チェーン式")
    about: ClassVar[tuple[str, str]] = (
        (
            "Chains to the wall stop the piece once they are taut; they are usually slack, and the jerk "
            "bends their hooks open or tears their screws out."
        ),
        (
            "壁とつないだチェーンが張ると転倒を止めるが、たるみやすく、急な力でフックが伸びたりねじが抜けたり"
            "する。"
        ),
    )

    itself: ClassVar[Link] = CHAIN

    count: int = parameter(2, "", 1, 20, ("number of chains", "本数"))
    slack: float = other_default(0.02, Tie, "slack")
    damping: float = other_default(0.02, WallDevice, "damping")
