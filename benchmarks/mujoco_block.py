"""The planar block of stayput as a MuJoCo model, to compare answers and speed.

The frame is the floor's: the body feels −m·ẍ_G and −m·z̈_G as applied forces at its centre of gravity.
Its base and top corners are small spheres against the planes of floor and walls, so that each corner is
one contact, as in stayput; the friction cone is elliptic. MuJoCo's contacts are soft and have one
coefficient of friction each, so it answers a slightly different question.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from mujoco import rollout

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FAR = 1e3
"""Distance of a wall that is not there [m]; all models have the same parts, as a rollout needs."""

RADIUS = 1e-4
"""Radius of a corner [m]."""

SOFTNESS = 10.0
"""Time constant of a contact, in steps: a choice, not an optimum. MuJoCo allows 2.

A block that should only slide chatters on its corners, the more the stiffer they are: one of 0.4 m × 1.2 m
with μ = 0.25, under a sine of 8 m/s² and 1 Hz, rocked by more than 0.3 rad or fell with 2 to 7 steps, and
rocked by less than 0.03 rad with 10 to 20. Over mixed cases as in `bench.py` the median error of the peak
tilt with 10 or 20 steps was a third to a sixth of that with 2, 20 being mostly the better; the largest
errors and the wrong verdicts showed no trend from 5 steps on.
"""

_MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -{gravity}" cone="elliptic" impratio="{impratio}"
          integrator="Euler" jacobian="dense"/>
  <default>
    <geom condim="3" contype="0" conaffinity="0"/>
    <pair condim="3" solimp="0.99 0.99 0.001"/>
  </default>
  <worldbody>
    <geom name="floor" type="plane" size="0 0 1"/>
    <geom name="left wall" type="plane" size="0 0 1" pos="{left} 0 0" xyaxes="0 1 0 0 0 1"/>
    <geom name="right wall" type="plane" size="0 0 1" pos="{right} 0 0" xyaxes="0 -1 0 0 0 1"/>
    <body name="block" pos="0 0 0">
      <inertial pos="0 0 0" mass="{mass}" diaginertia="{inertia} {inertia} {inertia}"/>
      <joint type="slide" axis="1 0 0"/>
      <joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 1 0"/>
      {corners}
    </body>
  </worldbody>
  <contact>
    {pairs}
  </contact>
</mujoco>
"""


@dataclass(frozen=True, slots=True)
class Block:
    """What MuJoCo gets to know of a case.

    Parameters
    ----------
    width, height, mass : float
        Section [m] and mass [kg] of a uniform block.
    friction : float
        The one coefficient of friction of the floor.
    left_gap, right_gap : float
        Clear distances to the walls [m]; inf for none.
    wall_restitution, wall_friction : float
        Of both walls.
    """

    width: float
    height: float
    mass: float = 100.0
    friction: float = 0.3
    left_gap: float = math.inf
    right_gap: float = math.inf
    wall_restitution: float = 0.3
    wall_friction: float = 0.3

    def model(self, step: float = 1e-3, gravity: float = 9.80665, impratio: float = 10.0) -> mujoco.MjModel:
        """Compile the model for a step [s]; its contacts are `SOFTNESS` steps soft."""
        u, v = self.width / 2 - RADIUS, self.height / 2 - RADIUS
        corners = {"A": (-u, -v), "B": (u, -v), "C": (-u, v), "D": (u, v)}
        soft = SOFTNESS * step
        floor = f'solref="{soft} 1" friction="{self.friction} {self.friction}"'
        damping = damping_ratio(self.wall_restitution)
        wall = f'solref="{soft} {damping}" friction="{self.wall_friction} {self.wall_friction}"'
        sides = [(name, "floor", floor) for name in corners]
        sides += [(name, "left wall", wall) for name in "AC"] + [(name, "right wall", wall) for name in "BD"]
        return mujoco.MjModel.from_xml_string(
            _MODEL.format(
                step=step,
                gravity=gravity,
                impratio=impratio,
                mass=self.mass,
                inertia=self.mass * (self.width**2 + self.height**2) / 12.0,
                left=-self.width / 2 - min(self.left_gap, FAR),
                right=self.width / 2 + min(self.right_gap, FAR),
                corners="\n".join(
                    f'<geom name="{name}" type="sphere" size="{RADIUS}" pos="{x} 0 {z}"/>'
                    for name, (x, z) in corners.items()
                ),
                pairs="\n".join(f'<pair geom1="{a}" geom2="{b}" {how}/>' for a, b, how in sides),
            )
        )

    def state(self, tilt: float = 0.0, tilt_rate: float = 0.0, slide_rate: float = 0.0) -> Array:
        """Return time, (x, z, tilt) of G and their rates, standing on the floor.

        A tilted or turning block turns about its fulcrum, B for a positive tilt or rate.
        """
        side = math.copysign(1.0, tilt if tilt else tilt_rate)
        u, v = side * self.width / 2, -self.height / 2
        c, s = math.cos(tilt), math.sin(tilt)
        x = side * self.width / 2 - (u * c + v * s)
        z = u * s - v * c
        return np.array(
            [0.0, x, z, tilt, slide_rate + z * tilt_rate, (u * c + v * s) * -tilt_rate, tilt_rate]
        )


