"""The flow of a lone body: its smooth motion between events, while the same contacts press, stick and slip.

The contact problem of a step then has one solution that is smooth in time, and the motion is an ordinary
differential equation: on an edge that sticks of one degree of freedom (`stayput.mechanics.space.stuck_edge`),
on other contacts of six with their accelerations forbidden (`stayput.mechanics.space.active_set`), in flight
without any. It is integrated from sample to sample (`stayput.mechanics.space.flow_step`) until a contact
lifts, friction gives way, what slips is about to stand, a device fails, or a point meets a plane. There one
step of the general law with all contacts (`stayput.mechanics.space.stepping`) tells how it goes on.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.active_set import kappa_of, project
from stayput.mechanics.space.body import place_of, stop
from stayput.mechanics.space.closing import OPEN, note_all_gaps
from stayput.mechanics.space.columns import BY_ROOM
from stayput.mechanics.space.constants import (
    FLOW_WORK,
    IMPULSE_TIME,
    LENGTH,
    LONGEST_FLOW_STEP,
    PINNED_REST,
    PINNED_SPEED,
    PRESSING_SHARE,
    SETTLE_GAP,
    SETTLE_SPEED,
    SETTLED_GAP,
    SHORTEST,
    SLIP_BEGIN_SPEED,
    STEP_AFTER_EVENT,
    STIFF_PAUSE,
)
from stayput.mechanics.space.contact import slip, velocity_at
from stayput.mechanics.space.events import note_peaks
from stayput.mechanics.space.flow_step import GOES_ON, HITS, LANDS, STIFF, advance_flow
from stayput.mechanics.space.solve import any_closes_fast
from stayput.mechanics.space.stepping import fastest
from stayput.mechanics.space.touching import lever_of_point
from stayput.mechanics.space.vectors import added


@inline
def _fill_in(c, contact, points, features, s, body, on_floor, h):
    """Note a contact that presses after a step of length h."""
    c.key, c.plane, c.floor, c.sticks = contact.key, contact.plane, contact.floor, contact.stuck
    c.point = contact.key - contact.plane * features
    c.mu_static, c.mu_kinetic = contact.mu_static, contact.mu_kinetic
    if contact.floor and on_floor <= 2 and not points[c.point].mu_static >= 0.0:  # NaN: none of its own
        c.mu_static, c.mu_kinetic = body.edge_static, body.edge_kinetic
    c.kappa = kappa_of(body, on_floor) if contact.floor else 1.0
    c.pn, c.ps, c.pt = contact.pn / h, contact.ps / h, contact.pt / h
    c.ax, c.ay, c.az = added(place_of(s), 1.0, lever_of_point(s, points[c.point]))


@inner
def begin_flow(world, poses, contacts, count, h, gravity, memory):
    """Let a lone body flow on after a step of length h, if it does, with the contacts that pressed in it."""
    flow, pressing = memory[0][0], memory[1]
    body, points, s = world[0][0], world[1], poses[0]
    flow.ready = 0
    if any_closes_fast(contacts, count):
        return
    least = PRESSING_SHARE * body.mass * gravity * h
    number = on_floor = sticking = 0
    for c in contacts[:count]:
        if c.pn > least:
            number += 1
            on_floor += 1 if c.floor else 0
            sticking += 1 if c.stuck else 0
            u, v = slip(c, poses)
            if number > pressing.shape[0] or (not c.stuck and math.hypot(u, v) < SLIP_BEGIN_SPEED):
                return
    if number == 0 or (number > 2 and fastest(world[0], poses) <= PINNED_SPEED):
        return
    number = 0
    for c in contacts[:count]:
        if c.pn > least:
            _fill_in(pressing[number], c, points, points.shape[0], s, body, on_floor, h)
            number += 1
    flow.count, flow.all_stick = number, 1 if sticking == number else 0
    flow.on_edge = 1 if number == on_floor == sticking == 2 else 0
    flow.begins = flow.ready = 1
    flow.step = LONGEST_FLOW_STEP if flow.on_edge or flow.step_off_edge == 0.0 else flow.step_off_edge
    flow.relaxation = 1.0
    flow.fx = flow.fy = flow.fz = flow.mx = flow.my = flow.mz = 0.0


@inline
def presses_on_wall(contacts, count):
    """Return whether any contact that is not on the floor presses."""
    for c in contacts[:count]:
        if c.pn > 0.0 and not c.floor:
            return True
    return False


@inner
def pin(world, poses, contacts, count, kept, h, gravity, memory):
    """Stop a body that comes to rest on the contacts that press on it, and put it onto their planes.

    Contacts are closed from a small gap on, and general steps close what is left of it little by little: a
    body that leans on a wall would creep for a tenth of a second, and its contacts stick and slip in turn.
    """
    flow, pressing = memory[0][0], memory[1]
    body, points, s = world[0][0], world[1], poses[0]
    least = PRESSING_SHARE * body.mass * gravity * h
    flow.count, flow.all_stick = 0, 1
    for contact in contacts[:count]:
        if contact.pn > least and flow.count < pressing.shape[0]:
            c = pressing[flow.count]
            _fill_in(c, contact, points, points.shape[0], s, body, 0, h)
            c.sticks, kept[c.key, 3] = 1, 1.0
            flow.count += 1
    project(flow, pressing, body, points, world[3], s, memory[2])
    if fastest(world[0], poses) <= PINNED_REST:
        stop(s)


@inner
def keep_flow(kept, memory):
    """Note the contacts of a flow as those of a step, for the next one with all contacts."""
    flow, pressing = memory[0][0], memory[1]
    for key in range(kept.shape[0]):
        kept[key, 0] = kept[key, 1] = kept[key, 2] = 0.0
        kept[key, 3], kept[key, 4], kept[key, 8] = OPEN, 1.0, 0.0
    for c in pressing[: flow.count]:
        row = kept[c.key]
        row[0], row[1], row[2] = IMPULSE_TIME * c.pn, IMPULSE_TIME * c.ps, IMPULSE_TIME * c.pt
        row[3] = float(c.sticks)


@inline
def stands_off(world, gaps):
    """Return whether a point is nearly on the floor: within what counts as closed, and above rounding."""
    points = world[1]
    for i in range(points.shape[0]):
        if points[i].floor and SETTLED_GAP < gaps[i] <= SETTLE_GAP:
            return True
    return False


@inner
def settle(world, poses, gaps, kept, memory):
    """Stop points that are about to land on the floor slowly, or to leave it so, and put them onto it.

    Their friction is that of those that pressed, and stays noted.
    """
    flow, pressing = memory[0][0], memory[1]
    body, points, planes, s = world[0][0], world[1], world[3], poses[0]
    sticks = 1
    for c in pressing[: flow.count]:
        sticks = sticks if c.sticks else 0
    flow.count = flow.all_stick = 0
    for i in range(points.shape[0]):
        near = points[i].floor and gaps[i] <= SETTLE_GAP and flow.count < pressing.shape[0]
        if near and abs(velocity_at(s, lever_of_point(s, points[i]))[2]) <= SETTLE_SPEED:
            c = pressing[flow.count]
            c.key, c.plane, c.point, c.floor, c.sticks, c.kappa = i, 0, i, 1, sticks, 1.0
            kept[i, 3] = float(sticks) if kept[i, 3] == OPEN else kept[i, 3]
            flow.count += 1
    project(flow, pressing, body, points, planes, s, memory[2])


@inline
def note_flow(histories, sample, flow):
    """Note what presses on the body in a flow."""
    for axis in range(histories.shape[2] - BY_ROOM):
        histories[0, sample, BY_ROOM + axis] = 0.0
    row = histories[0, sample]
    row[BY_ROOM], row[BY_ROOM + 1], row[BY_ROOM + 2] = flow.px, flow.py, flow.pz


@inner
def flow_on(world, held, poses, acceleration, k, t, numbers, last, scratch, output):
    """Flow on from the time t after sample k.

    Returns
    -------
    tuple
        How long, 0 where it does not, and the length of the step that the contacts kept are of.
    """
    longest, now, pace, memory = numbers[1], poses[0], scratch[11], scratch[12]
    flow, kept, gaps = memory[0][0], scratch[1][0], scratch[2][0]
    devices_before = scratch[9], scratch[10]
    h, how = advance_flow(world, held, poses, acceleration, k, t, numbers, devices_before, memory, output[5])
    output[5][2] += FLOW_WORK
    if h > 0.0:
        now[0] = poses[1, 0]
        note_peaks(world[0], now, output[4])
        flow.moved, flow.refused = 1, 0
    if h > 0.0 and how == GOES_ON:
        return h, last
    flow.ready = 0
    if flow.moved:
        last = IMPULSE_TIME
        note_all_gaps(world, now, scratch, gaps)
        keep_flow(kept, memory)
        if how == LANDS:
            settle(world, now, gaps, kept, memory)
            note_all_gaps(world, now, scratch, gaps)
    if flow.moved or not flow.refused:
        pace[LENGTH] = SHORTEST if how == HITS else STEP_AFTER_EVENT * longest
    flow.refused = 1 if h == 0.0 else 0
    flow.pause = STIFF_PAUSE if how == STIFF else 0
    return h, last
