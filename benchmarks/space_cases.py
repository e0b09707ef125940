"""Random bodies, rows and stacks in space, by families of cases alike; `space_random.py` runs them."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    Rng = np.random.Generator

GRAVITY = 9.80665
DURATION, SAMPLE = 0.1, 0.01
"""Of a single body's case, and between samples [s]."""

RATIO = 100.0
"""Ratio of masses up to which no run may be given up."""

FLIES, SLIDES, ROCKS = "flies", "slides without friction", "rocks without a hit"
"""What a case keeps: all momenta; momenta in and about the floor; a body alone also energy."""


class Thrown(NamedTuple):
    """A case: what stands where and how fast, in what room, how the floor moves, and what it keeps."""

    bodies: tuple[sp.Piece, ...]
    room: sp.Room
    motion: sp.Motion
    friction: tuple[float, float]
    keeps: str = ""


def still(duration: float) -> sp.Motion:
    """Return a floor that does not move."""
    return sp.Motion(dt=SAMPLE, x=np.zeros(round(duration / SAMPLE) + 1))


def shaken(rng: Rng, size: float, duration: float = DURATION) -> sp.Motion:
    """Draw a motion of three sines."""
    t = SAMPLE * np.arange(round(duration / SAMPLE) + 1)
    x, y, z = (size * rng.normal() * np.sin(rng.uniform(5.0, 40.0) * t) for _ in range(3))
    return sp.Motion(dt=SAMPLE, x=x, y=y, z=0.5 * z)


def drawn(rng: Rng, kind: str, mass: float, size: float = 1.5, aspect: float = 1.0) -> sp.Body:
    """Draw a box, a cylinder or a hull of points; its height is stretched by ``aspect``."""
    if kind == "box":
        width, length, height = rng.uniform(0.07 * size, size, 3)
        return sp.Body.box(width, length, aspect * height, mass)
    if kind == "cylinder":
        radius, half = rng.uniform(0.07, 0.5, 2) * size
        return sp.Body.cylinder(radius, 2.0 * aspect * half, mass)
    points = rng.uniform(-0.27, 0.27, (rng.integers(5, 16), 3)) + 0.07 * rng.normal(size=3)
    return sp.Body.hull(size * points * (1.0, 1.0, aspect), mass)


def shapes(rng: Rng, count: int) -> list[sp.Body]:
    """Draw bodies of 1 to 200 kg."""
    kinds = ("box", "cylinder", "hull")
    return [drawn(rng, kinds[number % 3], float(rng.uniform(1.0, 200.0))) for number in range(count)]


def raised(standing: sp.Piece, level: float) -> sp.Piece:
    """Return a body whose lowest point is at a level."""
    x, y, z = standing.at
    return replace(standing, at=(x, y, z + level - standing.reach((0.0, 0.0, 1.0))[0]))


def turned(rng: Rng) -> tuple[float, float, float]:
    """Draw a rotation vector."""
    axis = rng.normal(size=3)
    x, y, z = (rng.uniform(0.0, 3.1) * axis / np.linalg.norm(axis)).tolist()
    return x, y, z


def flung(rng: Rng, solid: sp.Body, speed: float = 1.0, rate: float = 3.0, tilt: bool = True) -> sp.Piece:
    """Return a body in any attitude that moves at random."""
    return sp.Piece(
        solid,
        heading=rng.uniform(-3.0, 3.0),
        tilt=turned(rng) if tilt else (0.0, 0.0, 0.0),
        velocity=tuple(rng.normal(0.0, speed, 3)),
        rotation_rate=tuple(rng.normal(0.0, rate, 3)),
    )


def any_floor(rng: Rng) -> sp.Floor:
    """Draw a floor: friction, in half of the cases another one at edges and behind, and restitution."""
    kinetic = rng.uniform(0.5, 1.0)
    static, edge, behind = rng.uniform(size=3).tolist()
    bounce = rng.choice([0.0, rng.uniform(0.0, 0.9)])
    if rng.random() < 0.5:
        return sp.Floor(static, kinetic * static, normal_restitution=bounce)
    return sp.Floor(
        static,
        kinetic * static,
        edge_static_friction=edge,
        edge_kinetic_friction=kinetic * edge,
        left_edge_static_friction=behind,
        left_edge_kinetic_friction=kinetic * behind,
        normal_restitution=bounce,
    )


