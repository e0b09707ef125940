"""All elements of a case together: their force on the body, their margins, peaks and branches."""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.columns import (
    AXIAL,
    F_NORMAL,
    F_TANGENT,
    HOLDS,
    NONE,
    NORMAL,
    OPEN,
    TANGENT,
)
from stayput.mechanics.restrained.lines import (
    elastic_push,
    first_branch,
    force,
    joint_margin,
    margins,
    settle,
    share,
)
from stayput.mechanics.roots import falls_inside

SLACK_FORCE = 1e-8
"""A line whose force starts at a limit has passed it when it is this far beyond [m/s²]."""


@inner
def set_up_elements(elements, links, devices, case, s):
    """Place the anchors, for a body at rest at slide 0, and forget what was before."""
    sin, cos = math.sin(s.rest), math.cos(s.rest)
    x = s.foot_a - (case.u[0] * cos + case.v[0] * sin)
    z = case.u[0] * sin - case.v[0] * cos
    for n in range(elements.shape[0]):
        el, link, device = elements[n], links[n], devices[n]
        here = math.isnan(el.x)
        link.x = x + el.u * cos + el.v * sin if here else el.x
        link.z = z + el.v * cos - el.u * sin if here else el.z
        link.lines = 0
        for i in range(2):
            first_branch(el, link, i)
            device.plastic[i] = 0.0
        if el.kind != NONE:
            link.lines = 1 if el.kind == AXIAL or el.stiffness[TANGENT] == 0.0 else 2
        link.push = link.push_rate = 0.0
        device.peak_pull = device.peak_push = device.peak_shear = 0.0
        device.failure, device.failure_time = HOLDS, math.nan


@inline
def _along_normal(el, dx, dz):
    """Unit vector of the normal line, and its elongation [m]."""
    if el.kind != AXIAL:
        return -el.sin, el.cos, el.cos * dz - el.sin * dx
    far = math.sqrt(dx * dx + dz * dz)
    if far == 0.0:
        return 0.0, 0.0, -el.length
    return dx / far, dz / far, far - el.length


@inline
def measure(elements, links, sin, cos, x, z, vx, vz, omega):
    """Force on the body and its moment about G, + clockwise; the links keep elongations and forces.

    The body is at the tilt of this sine and cosine, with G at (x, z) and these rates.
    """
    fx = fz = fl = 0.0
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        if link.lines == 0:
            continue
        right, up = el.u * cos + el.v * sin, el.v * cos - el.u * sin
        dx, dz = x + right - link.x, z + up - link.z
        wx, wz = vx + omega * up, vz - omega * right
        nx, nz, e = _along_normal(el, dx, dz)
        rate = nx * wx + nz * wz
        F = force(el, link, NORMAL, e, rate, 0.0)
        link.e[NORMAL], link.rate[NORMAL], link.force[NORMAL] = e, rate, F
        px, pz = -F * nx, -F * nz
        if link.lines == 2:
            push, push_rate = elastic_push(el, link, e, rate)
            e, rate = el.cos * dx + el.sin * dz, el.cos * wx + el.sin * wz
            F = force(el, link, TANGENT, e, rate, push)
            link.e[TANGENT], link.rate[TANGENT], link.force[TANGENT] = e, rate, F
            link.push, link.push_rate = push, push_rate
            px, pz = px - F * el.cos, pz - F * el.sin
        fx, fz, fl = fx + px, fz + pz, fl + (px * up - pz * right)
    return fx, fz, fl


@inner
def settle_elements(elements, links, devices, time):
    """Bring all branches up to date with what was last measured; return how many devices failed."""
    failed = 0
    for n in range(elements.shape[0]):
        if links[n].lines > 0 and settle(elements[n], links[n], devices[n], time):
            failed += 1
    return failed


@inner
def none_left(links):
    """Whether no element acts any more."""
    for n in range(links.shape[0]):
        if links[n].lines > 0:
            return False
    return True


@inline
def _level(margin, slack):
    return 0.0 if margin > slack else min(margin, 0.0) - slack


@inner
def note_margins(elements, links):
    """Keep the margins at the place last measured."""
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        for i in range(link.lines):
            link.low1[i], link.high1[i] = margins(
                el, link, i, link.e[i], link.rate[i], link.push, link.push_rate
            )
        if link.lines == 2 and el.interaction != 0:
            link.joint1 = joint_margin(el, link.force[NORMAL], link.force[TANGENT])


@inner
def begin_step(elements, links, patience):
    """Keep what was last measured as the start of a step, and set the levels that end it.

    A margin that starts at its limit must pass it by a slack; see `roots.closed_level`.
    """
    slack = patience * SLACK_FORCE
    for n in range(elements.shape[0]):
        link = links[n]
        for i in range(link.lines):
            link.e0[i], link.rate0[i], link.force0[i] = link.e[i], link.rate[i], link.force[i]
            low, high = link.low1[i], link.high1[i]
            link.low0[i], link.high0[i] = low, high
            link.low[i], link.high[i] = _level(low, slack), _level(high, slack)
        if link.lines == 2 and elements[n].interaction != 0:
            link.joint = _level(link.joint1, slack)


