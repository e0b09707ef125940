"""Where the body stands: floor, walls and ceiling, and presets for surfaces."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import not_allowed, shown, within, word_of
from stayput.model.parameters import check_fields, choice, parameter, quantity
from stayput.uncertainty import Confidence
from stayput.vocabulary import preset_meant
from stayput.wording import Brief, brief, check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.model.body import Body

MOST_SETTLEMENT = 0.05
"""How far a piece may sink in at most [m]."""

FRICTION_RANGE = (0.0, 1e6)
"""Smallest and largest coefficient of friction: 1e3, say, is for a body that must not slip."""


_BASES: dict[str, Phrase] = {
    "": ("Floor", "床"),
    "edge_": ("Floor edge", "底の角"),
    "left_edge_": ("Floor left edge", "底の左の角"),
    "right_edge_": ("Floor right edge", "底の右の角"),
}
"""Parts of the base with friction of their own: how the fields begin, and what they are called."""


def _friction(default: float | None, base: str, kind: str) -> Any:
    """Return the field of a part of the base's static or kinetic coefficient of friction."""
    label = phrase(f"model.{kind}_friction", surface=_BASES[base])
    return parameter(default, "", *FRICTION_RANGE, label)


def _restitution(default: float, label: Phrase) -> Any:
    """Return the field of a coefficient of restitution."""
    return parameter(default, "", 0.0, 1.0, label)


