"""L-brackets between the top of the furniture and the wall, in a stud or in gypsum board."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.element import Element, Line, damper
from stayput.measures.measure import Held, Measure, wall_behind
from stayput.measures.parameters import choice
from stayput.model.parameters import other_default, parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room

HEIGHT = ("height on the piece, as a part of its height", "取付け高さ（家具の高さに対する比）")
REACH = 0.15
"""Farthest from the wall that an L-bracket reaches [m]."""


@dataclass(frozen=True, slots=True)
class Bracket(Measure):
    """Brackets that pull, push and shear like springs between the back of the piece and the wall."""

    count: int = parameter(2, "", 1, 20, ("number of brackets", "個数"))
    strength: float = parameter(1500.0, "N", 1.0, 1e6, ("strength of one", "1個の強さ"), decides=True)
    stiffness: float = parameter(300e3, "N/m", 1e3, 1e8, ("stiffness of one", "1個の剛性"))
    slack: float = parameter(0.0005, "m", 0.0, 0.1, ("slack", "がた"))
    ultimate: float = parameter(0.005, "m", 0.0, 0.1, ("plastic elongation at failure", "破断までの塑性伸び"))
    height: float = parameter(1.0, "", 0.1, 1.0, HEIGHT)
    damping: float = parameter(0.05, "", 0.0, 2.0, ("damping ratio", "減衰定数"))

    def where(self) -> Phrase | None:
        """Return the height on the wall."""
        return phrase("measures.on_wall", height=self.height)

    def _strength(self) -> float:
        return self.count * self.strength

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its back to the wall."""
        gap = wall_behind(self, room).gap
        if gap > REACH:
            raise InputError(
                "measures.too_far", "room.left_wall.gap", measure=self.label, gap=gap, most=REACH
            )
        k, most = self.count * self.stiffness, self._strength()
        c = damper(self.damping, k, body.mass)
        pushes = Line(k, c, self.slack, self.slack, most, ultimate=self.ultimate)
        shears = Line(k, c, self.slack, self.slack, most, most, ultimate=self.ultimate)
        element = Element(
            self.kind,
            (-body.width / 2, self.height * body.height),
            pushes,
            shears,
            facing=(1.0, 0.0),
            interaction=self.ultimate == 0.0,
        )
        return Held(body, room, (element,), (self,))


@dataclass(frozen=True, slots=True)
class LBracket(Bracket):
    """L-brackets screwed into studs."""

    kind: ClassVar[str] = "l_bracket"
    label: ClassVar[tuple[str, str]] = ("L-brackets in studs", "L型金具（下地に固定）")
    about: ClassVar[tuple[str, str]] = (
        (
            "Brackets screwed to the top and into studs tie the piece to the wall; they fail where the "
            "screws are drawn out, sooner with the bracket below the edge and its screws pointing up."
        ),
        (
            "家具の上部と壁の下地をL型金具でねじ留めするが、ねじが引き抜けると効かなくなり、上向きの取付けは"
            "弱い。"
        ),
    )

    screws: str = choice("down", ("down", "up"), ("direction of the screws", "ねじの向き"))
    upward_strength: float = parameter(
        0.7, "", 0.0, 1.0, ("strength with the screws up, of that with them down", "上向き取付けの強さの比")
    )

    def _strength(self) -> float:
        factor = self.upward_strength if self.screws == "up" else 1.0
        return factor * Bracket._strength(self)


@dataclass(frozen=True, slots=True)
class LBracketInBoard(Bracket):
    """L-brackets on anchors in gypsum board."""

    kind: ClassVar[str] = "l_bracket_board"
    label: ClassVar[tuple[str, str]] = ("L-brackets in gypsum board", "L型金具（石こうボードに固定）")
    about: ClassVar[tuple[str, str]] = (
        (
            "Brackets on anchors in gypsum board look the same as those in studs, but the board holds next "
            "to nothing and crumbles at once."
        ),
        "下地のない石こうボードに留めたL型金具は、見た目は同じでもほとんど力に耐えず、ボードごと抜ける。",
    )

    strength: float = other_default(150.0, Bracket, "strength")
    stiffness: float = other_default(100e3, Bracket, "stiffness")
    ultimate: float = other_default(0.0, Bracket, "ultimate")
