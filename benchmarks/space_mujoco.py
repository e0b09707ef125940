"""Boxes in space beside MuJoCo: what both say, and what it costs, as tables in Markdown.

``python benchmarks/space_mujoco.py [PART ...]``: `boxes` that rock alone and their cost at equal accuracy, a
`row` of shelves and rows of `dominoes` of which the first is tipped, `towers` under strong shaking, and
`rest`, how far a box creeps in MuJoCo that is pushed with half of what friction holds; all where none is
said. The error of an engine is that against its own finest steps. The axes are the floor's: bodies feel a
force −m a in both. MuJoCo's contacts are soft; one coefficient of friction holds. Times are those of a core
without making the models; compare the ratios.
"""

from __future__ import annotations

import argparse
import math
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from mujoco import rollout

import stayput as sp
from csv_tables import tell, three

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

GRAVITY = 9.80665
SOFTNESS = 4.0
"""Time constant of a contact, in steps; MuJoCo allows 2."""

CHUNK = 20_000
"""Steps of MuJoCo whose states are kept at a time."""

_MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -9.80665" cone="elliptic" impratio="10" integrator="implicitfast"/>
  <default><geom condim="3" friction="{between} 0 0" solref="{soft} 1" solimp="0.99 0.999 0.0001"/></default>
  <worldbody>
    <geom type="plane" size="0 0 1" friction="{floor} 0 0"/>
    {bodies}
  </worldbody>
