"""A base isolator for furniture: it slides easily, up to its stops."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from stayput.errors import InputError
from stayput.measures.element import Element, Line, damper
from stayput.measures.floor import KINETIC, STATIC, with_friction
from stayput.measures.measure import UNDER_THE_BASE, Held, Measure
from stayput.model.parameters import parameter
from stayput.model.room import FRICTION_RANGE

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.body import Body
    from stayput.model.room import Room


@dataclass(frozen=True, slots=True)
class BaseIsolator(Measure):
    """A tray with little friction, and stops at the ends of its stroke to both sides.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import BaseIsolator
    >>> for stroke in (0.3, 0.5):  # m; its stops rock the piece where they are too near
    ...     isolator = BaseIsolator(stroke=stroke)
    ...     run = sp.simulate(sp.Body(0.6, 1.8, 100.0), sp.Room(), sp.near_fault(), [isolator])
    ...     print(f"{stroke}: {run.outcome}, {run.peak_slide:.2f} m")
    0.3: rocked, 0.30 m
    0.5: slid, 0.44 m
    """

    kind: ClassVar[str] = "base_isolator"
    label: ClassVar[tuple[str, str]] = ("Furniture base isolator", "家具用免震装置")
    about: ClassVar[tuple[str, str]] = (
        (
            "The piece stands on a tray that slides easily, so that little shaking reaches it; where the "
            "floor moves more than the stroke, the stops hit and may tip it."
        ),
        (
            "滑りやすい台に載せて揺れを伝えにくくするが、床の動きが可動範囲を超えるとストッパーに当たり、倒れ"
            "ることがある。"
        ),
    )
    acts_on: ClassVar[str] = "the base"

    static_friction: float = parameter(0.05, "", *FRICTION_RANGE, STATIC, decides=True)
    kinetic_friction: float = parameter(0.04, "", *FRICTION_RANGE, KINETIC, decides=True)
    stroke: float = parameter(0.1, "m", 1e-3, 5.0, ("stroke to either side", "片側の可動範囲"), decides=True)
    stop_stiffness: float = parameter(200e3, "N/m", 1e3, 1e8, ("stiffness of the stops", "ストッパーの剛性"))
    damping: float = parameter(0.2, "", 0.0, 2.0, ("damping ratio of the stops", "ストッパーの減衰定数"))

    def __post_init__(self) -> None:
        Measure.__post_init__(self)
        if self.kinetic_friction > self.static_friction:
            raise InputError(
                "measures.kinetic_above_static",
                "kinetic_friction",
                measure=self.label,
                kinetic=self.kinetic_friction,
                static=self.static_friction,
            )

    def where(self) -> Phrase | None:
        """Return the place under the base."""
        return UNDER_THE_BASE

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body on a floor with little friction, with an element for the stops."""
        k = self.stop_stiffness
        stops = Line(k, damper(self.damping, k, body.mass), self.stroke, self.stroke)
        middle = (0.0, 0.5 * sum(body.base_heights))
        element = Element(self.kind, middle, stops, facing=(1.0, 0.0))
        floor = with_friction(room.floor, self.static_friction, self.kinetic_friction)
        return Held(body, replace(room, floor=floor), (element,), (self,))
