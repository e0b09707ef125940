"""The engine in space: flows and steps between samples of the floor's motion, shortened where bodies meet.

Between events a lone body without rims flows (`stayput.mechanics.space.flow`); where it does not, it takes
plain steps. Those of groups and round bodies are refined (`stayput.mechanics.space.stepping`): of fourth
order, as long as their error allows, up to a longest one. Where contacts begin or end to bear within one it
is halved, down to a quarter of the longest plain one, and then taken as it is; where they begin or end to
slip, down to `LOCATED`, and it then ends when they do: what is left of it begins with their new friction.
What stands on the floor alone at rest is let go when its friction or its stance gives way. A step in which a
body would enter or hit another is shortened to where they meet, and the impact has a step of its own, the
shortest: in a longer one it would be solved with velocities that lack what half of that step brings. What a
body has entered (`ENTERS`) is moved out without a change of velocity.

Axes move with the floor: its acceleration acts on bodies against its direction.
"""

from __future__ import annotations

import math
from typing import Any

from stayput.compiling import entry, inline, inner
from stayput.mechanics.space.body import attitude, set_attitude, stop
from stayput.mechanics.space.closing import TOGETHER, keep, meeting, note_all_gaps
from stayput.mechanics.space.constants import (
    EVENT,
    LENGTH,
    LIMIT,
    PINNED_SPEED,
    PLAIN_GROWTH,
    PLAIN_GROWTH_OF_SEVERAL,
    ROUGH,
    SHORT,
    SHORTEST,
    SHORTEST_OF_SEVERAL,
    STEP_AFTER_EVENT,
)
from stayput.mechanics.space.devices import give, note_forces, note_loads
from stayput.mechanics.space.events import (
    all_stick,
    first_event,
    leaning,
    next_switch,
    note_hits,
    note_peaks,
    note_pose,
    note_pressing,
    note_weight,
    switch_now,
)
from stayput.mechanics.space.flow import (
    begin_flow,
    flow_on,
    note_flow,
    pin,
    presses_on_wall,
    settle,
    stands_off,
)
from stayput.mechanics.space.penetration import move_out
from stayput.mechanics.space.rest import (
    SLIPS,
    STAYS,
    TIPS,
    let_slip,
    note_stances,
    on_floor_alone,
    stays_until,
    surely_stays,
)
from stayput.mechanics.space.solve import any_closes_fast
from stayput.mechanics.space.stepping import RUBS, fastest, mean_push, moves, push_at, refine, step

IGNORED = 1e-12
"""Depth up to which a body that has entered another stays [m]: rounding."""

SHORT_STEPS = 8
"""Shortest steps in a row after which they are twice as long: bodies meet that do not come apart."""

DEEP = 1e-5
"""Depth from which on they are made shorter again [m]."""

LEAST, RIM_LEAST = 0.25, 0.02
"""The shortest that is halved no more, over the longest plain one, without and with rims."""

FINER = 0.25
"""The latter where contacts begin or end to slip, over the latter otherwise: friction jumps there."""

TOLERANCE, SLIDING, RIM_TOLERANCE = 1e-2, 1e-3, 1e-4
"""Difference of a step and its halves, over its length, up to which it is not shortened [m/s]; the same where
something slips that nothing holds, whose way may turn fast; and where a body has a rim, which turns fast
where it rolls nearly flat.
"""

SEVERAL = 1e-7
"""Difference up to which steps of several bodies are not shortened: their impulses are no surer [m]."""

CREEPS = 1e-4
"""Speed up to which what moves has no need of refined steps: it moves by a micrometre in one [m/s]."""

STOOD = 0.999
"""Share of a plain step before which it ends where a base stands that turns back: what sticks may hold it."""

LOCATED, AT_ONCE = 2.5, 0.1
"""Longest step, over the longest plain one, in which the time is found when a contact begins or ends to slip;
and the share of it within which others do so together with the first.
"""

TIMED, MOST_AGAIN = 2e-3, 3
"""How exactly that is found, over the time until then, and in how many more steps."""

GROWS = 4.0
"""How many times as long as the last a refined step may be."""

PAUSE = 4
"""Plain steps after an event where one follows on another, as in a tower that rattles."""

