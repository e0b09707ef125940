"""Where furniture stands, and where its mass is: measures without a device."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, not_allowed
from stayput.measures.measure import Held, Measure, wall_behind
from stayput.measures.sketch import Shape, box, outline
from stayput.model.parameters import parameter

if TYPE_CHECKING:
    from stayput.model.body import Body
    from stayput.model.room import Room

GAP = ("gap to the wall behind", "背面の壁とのすき間")


@dataclass(frozen=True, slots=True)
class OtherGap(Measure):
    """Another distance from the wall behind."""

    acts_on: ClassVar[str] = "the room"
    needs: ClassVar[Literal["wall", "ceiling", ""]] = "wall"
    cost_class: ClassVar[int] = 0

    gap: float

    def where(self) -> Phrase | None:
        """Return the distance from the wall."""
        return phrase("measures.at_distance")

    def apply(self, body: Body, room: Room) -> Held:
        """Return the room with the wall at this distance."""
        wall = replace(wall_behind(self, room), gap=self.gap)
        return Held(body, replace(room, left_wall=wall), (), (self,))


@dataclass(frozen=True, slots=True)
class AgainstWall(OtherGap):
    """Moved against the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import AgainstWall
    >>> body, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.2))
    >>> for measures in ([], [AgainstWall()]):  # it has no room to fall back, nor to swing
    ...     print(sp.simulate(body, room, sp.near_fault(), measures).outcome)
    overturned
    rocked
    """

    kind: ClassVar[str] = "against_wall"

    gap: float = parameter(0.0, "m", 0.0, 10.0, GAP)


@dataclass(frozen=True, slots=True)
class AwayFromWall(OtherGap):
    """Moved away from the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import AwayFromWall
    >>> chest, room = sp.Body(0.6, 1.2, 60.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for measures in ([], [AwayFromWall()]):
    ...     run = sp.simulate(chest, room, sp.near_fault(), measures)
    ...     print(f"{run.room.left_wall.gap} m: {run.outcome}, {run.wall_impacts} hits on the wall")
    0.02 m: slid, 3 hits on the wall
    0.3 m: slid, 0 hits on the wall
    """

    kind: ClassVar[str] = "away_from_wall"

    gap: float = parameter(0.3, "m", 0.0, 10.0, GAP)


def with_mass(body: Body, mass: float, height: float, size: tuple[float, float]) -> Body:
    """Return the body with a uniform rectangle more, mid-width; a negative mass is taken away.

    Parameters
    ----------
    body : Body
        The body.
    mass : float
        Mass of the rectangle [kg].
    height : float
        Height of its centre above the base [m].
    size : tuple of float
        Its width and height [m].

    Raises
    ------
    InputError
        The body has not so much to take away there.
    """
    (x_g, z_g), m = body.centre_of_gravity, body.mass + mass
    x, z = body.mass * x_g / m, (body.mass * z_g + mass * height) / m
    before = body.inertia_about_cg + body.mass * ((x_g - x) ** 2 + (z_g - z) ** 2)
    inertia = before + mass * ((size[0] ** 2 + size[1] ** 2) / 12.0 + x**2 + (height - z) ** 2)
    return replace(body, mass=m, cg_offset=(x, z - body.height / 2), inertia=inertia)


@dataclass(frozen=True, slots=True)
class Ballast(Measure):
    """Extra mass near the base.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Ballast, hold
    >>> bare = sp.Body(0.4, 1.8, 60.0)
    >>> for body in (bare, hold(bare, sp.Room(), [Ballast(mass=20.0)]).body):
    ...     (_, height), (tips, _) = body.centre_of_gravity, body.overturning_acceleration()
    ...     print(f"{body.mass:.0f} kg, centre of gravity at {height:.2f} m, tips from {tips:.2f} m/s² on")
    60 kg, centre of gravity at 0.90 m, tips from 2.18 m/s² on
    80 kg, centre of gravity at 0.70 m, tips from 2.80 m/s² on
    """

    kind: ClassVar[str] = "ballast"
    acts_on: ClassVar[str] = "the body"
    cost_class: ClassVar[int] = 2

    mass: float = parameter(20.0, "kg", 0.01, 1e5, ("mass", "質量"))
    height: float = parameter(0.1, "m", 0.0, 10.0, ("height of its centre above the base", "中心の高さ"))

    def to_buy(self, product: Phrase, body: Body) -> Phrase:
        """Return the mass that is asked for."""
        return phrase("measures.ballast_to_buy", product=product, mass=self.mass)

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return how high its centre is to be."""
        return phrase("measures.in_bottom", height=self.height)

    def outlines(self, body: Body) -> list[Shape]:
        """Return a board at its height."""
        half, thick = 0.45 * body.width, min(0.04, self.height)
        return [outline(body, "mass", box(-half, self.height - thick, half, self.height + thick))]

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with the mass across its width."""
        self.check_most("height", body.height)
        return Held(with_mass(body, self.mass, self.height, (body.width, 0.0)), room, (), (self,))


@dataclass(frozen=True, slots=True)
class LowerShelves(Measure):
    """Heavy things moved from the upper half to the lower half.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LowerShelves
    >>> bookcase, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for measures in ([], [LowerShelves(share=0.2)]):  # a fifth of the mass moves down
    ...     print(f"{sp.simulate(bookcase, room, sp.near_fault(), measures).peak_tilt:.2f} rad")
    0.19 rad
    0.11 rad
    """

    kind: ClassVar[str] = "lower_shelves"
    acts_on: ClassVar[str] = "the body"
    cost_class: ClassVar[int] = 0

    share: float = parameter(0.2, "", 0.0, 0.45, ("part of the mass that is moved", "移す質量の割合"))

    def where(self) -> Phrase | None:
        """Return the shelves."""
        return phrase("measures.on_shelves")

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return how much is moved from where to where."""
        return phrase("measures.shelves_down", mass=self.share * held.body.mass)

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with a uniform mass moved from its upper half to its lower half.

        Raises
        ------
        InputError
            The upper half of the piece has not so much mass.
        """
        moved, half = self.share * body.mass, body.height / 2
        try:
            lighter = with_mass(body, -moved, 1.5 * half, (body.width, half))
        except InputError:  # what is left would have no inertia
            raise not_allowed("share", f"{self.share:g}", "measures.upper_half", "share") from None
        return Held(with_mass(lighter, moved, 0.5 * half, (body.width, half)), room, (), (self,))