@dataclass(frozen=True, slots=True, repr=False)
class Floor:
    """The floor under the body.

    Parameters
    ----------
    static_friction : float
        Coefficient μ of static friction of the flat base (Amontons–Coulomb).
    kinetic_friction : float
        Coefficient μ' ≤ μ of kinetic friction of the flat base.
    edge_static_friction : float, optional
        Static friction of a single corner ("rotational" in the paper, 14WCEE 2008); default the flat base's.
    edge_kinetic_friction : float, optional
        Kinetic friction of a single corner; default the flat base's.
    restitution : float
        Factor e on the rotation rate at a change of fulcrum, on top of the momentum balance (the paper's
        Eq. 3.14); 1 is Housner's.
    normal_restitution : float
        Newton's restitution e_n of a landing corner (``contact="coulomb"`` only); 0 is plastic.
    left_edge_static_friction : float, optional
        Static friction of the left base corner alone, as of a strip of rubber under it; it has that flat or
        tipped. Default: as the other corner's.
    left_edge_kinetic_friction : float, optional
        Kinetic friction of the left base corner alone.
    right_edge_static_friction : float, optional
        Static friction of the right base corner alone.
    right_edge_kinetic_friction : float, optional
        Kinetic friction of the right base corner alone.
    landing_place : float
        ξ, where a landing pushes, as a part of the way from below the centre of gravity to the corner: 1 is
        the corner itself, Housner's; a flat base lands over a region, and loses less (Kalliontzis, Sritharan
        and Schultz 2016). On top of it comes the restitution.
    settlement : float
        How far a flat base sinks in under the piece at rest [m]; 0 is a rigid floor. See
        `stayput.model.soft_base`.
    rolling_resistance : float
        f, how far ahead of the contact of a round body that rolls the floor's force lies [m], in space: it
        slows down by 2/3 g f/R of a cylinder. The default is of wood on wood (0.06 in; tables of handbooks
        have 0.5 mm of steel on steel and 1.2 mm of wood on steel); soft floors have more.
    surface : str
        The preset that it was made from, or empty; what sticks to it or sinks in depends on it.

    Raises
    ------
    InputError
        A coefficient out of its range.

    Examples
    --------
    >>> import stayput as sp
    >>> box, shaking = sp.Body(width=0.5, height=1.0, mass=100.0), sp.near_fault().scaled(0.6)
    >>> for floor in (sp.Floor.of("PTFE glide"), sp.Floor.of("vinyl"), sp.Floor(0.5, 0.4)):
    ...     slide = sp.simulate(box, sp.Room(floor), shaking).peak_slide
    ...     print(f"friction {floor.static_friction}, {floor.kinetic_friction}: {100 * slide:.0f} cm")
    friction 0.12, 0.1: 18 cm
    friction 0.35, 0.28: 3 cm
    friction 0.5, 0.4: 0 cm
    """

    static_friction: float = _friction(0.4, "", "static")
    kinetic_friction: float = _friction(0.3, "", "kinetic")
    edge_static_friction: float | None = _friction(None, "edge_", "static")
    edge_kinetic_friction: float | None = _friction(None, "edge_", "kinetic")
    restitution: float = _restitution(1.0, ("Floor restitution", "床の反発係数"))
    normal_restitution: float = _restitution(0.0, ("Floor normal restitution", "床の鉛直方向の反発係数"))
    left_edge_static_friction: float | None = _friction(None, "left_edge_", "static")
    left_edge_kinetic_friction: float | None = _friction(None, "left_edge_", "kinetic")
    right_edge_static_friction: float | None = _friction(None, "right_edge_", "static")
    right_edge_kinetic_friction: float | None = _friction(None, "right_edge_", "kinetic")
    landing_place: float = parameter(1.0, "", 0.0, 1.0, ("Floor landing place", "着地の力の位置"))
    settlement: float = parameter(0.0, "m", 0.0, MOST_SETTLEMENT, ("Floor settlement", "床の沈み込み"))
    rolling_resistance: float = parameter(
        1.5e-3, "m", 0.0, 0.1, ("Floor rolling resistance", "床の転がり抵抗")
    )
    surface: str = field(default="", compare=False)

    def __repr__(self) -> str:
        if self.surface and self == Floor.of(self.surface):
            return f"Floor.of({self.surface!r})"
        return brief(self, first=2)

    def __post_init__(self) -> None:
        check_fields(self)
        word_of("model.surface", self.surface, ("", *SURFACES), "surface")
        flat, edge = (self.static_friction, self.kinetic_friction), self.edge_friction
        each = (flat, edge, self._own("left_edge_", edge), self._own("right_edge_", edge))
        for (base, called), (static, kinetic) in zip(_BASES.items(), each, strict=True):
            name = phrase("model.kinetic_friction", surface=called)
            within(name, kinetic, 0.0, static, field=f"{base}kinetic_friction")

    @property
    def edge_friction(self) -> tuple[float, float]:
        """Static and kinetic coefficients of a single corner."""
        return self._own("edge_", (self.static_friction, self.kinetic_friction))

    def _own(self, base: str, other: tuple[float, float]) -> tuple[float, float]:
        """Coefficients of a part of the base; one that is not given is the other's."""
        static: float | None = getattr(self, f"{base}static_friction")
        kinetic: float | None = getattr(self, f"{base}kinetic_friction")
        return other[0] if static is None else static, other[1] if kinetic is None else kinetic

    @classmethod
    def of(cls, surface: str, *, restitution: float = 1.0, normal_restitution: float = 0.0) -> Floor:
        """Make a floor from a surface preset of `SURFACES`, or from what people call it: "tatami", "畳"."""
        surface = preset_meant("floor", "model.surface", surface, SURFACES, "surface")
        known = SURFACES[surface]
        return cls(
            known.static_friction,
            known.kinetic_friction,
            restitution=restitution,
            settlement=known.settlement,
            normal_restitution=normal_restitution,
            surface=surface,
        )


class SurfacePreset(NamedTuple):
    """What is known of furniture on a common surface.

    Attributes
    ----------
    static_friction, kinetic_friction : float
        As of a `Floor`.
    settlement : float
        The same [m], of a piece on a flat base; 0 of casters, which stand on points.
    confidence : Confidence
        How well founded the friction is.
    """

    static_friction: float
    kinetic_friction: float
    settlement: float
    confidence: Confidence = Confidence.MEDIUM


LOCKED_CASTER = "locked caster"

