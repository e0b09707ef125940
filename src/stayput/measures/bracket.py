"""L-brackets between the top of the furniture and the wall."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.element import Element, Line, at_rest, damper
from stayput.measures.fixing import (
    BRACKET,
    FASTENINGS,
    PRYING,
    PRYING_STIFFNESS,
    SCREWS,
    TOP_BOARDS,
    TOPS,
    in_series,
    panel,
)
from stayput.measures.measure import BadlyInstalled, Held, wall_behind
from stayput.measures.parameters import choice
from stayput.measures.wall import WallDevice, height_of
from stayput.model.parameters import other_default, parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.measures.fixing import Link
    from stayput.model.body import Body
    from stayput.model.room import Room

REACH = 0.15
"""Farthest from the wall that an L-bracket reaches [m]."""


@dataclass(frozen=True, slots=True)
class Bracket(WallDevice):
    """Brackets that pull, push and shear like springs between the back of the piece and the wall."""

    count: int = parameter(2, "", 1, 20, ("number of brackets", "個数"))
    slack: float = parameter(0.0005, "m", 0.0, 0.1, ("slack", "がた"))

    def where(self) -> Phrase | None:
        """Return the height on the wall."""
        return phrase("measures.on_wall", height=self.height)

    def _factor(self) -> float:
        """Return what is left of the strength as it is screwed on."""
        return 1.0

    def drawn(self, wall: str, height: float, span: float) -> Link:
        """Return one bracket with what it is fixed to, drawn from the wall; see `WallDevice.drawn`."""
        return self._as_given(
            in_series(
                FASTENINGS[wall].pull.times(PRYING, PRYING_STIFFNESS),
                BRACKET,
                TOPS[self.top].shear.times(SCREWS),
                panel(wall, height, span),
            )
        )

    def pushed_along(self, wall: str) -> Link:
        """Return one bracket with what it is fixed to, pushed along the wall.

        The screws in the top board bear no pull then: the back of a piece that tips rises, and presses the
        bracket's leg.
        """
        shear = FASTENINGS[wall].shear.times(SCREWS)
        return self._as_given(in_series(shear, BRACKET, TOP_BOARDS[self.top]))

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its back to the wall."""
        wall = wall_behind(self, room)
        if wall.gap > REACH:
            raise InputError(
                "measures.too_far", "room.left_wall.gap", measure=self.label, gap=wall.gap, most=REACH
            )
        point = (-body.width / 2, self.height * body.height)
        made_of = self.fixed_to(wall)
        pull = self.drawn(made_of, at_rest(body, point)[1], height_of(room))
        # the wall bears what pushes
        normal = replace(self._line(pull, body.mass), limit_minus=math.inf)
        tangent = self._line(self.pushed_along(made_of), body.mass)
        element = Element(
            self.kind,
            point,
            normal,
            tangent,
            facing=(1.0, 0.0),
            interaction=pull.ultimate == 0.0,
            count=self.count,
        )
        return Held(body, room, (element,), (self,))

    def _line(self, link: Link, mass: float) -> Line:
        k, most = self.count * link.stiffness, self.count * self._factor() * link.strength
        return Line(
            k,
            damper(self.damping, k, mass),
            self.slack,
            self.slack,
            most,
            most,
            ultimate=link.ultimate,
            weakest=link.fails,
        )


@dataclass(frozen=True, slots=True)
class LBracket(Bracket):
    """L-brackets screwed to what the wall has.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket, hold
    >>> body, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for screws in ("down", "up"):
    ...     pull = hold(body, room, [LBracket(screws=screws)]).elements[0].normal
    ...     print(f"{screws}: {pull.limit_plus:.0f} N, then {pull.weakest[0]}")
    down: 2605 N, then the screws pull out of the stud
    up: 1824 N, then the screws pull out of the stud
    """

    kind: ClassVar[str] = "l_bracket"
    label: ClassVar[tuple[str, str]] = ("Screwed L-brackets", "L型金具（ねじ留め）")
    about: ClassVar[tuple[str, str]] = (
        (
            "Brackets screwed to the top and to the wall tie the piece to it; they fail where the "
            "screws are drawn out, sooner with the bracket below the edge and its screws pointing up."
        ),
        ("家具の上部と壁をL型金具でねじ留めするが、ねじが引き抜けると効かなくなり、上向きの取付けは弱い。"),
    )

    screws: str = choice("down", ("down", "up"), ("direction of the screws", "ねじの向き"))
    upward_strength: float = parameter(
        0.7, "", 0.0, 1.0, ("strength with the screws up, of that with them down", "上向き取付けの強さの比")
    )

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it with its screws in the plasterboard beside the studs, where there are studs to miss."""
        if room.left_wall is None or self.fixed_to(room.left_wall) not in ("stud", "hanging strip"):
            return None
        beside = replace(self, wall="plasterboard", strength=None, stiffness=None, ultimate=None)
        return BadlyInstalled(beside, phrase("measures.beside_the_studs"))

    def _factor(self) -> float:
        return self.upward_strength if self.screws == "up" else 1.0


@dataclass(frozen=True, slots=True)
class LBracketInBoard(Bracket):
    """L-brackets on anchors in gypsum board.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket, LBracketInBoard
    >>> bookcase, room = sp.Body(0.4, 1.8, 160.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for bracket in (LBracketInBoard(), LBracket()):
    ...     run = sp.simulate(bookcase, room, sp.near_fault(), [bracket])
    ...     print(bracket.kind, run.outcome, run.devices[0].cause)
    l_bracket_board rocked drawn out
    l_bracket rocked None
    """

    kind: ClassVar[str] = "l_bracket_board"
    label: ClassVar[tuple[str, str]] = ("L-brackets in gypsum board", "L型金具（石こうボードに固定）")
    about: ClassVar[tuple[str, str]] = (
        (
            "Brackets on anchors in gypsum board look the same as those in studs, but each holds a pull of "
            "only about 300 N and then comes out of the board without warning."
        ),
        (
            "下地のない石こうボードに留めたL型金具は、見た目は同じでも1個あたり約300 Nの引張りにしか耐えず、"
            "超えると前触れなく抜ける。"
        ),
    )

    wall: str = other_default("plasterboard", WallDevice, "wall")
