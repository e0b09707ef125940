"""What is put under the edges of the base: adhesive gel mats, and a wedge of rubber."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError
from stayput.measures.element import Element, Line, at_rest, damper
from stayput.measures.floor import SOFT, kinetic_of, static_of
from stayput.measures.measure import UNBREAKABLE, BadlyInstalled, Held, Sets, UnderTheBase
from stayput.measures.sketch import THIN, Shape, outline
from stayput.model.parameters import choice, parameter
from stayput.uncertainty import Confidence

if TYPE_CHECKING:
    from stayput.model.body import Body
    from stayput.model.room import Room

ON_DUST = 0.3
"""What is left of the bond on dust or an uneven floor: an assumption."""


@dataclass(frozen=True, slots=True)
class GelMats(UnderTheBase):
    """Pads of soft adhesive gel, half of them along each edge of the base.

    Each edge is held by a spring that only pulls, and one that shears either way; both tear off for good
    where (pull/strength)² + (shear/strength)² = 1. The floor's friction stays what it is: the bond adds to
    it, and what is torn leaves it. Their area is what the label asks for the piece's mass, unless given.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import GelMats
    >>> for mass in (60.0, 240.0):  # kg; each of four mats is as large as the label asks
    ...     print(mass, f"{1e4 * GelMats().fitted_to(sp.Body(0.4, 1.8, mass)).area:.0f} cm²")
    60.0 15 cm²
    240.0 60 cm²
    >>> run = sp.simulate(sp.Body(0.4, 1.8, 60.0), sp.Room(), sp.near_fault(), [GelMats()])
    >>> [(device.place, device.cause, round(device.failure_time, 1)) for device in run.devices]  # s
    [('back', 'pulled off', 6.6), ('front', 'pulled off', 6.7)]
    """

    kind: ClassVar[str] = "gel_mats"
    base: ClassVar[str | None] = "feet"
    compared_by_default: ClassVar[Sets] = ((),)
    tried_in_rooms: ClassVar[Sets] = ((), ("tension_pole",))
    cost_class: ClassVar[int] = 2

    rating: float = parameter(
        1e4,
        "kg/m²",
        1e2,
        1e6,
        ("mass that the label allows on an area", "面積あたりの耐荷重（表示値）"),
        confidence=Confidence.MEDIUM,
    )
    area: float | None = parameter(
        None,
        "m²",
        1e-5,
        1.0,
        ("area of one pad, if not by the rating", "1枚の面積（指定する場合）"),
        decides=True,
    )
    count: int = parameter(4, "", 2, 100, ("number of pads", "枚数"))
    strength: str = choice("rated", ("rated", UNBREAKABLE), ("strength", "強さ"))
    tension: float = parameter(
        100e3, "Pa", 1e2, 1e7, ("label stress in tension", "引張強さ（表示値）"), decides=True
    )
    shear: float = parameter(
        50e3, "Pa", 1e2, 1e7, ("label stress in shear", "せん断強さ（表示値）"), decides=True
    )
    realism: float = parameter(
        0.7,
        "",
        0.0,
        1.0,
        ("part of the label's strength that is reached", "表示値に対する実際の割合"),
        decides=True,
    )
    thickness: float = parameter(0.005, "m", 5e-4, 0.05, ("thickness", "厚さ"))
    modulus: float = parameter(300e3, "Pa", 1e3, 1e8, ("Young's modulus", "ヤング率"))
    damping: float = parameter(0.1, "", 0.0, 2.0, ("damping ratio", "減衰定数"))

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return them on dust."""
        return BadlyInstalled(replace(self, realism=ON_DUST * self.realism), phrase("measures.on_dust"))

    def in_a_usual_room(self) -> dict[str, float]:
        """Return the area of one pad under 100 kg."""
        return {"area": 100.0 / (self.rating * self.count)}

    def area_under(self, body: Body) -> float:
        """Return the area of one pad [m²]: as stated, or what the label asks for under a piece."""
        if self.area is not None:
            return self.area
        return min(1.0, max(1e-5, body.mass / (self.rating * self.count)))

    def fitted_to(self, body: Body) -> GelMats:
        """Return the mats that the label asks for under the piece."""
        return replace(self, area=self.area_under(body))

    def to_buy(self, product: Phrase, body: Body) -> Phrase:
        """Return the mats with their size and the mass that their label is to say."""
        side = 100.0 * math.sqrt(self.area_under(body))
        return phrase("measures.mats_to_buy", product=product, side=side, mass=body.mass)

    def checks(self, room: Room) -> tuple[Phrase, ...]:
        """Return that the floor must be clean."""
        return (phrase("measures.check_clean"),)

    def device_shapes(self, element: Element, body: Body, room: Room) -> list[Shape]:
        """Return a pad between body and floor."""
        u, v = element.point
        outer, inner = (at_rest(body, point) for point in ((u, v), (u - math.copysign(0.06, u), v)))
        return [Shape("polygon", (outer, inner, (inner[0], -THIN), (outer[0], -THIN)), "pad")]

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element at each edge of its base.

        Raises
        ------
        InputError
            On a carpet or on tatami, to which gel does not stick.
        """
        if room.floor.surface in SOFT:
            raise InputError("measures.does_not_stick", "room.floor", measure=self.label)
        area_of_one = self.area_under(body)
        area = 0.5 * self.count * area_of_one
        stiffness = self.modulus * area / self.thickness
        pull, shear = (self.realism * area * stress for stress in (self.tension, self.shear))
        peeled, sheared = phrase("measures.mats_peel"), phrase("measures.mats_shear")
        normal = Line(
            stiffness, damper(self.damping, stiffness, body.mass), 0.0, math.inf, pull, weakest=peeled
        )
        stiffness /= 3.0  # the gel does not change its volume: G = E/3
        tangent = Line(
            stiffness, damper(self.damping, stiffness, body.mass), 0.0, 0.0, shear, shear, weakest=sheared
        )
        half, (left, right), (back, front) = body.width / 2, body.base_heights, body.base_insets
        elements = tuple(
            Element(
                self.kind,
                point,
                normal,
                tangent,
                facing=(0.0, 1.0),
                place=place,
                interaction=True,
                count=count,
                inset=0.5 * math.sqrt(area_of_one),
            )
            for place, point, count in (
                ("back", (back - half, left), self.count // 2),
                ("front", (half - front, right), self.count - self.count // 2),
            )
        )
        return Held(replace(body, base=self.base), room, self.as_strong(*elements), (self,))


@dataclass(frozen=True, slots=True)
class WedgeStopper(UnderTheBase):
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
    compared_by_default: ClassVar[Sets] = ((), ("tension_pole",))
    tried_in_rooms: ClassVar[Sets] = (("tension_pole",),)
    cost_class: ClassVar[int] = 1

    thickness: float = parameter(
        0.007, "m", 5e-4, 0.1, ("thickness at the front edge", "前端の厚さ"), decides=True
    )
    static_friction: float = static_of("rubber pad")
    kinetic_friction: float = kinetic_of("rubber pad")

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return that it sinks in, and that the piece is too squat for it.

        On its flat base a piece slides and does not tip while the floor's friction is below width/height; the
        rubber takes that away, and what it gives in lean is little for such a piece.
        """
        sinks = self.advised_against(room)
        cautions = [] if sinks is None else [sinks]
        slender, friction = body.width / body.height, room.floor.kinetic_friction
        if friction < slender:
            cautions.append(
                phrase("measures.wedge_squat", measure=self.label, slender=slender, friction=friction)
            )
        return tuple(cautions)

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it too short, so that the edge stands on its thin part."""
        thin = max(5e-4, 0.5 * self.thickness)
        return BadlyInstalled(replace(self, thickness=thin), phrase("measures.too_short"))

    def advised_against(self, room: Room) -> Phrase | None:
        """Return that it sinks into a soft floor."""
        return phrase("measures.wedge_sinks", measure=self.label) if room.floor.surface in SOFT else None

    def to_buy(self, product: Phrase, body: Body) -> Phrase:
        """Return the stopper with its length and thickness."""
        thick = 1e3 * self.thickness
        return phrase("measures.wedge_to_buy", product=product, length=body.length, thickness=thick)

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return that it goes under the front."""
        return phrase("measures.under_front")

    def outlines(self, body: Body) -> list[Shape]:
        """Return the stopper under the front edge."""
        half, front = body.width / 2, body.base_heights[1]
        back, nose = max(-half, half - 0.15), half + 0.03
        inner = front * (0.5 + back / body.width)
        edge = (nose, front), (nose, THIN), (half, 0.8 * THIN), (half, 0.0)
        return [outline(body, "rubber", ((back, inner), *edge))]

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
