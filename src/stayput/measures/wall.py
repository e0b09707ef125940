"""Devices on the wall: brackets, belts and chains, each with what it is fixed to and with."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, within
from stayput.measures import fixing
from stayput.measures.element import EDGE, Element, Line, at_rest, damper, on_studs, spacing
from stayput.measures.measure import UNBREAKABLE, BadlyInstalled, Held, Measure, Sets, wall_behind
from stayput.measures.sketch import Shape
from stayput.model.parameters import choice, other_default, parameter
from stayput.model.state import wall_faces

if TYPE_CHECKING:
    from stayput.model.body import Body
    from stayput.model.room import Room, Wall

AS_ROOM = "room"
"""The word for a wall that is made of what the room's is."""


@dataclass(frozen=True, slots=True)
class WallDevice(Measure):
    """Something between the piece and the wall, as strong as its weakest link or as given."""

    needs: ClassVar[Literal["wall", "ceiling", ""]] = "wall"
    drilled: ClassVar[bool] = True
    cost_class: ClassVar[int] = 1

    count: int = parameter(2, "", 1, 20, ("number of them", "個数"))
    strength: float | Literal["unbreakable"] | None = parameter(
        None, "N", 1.0, 1e6, ("strength of one", "1個の強さ"), words=(UNBREAKABLE,), decides=True
    )
    stiffness: float | None = parameter(
        None, "N/m", 1e3, 1e8, ("stiffness of one with what it is fixed to", "取付け部を含む1個の剛性")
    )
    ultimate: float | None = parameter(
        None, "m", 0.0, 0.1, ("plastic elongation at failure", "破断までの塑性伸び")
    )
    wall: str = choice(
        AS_ROOM, (AS_ROOM, *fixing.FASTENINGS), ("what it is fixed to on the wall", "壁側の取付け先")
    )
    top: str = choice(
        "particle board",
        tuple(fixing.TOPS),
        ("what the furniture's top board is made of", "家具の天板の材質"),
    )
    height: float = parameter(
        1.0,
        "",
        0.1,
        1.0,
        ("height on the piece, as a part of its height", "取付け高さ（家具の高さに対する比）"),
    )
    damping: float = parameter(0.05, "", 0.0, 2.0, ("damping ratio", "減衰定数"))

    def fixed_to(self, wall: Wall) -> str:
        """Return what it is fixed to on the wall, of `stayput.model.room.WALLS`."""
        return wall.construction if self.wall == AS_ROOM else self.wall

    def pitches(self, wall: Wall) -> tuple[float, ...]:
        """Return the usual distances between what alone it may be fixed to [m]; none: it may be anywhere."""
        return fixing.STUD_PITCH if self.fixed_to(wall) == "stud" else ()

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return that plasterboard hardly holds it, where it is fixed there."""
        if room.left_wall is None or self.strength is not None:
            return ()
        in_board = self.fixed_to(room.left_wall) == "plasterboard"
        return (phrase("measures.in_plasterboard", measure=self.label),) if in_board else ()

    def in_a_usual_room(self) -> dict[str, float]:
        """Return what its weakest link comes to on a stud at 1.8 m."""
        link = self.drawn("stud", 1.8, fixing.SPAN)
        return {"strength": link.strength, "stiffness": link.stiffness, "ultimate": link.ultimate}

    def checks(self, room: Room) -> tuple[Phrase, ...]:
        """Return what the wall and the furniture's top board must be."""
        near, far = (1e3 * pitch for pitch in fixing.STUD_PITCH)
        numbers = {"near": near, "far": far, "depth": 1e3 * fixing.SCREW_IN_STUD}
        made_of = self.fixed_to(wall_behind(self, room))
        return phrase(f"measures.check_{made_of}", **numbers), phrase("measures.check_top")

    @abstractmethod
    def drawn(self, wall: str, height: float, span: float) -> fixing.Link:
        """Return one of them with what it is fixed to, drawn from the wall.

        Parameters
        ----------
        wall : str
            What it is fixed to.
        height, span : float
            Height of its end on the wall, and the wall's [m].
        """

    def _as_given(self, chain: fixing.Link) -> fixing.Link:
        """Return the chain of one with what is given in place of what follows from its links."""
        stated = chain.as_stated(self.strength, self.stiffness, self.ultimate)
        return stated if self.strength is None else replace(stated, fails=phrase("measures.as_given"))


