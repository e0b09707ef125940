"""What devices are fixed with and to: links in series, of which the weakest gives way.

    1/k = Σ 1/kᵢ        F_u = min F_uᵢ        the plastic elongation is that of the weakest link

since the other links stay elastic. A wall or a ceiling is a link too: its stiffness is that of its first mode
of bending. Its mass is left out: a stud with its strip of board has its first mode at about 13 Hz, above what
rocks furniture.

Withdrawal of screws and nails is the ultimate load of the Wood Handbook (Forest Products Laboratory), their
shear that of Eurocode 5 for a thin steel plate on wood (8.2.3, recalled and not read again).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from stayput.uncertainty import Confidence

if TYPE_CHECKING:
    from stayput.catalogue import Phrase

FIELD = "common knowledge of the field, not checked again"
HANDBOOK = "Wood Handbook's formula; dimensions assumed"
EUROCODE = "Eurocode 5, 8.2.3, recalled; dimensions assumed"


@dataclass(frozen=True, slots=True)
class Link:
    """One link of what holds a piece.

    Parameters
    ----------
    label : Phrase
        What it is.
    fails : Phrase
        What happens at its strength, as a clause: "the screws pull out of the stud".
    stiffness : float
        Force per elongation [N/m]; inf: rigid.
    strength : float
        Force that it bears [N]; inf: never the weakest.
    ultimate : float
        Plastic elongation at which it parts [m]; 0 is brittle.
    source : str
        Where the numbers are from.
    confidence : Confidence
        How well founded they are.
    """

    label: Phrase
    fails: Phrase
    stiffness: float = math.inf
    strength: float = math.inf
    ultimate: float = 0.0
    source: str = FIELD
    confidence: Confidence = Confidence.LOW

    def times(self, strength: float, stiffness: float | None = None) -> Link:
        """Return the link with its strength and, by the same factor or another, its stiffness multiplied."""
        factor = strength if stiffness is None else stiffness
        return replace(self, strength=strength * self.strength, stiffness=factor * self.stiffness)

    def as_stated(
        self, strength: float | str | None, stiffness: float | None, ultimate: float | None
    ) -> Link:
        """Return the link with the numbers that are stated in the place of its own; a word states none."""
        stated = {"strength": strength, "stiffness": stiffness, "ultimate": ultimate}
        numbers = {name: value for name, value in stated.items() if isinstance(value, int | float)}
        return replace(self, **numbers)


def in_series(*links: Link) -> Link:
    """Return links in series as one, which is called and fails like the weakest of them.

    It is rigid where all of them are.
    """
    weakest = min(links, key=lambda link: link.strength)
    compliance = sum(1.0 / link.stiffness for link in links)
    return replace(weakest, stiffness=1.0 / compliance if compliance > 0.0 else math.inf)


def screw_withdrawal(density: float, diameter: float, depth: float) -> float:
    """Return the ultimate withdrawal load of a wood screw from side grain [N]: 108.25 G² D L, D and L in mm.

    Parameters
    ----------
    density : float
        Specific gravity G of the wood, oven-dry.
    diameter, depth : float
        Of the shank, and of the thread in the wood [m].
    """
    return 108.25e6 * density**2 * diameter * depth


def nail_withdrawal(density: float, diameter: float, depth: float) -> float:
    """Return the ultimate withdrawal load of a nail from side grain [N]: 54.12 G^2.5 D L, D and L in mm."""
    return 54.12e6 * density**2.5 * diameter * depth


def screw_shear(embedment: float, diameter: float, depth: float) -> float:
    """Return the shear of a screw through a thin steel plate [N]: min(0.4 f d t, 1.15 √(2 M_y f d)).

    Parameters
    ----------
    embedment : float
        Strength f of the wood under the shank [Pa].
    diameter, depth : float
        Of the shank, and in the wood [m].
    """
    core = 1.1 * 0.7 * diameter
    yield_moment = 0.3 * 600.0 * (1e3 * core) ** 2.6 / 1e3  # of steel of 600 MPa; the formula is in N and mm
    return min(
        0.4 * embedment * diameter * depth, 1.15 * math.sqrt(2.0 * yield_moment * embedment * diameter)
    )


def hook_opening(yield_stress: float, wire: float, lever: float) -> float:
    """Return the force at which an open hook bends open [N]: its wire's plastic moment σ d³/6 over the lever.

    Parameters
    ----------
    yield_stress : float
        Of the wire [Pa].
    wire, lever : float
        Diameter of the wire, and distance of the force from its most bent section [m].
    """
    return yield_stress * wire**3 / (6.0 * lever)


def bending_stiffness(modulus: float, breadth: float, depth: float, span: float, at: float) -> float:
    """Return the stiffness of a simply supported beam at a place [N/m]: 3 E I L / (a² (L − a)²).

    Parameters
    ----------
    modulus : float
        Young's modulus [Pa].
    breadth, depth : float
        Of the section, the latter along the force [m].
    span, at : float
        Length L, and the force's distance a from one end [m]; rigid at and beyond the ends.
    """
    rest = span - at
    if not 0.0 < at < span:
        return math.inf
    return 3.0 * modulus * breadth * depth**3 / 12.0 * span / (at * rest) ** 2


SOFTWOOD, SOFTWOOD_MODULUS = 0.38, 7e9
"""Specific gravity and Young's modulus [Pa] of Japanese cedar."""

