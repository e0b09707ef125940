"""Tension poles between the top of the furniture and the ceiling."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Literal

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, within
from stayput.measures.element import Element, Line, at_rest, spacing
from stayput.measures.fixing import CEILING_LINKS, POLE, TOP_BOARDS, Link, in_series
from stayput.measures.measure import UNBREAKABLE, BadlyInstalled, Held, Measure, Sets
from stayput.measures.sketch import Shape
from stayput.model.parameters import choice, parameter
from stayput.model.room import FRICTION_RANGE, Ceiling, Room

if TYPE_CHECKING:
    from stayput.model.body import Body

SHORTEST, LONGEST = 0.02, 2.0
"""Least and most space above the piece that a pole is made for [m]."""


TIGHTENED = 0.5
"""What a pole is tightened to at most, in what the ceiling bears: it is seen to lift before it gives way."""

HARDLY_TIGHTENED = 20.0
"""Preload of a pole that was not tightened, or has worked loose [N]: an assumption."""

LONG = 0.6
"""From this length on a pole is called too long for much effect [m]: advice to residents."""


@dataclass(frozen=True, slots=True)
class TensionPole(Measure):
    """Poles that are jammed between the top of the piece and the ceiling.

    They push with a preload and a stiffness up to the strength of the ceiling, which then gives way; and drop
    out for good once they push no more. Sideways a strut of length L on flat pads of width w bears no more
    than its push times w/L before it leans, or than friction, if that is less; it falls once its head has
    walked by w.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import TensionPole, hold
    >>> for construction in ("joist", "plasterboard"):  # two poles bear what the ceiling does
    ...     room = sp.Room(ceiling=sp.Ceiling(2.4, construction=construction))
    ...     push = hold(sp.Body(0.4, 1.8, 60.0), room, [TensionPole()]).elements[0].normal
    ...     print(f"{push.limit_minus:.0f} N, then {push.weakest[0]}")
    1000 N, then the ceiling's joists lift
    554 N, then the pole goes through the ceiling's plasterboard
    """

    kind: ClassVar[str] = "tension_pole"
    needs: ClassVar[Literal["wall", "ceiling", ""]] = "ceiling"
    compared_by_default: ClassVar[Sets] = ((),)
    tried_in_rooms: ClassVar[Sets] = ((),)
    cost_class: ClassVar[int] = 2

    count: int = parameter(2, "", 1, 20, ("number of poles", "本数"))
    preload: float = parameter(150.0, "N", 1.0, 1e4, ("preload of one", "1本の突っ張り力"), decides=True)
    stiffness: float | None = parameter(
        None, "N/m", 1e3, 1e8, ("stiffness of one with the ceiling", "天井を含む1本の剛性")
    )
    strength: float | Literal["unbreakable"] | None = parameter(
        None,
        "N",
        1.0,
        1e6,
        ("force that the ceiling bears from one", "天井の強さ（1本あたり）"),
        words=(UNBREAKABLE,),
        decides=True,
    )
    give: float | None = parameter(
        None, "m", 0.0, 0.5, ("dent at which the ceiling breaks", "天井が破れるまでのへこみ")
    )
    top: str = choice(
        "particle board", tuple(TOP_BOARDS), ("what the furniture's top board is made of", "家具の天板の材質")
    )
    pad: float = parameter(
        0.07, "m", 0.005, 1.0, ("width of the pads at its ends", "両端の受け座の幅"), decides=True
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
        preload, strength = self.preload, self.strength
        if isinstance(strength, int | float) and preload >= strength:
            raise InputError(
                "measures.preload", "preload", measure=self.label, preload=preload, strength=strength
            )

    def where(self) -> Phrase | None:
        """Return the place on the top."""
        return phrase("measures.on_top", setback=self.setback)

    def cautions(self, body: Body, room: Room) -> tuple[Phrase, ...]:
        """Return that the ceiling's board hardly bears it, and that it is long."""
        cautions: list[Phrase] = []
        if room.ceiling is not None and room.ceiling.construction == "plasterboard" and self.strength is None:
            cautions.append(phrase("measures.pole_on_board", measure=self.label))
        height = self.ceiling_height if room.ceiling is None else room.ceiling.height
        if height is not None and height - body.height > LONG:
            cautions.append(phrase("measures.pole_long", measure=self.label, most=LONG))
        return tuple(cautions)

    def badly_installed(self, room: Room) -> BadlyInstalled | None:
        """Return them hardly tightened."""
        loose = replace(self, preload=min(self.preload, HARDLY_TIGHTENED))
        return BadlyInstalled(loose, phrase("measures.hardly_tightened"))

    def in_a_usual_room(self) -> dict[str, float]:
        """Return what the chain to a ceiling of joists comes to."""
        link = self.chain("joist")
        return {"strength": link.strength, "stiffness": link.stiffness, "give": link.ultimate}

    def placed_at(self, held: Held, base: float) -> Phrase:
        """Return where on the top it stands, and how long it is."""
        assert held.room.ceiling is not None
        elements = held.devices(self.kind)
        space = held.room.ceiling.height - base - elements[0].point[1]
        apart = spacing(elements, held.body.length or 0.0)
        return phrase("measures.pole_top", setback=self.setback, apart=apart, length=space)

    def checks(self, room: Room) -> tuple[Phrase, ...]:
        """Return that the ceiling must not give."""
        return (phrase("measures.check_ceiling"),)

    def device_shapes(self, element: Element, body: Body, room: Room) -> list[Shape]:
        """Return the pole with its pads."""
        assert room.ceiling is not None
        (u, v), (x, z), top, half = element.point, at_rest(body, element.point), room.ceiling.height, 0.035
        low, high = (at_rest(body, (end, v + 0.01)) for end in (u - half, u + half))
        lines = ((x - half, top - 0.01), (x + half, top - 0.01)), (low, high), ((x, z), (x, top))
        return [Shape("line", line, "metal") for line in lines]

    def chain(self, ceiling: str) -> Link:
        """Return one pole with the ceiling; what is given takes the place of what follows from the links.

        Parameters
        ----------
        ceiling : str
            What the ceiling is made of, of `stayput.model.room.CEILINGS`.

        Raises
        ------
        InputError
            A dropped ceiling, of which no strength is given.
        """
        if ceiling not in CEILING_LINKS:
            if self.strength is None:
                raise InputError("measures.dropped_ceiling", "room.ceiling", measure=self.label)
            ceiling = "joist"
        link = in_series(POLE, CEILING_LINKS[ceiling], TOP_BOARDS[self.top])
        return link.as_stated(self.strength, self.stiffness, self.give)

    def apply(self, body: Body, room: Room) -> Held:
        """Return the body with an element from its top to the ceiling."""
        if room.ceiling is None and self.ceiling_height is not None:
            room = replace(room, ceiling=Ceiling(self.ceiling_height))
        if room.ceiling is None:
            raise InputError("measures.no_ceiling", "room.ceiling", measure=self.label)
        self.check_most("setback", body.width)
        point = (-body.width / 2 + self.setback, body.height)
        space = room.ceiling.height - at_rest(body, point)[1]
        called = phrase("measures.space_for", measure=self.label)
        within(called, space, SHORTEST, LONGEST, "m", "room.ceiling.height")
        link = self.chain(room.ceiling.construction)
        # what a user gives, he has; a default pole is tightened as far as its ceiling lets it be
        tightened = 1.0 if isinstance(self.strength, int | float) else TIGHTENED
        preload = min(self.preload, tightened * link.strength)
        n = self.count
        k, slack, most = n * link.stiffness, -preload / link.stiffness, n * link.strength
        pushes = Line(k, slack_minus=slack, limit_minus=most, ultimate=link.ultimate, weakest=link.fails)
        rubs = Line(n * self.sideways_stiffness, 0.0, 0.0, 0.0, ultimate=self.pad)
        grip = min(self.friction, self.pad / space)
        element = Element(
            self.kind, point, pushes, rubs, facing=(0.0, -1.0), friction=grip, drops_out=True, count=n
        )
        return Held(body, room, self.as_strong(element), (self,))