MOST_UNCONVERGED, FEW, MANY = 0.05, 20, 1000
"""Share of steps whose impulses did not converge from which on a run is given up (its forces are rough); not
up to a few, as in a moment, and with many at once.
"""

LYING, FALLEN = 1.0 - math.cos(math.radians(89.0)), 1.0 - math.cos(math.radians(60.0))
"""1 − cos of the tilt from which on a body lies, and from which on one of several does: those of a row that
has fallen lean on each other. None of them stands up again.
"""


@inline
def _stop_all(poses):
    for b in range(poses.shape[0]):
        stop(poses[b])


@inline
def _at_rest(poses):
    for b in range(poses.shape[0]):
        if moves(poses[b]):
            return False
    return True


@inline
def _copy_devices(pulls, devices, to_pulls, to_devices):
    for d in range(pulls.shape[0]):
        to_pulls[d], to_devices[d] = pulls[d], devices[d]


@inner
def _advance(world, held, poses, acceleration, k, numbers, t, last, scratch, pace, output):
    """Take one step from row 0 of the poses to row 1, at the time t after sample k of the acceleration.

    Returns
    -------
    tuple
        Its length, the number of contacts, the least gap at its end, and whether it has been refined.
    """
    dt, longest, gravity = numbers[0], numbers[1], numbers[2]
    contacts, kept, gaps, work = scratch[0], scratch[1], scratch[2], output[5]
    now, trial = poses[0], poses[1]
    springs, most = held[0].shape[0] > 0, numbers[4]
    shortest, round_edges = pace[LIMIT], world[2].shape[0] > 0
    lone = _flows(world)
    grows = PLAIN_GROWTH if lone else PLAIN_GROWTH_OF_SEVERAL
    least_h = (RIM_LEAST if round_edges else LEAST) * longest
    h = (dt - t) / math.ceil((dt - t) / pace[LENGTH] * (1.0 - 1e-12))
    if springs and t == 0.0 and pace[LENGTH] >= 2.0 * dt and k + 2 < acceleration.shape[0]:
        h = 2.0 * dt  # each of its halves from a sample to the next
    # ``switch``, if not 0: contacts that changed by this share of a longer step do so at the end of this one
    plain, switch, tries = False, 0.0, 0
    while True:
        if dt < h < 2.0 * dt:
            h, switch = dt, 0.0
        push, ratio = mean_push(acceleration, k, t, h, dt, gravity), h / last if last > 0.0 else 0.0
        count, meets, stands = step(world, held, now, trial, push, h, shortest, scratch, kept[0], ratio, work)
        least = math.inf
        if meets == h or h <= shortest:
            least, left = note_all_gaps(world, trial, scratch, gaps[1])
            if left < 0.0:
                meets = min(meets, meeting(world, trial, gaps[0], gaps[1], h))
        if meets < h and h > shortest:
            h, switch = max(shortest, min(meets, h - shortest)), 0.0
            continue
        if switch > 0.0:
            again = next_switch(contacts, count, kept, switch)
            if (
                tries < MOST_AGAIN
                and abs(again - 1.0) > TIMED
                and shortest < again * h < min(2.0 * h, dt - t)
            ):
                h, tries = again * h, tries + 1
                continue
            switch_now(contacts, count, kept, switch, trial)
            if fastest(world[0], trial) <= CREEPS and all_stick(contacts, count):
                _stop_all(trial)
            pace[LENGTH] = min(max(pace[LENGTH], grows * h), longest if lone else most)
            return h, count, least, False
        plain = plain or pace[ROUGH] > 0.0 or h < max(0.5 * least_h, 2.0 * shortest)
        plain = plain or lone or any_closes_fast(contacts, count)
        # from rest it may begin to move within the step, which its end does not tell
        slow = 0.0 < fastest(world[0], now) <= CREEPS and fastest(world[0], trial) <= CREEPS
        if (plain and h > longest) or (slow and h > dt):
            h = longest if plain else dt
            continue
        if plain or slow:
            keep(contacts, count, kept[1], scratch[7][3])
            if lone:
                stands = min(stands, first_event(kept) * h)
            if shortest < stands < STOOD * h:
                switch, h = stands / h + AT_ONCE, stands
                continue
            pace[LENGTH] = (
                min(GROWS * h, most) if slow and not lone else min(max(pace[LENGTH], grows * h), longest)
            )
            return h, count, least, False
        slides = not springs and not all_stick(contacts, count)
        within = RIM_TOLERANCE if round_edges else (SLIDING if slides else TOLERANCE)
        keep(contacts, count, kept[1], scratch[7][3])
        _copy_devices(held[1], held[2], scratch[9], scratch[10])
        allowed = within * h if poses.shape[1] == 1 else max(within * h, SEVERAL)
        error, count = refine(
            world, held, poses, acceleration, k, dt, t, h, gravity, scratch, ratio, allowed, output
        )
        if error >= 0.0 and (error <= allowed or h <= 2.0 * least_h):
            least, left = note_all_gaps(world, trial, scratch, gaps[1])
            meets = meeting(world, trial, gaps[0], gaps[1], h) if left < 0.0 else h
            if meets == h:
                pace[EVENT] = max(least_h, 0.5 * pace[EVENT])
                factor = 0.8 * math.sqrt(allowed / max(error, 1e-15))
                pace[LENGTH] = max(2.0 * least_h, h * min(GROWS, max(0.5, factor)))
                pace[LENGTH] = min(most, pace[LENGTH])
                return h, count, least, True
        _copy_devices(scratch[9], scratch[10], held[1], held[2])
        down_to = pace[EVENT] * (FINER if error == RUBS else 1.0)
        first = first_event(kept) if error == RUBS and h <= LOCATED * longest else 1.0
        if meets < h:
            h = max(shortest, min(meets, h - shortest))
        elif error >= 0.0:
            h *= 0.25 if error > 16.0 * allowed else 0.5
        elif first == 1.0 and h > down_to:
            h = max(down_to, 0.5 * h)
        else:
            pace[EVENT] = min(2.0 * pace[EVENT], longest)
            if pace[EVENT] == longest:
                pace[ROUGH] = PAUSE
            plain = first == 1.0 or first * h < down_to
            switch, h = (0.0, min(h, down_to)) if plain else (first + AT_ONCE, first * h)