TOP_WOOD = 0.45
"""Specific gravity of a top board of solid wood."""

SCREW, SCREW_IN_STUD, SCREW_IN_STRIP, SCREW_IN_TOP = 0.004, 0.025, 0.018, 0.013
"""Diameter of a screw, and how deep it is in a stud behind 12.5 mm of board, a strip and a top board [m]."""

SCREWS = 2.0
"""Screws at either end of a bracket, a belt or a chain."""

PLATE, PLATE_SCREWS = 0.06, (0.015, 0.045)
"""Leg of a bracket, and its screws' distances from the leg's far end [m]; the device pulls at the other."""

PRYING = sum(r * r for r in PLATE_SCREWS) / (PLATE * PLATE_SCREWS[-1])
"""What a bracket's leg bears, in one screw's strength: it turns about its far end, and the screws' forces
grow with their distance from there."""

PRYING_STIFFNESS = sum(r * r for r in PLATE_SCREWS) / PLATE**2
"""The same of the stiffness where the device pulls."""

SPAN = 2.4
"""Height of a wall whose room has no ceiling [m]."""

STUD_PITCH = (0.303, 0.455)
"""Usual distances between studs in Japan [m]."""


@dataclass(frozen=True, slots=True)
class Fastening:
    """One screw or anchor in what it goes into: drawn straight out, and pushed sideways."""

    pull: Link
    shear: Link


def _wood(label: Phrase, pull: Phrase, shear: Phrase, density: float, depth: float) -> Fastening:
    """Return a wood screw in wood of a specific gravity."""
    mm, mean = 1e3 * SCREW, 1e3 * density
    drawn, slip = 1e3 * 25.0 * mm * 1e3 * depth, 1e3 * 2.0 * mean**1.5 * mm / 23.0  # slip through steel
    withdrawal = screw_withdrawal(density, SCREW, depth)
    sideways = screw_shear(0.082e6 * (1.0 - 0.01 * mm) * mean, SCREW, depth)
    return Fastening(
        Link(label, pull, drawn, withdrawal, 0.002, HANDBOOK, Confidence.MEDIUM),
        Link(label, shear, slip, sideways, 0.005, EUROCODE),
    )


_BOARD = ("anchor in plasterboard", "石こうボード用アンカー")
_PLUG = ("screw and plug in concrete", "コンクリート用プラグとねじ")
_PARTICLE = ("screw in particle board", "パーティクルボードのねじ")

FASTENINGS: Mapping[str, Fastening] = {
    "stud": _wood(
        ("screw in a stud", "下地（間柱）のねじ"),
        ("the screws pull out of the stud", "下地からねじが抜ける"),
        ("the screws in the stud shear", "下地のねじが横にずれて壊れる"),
        SOFTWOOD,
        SCREW_IN_STUD,
    ),
    "plasterboard": Fastening(
        Link(
            _BOARD,
            ("the screws pull out of the plasterboard", "石こうボードからねじが抜ける"),
            361.0 / 0.001,
            361.0,
            0.001,
            "a maker's test of three anchors in 12.5 mm of board (Kokushikan University): 341-376 N, "
            "1.7-2.5 mm at the peak, of which half is taken as plastic",
            Confidence.MEDIUM,
        ),
        Link(
            _BOARD,
            ("the plasterboard crumbles around the screws", "ねじのまわりの石こうボードが崩れる"),
            300e3,
            300.0,
            0.003,
        ),
    ),
    "concrete": Fastening(
        Link(
            _PLUG,
            ("the plugs pull out of the concrete", "コンクリートからプラグが抜ける"),
            5e6,
            2000.0,
            0.001,
        ),
        Link(
            _PLUG,
            ("the screws in the concrete shear", "コンクリートに留めたねじが切れる"),
            5e6,
            3000.0,
            0.002,
        ),
    ),
    "hanging strip": _wood(
        ("screw in a hanging strip", "付け鴨居・長押のねじ"),
        ("the screws pull out of the hanging strip", "付け鴨居からねじが抜ける"),
        ("the screws in the hanging strip shear", "付け鴨居のねじが横にずれて壊れる"),
        SOFTWOOD,
        SCREW_IN_STRIP,
    ),
}
"""A fastener by what the wall is made of."""

_LEAVES_TOP = ("the screws pull out of the furniture's top board", "家具の天板からねじが抜ける")
_TEARS_TOP = ("the screws tear through the furniture's top board", "家具の天板がねじのところで裂ける")
_PARTICLE_SHEAR = screw_shear(50e6 * 4.0**-0.6 * 15.0**0.2, SCREW, SCREW_IN_TOP)
_LEAST = "least of JIS A 5908 for boards of type 18, recalled"