@inline
def weight_of(margin):
    """Weight in the search for an event: −1 over a margin that is negative, 0 for one that takes no part."""
    return -1.0 / margin if margin < 0.0 else 0.0


@inline
def weighed(margin, weight):
    """Margin in the search for an event."""
    return weight * margin if weight > 0.0 else math.inf


@inner
def least_margin(elements, links):
    """Least of all margins above their levels, at the place last measured; their weights are set."""
    note_margins(elements, links)
    least = math.inf
    for n in range(elements.shape[0]):
        link = links[n]
        for i in range(link.lines):
            low, high = link.low1[i] - link.low[i], link.high1[i] - link.high[i]
            link.low_weight[i], link.high_weight[i] = weight_of(low), weight_of(high)
            least = min(least, low, high)
        if link.lines == 2 and elements[n].interaction != 0:
            joint = link.joint1 - link.joint
            link.joint_weight = weight_of(joint)
            least = min(least, joint)
    return least


@inner
def least_weighed_margin(elements, links):
    """Least of the margins that have a weight, each times it."""
    least = math.inf
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        for i in range(link.lines):
            low, high = margins(el, link, i, link.e[i], link.rate[i], link.push, link.push_rate)
            least = min(
                least,
                weighed(low - link.low[i], link.low_weight[i]),
                weighed(high - link.high[i], link.high_weight[i]),
            )
        if link.lines == 2 and el.interaction != 0:
            joint = joint_margin(el, link.force[NORMAL], link.force[TANGENT]) - link.joint
            least = min(least, weighed(joint, link.joint_weight))
    return least


@inline
def _halfway(link, i, h):
    """Elongation and rate in the middle of a step, by the cubic through both ends."""
    e0, e1, v0, v1 = link.e0[i], link.e[i], link.rate0[i], link.rate[i]
    return 0.5 * (e0 + e1) + 0.125 * h * (v0 - v1), 1.5 * (e1 - e0) / h - 0.25 * (v0 + v1)


@inner
def suspicious(elements, links, h):
    """Earliest time at which a parabola has a margin below its level, or h; the end has been measured."""
    first = h
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        if link.lines == 0 or link.calm:
            continue
        e_m, v_m = _halfway(link, NORMAL, h)
        push_m, push_rate_m = elastic_push(el, link, e_m, v_m)
        shares = link.lines == 2 and el.interaction != 0
        j0 = jm = 0.0
        for i in range(link.lines):
            e_m, v_m = _halfway(link, i, h)
            if shares:
                jm += share(el, i, force(el, link, i, e_m, v_m, push_m))
                j0 += share(el, i, link.force0[i])
            low_m, high_m = margins(el, link, i, e_m, v_m, push_m, push_rate_m)
            low, high = link.low[i], link.high[i]
            u = falls_inside(link.low0[i] - low, low_m - low, link.low1[i] - low)
            if u > 0.0:
                first = min(first, u * h)
            if link.high0[i] < math.inf:
                u = falls_inside(link.high0[i] - high, high_m - high, link.high1[i] - high)
                if u > 0.0:
                    first = min(first, u * h)
        if shares:
            u = falls_inside(1.0 - j0 - link.joint, 1.0 - jm - link.joint, link.joint1 - link.joint)
            if u > 0.0:
                first = min(first, u * h)
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
def _note(device, i, F):
    if i == TANGENT:
        device.peak_shear = max(device.peak_shear, abs(F))
    elif F > 0.0:
        device.peak_pull = max(device.peak_pull, F)
    else:
        device.peak_push = max(device.peak_push, -F)


@inner
def note_forces(links, devices):
    """Keep the largest forces so far."""
    for n in range(devices.shape[0]):
        for i in range(links[n].lines):
            _note(devices[n], i, links[n].force[i])


@inline
def _reaches_peak(link, device, i):
    """Whether the force of a line may have been larger in the step than ever."""
    high = max(link.force0[i], link.force[i]) + link.swing[i]
    low = min(link.force0[i], link.force[i]) - link.swing[i]
    if i == TANGENT:
        return max(high, -low) > device.peak_shear
    return high > device.peak_pull or -low > device.peak_push


@inner
def _note_within(el, link, device, i, h):
    e_m, v_m = _halfway(link, NORMAL, h)
    push, _ = elastic_push(el, link, e_m, v_m)
    e_m, v_m = _halfway(link, i, h)
    _note(device, i, _vertex(link.force0[i], force(el, link, i, e_m, v_m, push), link.force[i]))
    _note(device, i, link.force[i])


@inner
def note_forces_within(elements, links, devices, h):
    """Keep the largest forces at the end of a step, and where they turn inside it."""
    for n in range(elements.shape[0]):
        el, link, device = elements[n], links[n], devices[n]
        for i in range(link.lines):
            if link.branch[i] == OPEN or (link.calm and not _reaches_peak(link, device, i)):
                continue
            _note_within(el, link, device, i, h)


@inner
def note_sample_forces(forces, links, s):
    """Write the forces down at a sample, where they are kept."""
    if forces.shape[0] == 0:
        return
    for n in range(forces.shape[1]):
        forces[s.k, n, F_NORMAL], forces[s.k, n, F_TANGENT] = links[n].force[NORMAL], links[n].force[TANGENT]