@inner
def _rests(world, held, poses, a0, a1, numbers, start, last, scratch, bears, work):
    """Return whether bodies at rest stay so between two samples, with the number of contacts and the step.

    What walls and other bodies help to bear is convex in the push: steps at both samples tell.
    """
    dt, longest, gravity = numbers[0], numbers[1], numbers[2]
    contacts, kept, marks = scratch[0], scratch[1], scratch[7][3]
    h = dt / math.ceil(dt / longest * (1.0 - 1e-12))
    count = 0
    for end in range(1 if bears else 0, 2):
        push, ratio = push_at(a0, a1, float(end), gravity), h / last if last > 0.0 else 0.0
        count, _, _ = step(world, held, poses[0], poses[1], push, h, h, scratch, kept[0], ratio, work)
        if not _at_rest(poses[1]):
            return False, count, last
        keep(contacts, count, kept[0], marks)
        last = h
    give(held[0], held[1], held[2], poses[1], start + dt)
    return True, count, last


@inner
def _stay(bodies, poses, histories, first):
    """Leave bodies where they are from a sample on."""
    _stop_all(poses)
    for later in range(first, histories.shape[1]):
        note_pose(histories, later, poses)


@inline
def _set_limit(pace, h, least, low, high):
    """Set the shortest step after one of length h, with bodies ``-least`` deep at its end."""
    pace[SHORT] = pace[SHORT] + 1.0 if h <= pace[LIMIT] else 0.0
    if pace[SHORT] == 0.0:
        pace[LIMIT] = low
    elif least < -DEEP:
        pace[LIMIT] = max(low, 0.5 * pace[LIMIT])
    elif pace[SHORT] % SHORT_STEPS == 0.0:
        pace[LIMIT] = min(2.0 * pace[LIMIT], high)


@inline
def _copy_rows(rows, to):
    for key in range(rows.shape[0]):
        for i in range(rows.shape[1]):
            to[key, i] = rows[key, i]


@inline
def _all_lie(bodies, poses):
    least = LYING if bodies.shape[0] == 1 else FALLEN
    for b in range(bodies.shape[0]):
        if leaning(bodies[b], poses[b]) < least:
            return False
    return True


@inline
def _flows(world):
    """Return whether what stands in the room is a lone body without rims, which flows between events."""
    return world[0].shape[0] == 1 and world[2].shape[0] == 0


