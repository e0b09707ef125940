"""Devices in space: springs between a point of a body and a place in the room, or on another body.

The law is that of `stayput.mechanics.devices.device_law`, with the tangent a vector in the plane: with the
elongation e, its plastic part p, slacks s₊ and s₋, stiffness k and damping c

    F = k (e − p − s₊) + c ė ≥ 0    where the spring pulls,
    F = k (e − p + s₋) + c ė ≤ 0    where it pushes, else 0,

and along the plane, with x = e_t − p_t, F_t = k (|x| − s) x/|x| + c ė_t. A force beyond its strength breaks
the device, or the elongation beyond it is plastic (radial return); friction bounds F_t by the push.

Elongations are those in the middle of a step, where the contacts are closed, and rates the mean of those
before and after the impulses of the step. Dampers are part of Newton's method for the impulses of the
contacts; what it leaves, as where a force reaches its strength, is found again and again with these.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.devices import columns as col
from stayput.mechanics.space.body import in_body, in_room, place_of
from stayput.mechanics.space.contact import give_impulse, mobility, velocity_at
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, dot, norm, normal_of, scaled

SAME = 5e-5
"""Change of a force up to which it is the same [N/kg]."""


@inline
def lever_of_pull(pull):
    """Return the point of the body from its G."""
    return pull.lx, pull.ly, pull.lz


@inline
def arm_of_pull(pull):
    """Return the anchor on the other body from its G."""
    return pull.ox, pull.oy, pull.oz


@inline
def _rate(spring, pull, poses):
    """Return the velocity of the body's point relative to the anchor."""
    u = velocity_at(poses[spring.body], lever_of_pull(pull))
    if spring.other != ROOM:
        u = added(u, -1.0, velocity_at(poses[spring.other], arm_of_pull(pull)))
    return u


@inner
def stretch(springs, pulls, poses):
    """Set the elongations of all devices that hold, and their rates before the impulses of a step."""
    for k in range(springs.shape[0]):
        spring, pull = springs[k], pulls[k]
        if pull.lost:
            continue
        s = poses[spring.body]
        pull.lx, pull.ly, pull.lz = in_room(s, (spring.px, spring.py, spring.pz))
        anchor, n = (spring.ax, spring.ay, spring.az), (spring.nx, spring.ny, spring.nz)
        t = pull.tx, pull.ty, pull.tz
        if spring.other != ROOM:
            r = poses[spring.other]
            arm = in_room(r, anchor)
            pull.ox, pull.oy, pull.oz = arm
            anchor, n, t = added(place_of(r), 1.0, arm), in_room(r, n), in_room(r, t)
        way = added(added(place_of(s), 1.0, lever_of_pull(pull)), -1.0, anchor)
        if spring.kind == col.AXIAL:
            far = norm(way)
            pull.e = far - spring.length
            n = scaled(1.0 / max(far, 1e-12), way)
        else:
            pull.e = dot(n, way)
            # along the plane, less what is plastic
            pull.xx, pull.xy, pull.xz = added(added(way, -pull.e, n), -1.0, t)
        pull.nx, pull.ny, pull.nz = n
        pull.ux, pull.uy, pull.uz = _rate(spring, pull, poses)
        pull.px = pull.py = pull.pz = 0.0


@inline
def _over(spring, pull):
    """Return the elongation of the normal line beyond its slack: above 0 it pulls, below 0 it pushes."""
    e = pull.e - pull.plastic
    plus, minus = e - spring.slack_plus[col.NORMAL], e + spring.slack_minus[col.NORMAL]
    if spring.slack_plus[col.NORMAL] + spring.slack_minus[col.NORMAL] == 0.0 or plus > 0.0:
        return plus
    return min(minus, 0.0)


@inline
def _bonded(spring):
    return spring.slack_plus[col.NORMAL] + spring.slack_minus[col.NORMAL] == 0.0


@inline
def _along_normal(spring, pull, rate):
    """Return the force of the normal line."""
    over = _over(spring, pull)
    if over == 0.0 and not _bonded(spring):
        return 0.0
    F = spring.stiffness[col.NORMAL] * over + spring.damping[col.NORMAL] * rate
    if not _bonded(spring):
        F = max(F, 0.0) if over > 0.0 else min(F, 0.0)
    return min(max(F, -spring.limit_minus[col.NORMAL]), spring.limit_plus[col.NORMAL])


