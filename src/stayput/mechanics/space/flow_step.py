"""A step of a flow, and where in it the flow ends.

Steps are those of Dormand and Prince's method 5(4), mostly a sample of the floor's motion long. At the end of
each the margins of all forces and slips, and the gaps of all points that do not press, tell whether an event
is within; the dense output of the step tells when.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics import dormand_prince as dp
from stayput.mechanics.space.active_set import (
    RATES,
    accelerate,
    margin_of,
    note_pressing_force,
    note_slips,
    project,
    set_friction_levers,
    set_levers,
)
from stayput.mechanics.space.body import attitude, in_body, rotation, set_attitude
from stayput.mechanics.space.constants import (
    AFTER_SWITCH,
    DEVICE_LOSS_STEP,
    DEVICE_STEP,
    EVENT_TIME_TOLERANCE,
    FLOW_TOLERANCE,
    GAP_TOLERANCE,
    LEAST_GROWTH,
    LONGEST_FLOW_STEP,
    MARGIN_TOLERANCE,
    MOST_EVENT_LOOKS,
    MOST_GROWTH,
    MOST_STEP_TRIES,
    SHORTEST_FLOW,
    SHORTEST_FLOW_STEP,
    STEP_SAFETY,
    SWITCH_STEP,
    VELOCITY_ERROR_TIME,
    YIELDS_ON,
)
from stayput.mechanics.space.contact import velocity_at
from stayput.mechanics.space.devices import first_switch, give, loads_of
from stayput.mechanics.space.solve import IMPACT
from stayput.mechanics.space.stepping import push_at
from stayput.mechanics.space.stuck_edge import (
    angle_within,
    begin_on_edge,
    press_on_edge,
    set_pose_on_edge,
    step_on_edge,
    turn_on_edge,
)
from stayput.mechanics.space.touching import gap_of_point, lever_of_point, may_touch, plane_from
from stayput.mechanics.space.vectors import dot, normal_of, quaternion_rate

GOES_ON, CHANGES, LANDS, HITS, STIFF = range(5)
"""How a step ends: with no event; forces, slips or a device change; a point meets a plane slowly, or hits it;
it would have to be too short.
"""

OF_GAP, OF_MARGIN = range(2)
"""What an event is found by."""


@inner
def evaluate(flow, world, held, stage, push, memory, row):
    """Set the forces on a body, and a row to the rates of what `_to_vector` writes."""
    pressing, system = memory[1], memory[2]
    body, s = world[0][0], stage[0]
    if held[0].shape[0] > 0:
        force, moment = loads_of(held[0], held[1], stage)
        flow.fx, flow.fy, flow.fz = force
        flow.mx, flow.my, flow.mz = moment
    accelerate(flow, pressing, body, world[1], world[3], s, push, system)
    row[0], row[1], row[2] = s.vx, s.vy, s.vz
    row[3], row[4], row[5], row[6] = quaternion_rate(attitude(s), in_body(s, rotation(s)))
    for i in range(6):
        row[7 + i] = system[3][RATES, i]


@inline
def _to_vector(s, y):
    y[0], y[1], y[2] = s.x, s.y, s.z
    y[3], y[4], y[5], y[6] = s.qw, s.qx, s.qy, s.qz
    y[7], y[8], y[9] = s.vx, s.vy, s.vz
    y[10], y[11], y[12] = s.lx, s.ly, s.lz


@inline
def _to_pose(body, y, s):
    s.x, s.y, s.z = y[0], y[1], y[2]
    s.vx, s.vy, s.vz = y[7], y[8], y[9]
    s.lx, s.ly, s.lz = y[10], y[11], y[12]
    set_attitude(body, s, (y[3], y[4], y[5], y[6]))


@inner
def _reach(flow, world, held, stage, push, memory, h, number):
    """Set the rates of a stage from those of the stages before it."""
    stages, vectors = memory[3], memory[4]
    b = dp.RATES[number]
    for i in range(13):
        vectors[1, i] = vectors[0, i] + h * (
            b[0] * stages[0, i]
            + b[1] * stages[1, i]
            + b[2] * stages[2, i]
            + b[3] * stages[3, i]
            + b[4] * stages[4, i]
            + b[5] * stages[5, i]
        )
    _to_pose(world[0][0], vectors[1], stage[0])
    evaluate(flow, world, held, stage, push, memory, stages[number])


@inner
def _step(flow, world, held, stage, a0, a1, t, dt, h, gravity, memory):
    """Take a step from row 0 of the vectors to ``stage``; return its errors: of places and of velocities."""
    stages, body = memory[3], world[0][0]
    for number in range(1, 6):  # all rows are read
        for i in range(13):
            stages[number, i] = 0.0
    for number in range(1, dp.STAGES):
        p = push_at(a0, a1, (t + dp.TIMES[number] * h) / dt, gravity)
        _reach(flow, world, held, stage, p, memory, h, number)
    place = turn = speed = momentum = 0.0
    for i in range(13):
        off = h * (
            dp.ERROR[0] * stages[0, i]
            + dp.ERROR[2] * stages[2, i]
            + dp.ERROR[3] * stages[3, i]
            + dp.ERROR[4] * stages[4, i]
            + dp.ERROR[5] * stages[5, i]
            + dp.ERROR[6] * stages[6, i]
        )
        if i < 3:
            place += off * off
        elif i < 7:
            turn += off * off
        elif i < 10:
            speed += off * off
        else:
            momentum += off * off
    least = max(body.r1, max(body.r2, body.r3))
    spin = least * least * math.sqrt(momentum)
    return math.sqrt(place) + 2.0 * body.radius * math.sqrt(turn), math.sqrt(speed) + body.radius * spin


@inner
def _set_dense(memory):
    """Set rows 2 to 5 of the vectors to the coefficients of the dense output (Shampine), over the step."""
    stages, vectors = memory[3], memory[4]
    for i in range(13):
        k1, k3, k4, k5, k6, k7 = (
            stages[0, i],
            stages[2, i],
            stages[3, i],
            stages[4, i],
            stages[5, i],
            stages[6, i],
        )
        vectors[2, i] = k1
        vectors[3, i] = (
            -8048581381.0 / 2820520608.0 * k1
            + 131558114200.0 / 32700410799.0 * k3
            - 1754552775.0 / 470086768.0 * k4
            + 127303824393.0 / 49829197408.0 * k5
            - 282668133.0 / 205662961.0 * k6
            + 40617522.0 / 29380423.0 * k7
        )
        vectors[4, i] = (
            8663915743.0 / 2820520608.0 * k1
            - 68118460800.0 / 10900136933.0 * k3
            + 14199869525.0 / 1410260304.0 * k4
            - 318862633887.0 / 49829197408.0 * k5
            + 2019193451.0 / 616988883.0 * k6
            - 110615467.0 / 29380423.0 * k7
        )
        vectors[5, i] = (
            -12715105075.0 / 11282082432.0 * k1
            + 87487479700.0 / 32700410799.0 * k3
            - 10690763975.0 / 1880347072.0 * k4
            + 701980252875.0 / 199316789632.0 * k5
            - 1453857185.0 / 822651844.0 * k6
            + 69997945.0 / 29380423.0 * k7
        )


@inner
def _go_to(flow, world, held, stage, a0, a1, t, dt, h, part, gravity, memory, forces):
    """Pose ``stage`` at a part of a step; return the margin there where ``forces`` are asked for."""
    body, vectors = world[0][0], memory[4]
    push = push_at(a0, a1, (t + part * h) / dt, gravity)
    if flow.on_edge:
        angle, rate = angle_within(flow, h, part)
        change = turn_on_edge(flow, world, held, stage, angle, rate, push) if forces else 0.0
        set_pose_on_edge(flow, body, angle, rate, stage[0])
        if forces:
            return press_on_edge(
                flow, memory[1], body, stage[0], angle, rate, change, push, _weight(body, gravity)
            )
        return 0.0
    for i in range(13):
        vectors[1, i] = vectors[0, i] + h * part * (
            vectors[2, i] + part * (vectors[3, i] + part * (vectors[4, i] + part * vectors[5, i]))
        )
    _to_pose(body, vectors[1], stage[0])
    if not forces:
        return 0.0
    evaluate(flow, world, held, stage, push, memory, memory[3][1])
    return margin_of(flow, memory[1], _weight(body, gravity))


@inline
def _weight(body, gravity):
    return body.mass * gravity


@inner
def note_depths(world, s, depths):
    """Note how deep points may go in a flow that begins."""
    points, planes = world[1], world[3]
    for j in range(planes.shape[0]):
        height, n = plane_from(s, planes[j])
        for i in range(points.shape[0]):
            if may_touch(points[i], planes[j]):
                gap = gap_of_point(points[i], height, n)
                depths[j * points.shape[0] + i] = min(0.0, gap - GAP_TOLERANCE)


@inline
def _presses(flow, pressing, plane, point):
    for c in pressing[: flow.count]:
        if c.point == point and c.plane == plane:
            return True
    return False


@inner
def least_gap(flow, pressing, world, s, depths):
    """Return the least gap of the points that do not press, beyond how deep they may go, and its number."""
    body, points, planes = world[0][0], world[1], world[3]
    least, number = math.inf, -1
    for j in range(planes.shape[0]):
        height, n = plane_from(s, planes[j])
        if height > body.radius:
            continue
        for i in range(points.shape[0]):
            if may_touch(points[i], planes[j]):
                gap = gap_of_point(points[i], height, n) - depths[j * points.shape[0] + i]
                if gap < least and not _presses(flow, pressing, j, i):
                    least, number = gap, j * points.shape[0] + i
    return least, number


@inner
def _how_it_meets(world, s, number):
    """Return whether a point lands on a plane slowly, or hits it."""
    points, planes = world[1], world[3]
    j = number // points.shape[0]
    lever = lever_of_point(s, points[number - j * points.shape[0]])
    return HITS if dot(normal_of(planes[j]), velocity_at(s, lever)) < -IMPACT else LANDS


@inner
def _find_event(
    flow, world, held, stage, a0, a1, t, dt, h, gravity, memory, kind, last, first_value, last_value
):
    """Return the part of a step at which a gap closes, or a margin is used up, by false position (Illinois).

    It is just before a gap is closed, and just beyond a margin.
    """
    low, high, at_low, at_high = 0.0, last, max(first_value, 1e-12), last_value
    side = 0
    for look in range(MOST_EVENT_LOOKS):
        part = (low * at_high - high * at_low) / (at_high - at_low)
        if not low < part < high or look % 5 == 4:
            part = 0.5 * (low + high)
        margin = _go_to(flow, world, held, stage, a0, a1, t, dt, h, part, gravity, memory, kind == OF_MARGIN)
        value = margin
        if kind == OF_GAP:
            value, _ = least_gap(flow, memory[1], world, stage[0], memory[5])
        if value < 0.0:
            high, at_high = part, value
            at_low = 0.5 * at_low if side == 1 else at_low
            side = 1
            if kind == OF_MARGIN and value > -MARGIN_TOLERANCE:
                break
        else:
            low, at_low = part, value
            at_high = 0.5 * at_high if side == 2 else at_high
            side = 2
            if kind == OF_GAP and value < GAP_TOLERANCE:
                break
        if (high - low) * h < EVENT_TIME_TOLERANCE:
            break
    return high if kind == OF_MARGIN else low


@inner
def _begin_step(flow, world, held, stage, push, gravity, memory):
    """Set the rates at the beginning of a step; where a flow begins, too, its pose, margins and gaps."""
    pressing, body, s = memory[1], world[0][0], stage[0]
    begins = flow.begins
    if begins:
        project(flow, pressing, body, world[1], world[3], s, memory[2])
    if flow.on_edge:
        if begins:
            begin_on_edge(flow, pressing, body, world[1], s)
        if begins or flow.kinked:
            flow.change = turn_on_edge(flow, world, held, stage, flow.angle, flow.rate, push)
        if begins:
            weight = _weight(body, gravity)
            flow.margin = press_on_edge(
                flow, pressing, body, s, flow.angle, flow.rate, flow.change, push, weight
            )
        flow.angle0, flow.rate0, flow.change0 = flow.angle, flow.rate, flow.change
    else:
        stages = memory[3]
        _to_vector(s, memory[4][0])
        if begins:
            set_levers(flow, pressing, world[1], s)
            set_friction_levers(flow, pressing, world[3], s)
        note_slips(flow, pressing)
        if begins or flow.kinked:
            evaluate(flow, world, held, stage, push, memory, stages[0])
            flow.margin = margin_of(flow, pressing, _weight(body, gravity))
        else:  # as the last step ended
            for i in range(13):
                stages[0, i] = stages[6, i]
    if begins:
        note_depths(world, s, memory[5])
        flow.gap, _ = least_gap(flow, pressing, world, s, memory[5])


@inner
def advance_flow(world, held, poses, acceleration, k, t, numbers, devices_before, memory, work):
    """Flow from row 0 of the poses to row 1, at most until the next sample.

    Returns
    -------
    tuple
        How long, 0 where it does not, and how it ends.
    """
    dt, longest, gravity = numbers[0], numbers[1], numbers[2]
    flow, body = memory[0][0], world[0][0]
    springs, pulls, devices = held
    now, stage = poses[0], poses[1]
    a0, a1 = acceleration[k], acceleration[k + 1]
    h = min(dt - t, flow.step)
    if dt - t - h < 0.2 * h:
        h = dt - t
    stage[0] = now[0]
    _begin_step(flow, world, held, stage, push_at(a0, a1, t / dt, gravity), gravity, memory)
    if not flow.margin >= 0.0:
        return 0.0, CHANGES
    if flow.begins:
        now[0] = stage[0]
    flow.begins = 0
    for d in range(springs.shape[0]):
        devices_before[0][d], devices_before[1][d] = pulls[d], devices[d]
    for _ in range(MOST_STEP_TRIES):
        if h < SHORTEST_FLOW_STEP * longest and h < dt - t:
            break
        work[0] += 1.0
        if flow.on_edge:
            off, rate_off = step_on_edge(flow, world, held, stage, a0, a1, t, dt, h, gravity)
            error = 2.0 * body.radius * (off + VELOCITY_ERROR_TIME * rate_off)
        else:
            place_off, off = _step(flow, world, held, stage, a0, a1, t, dt, h, gravity, memory)
            error = place_off + VELOCITY_ERROR_TIME * off
        allowed = FLOW_TOLERANCE * longest * h
        growth = STEP_SAFETY * (allowed / max(error, 1e-30)) ** 0.2
        if not error <= allowed:
            h *= max(LEAST_GROWTH, min(STEP_SAFETY, growth))
            continue
        margin = _end_of_step(flow, world, held, stage, a0, a1, t, dt, h, gravity, memory)
        gap, _ = least_gap(flow, memory[1], world, stage[0], memory[5])
        how, part = GOES_ON, 1.0
        if margin < 0.0 or gap < 0.0:
            part, how = _first_event(flow, world, held, stage, a0, a1, t, dt, h, gravity, memory, margin, gap)
            if part * h < SHORTEST_FLOW:
                stage[0] = now[0]
                return 0.0, how
        switch = first_switch(springs, devices_before[0], pulls)
        # what yields or rubs from the beginning on goes on to do so
        yields_on = switch <= YIELDS_ON
        after = (DEVICE_STEP if yields_on else SWITCH_STEP) * longest
        if (part - switch) * h > after:
            h = switch * h + AFTER_SWITCH * after
            continue
        if springs.shape[0] > 0 and give(springs, pulls, devices, stage, dt * k + t + part * h):
            if part * h > DEVICE_LOSS_STEP * longest:
                for d in range(springs.shape[0]):
                    pulls[d], devices[d] = devices_before[0][d], devices_before[1][d]
                h = max(0.25 * part * h, 0.5 * DEVICE_LOSS_STEP * longest)
                continue
            how = CHANGES
        if part == 1.0:
            flow.margin, flow.gap = margin, gap
            most = DEVICE_STEP * longest if yields_on else LONGEST_FLOW_STEP
            flow.step = min(most, h * max(LEAST_GROWTH, min(MOST_GROWTH, growth)))
            flow.kinked = 1 if switch <= 1.0 else 0
            if not flow.on_edge:
                flow.step_off_edge = max(flow.step, longest)
        if not flow.on_edge:
            project(flow, memory[1], body, world[1], world[3], stage[0], memory[2])
            note_pressing_force(flow, memory[1], world[3])
        return part * h, how
    stage[0] = now[0]
    return 0.0, STIFF


@inner
def _end_of_step(flow, world, held, stage, a0, a1, t, dt, h, gravity, memory):
    """Return the margin at the end of a step; on an edge pose the body there."""
    body = world[0][0]
    if not flow.on_edge:
        return margin_of(flow, memory[1], _weight(body, gravity))
    set_pose_on_edge(flow, body, flow.angle, flow.rate, stage[0])
    push = push_at(a0, a1, (t + h) / dt, gravity)
    return press_on_edge(
        flow, memory[1], body, stage[0], flow.angle, flow.rate, flow.change, push, _weight(body, gravity)
    )


@inner
def _first_event(flow, world, held, stage, a0, a1, t, dt, h, gravity, memory, margin, gap):
    """Pose ``stage`` at the first event of a step; return at which part of it, and how it ends."""
    pressing, depths, part, how = memory[1], memory[5], 1.0, CHANGES
    if not flow.on_edge:
        _set_dense(memory)
    for _ in range(2):
        # beyond a margin, as where what slips has stood, gaps are not those of the body: it comes first
        if margin < 0.0:
            part = _find_event(
                flow,
                world,
                held,
                stage,
                a0,
                a1,
                t,
                dt,
                h,
                gravity,
                memory,
                OF_MARGIN,
                part,
                flow.margin,
                margin,
            )
            _go_to(flow, world, held, stage, a0, a1, t, dt, h, part, gravity, memory, True)
            how = CHANGES
            gap, _ = least_gap(flow, pressing, world, stage[0], depths)
        if gap >= 0.0:
            break
        part = _find_event(
            flow, world, held, stage, a0, a1, t, dt, h, gravity, memory, OF_GAP, part, flow.gap, gap
        )
        margin = _go_to(flow, world, held, stage, a0, a1, t, dt, h, part, gravity, memory, True)
        gap, number = least_gap(flow, pressing, world, stage[0], depths)
        how = _how_it_meets(world, stage[0], number)
        if margin >= 0.0:
            break
    return part, how