def any_mass(rng: Rng) -> float:
    """Draw a mass of 1 g to 30 t."""
    return float(10.0 ** rng.uniform(-3.0, math.log10(3e4)))


def single(kind: str, slender: bool = False) -> Callable[[Rng], Thrown]:
    """Return what draws a body that is thrown, or stands, on a floor that is shaken or not."""

    def draw(rng: Rng) -> Thrown:
        shape = kind or str(rng.choice(["box", "cylinder", "hull"]))
        aspect = float(10.0 ** (rng.choice([-1.0, 1.0]) * rng.uniform(0.3, 1.1))) if slender else 1.0
        solid = drawn(rng, shape, any_mass(rng), 0.5 if slender else 1.5, aspect)
        moves = rng.random() < 0.7
        body = flung(rng, solid, tilt=rng.random() < 0.5) if moves else sp.Piece(solid)
        body = raised(body, rng.choice([0.0, 1e-3, 0.05]))
        motion = shaken(rng, rng.choice([0.0, 0.0, 8.0]))
        return Thrown((body,), sp.Room(any_floor(rng)), motion, (0.0, 0.0))

    return draw


def nearly_flat(rng: Rng) -> Thrown:
    """Draw a cylinder that stands or spins nearly flat on its rim."""
    solid = drawn(rng, "cylinder", any_mass(rng), aspect=float(10.0 ** rng.uniform(-1.0, 0.3)))
    way, angle = rng.uniform(-math.pi, math.pi), 10.0 ** rng.uniform(-8.0, -1.0)
    body = sp.Piece(
        solid,
        tilt=(angle * math.cos(way), angle * math.sin(way), 0.0),
        velocity=tuple(rng.choice([0.0, 0.3]) * rng.normal(size=3)),
        rotation_rate=(*(angle * rng.normal(0.0, 3.0, 2)), rng.choice([0.0, 1.0]) * rng.uniform(-20.0, 20.0)),
    )
    body = raised(body, rng.choice([0.0, 1e-6, 1e-3]))
    return Thrown((body,), sp.Room(any_floor(rng)), shaken(rng, rng.choice([0.0, 0.0, 4.0])), (0.0, 0.0))


def in_flight(rng: Rng) -> Thrown:
    body = flung(rng, drawn(rng, str(rng.choice(["box", "hull"])), any_mass(rng)), 3.0, 10.0)
    return Thrown((raised(body, 10.0),), sp.Room(), still(DURATION), (0.0, 0.0), FLIES)


def on_ice(rng: Rng) -> Thrown:
    """Draw a body that is thrown onto a floor without friction that gives back all."""
    body = flung(rng, drawn(rng, str(rng.choice(["box", "hull"])), any_mass(rng)))
    room = sp.Room(sp.Floor(0.0, 0.0, normal_restitution=1.0))
    return Thrown((raised(body, rng.choice([1e-3, 0.05])),), room, still(0.4), (0.0, 0.0), SLIDES)


def on_an_edge(rng: Rng) -> Thrown:
    """Draw a box that rocks on an edge or a corner, and does not land within the time."""
    width, length, height = rng.uniform((0.5, 0.5, 0.5), (1.5, 1.5, 2.0))
    solid = sp.Body.box(width, length, height, any_mass(rng))
    over, reach = np.array([0.0, 1.0, 0.0]), width
    if rng.random() < 0.5:
        reach = math.hypot(width, length)
        over = np.array([length, width, 0.0]) / reach
    tilt = rng.uniform(0.5, 0.9) * math.atan(reach / height) * over
    body = raised(sp.Piece(solid, tilt=tuple(tilt)), 0.0)
    corners = body.at + solid.solid.vertices @ body.turn.T
    spin = rng.uniform(0.0, 0.5) * over
    lever = body.place - corners[np.argmin(corners[:, 2])]
    body = replace(body, velocity=tuple(np.cross(spin, lever)), rotation_rate=tuple(spin))
    return Thrown((body,), sp.Room(sp.Floor(5.0, 5.0)), still(DURATION), (0.0, 0.0), ROCKS)


