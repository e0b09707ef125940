"""Belts and chains between the top of the furniture and the wall."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.bracket import HEIGHT
from stayput.measures.element import Element, Line, at_rest, damper
from stayput.measures.measure import Held, Measure, wall_behind
from stayput.model.parameters import other_default, parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room


ANGLE = ("rise of the line towards the wall", "壁側への上がり角度")


@dataclass(frozen=True, slots=True)
class Tie(Measure):
    """Something that only pulls, along the line between a point of the piece and one on the wall."""

    count: int
    strength: float = parameter(1500.0, "N", 1.0, 1e6, ("strength of one", "1本の強さ"), decides=True)
    stiffness: float = parameter(50e3, "N/m", 1e3, 1e8, ("stiffness of one", "1本の剛性"))
    slack: float = parameter(0.01, "m", 0.0, 0.5, ("slack", "たるみ"), decides=True)
    setback: float = parameter(0.1, "m", 0.02, 5.0, ("distance from the back of the piece", "背面からの距離"))
    angle: float = parameter(0.5, "rad", -1.4, 1.4, ANGLE)
    height: float = parameter(1.0, "", 0.1, 1.0, HEIGHT)
    damping: float = parameter(0.05, "", 0.0, 2.0, ("damping ratio", "減衰定数"))

    def where(self) -> Phrase | None:
        """Return the height on the wall."""
        return phrase("measures.tied", height=self.height)

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
        k = self.count * self.stiffness
        most = self.count * self.strength
        pulls = Line(k, damper(self.damping, k, body.mass), self.slack, limit_plus=most)
        return Held(body, room, (Element(self.kind, point, pulls, to_anchor=(-away, rise)),), (self,))


def _left(body: Body) -> float:
    """Return the leftmost place of the body at rest [m]."""
    back = -body.width / 2
    return min(at_rest(body, (back, body.base_heights[0]))[0], at_rest(body, (back, body.height))[0])


@dataclass(frozen=True, slots=True)
class Belt(Tie):
    """Belts from the top of the piece to the wall."""

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

    count: int = parameter(2, "", 1, 20, ("number of belts", "本数"))


@dataclass(frozen=True, slots=True)
class Chain(Tie):
    """Chains from the top of the piece to the wall."""

    kind: ClassVar[str] = "chain"
    label: ClassVar[tuple[str, str]] = ("Chains", "チェーン式")
    about: ClassVar[tuple[str, str]] = (
        (
            "Chains to the wall stop the piece once they are taut; they are stiff and usually slack, so the "
            "jerk that tears their hooks or screws comes early."
        ),
        (
            "壁とつないだチェーンが張ると転倒を止めるが、硬くたるみやすいため、急な力で金具やねじが外れやすい"
            "。"
        ),
    )

    count: int = parameter(2, "", 1, 20, ("number of chains", "本数"))
    strength: float = other_default(1000.0, Tie, "strength")
    stiffness: float = other_default(200e3, Tie, "stiffness")
    slack: float = other_default(0.02, Tie, "slack")
    damping: float = other_default(0.02, Tie, "damping")
