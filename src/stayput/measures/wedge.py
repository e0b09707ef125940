"""A wedge of rubber under the front edge."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.measures.floor import kinetic_of, static_of
from stayput.measures.measure import UNDER_THE_BASE, Held, Measure
from stayput.measures.parameters import parameter

if TYPE_CHECKING:
    from stayput.body import Body
    from stayput.room import Room


@dataclass(frozen=True, slots=True)
class WedgeStopper(Measure):
    """A stopper of rubber pushed under the front edge: the piece leans back, and its front does not slide.

    The front corner of the base is lower by the thickness, so the body rests tilted back; that corner has the
    rubber's friction, and the other one the floor's.
    """

    kind: ClassVar[str] = "wedge_stopper"
    label: ClassVar[tuple[str, str]] = ("Wedge stopper", "ストッパー式（くさび）")
    about: ClassVar[tuple[str, str]] = (
        (
            "A rubber wedge under the front edge leans the piece back towards the wall; it only shifts the "
            "balance by about a degree, so strong shaking tips the piece all the same."
        ),
        (
            "前下部にくさび状のゴムを挟んで家具を壁側へわずかに傾けるが、傾きは1度ほどなので強い揺れでは倒れ"
            "る。"
        ),
    )
    acts_on: ClassVar[str] = "the base"

    thickness: float = parameter(0.007, "m", 5e-4, 0.1, ("thickness at the front edge", "前端の厚さ"))
    static_friction: float = static_of("rubber pad")
    kinetic_friction: float = kinetic_of("rubber pad")

    def where(self) -> str | None:
        """Return the place under the base."""
        return UNDER_THE_BASE

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body tilted back, with rubber at the front edge."""
        left, right = body.base_heights
        body = replace(body, base_heights=(left, right - self.thickness))
        floor = replace(
            room.floor,
            right_edge_static_friction=self.static_friction,
            right_edge_kinetic_friction=self.kinetic_friction,
        )
        return Held(body, replace(room, floor=floor), (), (self,))