def height_of(room: Room) -> float:
    """Return the height of the room's walls [m]."""
    return fixing.SPAN if room.ceiling is None else room.ceiling.height


def most_on_studs(length: float) -> int:
    """Return how many devices can be on studs behind a piece of a length [m], one on each."""
    return math.floor(max(0.0, length - 2.0 * EDGE) / fixing.STUD_PITCH[0]) + 1


REACH = 0.15
"""Farthest from the wall that an L-bracket reaches [m]."""


@dataclass(frozen=True, slots=True)
class Bracket(WallDevice):
    """Brackets that pull, push and shear like springs between the back of the piece and the wall."""

    count: int = parameter(2, "", 1, 20, ("number of brackets", "個数"))
    slack: float = parameter(0.0005, "m", 0.0, 0.1, ("slack", "がた"))

    def where(self) -> Phrase | None:
        """Return the height on the wall."""
        return phrase("measures.on_wall", height=self.height)

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return where it is screwed to the wall."""
        elements, length = held.devices(self.kind), held.body.length or 0.0
        where = {"apart": spacing(elements, length), "studs": on_studs(elements)}
        return phrase("measures.at_wall", height=base + elements[0].point[1], **where)

    def device_shapes(self, element: Element, body: Body, room: Room) -> list[Shape]:
        """Return an arm to the wall and a leg on it."""
        (u, v), (x, z) = element.point, at_rest(body, element.point)
        wall = wall_faces(body, room)[0]
        leg, inside = min(0.06, 0.5 * body.height), u + min(0.06, 0.5 * body.width)
        arm = at_rest(body, (u, v)), at_rest(body, (inside, v))
        return [
            Shape("line", line, "metal") for line in (((wall, z), (wall, z - leg)), arm, ((x, z), (wall, z)))
        ]

    def _factor(self) -> float:
        """Return what is left of the strength as it is screwed on."""
        return 1.0

    def drawn(self, wall: str, height: float, span: float) -> fixing.Link:
        """Return one bracket with what it is fixed to, drawn from the wall; see `WallDevice.drawn`."""
        return self._as_given(
            fixing.in_series(
                fixing.FASTENINGS[wall].pull.times(fixing.PRYING, fixing.PRYING_STIFFNESS),
                fixing.BRACKET,
                fixing.TOPS[self.top].shear.times(fixing.SCREWS),
                fixing.panel(wall, height, span),
            )
        )

    def pushed_along(self, wall: str) -> fixing.Link:
        """Return one bracket with what it is fixed to, pushed along the wall.

        The screws in the top board bear no pull then: the back of a piece that tips rises, and presses the
        bracket's leg.
        """
        shear = fixing.FASTENINGS[wall].shear.times(fixing.SCREWS)
        return self._as_given(fixing.in_series(shear, fixing.BRACKET, fixing.TOP_BOARDS[self.top]))

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its back to the wall."""
        wall = wall_behind(self, room)
        called = phrase("measures.gap_for", measure=self.label)
        within(called, wall.gap, 0.0, REACH, "m", "room.left_wall.gap")
        point = (-body.width / 2, self.height * body.height)
        made_of = self.fixed_to(wall)
        pull = self.drawn(made_of, at_rest(body, point)[1], height_of(room))
        # the wall bears what pushes
        normal = replace(self._line(pull, body.mass), limit_minus=math.inf)
        tangent = self._line(self.pushed_along(made_of), body.mass)
        brittle = pull.ultimate == 0.0
        element = Element(
            self.kind,
            point,
            normal,
            tangent,
            facing=(1.0, 0.0),
            interaction=brittle,
            count=self.count,
            pitches=self.pitches(wall),
        )
        return Held(body, room, self.as_strong(element), (self,))

    def _line(self, link: fixing.Link, mass: float) -> Line:
        k, most = self.count * link.stiffness, self.count * self._factor() * link.strength
        c, slack = damper(self.damping, k, mass), self.slack
        return Line(k, c, slack, slack, most, most, ultimate=link.ultimate, weakest=link.fails)


