"""What the engine in space writes down: poses, what presses on bodies, and what they hit."""

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import in_room
from stayput.mechanics.space.columns import BY_BODIES, BY_ROOM, HIT_SPEED, ON_BODY, ON_FLOOR, ON_ROOM
from stayput.mechanics.space.contact import first_tangent, second_tangent
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, normal_of, scaled


@inner
def note_hits(contacts, count, kept, time, hits, numbers):
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
