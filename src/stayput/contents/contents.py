"""`Contents`: what stands on the shelves of a piece of furniture, and what keeps it there."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, within
from stayput.measures.place import with_mass
from stayput.model.body import MASS_RANGE, SIZE_RANGE, Body
from stayput.model.parameters import check_fields, choice, other_default, parameter, parameter_of, quantity
from stayput.model.room import FRICTION_RANGE
from stayput.vocabulary import preset_meant

_SIZE, _FRICTION = ("m", *SIZE_RANGE), ("", *FRICTION_RANGE)


@dataclass(frozen=True, slots=True)
class ContentsKind:
    """What stands on a shelf, seen from the side of the furniture.

    Parameters
    ----------
    width : float
        Depth of an item, which lies along the shaking [m].
    height : float
        Its height [m].
    static_friction, kinetic_friction : float
        Friction on the shelf.
    setback : float
        Distance from the front edge of the shelf to the items [m].
    mass_share : float
        Mass of all contents as a part of the loaded furniture's.
    """

    width: float = field(metadata=quantity(*_SIZE, ("item depth", "物の奥行き")))
    height: float = field(metadata=quantity(*_SIZE, ("item height", "物の高さ")))
    static_friction: float = field(metadata=quantity(*_FRICTION, ("static friction", "静止摩擦係数")))
    kinetic_friction: float = field(metadata=quantity(*_FRICTION, ("kinetic friction", "動摩擦係数")))
    setback: float = field(metadata=quantity("m", 0.0, 10.0, ("setback from the edge", "棚の縁からの距離")))
    mass_share: float = field(metadata=quantity("", 0.0, 0.99, ("share of the mass", "質量の割合")))


CONTENTS: dict[str, ContentsKind] = {
    "books": ContentsKind(0.15, 0.21, 0.35, 0.30, 0.03, 0.80),
    "files": ContentsKind(0.24, 0.31, 0.35, 0.30, 0.02, 0.75),
    "dishes": ContentsKind(0.20, 0.12, 0.25, 0.20, 0.05, 0.50),
    "bottles": ContentsKind(0.08, 0.28, 0.30, 0.25, 0.05, 0.50),
    "boxes": ContentsKind(0.28, 0.25, 0.42, 0.38, 0.02, 0.60),
    "pallet loads": ContentsKind(1.00, 1.20, 0.41, 0.37, 0.05, 0.85),
}
"""Contents by name.

The friction of pallet loads lies within the 0.37 to 0.45 that Sideris and Filiatrault (2010) measured; boxes
have about the same. All other numbers are usual values of low confidence.
"""

DOORS = ("none", "hinged", "hinged, latched", "sliding")
"""Kinds of doors."""

DRAWERS = ("none", "free", "stops", "catches")
"""Kinds of drawers: that come out; that a stop holds at the end; that a catch holds shut besides."""

STOPPED = ("stops", "catches")
"""Drawers that do not come out of the piece."""

CATCHES = {"hinged": 20.0, "hinged, latched": 300.0, "catches": 30.0}
"""Force at the free edge of a door's leaf, or at a drawer, at which the catch lets go [N]; low confidence."""

RUNNERS = (0.10, 0.08)
"""Static and kinetic friction of drawers on their runners; low confidence."""

SHELVES = 5
"""Number of shelves where neither it nor their loads are given."""

FILLED = 0.9
"""Largest height of an item as a part of the clear height between shelves."""


