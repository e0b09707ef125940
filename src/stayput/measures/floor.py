"""What lies between furniture and floor and changes its friction: sheets, glides, casters and isolators."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, ClassVar

from stayput.catalogue import Phrase, phrase
from stayput.errors import within
from stayput.measures.element import Element, Line, damper
from stayput.measures.measure import Held, Measure, Sets, UnderTheBase
from stayput.measures.sketch import THIN, Shape, box, outline
from stayput.model.parameters import parameter
from stayput.model.room import FRICTION_RANGE, LOCKED_CASTER, SURFACES, Room

if TYPE_CHECKING:
    from stayput.model.body import Body

SOFT = frozenset(("carpet", "tatami, along the weave", "tatami, across the weave"))
"""Surfaces to which nothing sticks, and into which a thin thing sinks."""

STATIC, KINETIC = ("static friction", "静止摩擦係数"), ("kinetic friction", "動摩擦係数")


def static_of(surface: str) -> Any:
    """Return the parameter for the static friction of a surface."""
    return _usual(surface, SURFACES[surface].static_friction, STATIC)


def kinetic_of(surface: str) -> Any:
    """Return the parameter for the kinetic friction of a surface."""
    return _usual(surface, SURFACES[surface].kinetic_friction, KINETIC)


def _usual(surface: str, value: float, label: Phrase) -> Any:
    confidence = SURFACES[surface].confidence
    return parameter(value, "", *FRICTION_RANGE, label, confidence=confidence, decides=True)


@dataclass(frozen=True, slots=True)
class OtherFriction(UnderTheBase):
    """Something under the whole base: its friction takes the place of the floor's.

    Attributes
    ----------
    surface : str
        What the base stands on then, where how its friction is drawn depends on it.
    on_soft_floor : str
        The id of a caution for a soft floor.
    """

    cost_class: ClassVar[int] = 1
    surface: ClassVar[str] = ""
    on_soft_floor: ClassVar[str] = ""

    static_friction: float
    kinetic_friction: float

    def __post_init__(self) -> None:
        Measure.__post_init__(self)
        name = phrase("measures.kinetic_friction", measure=self.label)
        within(name, self.kinetic_friction, 0.0, self.static_friction, field="kinetic_friction")

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return what a soft floor does to its friction."""
        if not self.on_soft_floor or room.floor.surface not in SOFT:
            return ()
        return (phrase(self.on_soft_floor, measure=self.label),)

    def outlines(self, body: Body) -> list[Shape]:
        """Return two pads under the ends of the base, or a sheet under all of it."""
        half, wide = body.width / 2, min(0.04, 0.2 * body.width)
        if self.base is None:
            return [outline(body, "rubber", box(-half, -THIN, half, 0.0))]
        return [outline(body, "pad", box(x, -THIN, x + wide, 0.0)) for x in (-half, half - wide)]

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body on a floor with this friction, on the base and on its edges alike."""
        edges = {field.name: None for field in fields(room.floor) if "edge_" in field.name}
        friction = {"static_friction": self.static_friction, "kinetic_friction": self.kinetic_friction}
        floor = replace(room.floor, **edges, **friction, surface=self.surface)
        standing = body if self.base is None else replace(body, base=self.base)
        return Held(standing, replace(room, floor=floor), (), (self,))


@dataclass(frozen=True, slots=True)
class AntiSlipSheet(OtherFriction):
    """Anti-slip sheet or rubber stoppers under the whole base.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import AntiSlipSheet
    >>> for measures in ([], [AntiSlipSheet()]):  # it slides no more, and rocks the more
    ...     run = sp.simulate(sp.Body(0.6, 1.8, 100.0), sp.Room(), sp.near_fault(), measures)
    ...     print(f"{100 * run.peak_slide:.0f} cm, {run.peak_tilt:.2f} rad")
    17 cm, 0.13 rad
    0 cm, 0.18 rad
    """

    kind: ClassVar[str] = "anti_slip_sheet"
    compared_by_default: ClassVar[Sets] = ((),)

    on_soft_floor: ClassVar[str] = "measures.rubber_slips"
    static_friction: float = static_of("rubber pad")
    kinetic_friction: float = kinetic_of("rubber pad")


@dataclass(frozen=True, slots=True)
class FeltGlides(OtherFriction):
    """Felt glides under the base.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import FeltGlides
    >>> for width in (0.3, 0.4):  # m: it slides where width over height is above the friction
    ...     run = sp.simulate(sp.Body(width, 1.8, 100.0), sp.Room(), sp.near_fault(), [FeltGlides()])
    ...     print(f"{width / 1.8:.2f} against {run.room.floor.static_friction}: {run.outcome}")
    0.17 against 0.2: overturned
    0.22 against 0.2: slid
    """

    kind: ClassVar[str] = "felt_glides"
    compared_by_default: ClassVar[Sets] = ((),)
    base: ClassVar[str | None] = "feet"

    on_soft_floor: ClassVar[str] = "measures.glides_stick"
    static_friction: float = static_of("felt on wood")
    kinetic_friction: float = kinetic_of("felt on wood")


@dataclass(frozen=True, slots=True)
class SlidingGlides(OtherFriction):
    """Glides of PTFE under the base.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import SlidingGlides
    >>> slender = sp.Body(width=0.3, height=1.8, mass=100.0)
    >>> run = sp.simulate(slender, sp.Room(), sp.near_fault(), [SlidingGlides()])
    >>> print(f"{run.outcome}, {100 * run.peak_slide:.0f} cm: so much room it needs")
    slid, 36 cm: so much room it needs
    """

    kind: ClassVar[str] = "sliding_glides"
    base: ClassVar[str | None] = "feet"

    on_soft_floor: ClassVar[str] = "measures.glides_stick"
    static_friction: float = static_of("PTFE glide")
    kinetic_friction: float = kinetic_of("PTFE glide")


@dataclass(frozen=True, slots=True)
class Casters(OtherFriction):
    """Wheels under the corners."""

    base: ClassVar[str | None] = "feet"
    cost_class: ClassVar[int] = 2

    def outlines(self, body: Body) -> list[Shape]:
        """Return two wheels."""
        half, radius = body.width / 2, min(0.025, 0.2 * body.width)
        turns = [2.0 * math.pi * i / 16 for i in range(16)]
        wheel = [(radius * math.cos(turn), radius * math.sin(turn)) for turn in turns]
        return [
            outline(body, "wheel", tuple((x + u, v) for u, v in wheel))
            for x in (radius - half, half - radius)
        ]


@dataclass(frozen=True, slots=True)
class FreeCasters(Casters):
    """Casters that roll.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import FreeCasters
    >>> room = sp.Room(left_wall=sp.Wall(0.1), right_wall=sp.Wall(0.3))
    >>> run = sp.simulate(sp.Body(0.6, 1.2, 100.0), room, sp.near_fault(), [FreeCasters()])
    >>> hits = [event for event in run.events if event.kind is sp.EventKind.WALL_IMPACT]
    >>> [(round(hit.time, 1), round(hit.slide, 1)) for hit in hits]  # it rolls from wall to wall [s, m]
    [(7.0, -0.1), (7.4, 0.3), (7.8, -0.1)]
    """

    kind: ClassVar[str] = "free_casters"

    static_friction: float = static_of("free caster, hard floor")
    kinetic_friction: float = kinetic_of("free caster, hard floor")


@dataclass(frozen=True, slots=True)
class LockedCasters(Casters):
    """Casters whose brakes are on.

    They may slip or roll all the same: locking the casters of an ultrasound machine did not necessarily
    lessen how far it moved on a shake table (Nikfar and Konstantinidis 2017, 16th World Conference on
    Earthquake Engineering, paper 2924), though it did in base-isolated buildings (the same 2019, doi
    10.1061/(ASCE)ST.1943-541X.0002266). So a verification draws their friction far wider than any other's:
    `stayput.model.room.friction_factor`.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import FreeCasters, LockedCasters
    >>> for casters in (FreeCasters(), LockedCasters()):
    ...     run = sp.simulate(sp.Body(0.7, 1.2, 100.0), sp.Room(), sp.near_fault(), [casters])
    ...     print(f"{casters.label[0]}: {run.outcome}, {100 * run.peak_slide:.0f} cm")
    Casters, free: slid, 43 cm
    Casters, locked: slid, 9 cm
    """

    kind: ClassVar[str] = "locked_casters"

    surface: ClassVar[str] = LOCKED_CASTER
    static_friction: float = static_of(LOCKED_CASTER)
    kinetic_friction: float = kinetic_of(LOCKED_CASTER)

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return that locks may not hold."""
        return (phrase("measures.locks_slip", measure=self.label),)


