"""Where the body stands: floor, walls and ceiling, and presets for surfaces."""

from __future__ import annotations

from dataclasses import dataclass

from stayput.catalogue import phrase
from stayput.errors import InputError, unknown, within

FRICTION_RANGE = (0.0, 1e6)
"""Smallest and largest coefficient of friction: 1e3, say, is for a body that must not slip."""


def _coefficients(surface: str, static: float, kinetic: float, prefix: str = "") -> None:
    static_field, kinetic_field = f"{prefix}static_friction", f"{prefix}kinetic_friction"
    called = phrase(surface)
    within(phrase("model.static_friction", surface=called), static, *FRICTION_RANGE, field=static_field)
    within(phrase("model.kinetic_friction", surface=called), kinetic, *FRICTION_RANGE, field=kinetic_field)
    if kinetic > static:
        raise InputError(
            "model.kinetic_above_static", kinetic_field, surface=called, kinetic=kinetic, static=static
        )


@dataclass(frozen=True, slots=True)
class Floor:
    """The floor under the body.

    Parameters
    ----------
    static_friction, kinetic_friction : float
        Amontons–Coulomb coefficients μ ≥ μ' of the flat base.
    edge_static_friction, edge_kinetic_friction : float, optional
        The same for a single corner ("rotational" in the paper, 14WCEE 2008); default the flat base's.
    restitution : float
        Factor e on the rotation rate at a change of fulcrum, on top of the momentum balance (the paper's
        Eq. 3.14); 1 is Housner's.
    normal_restitution : float
        Newton's restitution e_n of a landing corner (``contact="coulomb"`` only); 0 is plastic.
    left_edge_static_friction, left_edge_kinetic_friction : float, optional
        Coefficients of the left base corner alone, as of a strip of rubber under it; it has them flat or
        tipped. Default: as the other corner's.
    right_edge_static_friction, right_edge_kinetic_friction : float, optional
        The same for the right base corner.

    Raises
    ------
    InputError
        A coefficient out of its range.
    """

    static_friction: float = 0.4
    kinetic_friction: float = 0.3
    edge_static_friction: float | None = None
    edge_kinetic_friction: float | None = None
    restitution: float = 1.0
    normal_restitution: float = 0.0
    left_edge_static_friction: float | None = None
    left_edge_kinetic_friction: float | None = None
    right_edge_static_friction: float | None = None
    right_edge_kinetic_friction: float | None = None

    def __post_init__(self) -> None:
        _coefficients("model.floor", self.static_friction, self.kinetic_friction)
        _coefficients("model.edge", *self.edge_friction, "edge_")
        _coefficients("model.left_edge", *self._of_one_edge("left"), "left_edge_")
        _coefficients("model.right_edge", *self._of_one_edge("right"), "right_edge_")
        within("model.floor_restitution", self.restitution, 0.0, 1.0, field="restitution")
        normal = self.normal_restitution
        within("model.floor_normal_restitution", normal, 0.0, 1.0, field="normal_restitution")

    @property
    def edge_friction(self) -> tuple[float, float]:
        """Static and kinetic coefficients of a single corner."""
        static, kinetic = self.edge_static_friction, self.edge_kinetic_friction
        return (
            self.static_friction if static is None else static,
            self.kinetic_friction if kinetic is None else kinetic,
        )

    def _of_one_edge(self, side: str) -> tuple[float, float]:
        """Coefficients of one base corner; one that is not given is the edge's."""
        static, kinetic = self.edge_friction
        own_static: float | None = getattr(self, f"{side}_edge_static_friction")
        own_kinetic: float | None = getattr(self, f"{side}_edge_kinetic_friction")
        return (
            static if own_static is None else own_static,
            kinetic if own_kinetic is None else own_kinetic,
        )

    @classmethod
    def of(cls, surface: str, *, restitution: float = 1.0, normal_restitution: float = 0.0) -> Floor:
        """Make a floor from a surface preset of `SURFACES`."""
        if surface not in SURFACES:
            raise unknown("model.surface", surface, SURFACES, field="surface")
        static, kinetic = SURFACES[surface]
        return cls(static, kinetic, restitution=restitution, normal_restitution=normal_restitution)


SURFACES: dict[str, tuple[float, float]] = {
    "wood flooring": (0.40, 0.30),
    "vinyl": (0.35, 0.28),
    "tatami, along the weave": (0.35, 0.30),
    "tatami, across the weave": (0.45, 0.38),
    "carpet": (0.55, 0.45),
    "felt on wood": (0.20, 0.17),
    "PTFE glide": (0.12, 0.10),
    "rubber pad": (0.80, 0.70),
    "free caster, hard floor": (0.03, 0.03),
    "free caster, carpet": (0.06, 0.06),
    "locked caster": (0.40, 0.40),
}
"""Static and kinetic friction of furniture on common surfaces: defaults to be changed, not citations."""


@dataclass(frozen=True, slots=True)
class Wall:
    """A rigid wall beside the body.

    Parameters
    ----------
    gap : float
        Clear distance l_w from the body's side face to the wall [m]; 0 is flush.
    restitution : float
        Wall collision factor e_w.
    friction : float
        Coefficient of friction of a corner on the wall, static and kinetic alike.
    """

    gap: float
    restitution: float = 0.3
    friction: float = 0.3

    def __post_init__(self) -> None:
        within("model.wall_gap", self.gap, 0.0, 1e4, "m", "gap")
        within("model.wall_restitution", self.restitution, 0.0, 1.0, field="restitution")
        within("model.wall_friction", self.friction, *FRICTION_RANGE, field="friction")


@dataclass(frozen=True, slots=True)
class Ceiling:
    """A rigid ceiling above the body.

    Parameters
    ----------
    height : float
        Height above the floor [m].
    restitution, friction : float
        As for `Wall`.
    """

    height: float
    restitution: float = 0.3
    friction: float = 0.3

    def __post_init__(self) -> None:
        within("model.ceiling_height", self.height, 1e-3, 1e4, "m", "height")
        within("model.ceiling_restitution", self.restitution, 0.0, 1.0, field="restitution")
        within("model.ceiling_friction", self.friction, *FRICTION_RANGE, field="friction")


@dataclass(frozen=True, slots=True)
class Room:
    """Floor, walls and ceiling around the body.

    A body hits ``right_wall`` when it tilts or slides to +x; its back stands to ``left_wall``.
    """

    floor: Floor = Floor()
    left_wall: Wall | None = None
    right_wall: Wall | None = None
    ceiling: Ceiling | None = None