TOPS: Mapping[str, Fastening] = {
    "particle board": Fastening(
        Link(_PARTICLE, _LEAVES_TOP, 1e6, 500.0, 0.002, _LEAST),
        Link(_PARTICLE, _TEARS_TOP, 1e6, _PARTICLE_SHEAR, 0.005, EUROCODE),
    ),
    "solid wood": _wood(
        ("screw in solid wood", "無垢材のねじ"), _LEAVES_TOP, _TEARS_TOP, TOP_WOOD, SCREW_IN_TOP
    ),
}
"""A fastener by what the furniture's top board is made of."""

_TOP_LABEL = ("top board of 18 mm that bends, 0.1 m from a side", "曲がる天板（18 mm、側板から0.1 m）")
_TOP_FAILS = ("the furniture's top board breaks", "家具の天板が割れる")

TOP_BOARDS: Mapping[str, Link] = {
    top: Link(
        _TOP_LABEL,
        _TOP_FAILS,
        bending_stiffness(modulus, 0.3, 0.018, 0.8, 0.1),
        source="bending between the sides of a piece of 0.8 m; the modulus is assumed",
    )
    for top, modulus in (("particle board", 2.5e9), ("solid wood", 8e9))
}
"""What bends where a device lifts or presses the top board, by what that is made of."""

BRACKET = Link(
    ("steel bracket, 40 × 2.3 mm", "鋼製のL型金具（40×2.3 mm）"),
    ("the brackets bend open", "金具が曲がって開く"),
    3.7e6,
    2.0 * 250e6 * 0.040 * 0.0023**2 / 4.0 / 0.015,  # a plastic hinge at either end of 15 mm
    0.01,
    "plastic hinges of 250 MPa; dimensions assumed",
)

BELT = Link(
    ("webbing of polyester, 25 mm", "ポリエステルのベルト（25 mm）"),
    ("the belts tear", "ベルトが切れる"),
    110e3,
    5000.0,
)

CHAIN = Link(
    ("chain of steel with an open hook", "鋼製のチェーンと開いたフック"),
    ("the chains' hooks bend open", "チェーンのフックが伸びて外れる"),
    300e3,
    hook_opening(350e6, 0.005, 0.009),
    0.008,
    "plastic moment of 5 mm wire of 350 MPa; dimensions assumed",
)

POLE = Link(
    ("pole with its screw", "突っ張り棒とそのねじ"),
    ("the pole's screw gives way", "突っ張り棒のねじがすべって縮む"),
    100e3,
    1000.0,
    0.01,
)

CEILING_LINKS: Mapping[str, Link] = {
    "joist": Link(
        ("joist above the board", "天井の野縁"),
        ("the ceiling's joists lift", "天井の野縁が持ち上がる"),
        bending_stiffness(SOFTWOOD_MODULUS, 0.03, 0.04, 0.91, 0.455),
        500.0,
        0.01,
        f"bending over 0.91 m; strength: {FIELD}",
    ),
    "plasterboard": Link(
        ("plasterboard between joists", "野縁の間の石こうボード"),
        ("the pole goes through the ceiling's plasterboard", "天井の石こうボードが突き破られる"),
        bending_stiffness(2.5e9, 0.3, 0.0095, 0.455, 0.2275),
        360.0 * 0.35 / 0.455,
        0.005,
        "JIS A 6901 (a maker's table): 360 N on 350 mm, here 455 mm; the modulus is assumed",
        Confidence.MEDIUM,
    ),
    "concrete": Link(
        ("slab of concrete", "コンクリートの天井"), ("the slab gives way", "天井スラブが壊れる")
    ),
}
"""What a pole pushes against, by what the ceiling is made of; a dropped one bears nothing."""

_STRIP_NAILS = 2.0 * nail_withdrawal(SOFTWOOD, 0.00305, 0.045)


def panel(wall: str, height: float, span: float) -> Link:
    """Return the wall itself as a link: what bends behind the fasteners, and what it is nailed with.

    Parameters
    ----------
    wall : str
        What it is made of: of `FASTENINGS`.
    height : float
        Where the device pulls, above the floor [m].
    span : float
        Height of the wall [m].
    """
    studs = bending_stiffness(SOFTWOOD_MODULUS, 0.03, 0.105, span, height)
    label = ("stud of 30 × 105 mm that bends", "曲がる間柱（30×105 mm）")
    stud = Link(label, ("the studs break", "間柱が折れる"), studs, source="bending over the wall's height")
    match wall:
        case "concrete":
            return Link(("wall of concrete", "コンクリートの壁"), ("the wall breaks", "壁が壊れる"))
        case "hanging strip":
            strip = Link(
                ("hanging strip of 24 × 90 mm between posts", "柱の間の付け鴨居（24×90 mm）"),
                ("the hanging strip is pulled off its posts", "付け鴨居が柱から外れる"),
                bending_stiffness(SOFTWOOD_MODULUS, 0.09, 0.024, 0.91, 0.455),
                _STRIP_NAILS,
                0.002,
                HANDBOOK,
            )
            return in_series(strip, stud)
        case _:
            return stud