</mujoco>
"""


@dataclass(frozen=True, slots=True)
class Scene:
    """Boxes by width, length, height [m] and mass [kg], where they stand, and how they are shaken.

    ``friction`` is that of the floor, and that between boxes, which must not be larger: MuJoCo takes the
    larger of what two surfaces have. The boxes stand on each other where ``apart`` is 0, or in a row at that
    distance [m], the first turning about its front edge at ``rate`` [rad/s].
    """

    boxes: Sequence[tuple[float, float, float, float]]
    friction: tuple[float, float]
    motion: sp.Motion
    apart: float = 0.0
    rate: float = 0.0

    def standing(self) -> list[sp.Piece]:
        """Return the boxes."""
        found: list[sp.Piece] = []
        level = 0.0
        for number, (width, length, height, mass) in enumerate(self.boxes):
            rate = 0.0 if number else self.rate
            velocity = 0.5 * height * rate, 0.0, 0.5 * width * rate
            at = (number * self.apart, 0.0, level)
            solid = sp.Body.box(width, length, height, mass)
            found.append(sp.Piece(solid, at, velocity=velocity, rotation_rate=(0.0, rate, 0.0)))
            level += 0.0 if self.apart else height
        return found


@dataclass(frozen=True, slots=True)
class Histories:
    """Tilts [rad], kinetic energies [J], (boxes, samples), places (boxes, samples, 3) [m], and time [s]."""

    tilts: Array
    energies: Array
    places: Array
    seconds: float


def run_in_mujoco(scene: Scene, step: float) -> Histories:
    """Run a scene in MuJoCo's own loop, on this thread."""
    standing, motion = scene.standing(), scene.motion
    places = [one.place for one in standing]
    bodies = "".join(
        f'<body pos="{at[0]} {at[1]} {at[2]}"><freejoint/><geom type="box" mass="{mass}"'
        f' size="{width / 2} {length / 2} {height / 2}"/></body>'
        for at, (width, length, height, mass) in zip(places, scene.boxes, strict=True)
    )
    floor, between = scene.friction
    text = _MODEL.format(step=step, soft=SOFTNESS * step, floor=floor, between=between, bodies=bodies)
    model = mujoco.MjModel.from_xml_string(text)
    data, n = mujoco.MjData(model), len(standing)
    data.qvel[:] = np.concatenate([(*one.velocity, *one.rotation_rate) for one in standing])
    samples, each = len(motion.x), round(motion.dt / step)
    grid = motion.dt * np.arange(samples)
    middles = (np.arange(each * (samples - 1)) + 0.5) * step
    push = np.zeros((len(middles), n, 6))
    masses = np.array([box[3] for box in scene.boxes])
    for axis, name in enumerate("xyz"):
        if name in motion.components:
            a = np.interp(middles, grid, getattr(motion, name))
            push[:, :, axis] = -masses * a[:, np.newaxis]
    push = push.reshape(len(middles), -1)
    state = np.concatenate([[0.0], data.qpos, data.qvel])
    spec = int(mujoco.mjtState.mjSTATE_QFRC_APPLIED.value)
    kept, warm, seconds = [state[np.newaxis]], np.zeros(model.nv), 0.0
    lengths = range(0, len(middles), each * max(1, CHUNK // each))
    for begin in lengths:
        part = push[begin : begin + lengths.step]
        start = time.process_time()
        found, _ = rollout.rollout(
            model, data, state, part[np.newaxis], control_spec=spec, initial_warmstart=warm
        )
        seconds += time.process_time() - start
        kept.append(found[0, each - 1 :: each])
        state, warm = found[0, -1].copy(), np.array(data.qacc_warmstart)
    states = np.concatenate(kept)
    poses = states[:, 1 : 1 + 7 * n].reshape(-1, n, 7)
    rates = states[:, 1 + 7 * n :].reshape(-1, n, 6)
    tilts = np.arccos(np.clip(1.0 - 2.0 * (poses[..., 4] ** 2 + poses[..., 5] ** 2), -1.0, 1.0))
    inertia = np.stack([np.diag(one.solid.inertia) for one in standing])
    energies = 0.5 * (
        masses * (rates[..., :3] ** 2).sum(axis=2) + (inertia * rates[..., 3:] ** 2).sum(axis=2)
    )
    return Histories(tilts.T, energies.T, poses[..., :3].transpose(1, 0, 2), seconds)


def run_in_stayput(scene: Scene, step: float) -> Histories:
    """Run the same here."""
    pieces, both = scene.standing(), (scene.friction[1], scene.friction[1])
    room = sp.Room(sp.Floor(scene.friction[0], scene.friction[0]))
    start = time.process_time()
    run = sp.simulate(sp.Scene(pieces, room, friction=both), scene.motion, step=step)
    seconds = time.process_time() - start
    inertia = np.stack([np.diag(one.solid.inertia) for one in run.standing])
    masses = np.array([one.solid.mass for one in run.standing])
    own = np.einsum("bsij,bsi->bsj", run.turn, run.rotation_rate)
    linear = masses[:, np.newaxis] * (run.velocity**2).sum(axis=2)
    energies = 0.5 * (linear + np.einsum("bj,bsj->bs", inertia, own**2))
    tilts = np.stack([piece.tilt for piece in run.pieces]) * (math.nan if run.given_up else 1.0)
    return Histories(tilts, energies, run.place, seconds)


def in_mujoco(
    boxes: Sequence[tuple[float, float, float, float]],
    friction: tuple[float, float],
    motion: sp.Motion,
    step: float,
) -> tuple[Array, Array]:
    """Return tilts (boxes, samples) [rad] and places (boxes, samples, 3) [m] of boxes on each other."""
    found = run_in_mujoco(Scene(boxes, friction, motion), step)
    return found.tilts, found.places


def in_stayput(
    boxes: Sequence[tuple[float, float, float, float]],
    friction: tuple[float, float],
    motion: sp.Motion,
    step: float,
) -> sp.Run:
    """Run the same here."""
    floor, between = friction
    pieces = Scene(boxes, friction, motion).standing()
    return sp.simulate(
        sp.Scene(pieces, sp.Room(sp.Floor(floor, floor)), friction=(between, between)), motion, step=step
    )


def two_components(size: float, duration: float = 2.0) -> sp.Motion:
    """Return a pulse along x with a slower one along y [m/s²]; both end before the motion does."""
    t = 0.01 * np.arange(round(duration / 0.01) + 1)
    x = size * np.where(t < 0.7, np.sin(2.0 * np.pi * t / 0.7), 0.0)
    y = 0.6 * size * np.where(t < 1.0, np.sin(2.0 * np.pi * t), 0.0)
    return sp.Motion(dt=0.01, x=x, y=y, name="two pulses")


def creep(step: float, duration: float = 5.0) -> float:
    """Return how fast a resting box creeps in MuJoCo, pushed with half of what friction holds [m/s]."""
    pushed = np.full(round(duration / 0.01) + 1, 0.5 * 0.4 * GRAVITY)
    _, places = in_mujoco([(0.8, 0.8, 0.4, 50.0)], (0.4, 0.4), sp.Motion(dt=0.01, x=pushed), step)
    half = len(pushed) // 2
    return float(abs(places[0, -1, 0] - places[0, half, 0]) / (0.01 * (len(pushed) - 1 - half)))


CASES = {
    "one box that rocks": ([(0.4, 0.6, 1.6, 80.0)], (1.0, 1.0), 3.0),
    "one box that slides": ([(0.9, 0.9, 0.3, 80.0)], (0.2, 0.2), 5.0),
    "two boxes, stacked": ([(0.9, 0.9, 0.3, 60.0), (0.5, 0.5, 0.2, 20.0)], (0.6, 0.25), 4.5),
}


def still(duration: float, dt: float) -> sp.Motion:
    """Return a floor that does not move."""
    return sp.Motion(dt=dt, x=np.zeros(round(duration / dt) + 1))


def passed(found: Histories, dt: float, angle: float) -> Array:
    """Return when the tilt of each box first passes an angle [s], NaN where it does not."""
    times = np.full(len(found.tilts), math.nan)
    for number, tilt in enumerate(found.tilts):
        after = int(np.argmax(tilt > angle))
        if after:
            part = (angle - tilt[after - 1]) / (tilt[after] - tilt[after - 1])
            times[number] = dt * (after - 1 + part)
    return times


ENGINES: dict[str, tuple[Callable[[Scene, float], Histories], Sequence[float]]] = {
    "stayput": (run_in_stayput, (1e-3, 5e-4, 2e-4, 5e-5)),
    "MuJoCo": (run_in_mujoco, (1e-3, 5e-4, 2e-4, 1e-4, 5e-5)),
}
"""What runs a scene in an engine, and its steps, the finest last."""


def compared(
    scenes: Sequence[Scene],
    asked: Callable[[Scene, Histories], Array],
    unit: float,
    told: Callable[[Array], Sequence[str]],
    finer: Sequence[float] = (),
) -> list[list[str]]:
    """Return rows of a table: what both engines say at each step, how far it is off, and the time of a run.

    ``asked`` is what a run says, ``told`` how all of them are told. Off are the median and the most from the
    engine's own finest steps, times ``unit``; ``finer`` are further ones of MuJoCo. At last comes how many
    times as long MuJoCo takes for the median that we are off, its times and errors taken as straight lines
    between logarithms.
    """
    rows: list[list[str]] = []
    curves: list[tuple[Array, Array]] = []
    for name, (run, own_steps) in ENGINES.items():
        steps = [*own_steps, *(finer if name == "MuJoCo" else ())]
        runs = [[run(scene, step) for scene in scenes] for step in steps]
        said = np.array(
            [np.concatenate([asked(*of) for of in zip(scenes, one, strict=True)]) for one in runs]
        )
        seconds = np.array([sum(one.seconds for one in all_of) / len(scenes) for all_of in runs])
        off = np.abs(said - said[-1]) * unit
        errors = np.nan_to_num(np.nanmedian(off, axis=1), nan=math.inf)
        curves.append((errors[:-1], seconds[:-1]))
        for step, says, error, own, spent in zip(steps, said, errors, off, seconds, strict=True):
            least = [f"{error:.2g}", f"{np.nanmax(own):.2g}"] if step > steps[-1] else ["", ""]
            rows.append([name, f"{1e3 * step:g}", *told(says), *least, three(1e3 * spent), ""])
    (ours, our_time), (theirs, their_time) = curves
    rising = np.argsort(theirs)
    for row, error, spent in zip(rows, ours, our_time, strict=False):
        if 0.0 < error <= theirs.max():
            needed = np.exp(np.interp(np.log(error), np.log(theirs[rising]), np.log(their_time[rising])))
            row[-1] = f"{'over ' if error < theirs.min() else ''}{three(needed / spent)}"
    return rows


def heads(*said: str, off: str) -> list[str]:
    """Return the headings of the rows that `compared` returns."""
    return [
        "engine",
        "step [ms]",
        *said,
        f"median off [{off}]",
        f"most off [{off}]",
        "ms a run",
        "MuJoCo's time",
    ]


def boxes(folder: Path | None) -> None:
    """Compare 20 boxes that rock alone under two pulses, by their peak tilts."""
    rng = np.random.default_rng(1)
    sides = rng.uniform((0.3, 0.3, 1.2), (0.6, 1.2, 2.0), (20, 3)).tolist()
    scenes: list[Scene] = []
    for (width, length, height), factor in zip(sides, rng.uniform(1.05, 1.4, 20), strict=True):
        size = factor * GRAVITY * min(width, length / 0.6) / height
        scenes.append(Scene([(width, length, height, 100.0)], (0.9, 0.9), two_components(size)))

    def peak(_: Scene, found: Histories) -> Array:
        return np.log(found.tilts.max(axis=1))

    rows = compared(scenes, peak, 100.0, lambda said: [f"{np.exp(np.median(said)):.4f}"], (2e-5, 1e-5))
    tell("mujoco_boxes", heads("median peak tilt [rad]", off="%"), rows, folder)


def row(folder: Path | None) -> None:
    """Compare eight shelves of which the first is tipped, by when they pass 45°."""
    scene = Scene([(0.32, 0.9, 2.1, 120.0)] * 8, (0.4, 0.3), still(3.5, 0.01), 0.75, 0.75)

    def falls(scene: Scene, found: Histories) -> Array:
        return passed(found, scene.motion.dt, 0.25 * math.pi)

    def told(said: Array) -> list[str]:
        return [f"{np.isfinite(said).sum()}", " ".join(f"{one:.2f}" for one in said)]

    tell("mujoco_row", heads("fall", "at [s]", off="ms"), compared([scene], falls, 1e3, told), folder)


def dominoes(folder: Path | None) -> None:
    """Compare the speed of the wave in rows of ten dominoes, and what hits leave of the energy."""
    width, length, height = 0.0075, 0.024, 0.048
    gaps = (0.008, 0.016, 0.024, 0.032)
    scenes = [
        Scene([(width, length, height, 0.01)] * 10, (0.4, 0.2), still(0.8, 0.002), width + gap, 6.0)
        for gap in gaps
    ]

    def speed(scene: Scene, found: Histories) -> Array:
        times = passed(found, scene.motion.dt, 0.1)
        return np.log([3.0 * scene.apart / (times[7] - times[4])])

    rows = compared(scenes, speed, 100.0, lambda said: [f"{one:.3f}" for one in np.exp(said)])
    tell("mujoco_dominoes", heads(*(f"{1e3 * gap:g} mm [m/s]" for gap in gaps), off="%"), rows, folder)
    rows_of = {
        "dominoes": Scene(
            [(width, length, height, 0.01)] * 5, (0.4, 0.2), still(0.4, 1e-3), width + 0.008, 6.0
        ),
        "shelves": Scene([(0.32, 0.9, 2.1, 120.0)] * 5, (0.4, 0.3), still(2.2, 1e-3), 0.75, 0.75),
    }
    kept = [
        [kind, name, f"{1e3 * step:g}", *(f"{100.0 * one:.0f} %" for one in shares(run(scene, step)))]
        for kind, scene in rows_of.items()
        for name, (run, steps) in ENGINES.items()
        for step in steps
    ]
    tell(
        "mujoco_hits",
        ["row of", "engine", "step [ms]", *(f"hit {number}" for number in range(1, 5))],
        kept,
        folder,
    )


def shares(found: Histories, around: int = 2) -> list[float]:
    """Return what the first hit of each body in a row leaves of the kinetic energy of all."""
    total = found.energies.sum(axis=0)
    kept: list[float] = []
    for own in found.energies[1:]:
        hit = int(np.argmax(own > 1e-3 * total.max()))
        kept.append(float(total[hit + around] / total[hit - 1]) if hit else math.nan)
    return kept


def towers(folder: Path | None) -> None:
    """Compare towers of five and ten boxes under the near-fault motion, by the peak tilts of their boxes."""
    motion = sp.near_fault()
    shaking = sp.Motion(dt=motion.dt, x=motion.x, y=motion.y).trimmed(5.0, 11.0)

    def peaks(_: Scene, found: Histories) -> Array:
        return found.tilts.max(axis=1)

    def told(said: Array) -> list[str]:
        return [f"{said[0]:.3f}", f"{said.max():.3f}", f"{(said > 0.25 * math.pi).sum()}"]

    rows: list[list[str]] = []
    for count, scale in ((5, 0.7), (10, 0.7), (5, 1.0), (10, 1.0)):
        scene = Scene([(0.5, 0.5, 0.3, 20.0)] * count, (0.5, 0.4), shaking.scaled(scale))
        rows += [[f"{count} boxes, {scale:g}", *one] for one in compared([scene], peaks, 1.0, told)]
    tell(
        "mujoco_towers",
        ["tower, scale", *heads("lowest [rad]", "most [rad]", "fall", off="rad")],
        rows,
        folder,
    )


def rest(_: Path | None) -> None:
    """Print how fast a box at rest creeps."""
    for step in (1e-3, 2e-4, 5e-5):
        print(f"MuJoCo at rest creeps by {1e6 * creep(step):.2f} µm/s at steps of {step:g} s; stayput by 0")


PARTS = {part.__name__: part for part in (boxes, row, dominoes, towers, rest)}


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--tables", type=Path, metavar="FOLDER", help="write the tables as CSV")
    run_in_stayput(Scene([(0.4, 0.6, 0.3, 80.0)] * 2, (0.4, 0.3), still(0.1, 0.01)), 1e-3)  # compiled
    chosen = parser.parse_args()
    for part in chosen.parts or PARTS:
        PARTS[part](chosen.tables)


if __name__ == "__main__":
    main()