def case_of(rng: Rng, pool: list[sp.Body]) -> Thrown:
    """Draw a case: one body, or a stack of two or three; what is uppermost is thrown, or stands there."""
    count = int(rng.choice([1, 1, 2, 3]))
    return stack(rng, [pool[rng.integers(len(pool))] for _ in range(count)])


def stack(rng: Rng, solids: list[sp.Body], duration: float = DURATION, keeps: str = "") -> Thrown:
    """Put bodies on each other, the uppermost thrown in most cases; what slides does so without friction."""
    bodies: list[sp.Piece] = []
    top = 0.0
    for number, solid in enumerate(solids):
        last = number == len(solids) - 1
        gap = rng.choice([0.0, 1e-3, 0.05]) if last else 0.0
        thrown = last and rng.random() < 0.7
        body = flung(rng, solid, tilt=False) if thrown else sp.Piece(solid, heading=rng.uniform(-3.0, 3.0))
        bodies.append(raised(replace(body, at=(*rng.uniform(-0.1, 0.1, 2), 0.0)), top + gap))
        top += gap + float(np.ptp(solid.solid.vertices[:, 2])) + 1e-9
    static, between = rng.uniform(0.0, 1.0, 2)
    floor = sp.Floor(
        static, static * rng.uniform(0.5, 1.0), normal_restitution=rng.choice([0.0, rng.uniform(0, 0.8)])
    )
    motion = shaken(rng, rng.choice([0.0, 0.0, 8.0]), duration)
    if keeps == SLIDES:
        bounce = floor.normal_restitution
        floor = sp.Floor(0.0, 0.0, normal_restitution=bounce, rolling_resistance=0.0)
        motion = still(duration)
    return Thrown(tuple(bodies), sp.Room(floor), motion, (between, 0.8 * between), keeps)


def tipped(solid: sp.Body, edge: float, rate: float) -> sp.Piece:
    """Return a body that turns about its base edge at x = edge."""
    spin = np.array([0.0, rate, 0.0])
    lever = solid.solid.centre_of_gravity - np.array([edge, 0.0, 0.0])
    return sp.Piece(solid, velocity=tuple(np.cross(spin, lever)), rotation_rate=tuple(spin))


def row_of(
    count: int, solid: sp.Body, apart: float, rate: float, floor: float, between: float, duration: float
) -> Thrown:
    """Return bodies in a row of which the first is tipped towards the others."""
    first = tipped(solid, float(solid.solid.vertices[:, 0].max()), rate)
    bodies = first, *(sp.Piece(solid, (apart * n, 0.0, 0.0)) for n in range(1, count))
    return Thrown(bodies, sp.Room(sp.Floor(floor, floor)), still(duration), (between, between))


def row(sides: tuple[tuple[float, float], ...], density: float, duration: float) -> Callable[[Rng], Thrown]:
    """Return what draws a row: its bodies' least and most width, length and height [m], and density."""

    def draw(rng: Rng) -> Thrown:
        width, length, height = (float(rng.uniform(*side)) for side in sides)
        solid = sp.Body.box(width, length, height, density * width * length * height)
        size = 0.5 * math.hypot(width, height)
        over = math.sqrt(1.5 * GRAVITY * (1.0 - 0.5 * height / size) / size)  # just tips it
        apart, (floor, between) = width + height * rng.uniform(0.02, 0.6), rng.uniform((0.2, 0.1), (0.8, 0.6))
        return row_of(
            int(rng.integers(2, 13)), solid, apart, over * rng.uniform(0.9, 1.6), floor, between, duration
        )

    return draw


