"""Where furniture stands: close to the wall behind it, or away from it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.measures.measure import Held, Measure, wall_behind
from stayput.model.parameters import parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room

GAP = ("gap to the wall behind", "背面の壁とのすき間")


@dataclass(frozen=True, slots=True)
class OtherGap(Measure):
    """Another distance from the wall behind."""

    acts_on: ClassVar[str] = "the room"

    gap: float

    def where(self) -> Phrase | None:
        """Return the distance from the wall."""
        return phrase("measures.at_distance")

    def apply(self, body: Body, room: Room) -> Held:
        """Return the room with the wall at this distance."""
        wall = replace(wall_behind(self, room), gap=self.gap)
        return Held(body, replace(room, left_wall=wall), (), (self,))


@dataclass(frozen=True, slots=True)
class AgainstWall(OtherGap):
    """Moved against the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import AgainstWall
    >>> body, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.2))
    >>> for measures in ([], [AgainstWall()]):  # it has no room to fall back, nor to swing
    ...     print(sp.simulate(body, room, sp.near_fault(), measures).outcome)
    overturned
    rocked
    """

    kind: ClassVar[str] = "against_wall"
    label: ClassVar[tuple[str, str]] = ("Moved against the wall", "壁に寄せる")
    about: ClassVar[tuple[str, str]] = (
        (
            "Against the wall the piece cannot rock back, which often keeps the rocking from building up; it "
            "can still fall forwards."
        ),
        "壁に寄せると後ろへ揺れないため揺れが大きくなりにくいが、手前への転倒は防げない。",
    )

    gap: float = parameter(0.0, "m", 0.0, 10.0, GAP)


@dataclass(frozen=True, slots=True)
class AwayFromWall(OtherGap):
    """Moved away from the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import AwayFromWall
    >>> chest, room = sp.Body(0.6, 1.2, 60.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for measures in ([], [AwayFromWall()]):
    ...     run = sp.simulate(chest, room, sp.near_fault(), measures)
    ...     print(f"{run.room.left_wall.gap} m: {run.outcome}, {run.wall_impacts} hits on the wall")
    0.02 m: slid, 6 hits on the wall
    0.3 m: slid, 0 hits on the wall
    """

    kind: ClassVar[str] = "away_from_wall"
    label: ClassVar[tuple[str, str]] = ("Moved away from the wall", "壁から離す")
    about: ClassVar[tuple[str, str]] = (
        (
            "Away from the wall the piece does not bounce off it towards the room; nothing limits its "
            "rocking then."
        ),
        "壁から離すと壁に当たってはね返ることはないが、揺れを止めるものもなくなる。",
    )

    gap: float = parameter(0.3, "m", 0.0, 10.0, GAP)
