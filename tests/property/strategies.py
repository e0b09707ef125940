"""Bodies, rooms, motions and devices: Hypothesis strategies, and random samples by the hundred from a seed.

Both make their values by the same functions, from a `Source`. Hypothesis draws each number, so it can
shrink a case that breaks a law to a simple one; a seed gives large samples cheaply.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Protocol

import numpy as np
from hypothesis import strategies as st

from stayput import Body, Ceiling, Floor, Motion, Room, State, Wall
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import no_elements
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.state import standing_corners

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

COULOMB, PAPER = 0, 1
LAWS = ("coulomb", "paper")


class Source(Protocol):
    """Where the random values come from."""

    def uniform(self, low: float, high: float) -> float: ...

    def whole(self, low: int, high: int) -> int: ...


@dataclass(frozen=True)
class Drawn:
    """Values that Hypothesis draws, and shrinks when a property fails."""

    draw: st.DrawFn

    def uniform(self, low: float, high: float) -> float:
        return self.draw(st.floats(low, high))

    def whole(self, low: int, high: int) -> int:
        return self.draw(st.integers(low, high))


@dataclass(frozen=True)
class Seeded:
    """Values from a generator, for cases by the hundred."""

    rng: np.random.Generator

    def uniform(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))

    def whole(self, low: int, high: int) -> int:
        return int(self.rng.integers(low, high + 1))


def _among(source: Source, low: float, high: float) -> float:
    """Return a value spread evenly over the orders of magnitude."""
    return math.exp(source.uniform(math.log(low), math.log(high)))


def _one_in(source: Source, n: int) -> bool:
    return source.whole(1, n) == n


def random_body(source: Source, *, wedges: bool = True) -> Body:
    width = _among(source, 0.05, 3.0)
    height = min(max(width * _among(source, 0.1, 12.0), 0.05), 3.0)
    e_x = e_z = 0.0
    if _one_in(source, 2):
        e_x, e_z = source.uniform(-0.45, 0.45) * width, source.uniform(-0.45, 0.45) * height
    mass = _among(source, 0.1, 2000.0)
    inertia = None
    if _one_in(source, 3):
        inertia = source.uniform(0.1, 3.0) * mass * (width**2 + height**2) / 12.0
    base_heights = (0.0, 0.0)
    if wedges and _one_in(source, 5):
        lift = source.uniform(-0.04, 0.04) * min(width, height)
        base_heights = (lift, 0.0) if _one_in(source, 2) else (0.0, lift)
    return Body(width, height, mass, (e_x, e_z), inertia, base_heights)


def random_floor(source: Source) -> Floor:
    static = 0.0 if _one_in(source, 12) else source.uniform(0.0, 1.2)
    kinetic = static if _one_in(source, 2) else static * source.uniform(0.0, 1.0)
    edge = edge_kinetic = None
    if _one_in(source, 3):
        edge = source.uniform(0.0, 1.2)
        edge_kinetic = edge * source.uniform(0.0, 1.0)
    restitution = 1.0 if _one_in(source, 2) else source.uniform(0.0, 1.0)
    normal = 0.0 if _one_in(source, 2) else source.uniform(0.0, 0.9)
    return Floor(static, kinetic, edge, edge_kinetic, restitution, normal)


def _wall(source: Source) -> Wall | None:
    how = source.whole(0, 5)
    if how <= 2:
        return None
    gap = 0.0 if how == 3 else (_among(source, 1e-6, 1e-2) if how == 4 else source.uniform(0.005, 0.5))
    return Wall(gap, source.uniform(0.0, 1.0), 0.0 if _one_in(source, 6) else source.uniform(0.0, 1.2))


def random_room(source: Source, body: Body, *, walls: bool = True) -> Room:
    floor = random_floor(source)
    if not walls:
        return Room(floor)
    left, right, ceiling = _wall(source), _wall(source), None
    if _one_in(source, 4):
        top = max(z for _, z in standing_corners(body, State()))
        gap = 0.0 if _one_in(source, 5) else _among(source, 1e-5, 0.3)
        friction = source.uniform(0.0, 1.2)
        ceiling = Ceiling(top * (1.0 + 1e-15) + gap, source.uniform(0.0, 1.0), friction)
    return Room(floor, left, right, ceiling)


def clear_of_the_room(body: Body, room: Room, start: State) -> bool:
    """Whether no corner of the body is inside a wall or the ceiling at the start."""
    return min(clearances(body, room, np.array([standing_corners(body, start)]))[0]) >= 0.0


def clearances(body: Body, room: Room, corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Least distances of corners, shape [n, 4, 2], from floor, walls and ceiling, shape [n, 4] [m]."""
    rest = standing_corners(body, State())
    x, z = corners[:, :, 0], corners[:, :, 1]
    found = np.full((len(corners), 4), np.inf)
    found[:, 0] = z.min(axis=1)
    if room.right_wall is not None:
        found[:, 1] = max(c[0] for c in rest) + room.right_wall.gap - x.max(axis=1)
    if room.left_wall is not None:
        found[:, 2] = x.min(axis=1) - (min(c[0] for c in rest) - room.left_wall.gap)
    if room.ceiling is not None:
        found[:, 3] = room.ceiling.height - z.max(axis=1)
    return found