def tower(most: int, least_ratio: float, ratio: float) -> Callable[[Rng], Thrown]:
    """Return what draws a tower of boxes and cylinders that is shaken; masses differ by up to a ratio."""

    def draw(rng: Rng) -> Thrown:
        count = int(rng.integers(2, most + 1))
        masses = 10.0 ** (rng.uniform(0.0, 2.0, count) - (2.0 if least_ratio > 1.0 else 0.0))
        if least_ratio > 1.0:
            heavy, light = rng.choice(count, 2, replace=False)
            masses[heavy] = masses[light] * 10.0 ** rng.uniform(*np.log10((least_ratio, ratio)))
        bodies: list[sp.Piece] = []
        top = 0.0
        for mass in masses.tolist():
            a, b, height = rng.uniform((0.3, 0.3, 0.1), (0.6, 0.6, 0.4))
            solid = (
                sp.Body.box(a, b, height, mass)
                if rng.random() < 0.8
                else sp.Body.cylinder(a / 2, height, mass)
            )
            at = (*rng.uniform(-0.03, 0.03, 2), top)
            bodies.append(sp.Piece(solid, at, heading=rng.choice([0.0, rng.uniform(-3.0, 3.0)])))
            top += height
        static, between = rng.uniform(0.1, 0.8, 2)
        motion = shaken(rng, rng.choice([0.0, 2.0, 8.0]), 2.0)
        return Thrown(
            tuple(bodies), sp.Room(sp.Floor(static, 0.8 * static)), motion, (between, 0.8 * between)
        )

    return draw


def pyramid(rng: Rng) -> Thrown:
    """Draw a pyramid of boxes that is shaken, or that a box is thrown at."""
    base, mass = int(rng.integers(2, 5)), float(rng.uniform(1.0, 50.0))
    width, length, height = rng.uniform((0.2, 0.2, 0.1), (0.5, 0.5, 0.4))
    solid, apart = sp.Body.box(width, length, height, mass), width * rng.uniform(1.02, 1.5)
    bodies = [
        sp.Piece(solid, (apart * (n + 0.5 * level), 0.0, height * level))
        for level in range(base)
        for n in range(base - level)
    ]
    if thrown := rng.random() < 0.5:
        struck = flung(rng, drawn(rng, "box", mass * rng.uniform(0.1, 3.0), 0.5), 0.5)
        at = (-2.0, rng.uniform(-0.2, 0.2), 0.0)
        struck = raised(
            replace(struck, at=at, velocity=(rng.uniform(4.0, 8.0), 0.0, 1.0)), rng.uniform(0.1, 0.5)
        )
        bodies.append(struck)
    friction = rng.uniform(0.2, 0.7, 2)
    motion = still(1.5) if thrown else shaken(rng, 6.0, 1.5)
    return Thrown(tuple(bodies), sp.Room(sp.Floor(friction[0], friction[0])), motion, (friction[1],) * 2)


def pile_of(rng: Rng, solids: Iterable[sp.Body], across: int, duration: float) -> Thrown:
    """Drop bodies of up to 0.5 m in layers, in any attitude."""
    bodies: list[sp.Piece] = []
    for number, solid in enumerate(solids):
        layer, place = divmod(number, across * across)
        x, y = divmod(place, across)
        body = flung(rng, solid, 0.2, 0.5)
        near = rng.uniform(-0.04, 0.04, 2) + 0.65 * np.array([x, y])
        bodies.append(
            raised(replace(body, at=(*(near - (body.place - body.at)[:2]), 0.0)), 0.02 + 0.7 * layer)
        )
    static, between, e = rng.uniform((0.2, 0.1, 0.0), (0.7, 0.6, 0.3))
    room = sp.Room(sp.Floor(static, 0.8 * static, normal_restitution=rng.choice([0.0, e])))
    return Thrown(tuple(bodies), room, still(duration), (between, 0.8 * between))


def pile(rng: Rng) -> Thrown:
    kinds = rng.choice(["box", "cylinder", "hull"], int(rng.integers(3, 13)))
    solids = [drawn(rng, str(kind), float(10.0 ** rng.uniform(0.0, 1.9)), 0.3) for kind in kinds]
    return pile_of(rng, solids, 2, 1.5)