SURFACES: dict[str, SurfacePreset] = {
    "wood flooring": SurfacePreset(0.40, 0.30, 0.05e-3),
    "vinyl": SurfacePreset(0.35, 0.28, 0.02e-3),
    "tatami, along the weave": SurfacePreset(0.35, 0.30, 0.5e-3),
    "tatami, across the weave": SurfacePreset(0.45, 0.38, 0.5e-3),
    "carpet": SurfacePreset(0.55, 0.45, 1.0e-3),
    "felt on wood": SurfacePreset(0.20, 0.17, 0.05e-3),
    "PTFE glide": SurfacePreset(0.12, 0.10, 0.05e-3),
    "rubber pad": SurfacePreset(0.80, 0.70, 0.05e-3),
    "free caster, hard floor": SurfacePreset(0.03, 0.03, 0.0),
    "free caster, carpet": SurfacePreset(0.06, 0.06, 0.0),
    LOCKED_CASTER: SurfacePreset(0.40, 0.40, 0.0, Confidence.LOW),
}
"""Furniture on common surfaces: defaults to be changed, not citations.

A carpet on which a file cabinet is 40 % easier to tip (Barnett 2020) sinks in by 1.1 mm by the law of
`stayput.model.soft_base`.
"""

_LOCKED_POWER = 5.0
"""Power to which the drawn factor on friction is taken under locked casters; assumed."""

_LEAST, _MOST = (
    SURFACES[other].static_friction / SURFACES[LOCKED_CASTER].static_friction
    for other in ("free caster, hard floor", "rubber pad")
)
"""Least and largest factor on the friction of locked casters: they roll as if free, or grip like rubber."""


def friction_factor(floor: Floor, drawn: float | NDArray[np.float64]) -> float | NDArray[np.float64]:
    """Return the factor on a floor's friction for one that is drawn: far wider under locked casters.

    Locking the casters of an ultrasound machine did not necessarily lessen how far it moved on a shake table
    (Nikfar and Konstantinidis 2017, 16th World Conference on Earthquake Engineering, paper 2924); how much of
    the friction locks leave was not found.
    """
    return np.clip(drawn**_LOCKED_POWER, _LEAST, _MOST) if floor.surface == LOCKED_CASTER else drawn


SIDE_WALLS = ("near_side_wall", "far_side_wall")
"""Walls at either end of the length of a piece, which only space has."""

WALLS_AROUND = ("left_wall", "right_wall", *SIDE_WALLS)
"""All walls that a room may have."""

WALLS = ("stud", "plasterboard", "concrete", "hanging strip")
"""What a device on a wall may be fixed to: a hanging strip is nailed across the posts."""

CEILINGS = ("joist", "plasterboard", "dropped", "concrete")
"""What a pole may push against: plasterboard is that between the joists, a dropped ceiling hangs on wires."""