@inline
def _shortest(alone):
    return SHORTEST if alone else SHORTEST_OF_SEVERAL


@inner
def _accept(world, held, poses, count, time, h, least, refined, numbers, scratch, output):
    """Accept a step of length h that began at a time; return the length of that whose contacts are kept."""
    bodies, now, trial = world[0], poses[0], poses[1]
    contacts, kept, gaps, pace, memory = scratch[0], scratch[1], scratch[2], scratch[11], scratch[12]
    longest, gravity, alone, flow = numbers[1], numbers[2], _flows(world), memory[0][0]
    _set_limit(pace, h, least, _shortest(alone), LEAST * longest)
    if least < -IGNORED:
        move_out(world, trial, scratch, 0.0 if refined else h)
        note_all_gaps(world, trial, scratch, gaps[1])
    last = 0.5 * h if refined else h
    if refined:
        note_peaks(bodies, poses[2], output[4])
        _copy_rows(kept[2], kept[0])
    else:
        if pace[SHORT] == 0.0:
            pace[ROUGH] = max(0.0, pace[ROUGH] - 1.0)
        note_hits(contacts, count, kept[0], time + h, trial, output[2], output[3])
        keep(contacts, count, kept[0], scratch[7][3])
        give(held[0], held[1], held[2], trial, time + h)
    slows = alone and fastest(bodies, trial) < fastest(bodies, now)
    for b in range(bodies.shape[0]):
        now[b] = trial[b]
    _copy_rows(gaps[1:2], gaps[0:1])
    flow.moved, flow.pause = 0, max(0, flow.pause - 1)
    if alone and flow.pause == 0:
        begin_flow(world, now, contacts, count, last, gravity, memory)
        if not flow.ready and any_closes_fast(contacts, count):
            pace[LENGTH] = STEP_AFTER_EVENT * longest
    creeps = slows and moves(now[0]) and fastest(bodies, now) <= PINNED_SPEED
    if creeps and presses_on_wall(contacts, count):
        pin(world, now, contacts, count, kept[0], last, gravity, memory)
        note_all_gaps(world, now, scratch, gaps[0])
    elif alone and not moves(now[0]) and stands_off(world, gaps[0]):
        settle(world, now, gaps[0], kept[0], memory)
        note_all_gaps(world, now, scratch, gaps[0])
    note_peaks(bodies, now, output[4])
    return last