@inline
def _most_shear(spring, F):
    """Return the largest force along the plane at the force F of the normal line."""
    if spring.friction == spring.friction:  # False for NaN
        return spring.friction * max(-F, 0.0)
    return spring.limit_plus[col.TANGENT]


@inline
def _along_plane(spring, pull, rate, F):
    """Return the force along the plane, a vector, at the force F of the normal line."""
    x = pull.xx, pull.xy, pull.xz
    far = norm(x)
    over = far - spring.slack_plus[col.TANGENT]
    if spring.stiffness[col.TANGENT] == 0.0 or (over <= 0.0 and spring.slack_plus[col.TANGENT] > 0.0):
        return 0.0, 0.0, 0.0
    force = scaled(spring.stiffness[col.TANGENT] * over / max(far, 1e-12), x)
    force = added(force, spring.damping[col.TANGENT], rate)
    if spring.slack_plus[col.TANGENT] > 0.0 and dot(force, x) < 0.0:
        return 0.0, 0.0, 0.0
    size, most = norm(force), _most_shear(spring, F)
    return scaled(most / size, force) if size > most else force


@inline
def damps(spring, pull):
    """Return whether the impulse of a device depends on the velocities after a step."""
    return pull.lost == 0 and (spring.damping[col.NORMAL] > 0.0 or spring.damping[col.TANGENT] > 0.0)


@inline
def _forces(spring, pull, rate):
    """Return the force along the normal, and that along the plane, a vector, at a rate; note their sizes."""
    n = normal_of(pull)
    along = dot(n, rate)
    F = _along_normal(spring, pull, along)
    shear = 0.0, 0.0, 0.0
    if spring.kind != col.AXIAL:
        shear = _along_plane(spring, pull, added(rate, -along, n), F)
    pull.force, pull.shear = F, norm(shear)
    return F, shear


@inner
def loads_of(springs, pulls, poses):
    """Return the force and the moment about G of all devices on a lone body that is and moves as it does."""
    force, moment = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    stretch(springs, pulls, poses)
    for k in range(springs.shape[0]):
        spring, pull = springs[k], pulls[k]
        if pull.lost:
            continue
        F, shear = _forces(spring, pull, (pull.ux, pull.uy, pull.uz))
        f = scaled(-1.0, added(shear, F, normal_of(pull)))
        force, moment = added(force, 1.0, f), added(moment, 1.0, cross(lever_of_pull(pull), f))
    return force, moment


@inner
def change_of_impulse(spring, pull, poses, h):
    """Return by how much the impulse of a device differs from that of the present velocities.

    Set are the forces at these, and by how much the impulse falls with the velocity.
    """
    rate = added(_rate(spring, pull, poses), 1.0, (pull.ux, pull.uy, pull.uz))
    F, shear = _forces(spring, pull, scaled(0.5, rate))
    pull.cn = pull.ct = 0.0
    if -spring.limit_minus[col.NORMAL] < F < spring.limit_plus[col.NORMAL] and (F != 0.0 or _bonded(spring)):
        pull.cn = 0.5 * h * spring.damping[col.NORMAL]
    if 0.0 < pull.shear < _most_shear(spring, F) * (1.0 - 1e-12):
        pull.ct = 0.5 * h * spring.damping[col.TANGENT]
    return added(scaled(-h, added(shear, F, normal_of(pull))), -1.0, (pull.px, pull.py, pull.pz))


@inner
def change_impulse(spring, pull, bodies, poses, change):
    """Change the impulse of a device; velocities go with it."""
    pull.px, pull.py, pull.pz = added((pull.px, pull.py, pull.pz), 1.0, change)
    give_impulse(bodies[spring.body], poses[spring.body], lever_of_pull(pull), 1.0, change)
    if spring.other != ROOM:
        give_impulse(bodies[spring.other], poses[spring.other], arm_of_pull(pull), -1.0, change)


