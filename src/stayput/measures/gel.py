"""Adhesive gel mats under the corners."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.element import Element, Line, damper
from stayput.measures.floor import SOFT
from stayput.measures.measure import UNDER_THE_BASE, BadlyInstalled, Held, Measure
from stayput.model.parameters import parameter
from stayput.uncertainty import Confidence

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room


ON_DUST = 0.3
"""What is left of the bond on dust or an uneven floor: an assumption."""


@dataclass(frozen=True, slots=True)
class GelMats(Measure):
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
    label: ClassVar[tuple[str, str]] = ("Adhesive gel mats", "耐震ゲルマット（粘着マット式）")
    about: ClassVar[tuple[str, str]] = (
        (
            "Sticky gel under the corners holds the base down and sideways; it tears off for good where pull "
            "and shear together exceed its bond, which dust, rough floors and age weaken."
        ),
        (
            "四隅の粘着ゲルで底面を床に留めるが、引きはがす力とずれの力が粘着力を超えるとはがれて元に戻らず、"
            "ほこりや凹凸、劣化で弱くなる。"
        ),
    )
    acts_on: ClassVar[str] = "the base"

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

    def where(self) -> Phrase | None:
        """Return the place under the base."""
        return UNDER_THE_BASE

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return them on dust."""
        return BadlyInstalled(replace(self, realism=ON_DUST * self.realism), phrase("measures.on_dust"))

    def in_a_usual_room(self) -> dict[str, float]:
        """Return the area of one pad under 100 kg."""
        return {"area": 100.0 / (self.rating * self.count)}

    def fitted_to(self, body: Body) -> GelMats:
        """Return the mats that the label asks for under the piece."""
        if self.area is not None:
            return self
        return replace(self, area=min(1.0, max(1e-5, body.mass / (self.rating * self.count))))

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element at each edge of its base.

        Raises
        ------
        InputError
            On a carpet or on tatami, to which gel does not stick.
        """
        if room.floor.surface in SOFT:
            raise InputError("measures.does_not_stick", "room.floor", measure=self.label)
        area_of_one = self.fitted_to(body).area
        assert area_of_one is not None
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
        return Held(body, room, elements, (self,))