@entry
def run_in_space(
    world: Any, held: Any, poses: Any, acceleration: Any, numbers: Any, scratch: Any, output: Any
) -> None:
    """Run bodies under a motion of the floor.

    Parameters
    ----------
    world : tuple
        What stands in the room, and the room: SOLID[n], POINT[p], RIM[r], PLANE[w], PAIR[m], FACE[f], corners
        of the faces int64[l], edges int64[e, 2].
    held : tuple
        What holds them: SPRING[d], PULL[d], DEVICE[d]; the last is the result, in newtons.
    poses : POSE[4, n]
        The initial poses in the first row, and the last at the end; the others are working memory.
    acceleration : float64[samples, 3]
        Of the floor [m/s²], linear between samples.
    numbers : float64[5]
        Time between samples [s], longest plain step [s], gravity [m/s²], how long all bodies lie before the
        run ends [s], and the longest refined step [s].
    scratch : tuple
        Working memory: CONTACT[c], what `keep` notes of contacts float64[3, keys, 10], gaps float64[2,
        features], places of the points float64[p, 3], polygons float64[2, corners, 4], points that touch
        float64[8, 5]; what bodies stand on: sides float64[p, 3], their numbers int64[n], circles float64[n,
        3], least friction float64[n], forces and moments of devices float64[n, 6], middles and distances
        float64[n, 4]; Newton's method: Jacobians, and D times these, float64[c + d, 2, 6, 6], matrix
        float64[n, n, 6, 6], vector float64[n, 6], first bodies of rows int64[n], velocities gained float64[n,
        6]; the axes that separated pairs last int64[m, 2], −1 at first; PULL[d] and DEVICE[d] before a step;
        float64[5]; of flows FLOW[1], PRESSING[c], its system
        (`stayput.mechanics.space.active_set.accelerate`), rates of the stages float64[7, 13], vectors of the
        state float64[6, 13], and how deep points may go float64[features].
    output : tuple
        Histories at the samples float64[n, samples, 19]; forces of the devices there float64[samples, d, 2],
        along the normal, + where it pulls, and the plane; HIT[h], the first hits; numbers of hits by body and
        kind int64[n + 1, 3], in the last row of all hits; the largest 1 − cos of the bodies' tilts at any
        step float64[n]; steps, steps whose impulses did not converge, work in updates of a contact (some
        0.04 µs each), and the most of it, float64[4]: added to. Beyond the most work, and where too many
        steps do not converge, bodies stay where they are.
    """
    dt, longest, gravity = numbers[0], numbers[1], numbers[2]
    bodies, floor = world[0], world[3][0]
    contacts, kept, gaps = scratch[0], scratch[1], scratch[2]
    histories, forces, work = output[0], output[1], output[5]
    now = poses[0]
    for b in range(bodies.shape[0]):
        set_attitude(bodies[b], now[b], attitude(now[b]))
    note_pose(histories, 0, now)
    note_all_gaps(world, now, scratch, gaps[0])
    last, lies, count = 0.0, 0.0, 0
    alone, pace = _flows(world), scratch[11]
    pace[LENGTH], pace[EVENT], pace[ROUGH] = longest, LEAST * longest, 0.0
    pace[SHORT], pace[LIMIT] = 0.0, _shortest(alone)
    noted, bears, why, stayed = False, False, STAYS, False
    flow = scratch[12][0][0]
    flow.ready = flow.moved = 0
    k = 0
    while k < acceleration.shape[0] - 1:
        a0, a1, start = acceleration[k], acceleration[k + 1], dt * k
        t = 0.0
        if stayed and alone and surely_stays(bodies, now, floor, push_at(a0, a1, 1.0, gravity), scratch[6]):
            t = dt
        while t < dt:
            # what preloaded devices bear at rest is known after a step
            if (last > 0.0 or held[0].shape[0] == 0) and _at_rest(now):
                if not noted:
                    note_stances(world, now, TOGETHER, scratch[6])
                    note_loads(held[0], held[1], last, scratch[6][4])
                    noted = True
                part, why, b = stays_until(bodies, now, floor, a0, a1, gravity, t / dt, scratch[6])
                bears = bears and part == 0.0  # what others help to bear at a sample they may not within it
                if why != STAYS and part == 0.0:
                    bears, count, last = _rests(
                        world, held, poses, a0, a1, numbers, start, last, scratch, bears, work
                    )
                if why == STAYS or bears:
                    break
                if why == SLIPS and on_floor_alone(contacts, count, b):
                    let_slip(world, b, kept[0])
                if alone and part * dt > t:
                    pace[LENGTH] = STEP_AFTER_EVENT * longest
                t = part * dt
                flow.ready = 0
            if flow.ready:
                h, last = flow_on(world, held, poses, acceleration, k, t, numbers, last, scratch, output)
                if h > 0.0:
                    t = dt if t + h >= dt - 1e-12 else t + h
                    noted, why = False, TIPS
                    continue
            if work[2] > work[3] or work[1] > max(MANY, MOST_UNCONVERGED * work[0]):
                _stay(bodies, now, histories, k + 1)
                return
            h, count, least, refined = _advance(
                world, held, poses, acceleration, k, numbers, t, last, scratch, pace, output
            )
            last = _accept(world, held, poses, count, start + t, h, least, refined, numbers, scratch, output)
            t = max(dt, h) if t + h >= dt - 1e-12 else t + h
            noted, why = False, TIPS
        stayed = why == STAYS
        if t > dt:  # it has taken two
            k += 1
            note_pose(histories, k, poses[2])
            lies = lies + dt if _all_lie(bodies, poses[2]) else 0.0
        note_pose(histories, k + 1, now)
        if why == STAYS:
            note_weight(histories, k + 1, bodies, push_at(a0, a1, 1.0, gravity), scratch[6][4])
        elif flow.moved:
            note_flow(histories, k + 1, flow)
        else:
            note_pressing(histories, k + 1, contacts, count, last)
        note_forces(held[1], forces[k + 1])
        lies = lies + dt if _all_lie(bodies, now) else 0.0
        if lies > numbers[3]:
            _stay(bodies, now, histories, k + 2)
            return
        k += 1
