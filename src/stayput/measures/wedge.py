"""A wedge of rubber under the front edge."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.measures.floor import SOFT, kinetic_of, static_of
from stayput.measures.measure import UNDER_THE_BASE, BadlyInstalled, Held, Measure
from stayput.model.parameters import parameter

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room


@dataclass(frozen=True, slots=True)
class WedgeStopper(Measure):
    """A stopper of rubber pushed under the front edge: the piece leans back, and its front does not slide.

    The front corner of the base is lower by the thickness, so the body rests tilted back; that corner has the
    rubber's friction, and the other one the floor's. The base stays where it is: before a near wall the
    stopper goes in no farther than until the top touches the wall.

    Examples
    --------
    >>> from math import degrees
    >>> import stayput as sp
    >>> from stayput.measures import WedgeStopper, hold
    >>> body = sp.Body(0.4, 1.8, 60.0)
    >>> leaning = hold(body, sp.Room(left_wall=sp.Wall(0.1)), [WedgeStopper()]).body
    >>> round(degrees(leaning.resting_tilt), 1)  # back, to the wall
    -1.0
    >>> [round(one.overturning_acceleration()[1], 2) for one in (body, leaning)]  # to tip forward [m/s²]
    [2.18, 2.34]
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

    thickness: float = parameter(
        0.007, "m", 5e-4, 0.1, ("thickness at the front edge", "前端の厚さ"), decides=True
    )
    static_friction: float = static_of("rubber pad")
    kinetic_friction: float = kinetic_of("rubber pad")

    def where(self) -> Phrase | None:
        """Return the place under the base."""
        return UNDER_THE_BASE

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return that it sinks in, and that the piece is too squat for it.

        On its flat base a piece slides and does not tip while the floor's friction is below width/height; the
        rubber takes that away, and what it gives in lean is little for such a piece.
        """
        found: list[Phrase] = []
        if room.floor.surface in SOFT:
            found.append(phrase("measures.wedge_sinks", measure=self.label))
        slender, friction = body.width / body.height, room.floor.kinetic_friction
        if friction < slender:
            found.append(
                phrase("measures.wedge_squat", measure=self.label, slender=slender, friction=friction)
            )
        return tuple(found)

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it too short, so that the edge stands on its thin part."""
        thin = max(5e-4, 0.5 * self.thickness)
        return BadlyInstalled(replace(self, thickness=thin), phrase("measures.too_short"))

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body tilted back, with rubber at the front edge."""
        left, right = body.base_heights
        low = right - self.thickness
        if room.left_wall is not None:
            # tilted by φ, the top's back corner stands (h − z_A) sin φ right of the base's
            reach = _reach(body)[0] + body.base_insets[0]
            sine = (reach - room.left_wall.gap) / (body.height - left)
            if sine > -1.0:
                low = max(low, left + body.base_width * math.tan(math.asin(sine)))
        leaning = replace(body, base_heights=(left, low))
        room = _seen_from_the_leaning_body(room, body, leaning)
        floor = replace(
            room.floor,
            right_edge_static_friction=self.static_friction,
            right_edge_kinetic_friction=self.kinetic_friction,
        )
        return Held(leaning, replace(room, floor=floor), (), (self,))


def _seen_from_the_leaning_body(room: Room, body: Body, leaning: Body) -> Room:
    """Return the room with the walls where they were from the base's back corner.

    A wall's gap is from the side of the body that is nearest to it as it rests: a leaning one's top corner.
    """
    (back, front), (leaning_back, leaning_front) = _reach(body), _reach(leaning)
    left, right = room.left_wall, room.right_wall
    return replace(
        room,
        left_wall=None if left is None else replace(left, gap=max(0.0, left.gap + leaning_back - back)),
        right_wall=None if right is None else replace(right, gap=max(0.0, right.gap + front - leaning_front)),
    )


def _reach(body: Body) -> tuple[float, float]:
    """Return how far a body at rest reaches left and right of the base's back corner [m].

    Its centre of gravity plays no part, not even in the last bit: draws of it do not move the walls.
    """
    left, right = body.base_heights
    inset = body.base_insets[0]
    tilt = math.atan2(right - left, body.base_width)
    sin, cos = math.sin(tilt), math.cos(tilt)
    corners = (
        (-inset, 0.0),
        (body.width - inset, right - left),
        (-inset, body.height - left),
        (body.width - inset, body.height - left),
    )
    across = [u * cos + v * sin for u, v in corners]
    return min(across), max(across)