@dataclass(frozen=True, slots=True, repr=False)
class Wall(Brief):
    """A rigid wall beside the body.

    Parameters
    ----------
    gap : float
        Clear distance l_w from the body's side face to the wall [m]; 0 is flush.
    restitution : float
        Wall collision factor e_w.
    friction : float
        Coefficient of friction of a corner on the wall, static and kinetic alike.
    construction : str
        What devices are fixed to, of `WALLS`; it changes nothing else.

    Examples
    --------
    >>> import stayput as sp
    >>> body, shaking = sp.Body(width=0.4, height=1.8, mass=100.0), sp.near_fault()
    >>> for gap in (0.05, 0.2):  # m: near enough to stop it on its way, or too far
    ...     print(gap, sp.simulate(body, sp.Room(left_wall=sp.Wall(gap)), shaking).outcome)
    0.05 rocked
    0.2 overturned
    """

    gap: float = field(metadata=quantity("m", 0.0, 1e4, ("Wall gap", "壁とのすき間")))
    restitution: float = _restitution(0.3, ("Wall restitution", "壁の反発係数"))
    friction: float = parameter(0.3, "", *FRICTION_RANGE, ("Wall friction", "壁の摩擦係数"))
    construction: str = choice(WALLS[0], WALLS, ("Wall construction", "壁の下地"))

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True, slots=True, repr=False)
class Ceiling(Brief):
    """A rigid ceiling above the body.

    Parameters
    ----------
    height : float
        Height above the floor [m].
    restitution : float
        Ceiling collision factor.
    friction : float
        Coefficient of friction of a corner on the ceiling, static and kinetic alike.
    construction : str
        What poles push against, of `CEILINGS`; it changes nothing else.

    Examples
    --------
    >>> import stayput as sp
    >>> wardrobe = sp.Body(width=0.6, height=2.35, mass=100.0)  # 2.43 m across: it jams below the ceiling
    >>> strong = sp.near_fault().component("x").scaled(2.2)
    >>> for ceiling in (None, sp.Ceiling(height=2.4)):
    ...     print(sp.simulate(wardrobe, sp.Room(sp.Floor(1.0, 1.0), ceiling=ceiling), strong).outcome)
    overturned
    rocked
    """

    height: float = field(metadata=quantity("m", 1e-3, 1e4, ("Ceiling height", "天井の高さ")))
    restitution: float = _restitution(0.3, ("Ceiling restitution", "天井の反発係数"))
    friction: float = parameter(0.3, "", *FRICTION_RANGE, ("Ceiling friction", "天井の摩擦係数"))
    construction: str = choice(CEILINGS[0], CEILINGS, ("Ceiling construction", "天井の下地"))

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True, slots=True, repr=False)
class Room(Brief):
    """Floor, walls and ceiling around the body.

    A body hits ``right_wall`` when it tilts or slides to +x; its back faces ``left_wall``. Beside it, at
    either end of its length, are ``near_side_wall`` at −y and ``far_side_wall`` at +y: with x to the right
    and z up, one looks at it from the near side. Only in space can a room have side walls.

    Examples
    --------
    >>> import stayput as sp
    >>> body, shaking = sp.Body(width=0.4, height=2.3, mass=100.0), sp.near_fault().component("x")
    >>> for clear in (0.2, 0.8, 3.0):  # from the piece, its back to a wall, to the wall opposite [m]
    ...     room = sp.Room(left_wall=sp.Wall(gap=0.0), right_wall=sp.Wall(gap=clear))
    ...     print(clear, sp.simulate(body, room, shaking).outcome)
    0.2 rocked
    0.8 leaning
    3.0 overturned
    """

    floor: Floor = Floor()
    left_wall: Wall | None = None
    right_wall: Wall | None = None
    ceiling: Ceiling | None = None
    near_side_wall: Wall | None = None
    far_side_wall: Wall | None = None

    def _repr_html_(self) -> str:
        from stayput.report.notebook import room_html

        return room_html(self)

    def plot(self, ax: Axes | None = None, *, body: Body | None = None, language: str = "en") -> Axes:
        """Draw the section of the room at a piece, to scale, with walls and ceiling where they are near.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        body : Body, optional
            The piece; by default one of usual size is indicated.
        language : str
            Language of the texts, "en" or "ja".
        """
        from stayput.report.figures import plotted
        from stayput.report.section import draw_body_in_room

        return plotted(ax, draw_body_in_room, body, self, check_language(language))

    def __post_init__(self) -> None:
        parts = {"floor": (Floor, "Floor.of('wood flooring')"), "ceiling": (Ceiling, "Ceiling(height=2.4)")}
        for name in ("floor", *WALLS_AROUND, "ceiling"):
            kind, example = parts.get(name, (Wall, "Wall(gap=0.02)"))
            value = getattr(self, name)
            if not isinstance(value, kind) and (value is not None or name == "floor"):
                allowed = phrase("model.part_of_room", example=example)
                raise not_allowed(name, shown(value), allowed, name)

    @property
    def has_side_walls(self) -> bool:
        """Whether it has a wall beside the piece."""
        return any(getattr(self, name) is not None for name in SIDE_WALLS)

    def refuse_side_walls(self) -> None:
        """Raise `InputError` where it has a side wall, which the plane has not."""
        for name in SIDE_WALLS:
            if getattr(self, name) is not None:
                wall = f"room.{name}"
                raise not_allowed("dimensions", "2", phrase("model.side_wall_in_the_plane", name=wall), wall)
