"""A measure as a value with its parameters, what it makes of a body and its room, and several together.

How well a result is founded is told by a grade, that of the weakest of the inputs that decide it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import StrEnum
from types import MappingProxyType
from typing import TYPE_CHECKING, ClassVar, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import TEXTS, Phrase, is_phrase, phrase
from stayput.errors import InputError, instance_of, list_of, no_length, word_of
from stayput.measures.element import at_rest
from stayput.measures.sketch import Shape
from stayput.mechanics.devices.columns import ELEMENT
from stayput.model.body import Body
from stayput.model.parameters import GIVEN, check_fields, parameter_of
from stayput.model.room import Room, Wall
from stayput.uncertainty import Confidence

if TYPE_CHECKING:
    from stayput.measures.element import Element


class Grade(StrEnum):
    """How well an input, or a result that rests on it, is founded; the order is from the best."""

    A = "A"
    B = "B"
    C = "C"


GRADE_OF: Mapping[str, Grade] = MappingProxyType(
    {
        GIVEN: Grade.A,
        Confidence.HIGH.value: Grade.A,
        Confidence.MEDIUM.value: Grade.B,
        Confidence.LOW.value: Grade.C,
    }
)
"""The grade of each tag: what the user gives counts as known."""

MEANINGS: Mapping[Grade, tuple[str, str]] = MappingProxyType(
    {
        Grade.A: ("measured, from a standard, or given by you", "測定値・規格値、または利用者の指定"),
        Grade.B: ("published or usual values that scatter", "公表値または一般的な値。ばらつきあり"),
        Grade.C: ("assumed defaults; replace them by your own", "仮定した既定値。実際の値に置き換えが必要"),
    }
)
"""What each grade means, in English and Japanese."""


@dataclass(frozen=True, slots=True)
class Held:
    """A body and its room with measures in place.

    Parameters
    ----------
    body : Body
        The body, with what the measures change of it.
    room : Room
        The room, with what they change of it.
    elements : tuple of Element
        The force elements between the two.
    measures : tuple of Measure
        The measures.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket, LowerShelves, hold
    >>> held = hold(sp.Body(0.4, 1.8, 100.0), sp.Room(left_wall=sp.Wall(0.05)), [LBracket(), LowerShelves()])
    >>> [round(place, 2) for place in held.body.centre_of_gravity]  # [m], of 0.9 m without the latter
    [0.0, 0.72]
    >>> [element.kind for element in held.elements]
    ['l_bracket']
    """

    body: Body
    room: Room
    elements: tuple[Element, ...] = ()
    measures: tuple[Measure, ...] = ()

    @property
    def free_slide(self) -> float:
        """How far the measures are made to let the piece slide [m]."""
        return sum(measure.free_slide() for measure in self.measures)

    def devices(self, kind: str) -> list[Element]:
        """Return the devices of a kind of measure."""
        return [element for element in self.elements if element.kind == kind]


UNBREAKABLE: Literal["unbreakable"] = "unbreakable"
"""The strength of a device that cannot fail, whose forces are then the demand on it."""

Sets: TypeAlias = "tuple[tuple[str, ...], ...]"
"""Sets of kinds of measures."""

FAULTY = 0.23
"""Share of fixed furniture that was no better off in Kobe, 1995, since it was badly fixed.