@dataclass(frozen=True, slots=True)
class LBracket(Bracket):
    """L-brackets screwed to what the wall has.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket, hold
    >>> body, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for screws in ("down", "up"):
    ...     pull = hold(body, room, [LBracket(screws=screws)]).elements[0].normal
    ...     print(f"{screws}: {pull.limit_plus:.0f} N, then {pull.weakest[0]}")
    down: 2605 N, then the screws pull out of the stud
    up: 1824 N, then the screws pull out of the stud
    """

    kind: ClassVar[str] = "l_bracket"
    compared_by_default: ClassVar[Sets] = ((),)
    tried_in_rooms: ClassVar[Sets] = ((),)

    screws: str = choice("down", ("down", "up"), ("direction of the screws", "ねじの向き"))
    upward_strength: float = parameter(
        0.7, "", 0.0, 1.0, ("strength with the screws up, of that with them down", "上向き取付けの強さの比")
    )

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it with its screws in the plasterboard beside the studs, where there are studs to miss."""
        if room.left_wall is None or self.fixed_to(room.left_wall) not in ("stud", "hanging strip"):
            return None
        strength = self.strength if self.strength == UNBREAKABLE else None
        beside = replace(self, wall="plasterboard", strength=strength, stiffness=None, ultimate=None)
        return BadlyInstalled(beside, phrase("measures.beside_the_studs"))

    def _factor(self) -> float:
        return self.upward_strength if self.screws == "up" else 1.0


@dataclass(frozen=True, slots=True)
class LBracketInBoard(Bracket):
    """L-brackets on anchors in gypsum board.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket, LBracketInBoard
    >>> bookcase, room = sp.Body(0.4, 1.8, 160.0), sp.Room(left_wall=sp.Wall(0.02))
    >>> for bracket in (LBracketInBoard(), LBracket()):
    ...     run = sp.simulate(bookcase, room, sp.near_fault(), [bracket])
    ...     print(bracket.kind, run.outcome, run.devices[0].cause)
    l_bracket_board rocked drawn out
    l_bracket rocked None
    """

    kind: ClassVar[str] = "l_bracket_board"

    wall: str = other_default("plasterboard", WallDevice, "wall")


MORE_SLACK = 0.05
"""What a tie that was put up carelessly hangs through more [m]: an assumption."""

ANGLE = ("rise of the line towards the wall", "壁側への上がり角度")


@dataclass(frozen=True, slots=True)
class Tie(WallDevice):
    """Something that only pulls, along the line between a point of the piece and one on the wall.

    Attributes
    ----------
    itself : fixing.Link
        What it is without what it is fixed to.
    """

    itself: ClassVar[fixing.Link]

    slack: float = parameter(0.01, "m", 0.0, 0.5, ("slack", "たるみ"), decides=True)
    setback: float = parameter(0.1, "m", 0.02, 5.0, ("distance from the back of the piece", "背面からの距離"))
    angle: float = parameter(0.5, "rad", -1.4, 1.4, ANGLE)

    def where(self) -> Phrase | None:
        """Return the height on the wall."""
        return phrase("measures.tied", height=self.height)

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return it with more slack."""
        slack = max(self.slack, min(0.5, self.slack + MORE_SLACK))
        return BadlyInstalled(replace(self, slack=slack), phrase("measures.hangs_loose"))

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return where it is screwed to the top and to the wall."""
        elements, length = held.devices(self.kind), held.body.length or 0.0
        where = {"apart": spacing(elements, length), "studs": on_studs(elements)}
        height = base + elements[0].point[1] + elements[0].rise
        return phrase("measures.tied_top", setback=self.setback, height=height, **where)

    def drawn(self, wall: str, height: float, span: float) -> fixing.Link:
        """Return one of them with what it is fixed to, by plates at either end; see `WallDevice.drawn`."""
        ends = (
            fixing.FASTENINGS[wall].pull.times(fixing.SCREWS),
            fixing.TOPS[self.top].pull.times(fixing.SCREWS),
        )
        return self._as_given(fixing.in_series(*ends, self.itself, fixing.panel(wall, height, span)))

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its top to the wall."""
        wall = wall_behind(self, room)
        self.check_most("setback", body.width)
        point = (-body.width / 2 + self.setback, self.height * body.height)
        x, z = at_rest(body, point)
        away = x - _left(body) + wall.gap
        rise = away * math.tan(self.angle)
        top = math.inf if room.ceiling is None else room.ceiling.height
        if not 0.0 <= z + rise <= top:
            raise InputError(
                "measures.anchor", "angle", measure=self.label, angle=self.angle, height=z + rise
            )
        link = self.drawn(self.fixed_to(wall), z + rise, height_of(room))
        k, most = self.count * link.stiffness, self.count * link.strength
        c = damper(self.damping, k, body.mass)
        pulls = Line(k, c, self.slack, limit_plus=most, ultimate=link.ultimate, weakest=link.fails)
        pitches = self.pitches(wall)
        tie = Element(self.kind, point, pulls, to_anchor=(-away, rise), count=self.count, pitches=pitches)
        return Held(body, room, self.as_strong(tie), (self,))