@dataclass(frozen=True, slots=True)
class Contents:
    """What is in a piece of furniture: like items on equally spaced shelves, and what is in front of them.

    The piece's back is on the left, so that things come out to the right. What is not given is the kind's.

    Parameters
    ----------
    kind : str
        One of `stayput.contents.CONTENTS`.
    shelves : int, optional
        Number of shelves, the lowest at the base; default as many as loads, or five.
    loads : sequence of float, optional
        Mass on each shelf from the lowest up [kg].
    mass_share : float, optional
        Without loads: mass of all contents as a part of the furniture's.
    width, height : float, optional
        Depth, along the shaking, and height of an item on a shelf [m]; a drawer fills its compartment.
    static_friction, kinetic_friction : float, optional
        Friction on the shelf; of drawers on their runners.
    setback : float, optional
        Distance from the front edge of the shelf to the items on it [m].
    lip : float
        Height of a lip along the front edge of the shelves [m].
    slope : float
        Inclination of the shelves [rad], + where the front edge is the higher one.
    back : bool
        Whether there is a board or a wall behind the items; without, they stand in the middle.
    doors : str, one of `DOORS`
        What is in front of the shelves.
    drawers : str, one of `DRAWERS`
        Which drawers the contents are in, if any: the items are then drawers, one on each shelf, with what is
        in them.
    catch : float, optional
        Force at which the catch of a door's leaf or of a drawer lets go [N]; default `CATCHES`.
    door_mass : float
        Mass of all doors [kg].
    leaf : float
        Width of a sliding door's leaf [m].
    restitution : float
        Restitution of an item on the lip and the back board.
    items : int
        Items on each shelf that are computed, with friction and size drawn for each.

    Raises
    ------
    InputError
        A number or a word that is not possible, or two that contradict each other.

    Examples
    --------
    >>> from stayput.contents.contents import Contents
    >>> Contents("dishes", shelves=4, doors="hinged, latched").of_kind.static_friction
    0.25
    """

    kind: str = "books"
    shelves: int | None = parameter(None, "", 1, 100, ("number of shelves", "棚の数"), counts=True)
    loads: tuple[float, ...] | None = parameter(
        None, "kg", 0.0, MASS_RANGE[1], ("load of a shelf", "棚の荷重")
    )
    mass_share: float | None = other_default(None, ContentsKind, "mass_share")
    width: float | None = other_default(None, ContentsKind, "width")
    height: float | None = other_default(None, ContentsKind, "height")
    static_friction: float | None = other_default(None, ContentsKind, "static_friction")
    kinetic_friction: float | None = other_default(None, ContentsKind, "kinetic_friction")
    setback: float | None = other_default(None, ContentsKind, "setback")
    lip: float = parameter(0.0, "m", 0.0, 10.0, ("lip height", "棚の縁の高さ"))
    slope: float = parameter(0.0, "rad", -0.5, 0.5, ("slope of the shelves", "棚の傾き"))
    back: bool = True
    doors: str = choice(DOORS[0], DOORS, phrase("contents.doors"))
    drawers: str = choice(DRAWERS[0], DRAWERS, phrase("contents.drawers"))
    catch: float | None = parameter(None, "N", 0.0, 1e6, ("holding force of the catch", "留め具の保持力"))
    door_mass: float = parameter(5.0, "kg", 0.0, 1e3, ("mass of the doors", "扉の質量"))
    leaf: float = parameter(0.45, "m", 0.01, 10.0, ("width of a sliding leaf", "引き戸1枚の幅"))
    restitution: float = parameter(0.2, "", 0.0, 1.0, ("restitution of the items", "物の反発係数"))
    items: int = parameter(8, "", 1, 1000, ("items on a shelf", "1段あたりの物の数"))

    def __post_init__(self) -> None:
        kind = preset_meant("contents", "contents.kind", self.kind, CONTENTS, "kind")
        object.__setattr__(self, "kind", kind)
        instance_of("back", self.back, bool)
        check_fields(self, but=("loads",))
        for name in ("shelves", "items"):  # 4.0 counts, too
            if (count := getattr(self, name)) is not None:
                object.__setattr__(self, name, int(count))
        self._check_loads()
        self._check_fronts()
        static, kinetic = self.friction
        within("contents.kinetic_friction", kinetic, 0.0, static, field="kinetic_friction")

    def _check_loads(self) -> None:
        """Refuse loads that are none, or that are not those of the shelves."""
        if self.loads is None:
            return
        about = parameter_of(Contents, "loads")
        loads = tuple(about.check(load) for load in list_of("loads", self.loads))
        if not loads:
            raise InputError("common.empty", "loads")
        object.__setattr__(self, "loads", loads)
        if self.shelves not in (None, len(loads)):
            raise InputError("common.so_many_values", "loads", count=len(loads), wanted=self.shelves)
        if self.mass_share is not None:
            raise InputError("common.left_out", "mass_share", where=phrase("contents.beside_loads"))

    def _check_fronts(self) -> None:
        """Refuse doors with drawers, and what goes with neither of those given."""
        if self.drawers != "none" and self.doors != "none":
            raise InputError("common.left_out", "drawers", where=phrase("contents.behind_doors"))
        if self.catch is not None and not {self.doors, self.drawers} & CATCHES.keys():
            raise InputError("common.left_out", "catch", where=phrase("contents.without_catch"))
        needs_doors = {"door_mass": DOORS[1:], "leaf": ("sliding",)}
        for name in ("door_mass", "leaf", "lip", "setback", "width", "height"):
            if getattr(self, name) == parameter_of(Contents, name).default:
                continue
            if self.doors not in (kinds := needs_doors.get(name, DOORS)):
                where = phrase("contents.without_doors", needed=", ".join(map(repr, kinds)))
                raise InputError("common.left_out", name, where=where)
            if name not in needs_doors and self.drawers != "none":
                raise InputError("common.left_out", name, where=phrase("contents.in_drawers"))

    @property
    def of_kind(self) -> ContentsKind:
        """The preset, with what is given in its place."""
        fields = {name: getattr(self, name) for name in ContentsKind.__dataclass_fields__}
        stated = {name: value for name, value in fields.items() if value is not None}
        return replace(CONTENTS[self.kind], **stated)

    @property
    def friction(self) -> tuple[float, float]:
        """Static and kinetic coefficient of what slides: the items, or the drawers."""
        kind = self.of_kind
        static, kinetic = (kind.static_friction, kind.kinetic_friction) if self.drawers == "none" else RUNNERS
        stated = self.static_friction, self.kinetic_friction
        return static if stated[0] is None else stated[0], kinetic if stated[1] is None else stated[1]

    @property
    def levels(self) -> int:
        """Number of shelves."""
        if self.loads is not None:
            return len(self.loads)
        return SHELVES if self.shelves is None else self.shelves

    @property
    def holding_force(self) -> float:
        """Force at which the catch lets go [N]; 0 where there is none."""
        usual = CATCHES.get(self.doors, CATCHES.get(self.drawers, 0.0))
        return usual if self.catch is None else self.catch

    @property
    def tag(self) -> str:
        """How well founded the friction is: `stayput.model.parameters.GIVEN`, or the preset's confidence."""
        return parameter_of(Contents, "static_friction").tag(self.static_friction)

    def heights(self, body: Body) -> tuple[float, ...]:
        """Return the heights of the shelves above the base [m]."""
        return tuple(i * body.height / self.levels for i in range(self.levels))

    def masses(self, body: Body) -> tuple[float, ...]:
        """Return the mass on each shelf [kg].

        Raises
        ------
        InputError
            The loads leave nothing of the furniture's mass.
        """
        if self.loads is None:
            return (self.of_kind.mass_share * body.mass / self.levels,) * self.levels
        if sum(self.loads) >= body.mass:
            raise InputError("contents.too_heavy", "loads", loads=sum(self.loads), mass=body.mass)
        return self.loads

    def item_size(self, body: Body) -> tuple[float, float]:
        """Return depth and height of an item that fits into the furniture [m]."""
        kind, clear = self.of_kind, FILLED * body.height / self.levels
        if self.drawers != "none":
            return body.width, clear
        return min(kind.width, body.width), min(kind.height, clear)

    def places(self, body: Body) -> tuple[float, float]:
        """Return the clear distances from the items to the front edge and to the back board [m].

        What the depth leaves behind the last full row of items is behind the first.
        """
        width, _ = self.item_size(body)
        if self.drawers != "none":
            return 0.0, 0.0
        spare = body.width - width
        if not self.back:
            return 0.5 * spare, 0.5 * spare
        front = min(self.of_kind.setback, spare)
        return front, (spare - front) % width