def random_state(source: Source, body: Body, room: Room) -> State:
    """Return an initial state: at rest in every second case, and where it would be in a wall."""
    if _one_in(source, 2):
        return State()
    slender = min(abs(angle) for angle in body.slenderness)
    tilt = source.uniform(-1.2, 1.2) * slender if _one_in(source, 2) else 0.0
    tilt = min(max(tilt, -1.5), 1.5)
    tilt_rate = source.uniform(-3.0, 3.0) if _one_in(source, 2) else 0.0
    slide_rate = source.uniform(-3.0, 3.0) if _one_in(source, 2) else 0.0
    slide = source.uniform(-0.2, 0.2) if _one_in(source, 4) else 0.0
    state = State(tilt, tilt_rate, slide, slide_rate)
    return state if clear_of_the_room(body, room, state) else State()


def random_samples(source: Source, n: int, dt: float, largest: float, kind: int) -> NDArray[np.float64]:
    """Return n samples of acceleration, at most ``largest``: noise, a pulse, a sine or steps [m/s²]."""
    time = np.arange(n) * dt
    amplitude = largest * (source.uniform(0.0, 1.0) if not _one_in(source, 4) else 1.0)
    if kind == 0:
        rng = np.random.default_rng(source.whole(0, 2**32 - 1))
        values = rng.standard_normal(n)
        width = source.whole(1, max(1, int(0.3 / dt)))
        values = np.convolve(values, np.ones(width), "same")
        return amplitude * values / max(1e-300, np.abs(values).max())
    if kind == 1:
        begin, length = source.uniform(0.0, 0.3 * n * dt), _among(source, 2 * dt, 1.5)
        return np.where((time >= begin) & (time < begin + length), amplitude, 0.0)
    if kind == 2:
        frequency = _among(source, 0.2, min(10.0, 0.2 / dt))
        stop = source.uniform(0.3, 1.0) * n * dt
        sine = amplitude * np.sin(2.0 * math.pi * frequency * time + source.uniform(0.0, 6.3))
        return np.where(time <= stop, sine, 0.0)
    rng = np.random.default_rng(source.whole(0, 2**32 - 1))
    length = max(2, int(_among(source, 0.1, 2.0) / dt))
    levels = rng.uniform(-amplitude, amplitude, -(-n // length))
    return np.repeat(levels * (rng.uniform(size=len(levels)) < 0.8), length)[:n]


def random_motion(
    source: Source,
    *,
    kind: int | None = None,
    longest: int = 2000,
    seconds: tuple[float, float] = (2.0, 20.0),
) -> Motion:
    """Return a motion of the floor: up to 3 g along, in every third case up to 2 g up."""
    dt = _among(source, 0.002, 0.05)
    n = min(longest, max(20, int(source.uniform(*seconds) / dt)))
    how = source.whole(0, 3) if kind is None else kind
    x = random_samples(source, n, dt, 3.0 * STANDARD_GRAVITY, how)
    z = random_samples(source, n, dt, 2.0 * STANDARD_GRAVITY, how) if _one_in(source, 3) else None
    return Motion(dt, x, z=z)


@dataclass(frozen=True)
class Standing:
    """A body, its room and its initial state: a case apart from its motion."""

    body: Body
    room: Room
    start: State

    def columns(self) -> NDArray[np.void]:
        return case_columns(self.body, self.room, self.start, STANDARD_GRAVITY)


def random_standing(source: Source, *, walls: bool = True, wedges: bool = True) -> Standing:
    body = random_body(source, wedges=wedges)
    room = random_room(source, body, walls=walls)
    return Standing(body, room, random_state(source, body, room))


def up(motion: Motion) -> NDArray[np.float64]:
    """Return the vertical acceleration, zeros where there is none [m/s²]."""
    return np.zeros_like(motion.x) if motion.z is None else motion.z


def stacked(cases: Sequence[Standing]) -> NDArray[np.void]:
    """Return the columns of many cases, shape [m]."""
    return np.concatenate([case.columns() for case in cases])


def mirrored(case: Standing) -> Standing:
    """Return the case with right and left exchanged."""
    body, room, start = case.body, case.room, case.start
    return Standing(
        replace(
            body, cg_offset=(-body.cg_offset[0], body.cg_offset[1]), base_heights=body.base_heights[::-1]
        ),
        replace(room, left_wall=room.right_wall, right_wall=room.left_wall),
        State(-start.tilt, -start.tilt_rate, -start.slide, -start.slide_rate),
    )


def scaled(case: Standing, k: float) -> Standing:
    """Return the case with lengths × k and times × √k: accelerations and angles stay."""
    body, room, start = case.body, case.room, case.start
    root = math.sqrt(k)

    def moved(wall: Wall | None) -> Wall | None:
        return None if wall is None else replace(wall, gap=wall.gap * k)

    ceiling = None if room.ceiling is None else replace(room.ceiling, height=room.ceiling.height * k)
    return Standing(
        Body(
            body.width * k,
            body.height * k,
            body.mass,
            (body.cg_offset[0] * k, body.cg_offset[1] * k),
            body.inertia_about_cg * k * k,
            (body.base_heights[0] * k, body.base_heights[1] * k),
        ),
        Room(room.floor, moved(room.left_wall), moved(room.right_wall), ceiling),
        State(start.tilt, start.tilt_rate / root, start.slide * k, start.slide_rate * root),
    )


def random_element(source: Source, standing: Standing) -> NDArray[np.void]:
    """Return one element, shape [1], on a body that stands at rest."""
    e = no_elements(1)[0:1]
    body = standing.body
    corners = body.corners
    left, right = corners[0][0], corners[1][0]
    bottom, top = min(corners[0][1], corners[1][1]), corners[2][1]
    g = 9.8
    stiffness = g / (_among(source, 1e-5, 0.1))  # bears its weight with this elongation
    e["stiffness"][:, 0] = stiffness
    if not _one_in(source, 3):
        e["damping"][:, 0] = 2.0 * math.sqrt(stiffness) * _among(source, 1e-3, 1.5)
    e["u"], e["v"] = source.uniform(left, right), source.uniform(bottom, top)
    if _one_in(source, 2):
        e["v"] = top
    strength = g * _among(source, 0.01, 10.0)
    how = source.whole(0, 4)
    if how <= 1:
        e["kind"] = el.AXIAL
        reach = _among(source, 0.02, 1.0)
        angle = source.uniform(-math.pi, math.pi)
        rest = standing_corners(body, State())
        tilt = body.resting_tilt
        u, v = float(e["u"][0]) - corners[0][0], float(e["v"][0]) - corners[0][1]
        x = rest[0][0] + u * math.cos(tilt) + v * math.sin(tilt)
        z = rest[0][1] + v * math.cos(tilt) - u * math.sin(tilt)
        e["x"], e["z"], e["length"] = x + reach * math.cos(angle), z + reach * math.sin(angle), reach
        e["slack_plus"][:, 0] = 0.0 if _one_in(source, 2) else _among(source, 1e-4, 0.1)
        if how == 1:
            e["slack_minus"][:, 0] = source.whole(0, 1) * float(e["slack_plus"][0, 0])
        e["limit_plus"][:, 0] = strength
        if _one_in(source, 2):
            e["limit_minus"][:, 0] = strength
        if _one_in(source, 2):
            e["ultimate"][:, 0] = _among(source, 1e-4, 0.1)
        return e
    e["kind"] = el.PLANAR
    plane = source.whole(0, 3)
    e["cos"], e["sin"] = ((1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (-1.0, 0.0))[plane]
    e["stiffness"][:, 1] = 0.0 if _one_in(source, 4) else stiffness * _among(source, 0.05, 1.0)
    e["slack_plus"][:, 1] = e["slack_minus"][:, 1] = 0.0 if _one_in(source, 2) else _among(source, 1e-4, 0.1)
    if how == 2:  # a pole
        e["slack_minus"][:, 0] = -g * _among(source, 0.01, 1.0) / stiffness
        e["limit_minus"][:, 0] = strength + g
        e["damping"] = 0.0
        e["friction"] = source.uniform(0.0, 1.0)
        e["drops_out"] = source.whole(0, 1)
        return e
    e["slack_plus"][:, 0] = 0.0 if _one_in(source, 2) else _among(source, 1e-4, 0.02)
    if how == 4:
        e["slack_minus"][:, 0] = 0.0
    e["limit_plus"][:, 0] = strength
    if _one_in(source, 2):
        e["limit_plus"][:, 1] = e["limit_minus"][:, 1] = strength * _among(source, 0.3, 3.0)
        if _one_in(source, 2):
            e["interaction"] = 1
    if int(e["interaction"][0]) == 0 and _one_in(source, 3):
        e["ultimate"] = _among(source, 1e-4, 0.1)
    if not _one_in(source, 3):
        e["damping"][:, 1] = e["damping"][:, 0] if float(e["stiffness"][0, 1]) > 0.0 else 0.0
    return e


def random_elements(source: Source, standing: Standing, most: int = 3) -> NDArray[np.void]:
    """Return a row of ``most`` elements, some of them of no kind."""
    rows = no_elements(most)
    for n in range(source.whole(1, most)):
        rows[n : n + 1] = random_element(source, standing)
    return rows


def mirrored_elements(elements: NDArray[np.void]) -> NDArray[np.void]:
    """Return elements with right and left exchanged."""
    image = elements.copy()
    image["u"], image["x"] = -elements["u"], -elements["x"]
    image["sin"] = -elements["sin"]
    # along the mirrored tangent what was to one side is to the other
    for side, other in (("slack_plus", "slack_minus"), ("limit_plus", "limit_minus")):
        image[side][..., 1], image[other][..., 1] = elements[other][..., 1], elements[side][..., 1]
    return image


@st.composite
def sources(draw: st.DrawFn) -> Source:
    """Draw a source, for values that depend on one another in ways that a test says."""
    return Drawn(draw)


@st.composite
def standings(draw: st.DrawFn, *, walls: bool = True, wedges: bool = True) -> Standing:
    """Draw bodies in rooms."""
    return random_standing(Drawn(draw), walls=walls, wedges=wedges)


@st.composite
def motions(
    draw: st.DrawFn,
    *,
    kind: int | None = None,
    longest: int = 2000,
    seconds: tuple[float, float] = (2.0, 20.0),
) -> Motion:
    """Draw motions of the floor."""
    return random_motion(Drawn(draw), kind=kind, longest=longest, seconds=seconds)


@st.composite
def batches(draw: st.DrawFn, most: int = 6, *, walls: bool = True) -> list[Standing]:
    """Draw a few bodies in rooms, to be run as one batch."""
    return draw(st.lists(standings(walls=walls), min_size=1, max_size=most))


@st.composite
def held_batches(draw: st.DrawFn, most: int = 3) -> tuple[list[Standing], NDArray[np.void]]:
    """Draw a few bodies in rooms with their elements, ELEMENT of shape [cases, 3]."""
    cases = draw(batches(most))
    return cases, np.stack([random_elements(Drawn(draw), case) for case in cases])


SEEDS = st.integers(0, 2**32 - 1)
"""Seeds of large random samples."""
