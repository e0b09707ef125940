"""When contacts begin or end to slip within a step, and what they do then; what the engine writes down.

Each contact notes whether it sticks after a step, and when that changed: of a step that is tried they are in
row 1 of what is kept of contacts, beside row 0 of the step before. Written down are poses, what presses on
bodies, and what they hit.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.columns import HIT_SPEED
from stayput.mechanics.space.body import in_room
from stayput.mechanics.space.closing import OPEN
from stayput.mechanics.space.columns import BY_BODIES, BY_ROOM, ON_BODY, ON_FLOOR, ON_ROOM
from stayput.mechanics.space.contact import first_tangent, second_tangent, stands_at
from stayput.mechanics.space.solve import end_of, slip_rate
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, normal_of, scaled


@inner
def note_hits(contacts, count, kept, time, poses, hits, numbers):
    """Count and list what was hit in a step, once whatever its points; ``kept`` is of the step before."""
    last = count
    for k in range(count):
        c = contacts[k]
        if c.closing > -HIT_SPEED or kept[c.key, 0] > 0.0:
            continue
        if last < count:
            d = contacts[last]
            if d.a == c.a and d.b == c.b and d.plane == c.plane:
                continue
        last = k
        kind = ON_FLOOR if c.floor else (ON_ROOM if c.b == ROOM else ON_BODY)
        numbers[c.a, kind] += 1
        if c.b != ROOM:
            numbers[c.b, kind] += 1
        listed = numbers[numbers.shape[0] - 1, 0]
        if listed < hits.shape[0]:
            hit = hits[listed]
            hit.a, hit.b, hit.plane = c.a, c.b, c.plane
            hit.time, hit.speed, hit.impulse = time, -c.closing, c.pn
            s = poses[c.a]
            hit.x, hit.y, hit.z = s.x, s.y, s.z
            hit.qw, hit.qx, hit.qy, hit.qz = s.qw, s.qx, s.qy, s.qz
        numbers[numbers.shape[0] - 1, 0] += 1


@inner
def note_pressing(histories, sample, contacts, count, h):
    """Note what pressed on the bodies in a step of length h."""
    for b in range(histories.shape[0]):
        for axis in range(histories.shape[2] - BY_ROOM):
            histories[b, sample, BY_ROOM + axis] = 0.0
    for c in contacts[:count]:
        n, s, t = normal_of(c), first_tangent(c), second_tangent(c)
        p = scaled(1.0 / h, added(added(scaled(c.pn, n), c.ps, s), c.pt, t))
        first = BY_ROOM if c.b == ROOM else BY_BODIES
        for axis in range(3):
            histories[c.a, sample, first + axis] += p[axis]
            if c.b != ROOM:
                histories[c.b, sample, first + axis] -= p[axis]


@inner
def note_weight(histories, sample, bodies, push, loads):
    """Note what presses on bodies that the floor alone holds at rest."""
    for b in range(bodies.shape[0]):
        for axis in range(3):
            histories[b, sample, BY_ROOM + axis] = -bodies[b].mass * push[axis] - loads[b, axis]


@inline
def note_pose(histories, sample, poses):
    """Note where the bodies are and how they move."""
    for b in range(poses.shape[0]):
        s, row = poses[b], histories[b, sample]
        row[0], row[1], row[2] = s.x, s.y, s.z
        row[3], row[4], row[5], row[6] = s.qw, s.qx, s.qy, s.qz
        row[7], row[8], row[9] = s.vx, s.vy, s.vz
        row[10], row[11], row[12] = s.wx, s.wy, s.wz


@inline
def leaning(body, s):
    """Return 1 − cos of a body's tilt."""
    up = in_room(s, (body.ux, body.uy, body.uz))
    return min(1.0 - up[2], 2.0)


@inline
def note_peaks(bodies, poses, peaks):
    """Note the largest 1 − cos of the bodies' tilts."""
    for b in range(bodies.shape[0]):
        peaks[b] = max(peaks[b], leaning(bodies[b], poses[b]))


GIVES = 1e-3
"""Share of the friction that contacts have by which they bear more at an end of a step before they slip."""

SPARE = 0.15
"""Share that they have to spare in the halves of a step over a sample."""

STANDS = 1e-4
"""Slip up to which a contact stands where others of its body do [m/s]."""


@inline
def changes(kept, other, key):
    """Return whether a contact that is closed in both slips in one (0) and sticks in the other (1)."""
    return kept[key, 3] + other[key, 3] == 1.0