def damping_ratio(restitution: float) -> float:
    """Return the damping ratio ζ of a spring and dashpot that cannot pull and that gives ``restitution``.

    The contact ends when its force is zero, at ω_d t = π − atan2(2ζ√(1−ζ²), 2ζ²−1) after it began.
    """
    if restitution <= 0.0:
        return 1.0

    def given(zeta: float) -> float:
        root = math.sqrt(1.0 - zeta * zeta)
        angle = math.atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta)
        return math.exp(-zeta / root * (math.pi - angle))

    low, high = 1e-6, 1.0 - 1e-9
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if given(middle) > restitution else (low, middle)
    return 0.5 * (low + high)


@dataclass(frozen=True, slots=True)
class Histories:
    """What the rollout gives: one row a case, one column a step.

    ``time`` [s] has the shape (steps,), ``x`` and ``z`` of G [m], ``tilt`` [rad] and ``tilt_rate``
    [rad/s] (cases, steps).
    """

    time: Array
    x: Array
    z: Array
    tilt: Array
    tilt_rate: Array

    @property
    def peak_tilt(self) -> Array:
        """Largest tilt, at most 90° [rad]."""
        return np.minimum(np.abs(self.tilt).max(axis=1), math.pi / 2)

    @property
    def overturned(self) -> NDArray[np.bool_]:
        """Whether the tilt reached 90°, or ended beyond 80° (a fallen block may lie a little below)."""
        return (np.abs(self.tilt).max(axis=1) >= math.pi / 2) | (
            np.abs(self.tilt[:, -1]) > math.radians(80.0)
        )


def middles(duration: float, step: float) -> Array:
    """Return the middles of the steps [s], where a force that is held over a step is taken."""
    return (np.arange(round(duration / step)) + 0.5) * step


def forces(
    blocks: Sequence[Block], time: Array, dt: float, x: Array, z: Array | None, scales: Array
) -> Array:
    """Return the applied forces of every case at the times given, shape (cases, steps, 3) [N].

    The floor's acceleration [m/s²], sampled at ``dt`` [s], is piecewise linear, and zero after its end.
    """
    grid = np.arange(len(x)) * dt
    mass = np.array([block.mass for block in blocks])
    applied = np.zeros((len(blocks), len(time), 3))
    applied[:, :, 0] = -(mass * scales)[:, None] * np.interp(time, grid, x, right=0.0)
    if z is not None:
        applied[:, :, 1] = -(mass * scales)[:, None] * np.interp(time, grid, z, right=0.0)
    return applied


def run(models: Sequence[mujoco.MjModel], states: Array, applied: Array, *, threads: int = 1) -> Histories:
    """Roll all models out at once, in ``threads`` threads."""
    step = models[0].opt.timestep
    workers = [mujoco.MjData(models[0]) for _ in range(threads)]
    state, _ = rollout.rollout(
        list(models), workers, states, applied, control_spec=int(mujoco.mjtState.mjSTATE_QFRC_APPLIED.value)
    )
    time = step * np.arange(1, state.shape[1] + 1)
    return Histories(time, state[:, :, 1], state[:, :, 2], state[:, :, 3], state[:, :, 6])