@dataclass(frozen=True, slots=True)
class BaseIsolator(OtherFriction):
    """A tray with little friction that may be pulled back to the middle, and stops at the end of its stroke.

    In space stops and restoring force act alike in all directions in plan. A tray on a dish of the radius R
    is pulled back by the stiffness m g/R, with the mass m on it.

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
    cost_class: ClassVar[int] = 3
    static_friction: float = parameter(0.05, "", *FRICTION_RANGE, STATIC, decides=True)
    kinetic_friction: float = parameter(0.04, "", *FRICTION_RANGE, KINETIC, decides=True)
    stroke: float = parameter(0.1, "m", 1e-3, 5.0, ("stroke to either side", "片側の可動範囲"), decides=True)
    restoring_stiffness: float = parameter(
        0.0, "N/m", 0.0, 1e6, ("stiffness that pulls it back", "復元力の剛性")
    )
    stop_stiffness: float = parameter(200e3, "N/m", 1e3, 1e8, ("stiffness of the stops", "ストッパーの剛性"))
    damping: float = parameter(0.2, "", 0.0, 2.0, ("damping ratio of the stops", "ストッパーの減衰定数"))

    def outlines(self, body: Body) -> list[Shape]:
        """Return the tray, and the stops on the floor at the ends of its stroke."""
        half, reach = 0.5 * body.width, 0.5 * body.width + self.stroke
        sides = [box(x, -0.04, x + side * 0.02, 0.03) for x, side in ((-reach, -1.0), (reach, 1.0))]
        tray = outline(body, "metal", box(-half, -0.03, half, 0.0))
        return [tray, *(Shape("polygon", side, "rubber") for side in sides)]

    def device_shapes(self, element: Element, body: Body, room: Room) -> list[Shape]:
        """Return nothing: the stops are among the outlines."""
        return []

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body on a floor with little friction, its stops, and what pulls it back."""
        k = self.stop_stiffness
        stops = Line(k, damper(self.damping, k, body.mass), self.stroke, self.stroke)
        middle = (0.0, 0.5 * sum(body.base_heights))
        elements = [Element(self.kind, middle, Line(), stops, facing=(0.0, 1.0), place="stops")]
        if self.restoring_stiffness > 0.0:
            back = Line(self.restoring_stiffness, slack_plus=0.0, slack_minus=0.0)
            elements.append(replace(elements[0], tangent=back, place="spring"))
        return replace(OtherFriction.apply(self, body, room), elements=tuple(elements))

    def free_slide(self) -> float:
        """Return its stroke."""
        return self.stroke
