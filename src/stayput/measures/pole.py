"""Tension poles between the top of the furniture and the ceiling."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.measures.element import Element, Line, at_rest
from stayput.measures.measure import Held, Measure
from stayput.model.parameters import parameter
from stayput.model.room import FRICTION_RANGE, Ceiling

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room

SHORTEST, LONGEST = 0.02, 2.0
"""Least and most space above the piece that a pole is made for [m]."""


@dataclass(frozen=True, slots=True)
class TensionPole(Measure):
    """Poles that are jammed between the top of the piece and the ceiling.

    They push with a preload and a stiffness up to the strength of the ceiling, which then gives way; they rub
    on the ceiling, and drop out for good once they push no more.
    """

    kind: ClassVar[str] = "tension_pole"
    label: ClassVar[tuple[str, str]] = ("Tension poles", "ポール式（突っ張り棒）")
    about: ClassVar[tuple[str, str]] = (
        (
            "Poles jammed against the ceiling press the piece down; they drop out when the ceiling gives way "
            "or the top moves away from it."
        ),
        (
            "天井との間に突っ張って家具を押さえるが、天井が弱くてへこんだり、上部が離れて緩んだりすると脱落す"
            "る。"
        ),
    )

    count: int = parameter(2, "", 1, 20, ("number of poles", "本数"))
    preload: float = parameter(150.0, "N", 1.0, 1e4, ("preload of one", "1本の突っ張り力"), decides=True)
    stiffness: float = parameter(
        40e3, "N/m", 1e3, 1e8, ("stiffness of one with the ceiling", "天井を含む1本の剛性")
    )
    strength: float = parameter(
        500.0,
        "N",
        1.0,
        1e6,
        ("force that the ceiling bears from one", "天井の強さ（1本あたり）"),
        decides=True,
    )
    give: float = parameter(
        0.01, "m", 0.0, 0.5, ("dent at which the ceiling breaks", "天井が破れるまでのへこみ")
    )
    sideways_stiffness: float = parameter(
        20e3, "N/m", 1e2, 1e8, ("stiffness of one sideways", "1本の水平剛性")
    )
    friction: float = parameter(
        0.4, "", *FRICTION_RANGE, ("friction on the ceiling", "天井との摩擦係数"), decides=True
    )
    setback: float = parameter(0.05, "m", 0.0, 5.0, ("distance from the back of the piece", "背面からの距離"))
    ceiling_height: float | None = parameter(
        None,
        "m",
        0.1,
        1e4,
        ("height of the ceiling, if the room tells none", "天井高（部屋に指定がない場合）"),
    )

    def __post_init__(self) -> None:
        Measure.__post_init__(self)
        if self.preload >= self.strength:
            preload, strength = self.preload, self.strength
            raise InputError(
                "measures.preload", "preload", measure=self.label, preload=preload, strength=strength
            )

    def where(self) -> Phrase | None:
        """Return the place on the top."""
        return phrase("measures.on_top", setback=self.setback)

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its top to the ceiling."""
        if room.ceiling is None:
            if self.ceiling_height is None:
                raise InputError("measures.no_ceiling", "room.ceiling", measure=self.label)
            room = replace(room, ceiling=Ceiling(self.ceiling_height))
        if self.setback > body.width:
            raise InputError(
                "measures.setback", "setback", measure=self.label, setback=self.setback, width=body.width
            )
        assert room.ceiling is not None
        point = (-body.width / 2 + self.setback, body.height)
        space = room.ceiling.height - at_rest(body, point)[1]
        if not SHORTEST <= space <= LONGEST:
            raise InputError(
                "measures.length",
                "room.ceiling.height",
                measure=self.label,
                space=space,
                low=SHORTEST,
                high=LONGEST,
            )
        n, k = self.count, self.count * self.stiffness
        pushes = Line(
            k,
            slack_minus=-self.preload / self.stiffness,
            limit_minus=n * self.strength,
            ultimate=self.give,
        )
        rubs = Line(n * self.sideways_stiffness, 0.0, 0.0, 0.0)
        element = Element(
            self.kind, point, pushes, rubs, facing=(0.0, -1.0), friction=self.friction, drops_out=True
        )
        return Held(body, room, (element,), (self,))
