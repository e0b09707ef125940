"""All lines that act on a body together: their force, their margins, and what they do within a step."""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.columns import SLACK
from stayput.mechanics.restrained.laws import force_of, margins_of, place_of, push_of, used_of
from stayput.mechanics.roots import falls_inside

SLACK_FORCE = 1e-8
"""A force of a line or contact that starts at its limit has passed it when it is this far beyond [m/s²]."""


@inline
def pull(work, sin, cos, moves, x, z, vx, vz, omega):
    """Force of the lines on the body, and its moment about the origin, + clockwise; nothing is kept."""
    fx = fz = moment = push = 0.0
    for r in range(work.lines):
        line = work.line[r]
        if line.state == SLACK:
            push = 0.0
            continue
        e, rate, nx, nz, lever = place_of(line, sin, cos, moves, x, z, vx, vz, omega)
        F = force_of(line, e, rate, push)
        push, _ = push_of(line, F, rate)
        fx, fz, moment = fx - F * nx, fz - F * nz, moment - F * lever
    return fx, fz, moment


@inline
def measure_lines(work, sin, cos, moves, x, z, vx, vz, omega):
    """Force and moment of the lines, and the least of their margins above their levels.

    The rows keep elongations, rates, forces and margins.
    """
    fx = fz = moment = push = push_rate = used = 0.0
    least = math.inf
    for r in range(work.lines):
        line = work.line[r]
        e, rate, nx, nz, lever = place_of(line, sin, cos, moves, x, z, vx, vz, omega)
        F = force_of(line, e, rate, push)
        low, high = margins_of(line, e, rate, F, push, push_rate)
        push, push_rate = push_of(line, F, rate)
        line.e, line.rate, line.force, line.low1, line.high1 = e, rate, F, low, high
        least = min(least, low - line.low, high - line.high)
        if line.joins != 0:
            line.joint1 = 1.0 - used - used_of(line, F)
            least = min(least, line.joint1 - line.joint)
        used = used_of(line, F)
        fx, fz, moment = fx - F * nx, fz - F * nz, moment - F * lever
    return fx, fz, moment, least


@inline
def level_of(margin, slack):
    """Value at which a margin counts as passed in a step that starts with it; see `roots.closed_level`."""
    return 0.0 if margin > slack else min(margin, 0.0) - slack


@inline
def begin_step(work):
    """Keep what was last measured as the start of a step, and set the levels that end it.

    A margin that starts at its limit must pass it by a slack; see `roots.closed_level`.
    """
    slack = work.patience * SLACK_FORCE
    for r in range(work.lines):
        line = work.line[r]
        line.e0, line.rate0, line.force0 = line.e, line.rate, line.force
        low, high = line.low1, line.high1
        line.low0, line.high0 = low, high
        line.low, line.high = level_of(low, slack), level_of(high, slack)
        if line.joins != 0:
            line.joint0, line.joint = line.joint1, level_of(line.joint1, slack)


@inline
def weight_of(margin):
    """Weight in the search for an event: −1 over a margin that is negative, 0 for one that takes no part."""
    return -1.0 / margin if margin < 0.0 else 0.0


@inline
def weighed(margin, weight):
    """Margin in the search for an event."""
    return weight * margin if weight > 0.0 else math.inf


@inner
def set_line_weights(work):
    """Set the weights of the margins for a search that ends where they were last measured."""
    for r in range(work.lines):
        line = work.line[r]
        line.low_weight = weight_of(line.low1 - line.low)
        line.high_weight = weight_of(line.high1 - line.high)
        line.joint_weight = weight_of(line.joint1 - line.joint) if line.joins != 0 else 0.0


@inner
def least_weighed_line(work):
    """Least of the margins that have a weight, each times it."""
    least = math.inf
    for r in range(work.lines):
        line = work.line[r]
        least = min(
            least,
            weighed(line.low1 - line.low, line.low_weight),
            weighed(line.high1 - line.high, line.high_weight),
            weighed(line.joint1 - line.joint, line.joint_weight),
        )
    return least


@inline
def _halfway(line, h):
    """Elongation and rate in the middle of a step, by the cubic through both ends."""
    e0, e1, v0, v1 = line.e0, line.e, line.rate0, line.rate
    return 0.5 * (e0 + e1) + 0.125 * h * (v0 - v1), 1.5 * (e1 - e0) / h - 0.25 * (v0 + v1)


@inner
def suspicious(work, h):
    """Earliest time at which a parabola has a margin below its level, or h; the end has been measured."""
    first = h
    push = push_rate = used = 0.0
    for r in range(work.lines):
        line = work.line[r]
        if line.calm != 0:
            continue
        e, rate = _halfway(line, h)
        if line.tangent == 0:
            push = push_rate = 0.0
        F = force_of(line, e, rate, push)
        low, high = margins_of(line, e, rate, F, push, push_rate)
        push, push_rate = push_of(line, F, rate)
        u = falls_inside(line.low0 - line.low, low - line.low, line.low1 - line.low)
        if u > 0.0:
            first = min(first, u * h)
        if line.high0 < math.inf:
            u = falls_inside(line.high0 - line.high, high - line.high, line.high1 - line.high)
            if u > 0.0:
                first = min(first, u * h)
        if line.joins != 0:
            joint = 1.0 - used - used_of(line, F)
            u = falls_inside(line.joint0 - line.joint, joint - line.joint, line.joint1 - line.joint)
            if u > 0.0:
                first = min(first, u * h)
        used = used_of(line, F)
    return first


@inline
def _vertex(f0, fm, f1):
    """Value of largest magnitude of the parabola through three values, where it turns between the ends."""
    curvature = 2.0 * (f0 - 2.0 * fm + f1)
    slope = f1 - f0 - curvature
    if slope * (slope + 2.0 * curvature) < 0.0:
        return f0 - 0.25 * slope * slope / curvature
    return f1


@inline
def note_force(device, tangent, F):
    """Keep a force, if it is the largest so far."""
    if tangent != 0:
        device.peak_shear = max(device.peak_shear, abs(F))
    elif F > 0.0:
        device.peak_pull = max(device.peak_pull, F)
    else:
        device.peak_push = max(device.peak_push, -F)


@inline
def _reaches_peak(line, device):
    """Whether the force of a line may have been larger in the step than ever."""
    high = max(line.force0, line.force) + line.swing
    low = min(line.force0, line.force) - line.swing
    if line.tangent != 0:
        return max(high, -low) > device.peak_shear
    return high > device.peak_pull or -low > device.peak_push


@inner
def _note_within(work, r, device, h):
    line = work.line[r]
    push = 0.0
    if line.rubs != 0.0:
        normal = work.line[r - 1]
        e, rate = _halfway(normal, h)
        push, _ = push_of(normal, force_of(normal, e, rate, 0.0), rate)
    e, rate = _halfway(line, h)
    note_force(device, line.tangent, _vertex(line.force0, force_of(line, e, rate, push), line.force))
    note_force(device, line.tangent, line.force)


@inline
def note_forces_within(work, devices, h):
    """Keep the largest forces at the end of a step, and where they turn inside it."""
    for r in range(work.lines):
        line = work.line[r]
        device = devices[line.element]
        if line.state != SLACK and (line.calm == 0 or _reaches_peak(line, device)):
            _note_within(work, r, device, h)


@inner
def note_sample_forces(forces, work, s):
    """Write the forces down at a sample, where they are kept; those of devices that are gone stay zero."""
    if forces.shape[0] == 0:
        return
    for r in range(work.lines):
        line = work.line[r]
        forces[s.k, line.element, line.tangent] = line.force