@inline
def _yielding(spring, pull, bodies, poses, n):
    """Return by how much the relative velocity along n at a device changes with an impulse along n."""
    w = mobility(bodies[spring.body], poses[spring.body], lever_of_pull(pull), n)
    if spring.other != ROOM:
        w += mobility(bodies[spring.other], poses[spring.other], arm_of_pull(pull), n)
    return w


@inline
def _with_answer(spring, pull, bodies, poses, change):
    """Return what of a change of an impulse is left when the damper answers the velocity that it makes.

    Without it a strong damper would take back more than there was, each time more.
    """
    n = normal_of(pull)
    along = dot(n, change)
    across = added(change, -along, n)
    size = norm(across)
    along /= 1.0 + pull.cn * _yielding(spring, pull, bodies, poses, n)
    if size > 0.0 and pull.ct > 0.0:
        t = scaled(1.0 / size, across)
        across = scaled(1.0 / (1.0 + pull.ct * _yielding(spring, pull, bodies, poses, t)), across)
    return added(across, along, n)


@inner
def hold(springs, pulls, bodies, poses, h):
    """Bring the impulses of all devices near those of the present velocities; return whether any changed."""
    changed = False
    for k in range(springs.shape[0]):
        spring, pull = springs[k], pulls[k]
        if pull.lost:
            continue
        change = change_of_impulse(spring, pull, poses, h)
        if norm(change) > SAME * h * bodies[spring.body].mass:
            changed = True
            change_impulse(spring, pull, bodies, poses, _with_answer(spring, pull, bodies, poses, change))
    return changed


@inline
def _part_at(before, after, limit):
    """Return at which part of a step what changes evenly reaches a limit."""
    return min(1.0, max(0.0, (limit - before) / (after - before))) if after != before else 0.0


@inner
def first_switch(springs, before, pulls):
    """Return at which part of a step a device first begins or ends to bear, yields or rubs, or inf."""
    first = math.inf
    for k in range(springs.shape[0]):
        spring, pull, last = springs[k], pulls[k], before[k]
        if pull.lost:
            continue
        far_before, far = norm((last.xx, last.xy, last.xz)), norm((pull.xx, pull.xy, pull.xz))
        slack = spring.slack_plus[col.TANGENT]
        if (last.force > 0.0) != (pull.force > 0.0):
            first = min(first, _part_at(last.e, pull.e, pull.plastic + spring.slack_plus[col.NORMAL]))
        if (last.force < 0.0) != (pull.force < 0.0):
            first = min(first, _part_at(last.e, pull.e, pull.plastic - spring.slack_minus[col.NORMAL]))
        if (last.shear > 0.0) != (pull.shear > 0.0):
            first = min(first, _part_at(far_before, far, slack))
        if spring.interaction:
            continue
        most, least = spring.limit_plus[col.NORMAL], -spring.limit_minus[col.NORMAL]
        if pull.force >= most or pull.force <= least:
            over = (most if pull.force > 0.0 else least) / spring.stiffness[col.NORMAL]
            first = min(first, _part_at(_over(spring, last), _over(spring, pull), over))
        most = _most_shear(spring, pull.force)
        if pull.shear > 0.0 and pull.shear >= most * (1.0 - 1e-12):
            first = min(first, _part_at(far_before, far, slack + most / spring.stiffness[col.TANGENT]))
    return first


@inline
def _lose(pull, device, why, time):
    pull.lost, pull.force, pull.shear = 1, 0.0, 0.0
    device.failure, device.failure_time = why, time


@inner
def _yield_along_normal(spring, pull, device, time):
    """Make plastic what lies beyond the strength of the normal line, or break it."""
    k, over, F = spring.stiffness[col.NORMAL], _over(spring, pull), pull.force
    plus = F > 0.0
    most = spring.limit_plus[col.NORMAL] if plus else spring.limit_minus[col.NORMAL]
    if abs(F) < most or (spring.interaction and plus):
        return
    if spring.ultimate[col.NORMAL] == 0.0:
        _lose(pull, device, col.PULLED if plus else col.PUSHED, time)
        return
    grown = max(abs(over) - most / k, 0.0)
    pull.plastic += grown if plus else -grown
    device.plastic[col.NORMAL] = pull.plastic
    pull.plastic_sum += grown
    if pull.plastic_sum > spring.ultimate[col.NORMAL]:
        _lose(pull, device, col.DRAWN_OUT, time)