def emptied(body: Body, contents: Contents) -> Body:
    """Return the piece without its contents, each shelf's taken away as a rectangle that fills its shelf.

    A piece is computed with its contents fixed to it, all of them taking part in its inertia. Things that
    slide take part in less of it; the other bound is the piece without them.

    Raises
    ------
    InputError
        The contents are heavier than the piece, or leave it without inertia.
    """
    clear = body.height / contents.levels
    left = body
    try:
        for height, mass in zip(contents.heights(body), contents.masses(body), strict=True):
            left = with_mass(left, -mass, height + 0.5 * clear, (body.width, clear))
    except InputError:
        total = sum(contents.masses(body))
        raise InputError("contents.too_heavy", "contents", loads=total, mass=body.mass) from None
    return left


def opened(body: Body, contents: Contents, extension: float) -> Body:
    """Return the piece with all drawers, or what stands on its shelves, drawn out to the front.

    Mass and heights stay; the centre of gravity moves forwards, by x, and the inertia grows.

    Parameters
    ----------
    body : Body
        The piece with its contents.
    contents : Contents
        What is in it.
    extension : float
        How far out they are [m].

    Raises
    ------
    InputError
        The centre of gravity is beyond the front edge: the piece falls by itself.

    Examples
    --------
    >>> import stayput as sp
    >>> chest = opened(sp.Body(0.42, 1.365, 81.0), sp.Contents("boxes", drawers="stops"), 0.2)
    >>> round(chest.centre_of_gravity[0], 3)
    0.12
    """
    x = body.cg_offset[0]
    mass = sum(contents.masses(body))
    moved = x + mass * extension / body.mass
    inertia = body.inertia_about_cg + mass * ((extension - x) ** 2 - x**2) - body.mass * (moved - x) ** 2
    return replace(body, cg_offset=(moved, body.cg_offset[1]), inertia=inertia)