The figure was read second hand; nothing was found for single devices.
"""


@dataclass(frozen=True, slots=True)
class BadlyInstalled:
    """A measure as those install it who do it badly.

    Parameters
    ----------
    measure : Measure
        The measure, with what is wrong with it.
    how : Phrase
        What is wrong, as a clause.
    share : float
        Share of installations that are so; an assumption for any one device.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt
    >>> bad = Belt().badly_installed(sp.Room(left_wall=sp.Wall(0.02)))
    >>> print(f"{bad.share:.0%}: {bad.how[0]}, by {100 * bad.measure.slack:.0f} cm")
    23%: hangs loose, by 6 cm
    """

    measure: Measure
    how: Phrase
    share: float = FAULTY


@dataclass(frozen=True, slots=True)
class Measure(ABC):
    """An earthquake-proof measure: something that holds furniture, or makes it stand better.

    Its fields are its parameters, in SI units; `stayput.model.parameters` tells what is known of each.

    Attributes
    ----------
    kind : str
        Its name in a scenario.
    label : tuple of str
        What it is called, in English and Japanese.
    about : tuple of str
        How it works and what makes it fail, in one sentence in English and Japanese.
    acts_on : str
        What it changes: "the body", "the room" and "the base" come before "the tie", whatever their order.
    drilled : bool
        Whether it takes holes in a wall.
    needs : str
        What the room must have for it: a wall behind the piece, a ceiling or neither.
    base : str or None
        What bears on the floor with it, as of a `Body`: "feet" at the corners; None: what does without it.
    compared_by_default : Sets
        With which other kinds it is compared where a scenario of one piece names no measures; (): alone.
    tried_in_rooms : Sets
        With which other kinds it is tried on the pieces of a room; (): alone.
    cost_class : int
        What it costs for one piece, 0 (nothing) to 3, in the bounds of `stayput.rooms.steps.COST_BOUNDS`: a
        convention of this program, and no price. A class of your own that says nothing counts as the dearest.

    Raises
    ------
    InputError
        A parameter out of its range.

    Examples
    --------
    >>> import stayput as sp
    >>> [kind for kind, measure in sp.MEASURES.items() if measure.acts_on == "the body"]
    ['ballast', 'lower_shelves']
    >>> sp.MEASURES["belt"].label
    ('Belts', 'ベルト式')
    """

    kind: ClassVar[str]
    label: ClassVar[tuple[str, str]]
    about: ClassVar[tuple[str, str]]
    acts_on: ClassVar[str] = "the tie"
    drilled: ClassVar[bool] = False
    needs: ClassVar[Literal["wall", "ceiling", ""]] = ""
    base: ClassVar[str | None] = None
    compared_by_default: ClassVar[Sets] = ()
    tried_in_rooms: ClassVar[Sets] = ()
    cost_class: ClassVar[int] = 3

    def __init_subclass__(cls) -> None:
        if "label" not in cls.__dict__ and f"measures.{cls.__dict__.get('kind')}_about" in TEXTS:
            cls.label, cls.about = phrase(f"measures.{cls.kind}"), phrase(f"measures.{cls.kind}_about")
        # beside an exception for users' own classes: what is missing would come up after all computing
        if not is_phrase(getattr(cls, "label", ("", ""))) or not isinstance(getattr(cls, "kind", ""), str):
            raise InputError("measures.own_class", "label", name=cls.__name__)

    def __post_init__(self) -> None:
        if not hasattr(self, "kind") or not hasattr(self, "label"):
            raise InputError("measures.own_class", "label", name=type(self).__name__)
        check_fields(self, owner=self.label)

    def check_most(self, name: str, most: float) -> None:
        """Refuse a parameter above what the piece allows."""
        about = parameter_of(self, name)
        called = phrase("model.field_of", owner=self.label, name=(name, about.label[1]))
        about.check(getattr(self, name), called=called, bounds=(min(about.low, most), most))

    def where(self) -> Phrase | None:
        """Return the place where only one measure can be, or None if it takes up none."""
        return None

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return why it may not do much for this piece in this room, each as a clause; none by default.

        What cannot work at all is refused by `apply`.
        """
        return ()

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it as it is often installed in a room; None where little can be done wrong."""
        return None

    def in_a_usual_room(self) -> dict[str, float]:
        """Return what those of its parameters come to there that have no default: a page starts from it."""
        return {}

    def fitted_to(self, body: Body) -> Measure:
        """Return the product that is bought for a piece; by default there is but one."""
        return self

    def free_slide(self) -> float:
        """Return how far it is made to let the piece slide, which no verdict counts as sliding [m]."""
        return 0.0

    def unbreakable(self) -> Measure:
        """Return it with the strength "unbreakable": it then bears whatever is asked of it.

        What has no strength is returned as it is: glides, sheets, casters, wedges and ballast bear no force
        of a device, and the stops of a base isolator cannot fail.
        """
        return replace(self, strength=UNBREAKABLE) if hasattr(self, "strength") else self

    def as_strong(self, *elements: Element) -> tuple[Element, ...]:
        """Return its devices as they are, or so that they cannot fail where its strength says so."""
        if getattr(self, "strength", None) != UNBREAKABLE:
            return elements
        return tuple(element.unbreakable() for element in elements)

    def advised_against(self, room: Room) -> Phrase | None:
        """Return why a plan does not choose it in a room where it can be put; None by default."""
        return None

    def to_buy(self, product: Phrase, body: Body) -> Phrase:
        """Return the product as it is asked for in a shop, with its size for a piece."""
        return product

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return where it goes on a piece, which it is in place on and whose base is so high [m]."""
        return self.where() or ("", "")

    def checks(self, room: Room) -> tuple[Phrase, ...]:
        """Return what to look at in the room before it is bought; nothing by default."""
        return ()

    def outlines(self, body: Body) -> list[Shape]:
        """Return what it looks like from the side, but for its devices, below or in a body at rest."""
        return []

    def device_shapes(self, element: Element, body: Body, room: Room) -> list[Shape]:
        """Return what a device of it looks like; by default a line from the body to the anchor."""
        (right, up), (x, z) = element.to_anchor or (0.0, 0.0), at_rest(body, element.point)
        return [Shape("line", ((x, z), (x + right, z + up)), "tie")]

    @abstractmethod
    def apply(self, body: Body, room: Room) -> Held:
        """Return the body and the room with the measure in place.

        Raises
        ------
        InputError
            It cannot be put there: no wall, no ceiling, no room for it.
        """