@inner
def _yield_along_plane(spring, pull, device, time, poses):
    """Make plastic what lies beyond the strength along the plane, or break the device."""
    most = _most_shear(spring, pull.force)
    rubs = spring.friction == spring.friction
    if spring.stiffness[col.TANGENT] == 0.0 or pull.shear < most or spring.interaction:
        return
    if spring.ultimate[col.TANGENT] == 0.0 and not rubs:
        _lose(pull, device, col.SHEARED, time)
        return
    x = pull.xx, pull.xy, pull.xz
    far = norm(x)
    grown = max(far - spring.slack_plus[col.TANGENT] - most / spring.stiffness[col.TANGENT], 0.0)
    step = scaled(grown / max(far, 1e-12), x)
    if spring.other != ROOM:
        step = in_body(poses[spring.other], step)
    pull.tx, pull.ty, pull.tz = added((pull.tx, pull.ty, pull.tz), 1.0, step)
    pull.slip_sum += grown
    slipped = norm((pull.tx, pull.ty, pull.tz))
    device.plastic[col.TANGENT] = slipped
    # a head that rubs is lost where it is off its pad, whatever it slipped to and fro
    used = slipped if rubs else pull.slip_sum
    if spring.ultimate[col.TANGENT] > 0.0 and used > spring.ultimate[col.TANGENT]:
        _lose(pull, device, col.DROPPED_OUT if rubs else col.DRAWN_OUT, time)


@inner
def note_loads(springs, pulls, h, loads):
    """Set the force and the moment of the devices on each body in the last step, of length h."""
    for b in range(loads.shape[0]):
        for axis in range(6):
            loads[b, axis] = 0.0
    for k in range(springs.shape[0]):
        spring, pull = springs[k], pulls[k]
        if pull.lost:
            continue
        p = scaled(1.0 / h, (pull.px, pull.py, pull.pz))
        _add_load(loads[spring.body], p, cross(lever_of_pull(pull), p), 1.0)
        if spring.other != ROOM:
            _add_load(loads[spring.other], p, cross(arm_of_pull(pull), p), -1.0)


@inline
def _add_load(load, force, moment, sign):
    for axis in range(3):
        load[axis] += sign * force[axis]
        load[3 + axis] += sign * moment[axis]


@inline
def note_forces(pulls, row):
    """Write the forces into a row of their history."""
    for k in range(pulls.shape[0]):
        row[k, col.NORMAL], row[k, col.TANGENT] = pulls[k].force, pulls[k].shear


@inner
def give(springs, pulls, devices, poses, time):
    """Note the forces of a step, make plastic what yielded, and let go what broke; return whether any did."""
    lost = False
    for k in range(springs.shape[0]):
        spring, pull, device = springs[k], pulls[k], devices[k]
        if pull.lost:
            continue
        F, shear = pull.force, pull.shear
        used = 0.0
        if spring.interaction:
            of_pull = max(F, 0.0) / spring.limit_plus[col.NORMAL]
            of_shear = shear / spring.limit_plus[col.TANGENT]
            used = of_pull * of_pull + of_shear * of_shear
            if used >= 1.0:
                # no device bears more than its strength
                part = 1.0 / math.sqrt(used)
                F, shear = part * F if F > 0.0 else F, part * shear
                _lose(pull, device, col.PULLED if of_pull >= of_shear else col.SHEARED, time)
        device.peak_pull, device.peak_push = max(device.peak_pull, F), max(device.peak_push, -F)
        device.peak_shear = max(device.peak_shear, shear)
        if spring.drops_out:
            if F < 0.0:
                pull.pushes = 1
            elif pull.pushes:
                _lose(pull, device, col.DROPPED_OUT, time)
        if device.failure == col.HOLDS:
            _yield_along_normal(spring, pull, device, time)
        if device.failure == col.HOLDS and spring.kind != col.AXIAL:
            _yield_along_plane(spring, pull, device, time, poses)
        lost = lost or device.failure != col.HOLDS
    return lost