def _left(body: Body) -> float:
    """Return the leftmost place of the body at rest [m]."""
    back = -body.width / 2
    return min(at_rest(body, (back, body.base_heights[0]))[0], at_rest(body, (back, body.height))[0])


@dataclass(frozen=True, slots=True)
class Belt(Tie):
    """Belts from the top of the piece to the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt
    >>> bookcase, room = sp.Body(0.4, 1.8, 60.0), sp.Room(left_wall=sp.Wall(0.05))
    >>> for slack in (0.0, 0.03):  # m; the looser, the harder the jerk
    ...     device = sp.simulate(bookcase, room, sp.near_fault(), [Belt(slack=slack)]).devices[0]
    ...     print(f"{slack}: {device.peak_pull:.0f} N, {device.utilisation:.0%} of its strength")
    0.0: 1077 N, 54% of its strength
    0.03: 1235 N, 62% of its strength
    """

    kind: ClassVar[str] = "belt"
    compared_by_default: ClassVar[Sets] = ((),)
    tried_in_rooms: ClassVar[Sets] = ((),)

    itself: ClassVar[fixing.Link] = fixing.BELT

    count: int = parameter(2, "", 1, 20, ("number of belts", "本数"))


@dataclass(frozen=True, slots=True)
class Chain(Tie):
    """Chains from the top of the piece to the wall.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt, Chain, hold
    >>> body, room = sp.Body(0.4, 1.8, 80.0), sp.Room(left_wall=sp.Wall(0.05))
    >>> for tie in (Chain(), Belt()):  # how far it gives before it pulls: a chain hangs more loosely
    ...     print(f"{tie.kind}: {1000 * hold(body, room, [tie]).elements[0].normal.slack_plus:.0f} mm")
    chain: 20 mm
    belt: 10 mm
    """

    kind: ClassVar[str] = "chain"

    itself: ClassVar[fixing.Link] = fixing.CHAIN

    count: int = parameter(2, "", 1, 20, ("number of chains", "本数"))
    slack: float = other_default(0.02, Tie, "slack")
    damping: float = other_default(0.02, WallDevice, "damping")
