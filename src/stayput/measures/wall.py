"""What devices on the wall have in common: the chain from the furniture's top board to the wall."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.measures.fixing import FASTENINGS, SPAN, TOPS
from stayput.measures.measure import Measure
from stayput.measures.parameters import choice
from stayput.model.parameters import parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.measures.fixing import Link
    from stayput.model.body import Body
    from stayput.model.room import Room, Wall

AS_ROOM = "room"
"""The word for a wall that is made of what the room's is."""


@dataclass(frozen=True, slots=True)
class WallDevice(Measure):
    """Something between the piece and the wall, as strong as its weakest link or as given."""

    drilled: ClassVar[bool] = True

    count: int = parameter(2, "", 1, 20, ("number of them", "個数"))
    strength: float | None = parameter(None, "N", 1.0, 1e6, ("strength of one", "1個の強さ"), decides=True)
    stiffness: float | None = parameter(
        None, "N/m", 1e3, 1e8, ("stiffness of one with what it is fixed to", "取付け部を含む1個の剛性")
    )
    ultimate: float | None = parameter(
        None, "m", 0.0, 0.1, ("plastic elongation at failure", "破断までの塑性伸び")
    )
    wall: str = choice(AS_ROOM, (AS_ROOM, *FASTENINGS), ("what it is fixed to on the wall", "壁側の取付け先"))
    top: str = choice(
        "particle board", tuple(TOPS), ("what the furniture's top board is made of", "家具の天板の材質")
    )
    height: float = parameter(
        1.0,
        "",
        0.1,
        1.0,
        ("height on the piece, as a part of its height", "取付け高さ（家具の高さに対する比）"),
    )
    damping: float = parameter(0.05, "", 0.0, 2.0, ("damping ratio", "減衰定数"))

    def fixed_to(self, wall: Wall) -> str:
        """Return what it is fixed to on the wall, of `stayput.model.room.WALLS`."""
        return wall.construction if self.wall == AS_ROOM else self.wall

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return that plasterboard hardly holds it, where it is fixed there."""
        if room.left_wall is None or self.strength is not None:
            return ()
        in_board = self.fixed_to(room.left_wall) == "plasterboard"
        return (phrase("measures.in_plasterboard", measure=self.label),) if in_board else ()

    def in_a_usual_room(self) -> dict[str, float]:
        """Return what its weakest link comes to on a stud at 1.8 m."""
        link = self.drawn("stud", 1.8, SPAN)
        return {"strength": link.strength, "stiffness": link.stiffness, "ultimate": link.ultimate}

    @abstractmethod
    def drawn(self, wall: str, height: float, span: float) -> Link:
        """Return one of them with what it is fixed to, drawn from the wall.

        Parameters
        ----------
        wall : str
            What it is fixed to.
        height, span : float
            Height of its end on the wall, and the wall's [m].
        """

    def _as_given(self, chain: Link) -> Link:
        """Return the chain of one with what is given in place of what follows from its links."""
        given = {name: getattr(self, name) for name in ("strength", "stiffness", "ultimate")}
        changed = {name: value for name, value in given.items() if value is not None}
        if self.strength is not None:
            changed["fails"] = phrase("measures.as_given")
        return replace(chain, **changed)


def height_of(room: Room) -> float:
    """Return the height of the room's walls [m]."""
    return SPAN if room.ceiling is None else room.ceiling.height
