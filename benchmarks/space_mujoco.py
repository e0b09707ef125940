"""Boxes in space beside MuJoCo: one free box, and two stacked, under two horizontal components.

Prints peak tilt and residual slide of both engines over their steps, and how far a box that rests in MuJoCo
creeps on a floor that pushes it with half of what friction holds. The axes are the floor's: bodies feel a
field −a in both. MuJoCo's contacts are soft; one coefficient of friction holds.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import mujoco
import numpy as np

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

GRAVITY = 9.80665
SOFTNESS = 4.0
"""Time constant of a contact, in steps; MuJoCo allows 2."""

_MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -9.80665" cone="elliptic" impratio="10" integrator="implicitfast"
          tolerance="1e-12" iterations="200"/>
  <default><geom condim="3" friction="{between} 0 0" solref="{soft} 1" solimp="0.99 0.999 0.0001"/></default>
  <worldbody>
    <geom type="plane" size="0 0 1" friction="{floor} 0 0"/>
    {bodies}
  </worldbody>
</mujoco>
"""


def in_mujoco(
    boxes: Sequence[tuple[float, float, float, float]],
    friction: tuple[float, float],
    motion: sp.Motion,
    step: float,
) -> tuple[Array, Array]:
    """Run boxes that stand on each other, given by width, length, height [m] and mass [kg].

    ``friction`` is that of the floor, and that between boxes, which must not be larger: MuJoCo takes the
    larger of what two surfaces have.

    Returns
    -------
    tuple of ndarray
        Tilts, shape (boxes, samples) [rad], and places of the centres, shape (boxes, samples, 3) [m].
    """
    bodies, level = [], 0.0
    for width, length, height, mass in boxes:
        bodies.append(
            f'<body pos="0 0 {level + height / 2}"><freejoint/><geom type="box" mass="{mass}"'
            f' size="{width / 2} {length / 2} {height / 2}"/></body>'
        )
        level += height
    text = _MODEL.format(
        step=step, soft=SOFTNESS * step, floor=friction[0], between=friction[1], bodies="".join(bodies)
    )
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    acceleration = np.zeros((len(motion.x), 3))
    for axis, name in enumerate("xyz"):
        if name in motion.components:
            acceleration[:, axis] = getattr(motion, name)
    grid = motion.dt * np.arange(len(motion.x))
    each = round(motion.dt / step)
    middles = (np.arange(each * (len(grid) - 1)) + 0.5) * step
    push = np.column_stack([np.interp(middles, grid, column) for column in acceleration.T])
    tilts, places = np.zeros((len(boxes), len(grid))), np.zeros((len(boxes), len(grid), 3))
    for sample in range(len(grid)):
        for b in range(len(boxes)):
            tilts[b, sample] = math.acos(min(1.0, data.xmat[b + 1][8])) if sample else 0.0
            places[b, sample] = data.xpos[b + 1] if sample else (0.0, 0.0, 0.0)
        if sample < len(grid) - 1:
            for row in push[sample * each : (sample + 1) * each]:
                model.opt.gravity[:] = -row - np.array([0.0, 0.0, GRAVITY])
                mujoco.mj_step(model, data)
    return tilts, places


def in_stayput(
    boxes: Sequence[tuple[float, float, float, float]],
    friction: tuple[float, float],
    motion: sp.Motion,
    step: float,
) -> sp.SpaceRun:
    """Run the same here."""
    stack, level = [], 0.0
    for width, length, height, mass in boxes:
        stack.append(sp.Standing(sp.Solid.box(width, length, height, mass), (0.0, 0.0, level)))
        level += height
    floor, between = friction
    room = sp.Room(sp.Floor(floor, floor))
    return sp.simulate(sp.Assembly(stack, (between, between)), room, motion, step=step)


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


def main() -> None:
    for name, (boxes, friction, size) in CASES.items():
        motion = two_components(size)
        print(name)
        for step in (1e-3, 5e-4, 2e-4, 1e-4):
            run = in_stayput(boxes, friction, motion, step)
            slide = np.linalg.norm(run.place[:, -1, :2] - run.place[:, 0, :2], axis=1)
            print(f"  stayput {step:g} s: peak tilts {run.tilt.max(axis=1)} rad, ways {slide} m")
        for step in (1e-3, 2e-4, 5e-5, 2e-5):
            tilts, places = in_mujoco(boxes, friction, motion, step)
            slide = np.linalg.norm(places[:, -1, :2], axis=1)
            print(f"  MuJoCo  {step:g} s: peak tilts {tilts.max(axis=1)} rad, ways {slide} m")
    for step in (1e-3, 2e-4, 5e-5):
        print(f"MuJoCo at rest creeps by {1e6 * creep(step):.2f} µm/s at steps of {step:g} s; stayput by 0")


if __name__ == "__main__":
    main()