@inner
def changes_at(c, kept, ratio, before, after):
    """Return when a contact begins or ends to slip, over a step's length: before or after its end too.

    What sticks slips where it has no friction to spare. That is taken as linear in time, from the middle of
    the last step to that of this one, and lacks what would take the slip away.
    """
    if kept[c.key, 3] == OPEN:
        return 1.0
    if kept[c.key, 3] == 0.0:
        return stands_at(c, before, after)
    if ratio == 0.0 or kept[c.key, 4] == 0.0:  # it stuck at the end of the last step alone
        return 0.0
    ps, pt = ratio * kept[c.key, 1], ratio * kept[c.key, 2]
    first = c.mu_static * ratio * kept[c.key, 0] - math.sqrt(ps * ps + pt * pt)
    spare = c.mu_static * c.pn - math.sqrt(c.ps * c.ps + c.pt * c.pt)
    if not c.stuck:
        spare -= slip_rate(c, after) / c.stiff
    if first <= max(0.0, spare):
        return math.inf
    middle = 0.5 / ratio
    return max(0.0, (middle + 0.5) * first / (first - spare) - middle)


@inline
def _spare(contacts, first, end, kept, whole, half):
    """Return what sticking contacts of a body have of friction beyond what they bear, and what they have.

    Of the impulses of a step (row 1) and of its second half (row 2) so many times each are meant.
    """
    most, s, t = 0.0, 0.0, 0.0
    for k in range(first, end):
        c = contacts[k]
        most += c.mu_static * (whole * kept[1, c.key, 0] + half * kept[2, c.key, 0])
        s += whole * kept[1, c.key, 1] + half * kept[2, c.key, 1]
        t += whole * kept[1, c.key, 2] + half * kept[2, c.key, 2]
    return most - math.sqrt(s * s + t * t), most


@inner
def gives_way(contacts, count, kept, over_sample):
    """Return whether friction gives way in a step that its mean holds; note in row 1 what slips, and when.

    Forces that are linear in time are at the ends of a step what it and its second half say. The motion of
    the floor has its peaks at samples, where steps end. One over a sample has its peak in the middle, of
    which its halves tell nothing: they have to have friction to spare, and no time is noted.
    """
    changed, first = False, 0
    while first < count:
        end, sticks = end_of(contacts, first, count), True
        for k in range(first, end):
            sticks = sticks and kept[1, contacts[k].key, 3] == 1.0
        now, most = _spare(contacts, first, end, kept, 2.0 if over_sample else 1.5, -2.0)
        then, last = _spare(contacts, first, end, kept, 0.0 if over_sample else -0.5, 2.0)
        least = SPARE if over_sample else -GIVES
        if sticks and min(most, last) > 0.0 and (now < least * most or then < least * last):
            if over_sample:
                return True
            changed = True
            for k in range(first, end):
                kept[1, contacts[k].key, 3] = 0.0
                kept[1, contacts[k].key, 4] = 0.0 if now <= 0.0 else now / (now - then)
        first = end
    return changed


@inner
def first_event(kept):
    """Return when in a step, as a share, the first contact begins or ends to slip; 1 where none does."""
    first = 1.0
    for key in range(kept.shape[1]):
        if changes(kept[0], kept[1], key):
            first = min(first, kept[1, key, 4])
    return first


@inline
def _switches(c, kept, by):
    """Return whether a contact began or ended to slip by a share of a longer step."""
    return changes(kept[0], kept[1], c.key) and kept[1, c.key, 4] <= by


@inner
def next_switch(contacts, count, kept, by):
    """Return when in this step the first of these does, as a share."""
    first = math.inf
    for k in range(count):
        if _switches(contacts[k], kept, by):
            first = min(first, contacts[k].when)
    return first


@inner
def switch_now(contacts, count, kept, by, poses):
    """Let these contacts begin or end to slip; where one stands all do that slip no more."""
    stand = False
    for c in contacts[:count]:
        if _switches(c, kept, by):
            c.stuck, c.when = int(kept[1, c.key, 3]), 0.0
            c.stood = c.stuck
            stand = stand or c.stuck == 1
    for c in contacts[:count]:
        if stand and kept[0, c.key, 3] == 0.0 and slip_rate(c, poses) <= STANDS:
            c.stuck = c.stood = 1
            c.when = 0.0


@inline
def all_stick(contacts, count):
    """Return whether no contact slips."""
    for k in range(count):
        if not contacts[k].stuck:
            return False
    return True
