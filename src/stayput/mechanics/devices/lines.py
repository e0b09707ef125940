"""The active lines of a case within a step: places, forces, event margins, crossing candidates, peak forces.

They are set when a mode begins and hold to the next event, each with the law of its present branch. The
elongation about the *origin*, G or a fulcrum that sticks, is e = a + n·(x, z) + p cos θ + q sin θ; its
derivative by θ is the lever of the force about that origin.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.devices.columns import AXIAL, NORMAL, SLACK, TANGENT
from stayput.mechanics.devices.device_law import (
    clipped,
    force_of,
    margins_of,
    note_force,
    push_of,
    set_law,
    utilization_of,
)
from stayput.mechanics.roots import SLACK_FORCE, level_of, parabola_negative_at


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
            set_law(line, el, link, i)
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


@inline
def line_force(work, sin, cos, moves, x, z, vx, vz, omega):
    """Force of the lines on the body and its moment about the origin, + clockwise; stores nothing."""
    fx = fz = moment = push = 0.0
    for line in work.line[: work.lines]:
        if line.state == SLACK:
            push = 0.0
            continue
        e, rate, nx, nz, lever = place_of(line, sin, cos, moves, x, z, vx, vz, omega)
        F = force_of(line, e, rate, push)
        push, _ = push_of(line, F, rate)
        fx, fz, moment = fx - F * nx, fz - F * nz, moment - F * lever
    return fx, fz, moment


@inline
def evaluate_lines(work, sin, cos, moves, x, z, vx, vz, omega):
    """Force and moment of the lines, and the least of their margins above their levels.

    Elongations, rates, forces and margins are stored in the rows.
    """
    fx = fz = moment = push = push_rate = used = 0.0
    least = math.inf
    for line in work.line[: work.lines]:
        e, rate, nx, nz, lever = place_of(line, sin, cos, moves, x, z, vx, vz, omega)
        F = force_of(line, e, rate, push)
        low, high = margins_of(line, e, rate, F, push, push_rate)
        push, push_rate = push_of(line, F, rate)
        line.e, line.rate, line.force, line.low1, line.high1 = e, rate, F, low, high
        least = min(least, low - line.low, high - line.high)
        if line.interacts != 0:
            line.joint1 = 1.0 - used - utilization_of(line, F)
            least = min(least, line.joint1 - line.joint)
        used = utilization_of(line, F)
        fx, fz, moment = fx - F * nx, fz - F * nz, moment - F * lever
    return fx, fz, moment, least


@inline
def begin_step(work):
    """Start a step from the values last evaluated, and set the levels of the margins that end it.

    A margin that starts at its limit must fall below it by a slack; see `roots.level_of`.
    """
    slack = work.slack_factor * SLACK_FORCE
    for line in work.line[: work.lines]:
        line.e0, line.rate0, line.force0 = line.e, line.rate, line.force
        low, high = line.low1, line.high1
        line.low0, line.high0 = low, high
        line.low, line.high = level_of(low, slack), level_of(high, slack)
        if line.interacts != 0:
            line.joint0, line.joint = line.joint1, level_of(line.joint1, slack)


@inline
def event_weight(margin):
    """Scale of a margin in the event search: to −1 where it is negative, 0 where it is not searched."""
    return -1.0 / margin if margin < 0.0 else 0.0


@inline
def weighted_margin(margin, weight):
    """Scaled margin in the event search; infinity where it is not searched."""
    return weight * margin if weight > 0.0 else math.inf


@inner
def set_line_weights(work):
    """Set the scales of the line margins for a search that ends where they were last evaluated."""
    for line in work.line[: work.lines]:
        line.low_weight = event_weight(line.low1 - line.low)
        line.high_weight = event_weight(line.high1 - line.high)
        line.joint_weight = event_weight(line.joint1 - line.joint) if line.interacts != 0 else 0.0


@inner
def least_weighted_line(work, at_start):
    """Least scaled margin of the lines, as last evaluated or at the start of the step."""
    least = math.inf
    for line in work.line[: work.lines]:
        low, high, joint = line.low1, line.high1, line.joint1
        if at_start:
            low, high, joint = line.low0, line.high0, line.joint0
        least = min(
            least,
            weighted_margin(low - line.low, line.low_weight),
            weighted_margin(high - line.high, line.high_weight),
            weighted_margin(joint - line.joint, line.joint_weight),
        )
    return least


@inner
def first_crossing_candidate(work, sin, cos, moves, x, z, vx, vz, omega):
    """First crossing candidate: part of the step at which a parabola first has a margin below its level.

    The parabola passes through the margin at the start, the middle and the end of the step; 1 where there is
    none. The state is that in the middle, and the rows hold the values at both ends.
    """
    first = 1.0
    push = push_rate = used = 0.0
    for line in work.line[: work.lines]:
        if line.inactive != 0:
            continue
        e, rate, _, _, _ = place_of(line, sin, cos, moves, x, z, vx, vz, omega)
        if line.tangent == 0:
            push = push_rate = 0.0
        F = force_of(line, e, rate, push)
        low, high = margins_of(line, e, rate, F, push, push_rate)
        push, push_rate = push_of(line, F, rate)
        u = parabola_negative_at(line.low0 - line.low, low - line.low, line.low1 - line.low)
        if u > 0.0:
            first = min(first, u)
        if line.high0 < math.inf:
            u = parabola_negative_at(line.high0 - line.high, high - line.high, line.high1 - line.high)
            if u > 0.0:
                first = min(first, u)
        if line.interacts != 0:
            joint = 1.0 - used - utilization_of(line, F)
            u = parabola_negative_at(line.joint0 - line.joint, joint - line.joint, line.joint1 - line.joint)
            if u > 0.0:
                first = min(first, u)
        used = utilization_of(line, F)
    return first


@inline
def _midpoint(line, h):
    """Elongation and rate at the midpoint of a step, by cubic Hermite interpolation."""
    e0, e1, v0, v1 = line.e0, line.e, line.rate0, line.rate
    return 0.5 * (e0 + e1) + 0.125 * h * (v0 - v1), 1.5 * (e1 - e0) / h - 0.25 * (v0 + v1)


@inline
def _vertex(f0, fm, f1):
    """Extreme value, inside the step, of the parabola through three values; else the last of them."""
    curvature = 2.0 * (f0 - 2.0 * fm + f1)
    slope = f1 - f0 - curvature
    if slope * (slope + 2.0 * curvature) < 0.0:
        return f0 - 0.25 * slope * slope / curvature
    return f1


@inline
def _reaches_peak(line, device):
    """Whether the force of a line may have exceeded its peak inside the step."""
    high = max(line.force0, line.force) + line.deviation
    low = min(line.force0, line.force) - line.deviation
    if line.tangent != 0:
        return max(high, -low) > device.peak_shear
    return high > device.peak_pull or -low > device.peak_push


@inner
def reaches_peak(work, devices):
    """Whether the force of a line may have exceeded its peak inside the step."""
    for line in work.line[: work.lines]:
        if line.state != SLACK and _reaches_peak(line, devices[line.element]):
            return True
    return False


@inner
def _note_peaks_within(work, r, device, h):
    line = work.line[r]
    push = 0.0
    if line.per_push != 0.0:
        normal = work.line[r - 1]
        e, rate = _midpoint(normal, h)
        push, _ = push_of(normal, force_of(normal, e, rate, 0.0), rate)
    e, rate = _midpoint(line, h)
    turning = _vertex(line.force0, force_of(line, e, rate, push), line.force)
    note_force(device, line.tangent, clipped(line, turning, math.inf))
    note_force(device, line.tangent, clipped(line, line.force, math.inf))


@inline
def note_forces_within(work, devices, h):
    """Update the peak forces with those at the end of a step and their extremes inside it."""
    for r in range(work.lines):
        line = work.line[r]
        device = devices[line.element]
        if line.state != SLACK and (line.inactive == 0 or _reaches_peak(line, device)):
            _note_peaks_within(work, r, device, h)


@inner
def record_forces(forces, work, s):
    """Write the forces at a sample into the force history, if it is kept; failed devices stay at zero."""
    if forces.shape[0] == 0:
        return
    for line in work.line[: work.lines]:
        forces[s.k, line.element, line.tangent] = line.force