def in_the_air(rng: Rng) -> Thrown:
    """Draw two or three bodies that fly at each other."""
    bodies: list[sp.Piece] = []
    for number in range(int(rng.integers(2, 4))):
        kind = str(rng.choice(["box", "cylinder", "hull"]))
        body = flung(rng, drawn(rng, kind, float(10.0 ** rng.uniform(0.0, 2.0)), 0.5), 0.3)
        x = 1.2 * number
        flies = (rng.uniform(3.0, 5.0) * (1.0, -0.2, -1.0)[number], *rng.normal(0.0, 0.2, 2))
        bodies.append(raised(replace(body, at=(x, 0.0, 0.0), velocity=flies), 10.0))
    between = rng.uniform(0.0, 1.0)
    return Thrown(tuple(bodies), sp.Room(), still(0.4), (between, between), FLIES)


def stacks(rng: Rng) -> Thrown:
    return stack(rng, shapes(rng, 3)[: rng.integers(2, 4)])


def stacks_on_ice(rng: Rng) -> Thrown:
    return stack(rng, shapes(rng, 3)[: rng.integers(2, 4)], 0.3, SLIDES)


def two_light(rng: Rng) -> Thrown:
    """Draw two bodies of 3 to 100 kg for 0.6 s: of such a case there were 700,343 steps."""
    kinds = rng.choice(["box", "cylinder", "hull"], 2)
    solids = [drawn(rng, str(kind), float(10.0 ** rng.uniform(math.log10(3.0), 2.0))) for kind in kinds]
    return stack(rng, solids, 0.6)


def heavy_on_light(rng: Rng) -> Thrown:
    """Draw 26 t on 0.3 kg for 0.02 s: such a case took 56 s."""
    kinds = rng.choice(["box", "cylinder", "hull"], 2)
    solids = [drawn(rng, str(kind), mass) for kind, mass in zip(kinds, (0.3, 26e3), strict=True)]
    return stack(rng, solids, 0.02)


def twenty_shelves(rng: Rng) -> Thrown:
    return row_of(20, sp.Body.box(0.32, 0.9, 2.1, 120.0), 0.75, 0.75, 0.4, 0.3, 10.0)


def hundred_boxes(rng: Rng) -> Thrown:
    solids = [drawn(rng, "box", float(rng.uniform(2.0, 20.0)), 0.35) for _ in range(100)]
    return pile_of(rng, solids, 4, 4.0)


class Family(NamedTuple):
    """Cases alike: how many, what draws one, and the processor time after which it is ended [s]."""

    cases: int
    draw: Callable[[Rng], Thrown]
    limit: float


SHELVES, DOMINOES = (((0.25, 0.45), (0.6, 1.2), (1.5, 2.2)), ((0.007, 0.02), (0.02, 0.1), (0.04, 0.1)))
FAMILIES = {
    "boxes": Family(20_000, single("box"), 2.0),
    "cylinders": Family(20_000, single("cylinder"), 2.0),
    "hulls": Family(20_000, single("hull"), 2.0),
    "slender and squat": Family(15_000, single("", slender=True), 2.0),
    "nearly flat rims": Family(15_000, nearly_flat, 2.0),
    "in flight": Family(3_000, in_flight, 2.0),
    "on ice": Family(4_000, on_ice, 2.0),
    "on an edge": Family(3_000, on_an_edge, 2.0),
    "stacks of 2-3": Family(150, stacks, 10.0),
    "stacks on ice": Family(100, stacks_on_ice, 10.0),
    "hits in the air": Family(100, in_the_air, 10.0),
    "rows of shelves": Family(100, row(SHELVES, 200.0, 3.0), 30.0),
    "rows of dominoes": Family(100, row(DOMINOES, 600.0, 1.0), 30.0),
    "towers": Family(150, tower(10, 1.0, RATIO), 30.0),
    "pyramids": Family(75, pyramid, 30.0),
    "piles": Family(75, pile, 30.0),
    "towers beyond": Family(75, tower(4, RATIO, 1e5), 30.0),
    "two of 3-100 kg": Family(50, two_light, 30.0),
    "26 t on 0.3 kg": Family(23, heavy_on_light, 30.0),
    "20 shelves": Family(1, twenty_shelves, 300.0),
    "100 boxes": Family(1, hundred_boxes, 600.0),
}
"""By their names; those up to "on an edge" are of one body."""
