"""The active lines of a case about an origin: their places, and the law of each on its present branch.

They are set when a mode begins and hold to the next event. The elongation about the *origin*, G or a fulcrum
that sticks, is e = a + n·(x, z) + p cos θ + q sin θ; its derivative by θ is the lever of the force about that
origin.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.devices.columns import AXIAL, NORMAL, TANGENT
from stayput.mechanics.devices.device_law import branch_of


@inline
def _set_place(el, link, line, i, u, v, x, z):
    """Set the geometry of a line about an origin at (x, z), from which its point is at (u, v)."""
    line.axial = 1 if el.kind == AXIAL else 0
    line.u, line.v, line.x, line.z = u, v, link.x - x, link.z - z
    nx, nz = (-el.sin, el.cos) if i == NORMAL else (el.cos, el.sin)
    line.nx, line.nz = nx, nz
    line.p, line.q = nx * u + nz * v, nx * v - nz * u
    line.reach = math.sqrt(u * u + v * v)
    line.a = -el.length if el.kind == AXIAL else -(nx * line.x + nz * line.z)


@inline
def _set_branch(line, branch):
    """Copy a `Branch` into the row of its line."""
    line.state, line.constant, line.k, line.c = branch.state, branch.constant, branch.k, branch.c
    line.per_push, line.stiffness, line.damping = branch.per_push, branch.stiffness, branch.damping
    line.low_at_0, line.low_per_force, line.low_per_push = (
        branch.low_at_0,
        branch.low_per_force,
        branch.low_per_push,
    )
    line.high_at_0, line.high_per_force, line.high_per_push = (
        branch.high_at_0,
        branch.high_per_force,
        branch.high_per_push,
    )
    line.bears_friction = branch.bears_friction
    line.per_plus, line.per_minus = branch.per_plus, branch.per_minus


@inner
def set_lines(elements, links, case, corner, x, z, work):
    """Set the rows of the active lines, about an origin at (x, z).

    Parameters
    ----------
    corner : int
        Corner of the body at the origin; −1 where the origin is G, whose position is then given later.
    """
    count = 0
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        u, v = el.u, el.v
        if corner >= 0:
            u, v = u - case.u[corner], v - case.v[corner]
        for i in range(link.lines):
            line = work.line[count]
            line.element, line.tangent = n, i
            line.interacts = 1 if i == TANGENT and el.interaction != 0 else 0
            _set_place(el, link, line, i, u, v, x, z)
            if corner < 0:
                line.reach = math.inf
            _set_branch(line, branch_of(el, link, i))
            count += 1
    work.lines = count


@inline
def place_of(line, sin, cos, moves, x, z, vx, vz, omega):
    """Elongation of a line and its rate, its direction, and the lever arm of its force about the origin.

    The origin, where it ``moves``, is at (x, z) with the rates ẋ and ż.
    """
    if line.axial == 0:
        nx, nz = line.nx, line.nz
        lever = line.q * cos - line.p * sin
        e, rate = line.a + (line.p * cos + line.q * sin), omega * lever
        if moves:
            e, rate = e + (nx * x + nz * z), rate + (nx * vx + nz * vz)
        return e, rate, nx, nz, lever
    dx, dz = line.u * cos + line.v * sin, line.v * cos - line.u * sin
    right, up = dx, dz
    dx, dz = dx - line.x, dz - line.z
    if moves:
        dx, dz = dx + x, dz + z
    far = math.sqrt(dx * dx + dz * dz)
    nx, nz = (dx / far, dz / far) if far > 0.0 else (0.0, 0.0)
    lever = nx * up - nz * right
    rate = omega * lever
    if moves:
        rate += nx * vx + nz * vz
    return far + line.a, rate, nx, nz, lever