@dataclass(frozen=True, slots=True)
class UnderTheBase(Measure):
    """A measure between the base and the floor, of which there can be but one."""

    acts_on: ClassVar[str] = "the base"

    def where(self) -> Phrase | None:
        """Return the place under the base."""
        return phrase("measures.under_base")

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return that it goes under the corners or the whole base."""
        return phrase("measures.under_base" if self.base is None else "measures.under_corners")

    def checks(self, room: Room) -> tuple[Phrase, ...]:
        """Return that it needs a hard floor."""
        return (phrase("measures.check_hard"),)


_ORDER = ("the body", "the room", "the base", "the tie")


def identity_of(measure: Measure) -> Hashable:
    """Return what is equal of two measures only where they do the same, also of classes of one's own.

    A class without an equality of its own may hold what its fields and its text do not tell.
    """
    if "__eq__" in vars(type(measure)):
        with suppress(TypeError):  # of a field that cannot be hashed, as an array
            hash(measure)
            return measure
    return measure.apply  # methods are equal where they are of the same object


def _step_of(measure: Measure) -> int:
    """Return when a measure is put in place beside others."""
    name = f"acts_on of {measure.kind}"
    return _ORDER.index(word_of(name, measure.acts_on, _ORDER, name))


def hold(body: Body, room: Room, measures: Iterable[Measure], *, dimensions: int = 2) -> Held:
    """Put measures in place together.

    The result does not depend on their order, but that the elements are listed in it. In the plane like
    devices of a measure act as one element; in space each is one, at its place along the body's length.

    Parameters
    ----------
    body : Body
        What stands.
    room : Room
        Where it stands.
    measures : iterable of Measure
        The measures.
    dimensions : int
        2 in the plane, 3 in space.

    Raises
    ------
    InputError
        Two measures for one place, one that cannot be put there, or in space a body without a length.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import AntiSlipSheet, GelMats
    >>> try:
    ...     sp.hold(sp.Body(0.4, 1.8, 100.0), sp.Room(), [GelMats(), AntiSlipSheet()])
    ... except sp.InputError as error:
    ...     print(str(error).partition(";")[0])
    Adhesive gel mats and Anti-slip sheet are given together, both under the base
    """
    instance_of("body", body, Body)
    instance_of("room", room, Room)
    asked = list_of("measures", measures, Measure)
    refuse_conflicts(asked)
    if asked and body.shape is not None:
        raise InputError("model.another_shape", "measures")
    elements_of: dict[int, tuple[Element, ...]] = {}
    for place in sorted(range(len(asked)), key=lambda n: _step_of(asked[n])):
        held = instance_of(f"apply() of {asked[place].kind}", asked[place].apply(body, room), Held)
        body, room, elements_of[place] = held.body, held.room, held.elements
    elements = tuple(element for place in range(len(asked)) for element in elements_of[place])
    if dimensions == 3:
        if body.length is None:
            raise no_length()
        elements = tuple(part for element in elements for part in element.spread(body.length))
    return Held(body, room, elements, asked)


def element_rows(held: Held, strength: float | Sequence[float] = 1.0) -> NDArray[np.void]:
    """Return the elements as the mechanics read them, shape [n]: forces per unit mass, places relative to G.

    Parameters
    ----------
    held : Held
        The body and the elements that hold it.
    strength : float or sequence of float
        Factor on all strengths, or one for each element. Friction is not a strength.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket, element_rows, hold
    >>> held = hold(sp.Body(0.4, 1.8, 80.0), sp.Room(left_wall=sp.Wall(0.05)), [LBracket()])
    >>> for strength in (1.0, 0.5):  # most pull and shear over the mass of the body [m/s²]
    ...     print(element_rows(held, strength)["limit_plus"].round(1))
    [[32.6 44.1]]
    [[16.3 22. ]]
    """
    rows = np.zeros(len(held.elements), ELEMENT)
    factors = [strength] * len(rows) if isinstance(strength, int | float) else strength
    for n, (element, factor) in enumerate(zip(held.elements, factors, strict=True)):
        rows[n] = element.row(held.body, factor)
    return rows


def refuse_conflicts(measures: Iterable[Measure]) -> None:
    """Raise `InputError` where two measures take up one place."""
    taken: dict[Phrase, Measure] = {}
    for measure in measures:
        place = measure.where()
        if place is None:
            continue
        if place in taken:
            first = taken[place].label
            if first == measure.label:
                raise InputError("measures.twice", measure=first, place=place)
            raise InputError("measures.same_place", first=first, second=measure.label, place=place)
        taken[place] = measure


def wall_behind(measure: Measure, room: Room) -> Wall:
    """Return the wall at the back (left), which some measures need.

    Raises
    ------
    InputError
        There is none.
    """
    if room.left_wall is None:
        raise InputError("measures.no_wall", "room.left_wall", measure=measure.label)
    return room.left_wall
