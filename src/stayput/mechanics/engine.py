"""Event loop of the solver: integrate in one mode to the next event, handle it, choose the next mode.

There is one loop for bodies with and without devices. Where a case has none, ``held`` is None, and Numba
leaves out what devices need: a bare body compiles in less time, and runs as fast as if they were unknown.
"""

import math

from stayput.compiling import entry, inline, inner
from stayput.mechanics import columns as col
from stayput.mechanics.devices.elements import (
    evaluate_elements,
    no_element_left,
    note_forces,
    note_forces_of_links,
    set_up_elements,
    update_elements,
)
from stayput.mechanics.devices.stepper import REST_RATE, advance_step_by_step
from stayput.mechanics.flat import advance_rest, advance_slide, slide_friction
from stayput.mechanics.flight_and_lean import advance_flight, advance_lean
from stayput.mechanics.fulcrum import advance_fulcrum
from stayput.mechanics.geometry import (
    STICK_RATE,
    corner_right,
    corner_up,
    set_pivot_velocity,
    set_up,
    slide_of,
    touching,
    turn_to,
    update_peaks,
)
from stayput.mechanics.impact import (
    CLOSING,
    closing_contacts,
    impact_without_collision,
    land,
    pivot_on_landing,
    stop_on_landing,
)
from stayput.mechanics.modes import choose_mode
from stayput.mechanics.paper import choose_paper_mode, collide_by_paper
from stayput.mechanics.records import CaseDevices, loads, public_mode, record_sample

NEAR_SIMULTANEOUS = 1e-8
"""Interval below which two events count as simultaneous [s]."""

CROWDED_EVENTS = 8
"""Near-simultaneous events in a row after which each further one relaxes the event thresholds tenfold."""

MAX_SLACK_FACTOR = 1e6
"""Largest factor by which event thresholds are relaxed."""


@inner
def handle_impacts(scratch, touch, case, s, held, law):
    """Apply the impact of the contacts that close, if any do, and count it; devices give no impulse."""
    contacts = scratch.contacts
    if law == col.COULOMB:
        # also contacts that close in the same instant as another one, or as a force reaches its limit
        s.hit |= closing_contacts(contacts, touch & ~s.closed, s, CLOSING)
    if not s.hit:
        return
    if s.hit & col.FLOOR_BITS:
        s.floor_impacts += 1
    if closing_contacts(contacts, s.hit & ~col.FLOOR_BITS, s, col.HIT_SPEED):
        s.wall_impacts += 1
    if law == col.PAPER:
        collide_by_paper(contacts, case, s)
    elif held is None or not stop_on_landing(contacts, touch, case, s):  # of a bare body it was tried before
        land(scratch.rows, contacts, s.closed, touch & ~s.closed, case, s)


@inner
def _update_branches(held, s, time):
    """Update the devices' branches for the state, repeatedly, as a failure shifts force to others."""
    for _ in range(3):
        evaluate_elements(held.elements, held.links, s.sin, s.cos, s.x, s.z, s.vx, s.vz, s.omega)
        failed = update_elements(held.elements, held.links, held.devices, time)
        held.work.failed += failed
        if failed == 0:
            break


@inner
def update_mode(scratch, touch, settle_rate, case, s, held, motion, law):
    """Update the devices, and choose the mode at the present time, under either contact law.

    Where no active set is consistent (Painlevé), an impact without collision stops the slip first.
    """
    time = s.k * motion.dt + s.tau
    load = loads(case, motion.ax, motion.az, case.scale / motion.dt, s.k, s.tau)
    if law == col.PAPER:
        choose_paper_mode(scratch.contacts, case, s, touch, load[0], load[1])
        return
    for attempt in range(2):
        if attempt == 1:
            impact_without_collision(scratch.contacts, touch, case, s)
        if held is not None:
            _update_branches(held, s, time)
        choose_mode(scratch, touch, settle_rate, case, s, held, load, time)
        if s.kind != col.FAILED:
            break
    if held is not None:  # only now: the branches from before an impact do not hold for the rates after it
        note_forces(held.elements, held.links, held.devices)


@inner
def relax_event_thresholds(s, work, dt, before):
    """Zeno guard: relax event thresholds after repeated near-simultaneous events."""
    now = s.k * dt + s.tau
    if now - before > NEAR_SIMULTANEOUS:
        work.crowded_events, work.slack_factor = 0, 1.0
        return
    work.crowded_events += 1
    if work.crowded_events > CROWDED_EVENTS:
        work.slack_factor = min(10.0 * work.slack_factor, MAX_SLACK_FACTOR)


@inner
def initialize_state(case, contacts, s):
    """Set the initial state: the body on the floor, flat or tilted about one corner."""
    set_up(case, contacts, s)
    s.omega = case.tilt_rate
    right = case.tilt > 0.0 or (case.tilt == 0.0 and case.tilt_rate > 0.0)
    s.i, s.j, s.d, s.dj = (1 if right else 0), -1, 0, 0
    if case.tilt == 0.0:
        s.x += case.slide
        s.kind = col.SLIDE if case.tilt_rate == 0.0 else col.ROCK
        s.closed = col.FLOOR_BITS
    else:
        turn_to(s, s.rest + case.tilt)
        s.x = case.slide + (s.foot_b if right else s.foot_a) - corner_right(case, s.i, s)
        s.z = -corner_up(case, s.i, s)
        s.kind = col.ROCK
        s.closed = 1 << s.i
    set_pivot_velocity(contacts[s.i], s)
    s.vx += case.slide_rate
    if s.kind == col.ROCK and case.slide_rate != 0.0:
        s.kind = col.SLIDE_ROCK
    s.alpha = s.tau = 0.0
    s.k = s.floor_impacts = s.wall_impacts = s.events = s.steps = s.moved = s.hit = 0
    s.peak_tilt = s.peak_slide = 0.0
    update_peaks(case, s)


@inner
def _initialize_devices(case, s, held, dt):
    work = held.work
    work.foot = 0.0
    work.still_rate = REST_RATE
    work.step_limit = dt
    work.slack_factor = 1.0
    work.crowded_events = work.failed = work.facets = 0
    set_up_elements(held.elements, held.links, held.devices, case, s)


@inline
def _note_motion(s):
    kind = s.kind
    if kind == col.SLIDE:
        s.moved |= col.MOVED_SLIDING
    elif kind in (col.ROCK, col.SLIDE_ROCK):
        s.moved |= col.MOVED_ROCKING if kind == col.ROCK else col.MOVED_ROCKING | col.MOVED_SLIDING
    elif kind != col.REST:
        s.moved |= col.MOVED_FLYING


@inline
def _advance(scratch, case, s, held, motion, settings, output):
    """Advance the body in its mode to the next event."""
    _note_motion(s)
    kind = s.kind
    contacts, history = scratch.contacts, output.history
    if kind == col.REST:
        return advance_rest(case, held, s, motion, output)
    if held is not None:
        return advance_step_by_step(held, contacts, scratch.rows, case, s, motion, settings, output)
    if kind == col.SLIDE:
        friction = slide_friction(contacts, case, s)
        return advance_slide(contacts, case, s, motion, friction, settings.law == col.COULOMB, history)
    if kind in (col.ROCK, col.SLIDE_ROCK):
        return advance_fulcrum(contacts, case, s, motion, settings, history)
    if kind == col.FLIGHT:
        return advance_flight(contacts, case, s, motion, history)
    return advance_lean(scratch.rows, contacts, case, s, motion, settings, history)


@inner
def _kind_of_event(s, why, kind, closed):
    """Public kind of an event, from the modes and contacts before and after it."""
    if s.kind == col.FAILED:
        return col.FAILED_EVENT
    if s.kind == col.OVERTURNED:
        return col.OVERTURNED_EVENT
    if why == col.CLOSED:
        if s.hit & col.FLOOR_BITS:
            return col.FLOOR_IMPACT_EVENT
        return col.CEILING_IMPACT_EVENT if s.hit >> col.C_CEILING else col.WALL_IMPACT_EVENT
    if s.kind == col.REST:
        return col.REST_EVENT
    if closed & col.FLOOR_BITS and not s.closed & col.FLOOR_BITS:
        return col.LIFT_OFF_EVENT
    if closed & ~col.FLOOR_BITS and not s.closed & ~col.FLOOR_BITS:
        return col.WALL_RELEASE_EVENT
    if kind in (col.REST, col.SLIDE) and s.kind in (col.ROCK, col.SLIDE_ROCK):
        return col.UPLIFT_EVENT
    return col.STICK_EVENT if s.kind == col.ROCK else col.SLIP_EVENT


@inner
def _record_event(events, case, s, held, dt, why, before):
    """Write an event into its row of the list, if it has one.

    ``before`` is the mode before it: its kind, closed contacts and direction of slip. An event is listed as a
    device's failure where one failed, and is internal where only the branch of a device has changed.
    """
    if s.events > events.shape[0]:
        return
    kind, closed, d = before
    row = events[s.events - 1]
    row[col.E_TIME], row[col.E_KIND] = s.k * dt + s.tau, _kind_of_event(s, why, kind, closed)
    row[col.E_MODE] = col.OVERTURNED_MODE if s.kind == col.OVERTURNED else public_mode(s)
    row[col.E_TILT], row[col.E_TILT_RATE] = s.theta - s.rest, s.omega
    row[col.E_SLIDE], row[col.E_SLIDE_RATE] = slide_of(case, s)
    if held is not None and s.kind != col.FAILED and s.kind != col.OVERTURNED:
        if held.work.failed:
            row[col.E_KIND] = col.DEVICE_FAILURE_EVENT
        elif why == col.LIMIT and s.kind == kind and s.closed == closed and s.d == d:
            row[col.E_KIND] = col.INTERNAL_EVENT


@inner
def _is_finite(s):
    """Whether the state is finite; a run whose state is not ends as failed, never as a body that stands."""
    return math.isfinite(s.x + s.z + s.theta + s.vx + s.vz + s.omega + s.peak_tilt + s.peak_slide + s.tau)


@inner
def _outcome_of(s):
    """Public outcome of a run, from its final state."""
    if s.kind == col.FAILED or not _is_finite(s) or s.tau < 0.0:
        return col.FAILED_OUTCOME
    if s.kind == col.OVERTURNED:
        return col.OVERTURNED_OUTCOME
    if public_mode(s) == col.LEAN_MODE:
        return col.LEANING
    if s.moved & col.MOVED_FLYING or (s.moved & col.MOVED_ROCKING and s.peak_tilt > col.ROCKING_TILT):
        return col.ROCKED
    return col.SLID if s.moved & col.MOVED_SLIDING else col.RESTED


@inner
def _record_result(result, case, s, dt):
    """Write the result of a completed case."""
    result.outcome, result.end = _outcome_of(s), s.k * dt + s.tau
    result.residual_slide, result.residual_tilt = slide_of(case, s)[0], s.theta - s.rest
    result.peak_slide, result.peak_tilt = s.peak_slide, s.peak_tilt
    result.floor_impacts, result.wall_impacts = s.floor_impacts, s.wall_impacts
    result.events, result.steps = s.events, s.steps


@inner
def _handle_event(scratch, touch, case, s, held, motion, law, why):
    """Apply impacts, and choose the next mode; return why the last one ended."""
    handle_impacts(scratch, touch, case, s, held, law)
    settle_rate = s.settle_rate if s.hit else STICK_RATE
    update_mode(scratch, touch, settle_rate, case, s, held, motion, law)
    return col.CLOSED if s.hit else why


@inner
def _continue_case(case, scratch, s, held, motion, settings, output):
    """Run a case from its present state and mode to its end, or to where its last device has failed.

    Each pass of the loop: integrate to the next event; stop at the end of the record, on overturning or on
    failure; apply impacts; choose the next mode; list the event.

    Returns
    -------
    bool
        Whether the body goes on as one without devices.
    """
    dt, last = motion.dt, motion.ax.shape[0] - 1
    while s.kind != col.FAILED:
        if held is not None and s.kind != col.REST and no_element_left(held.links):
            return True
        before, time = (s.kind, s.closed, s.d), s.k * dt + s.tau
        why = _advance(scratch, case, s, held, motion, settings, output)
        update_peaks(case, s)
        if why == col.ENDED:
            break
        s.events += 1
        if s.events >= settings.max_events or not _is_finite(s):
            s.kind = col.FAILED
        elif why == col.TURNED_OVER:
            s.kind = col.OVERTURNED
        if s.kind == col.FAILED or s.kind == col.OVERTURNED or s.k >= last:
            _record_event(output.events, case, s, held, dt, why, before)
            break
        if why != col.CLOSED:
            s.hit = 0
        if held is not None:
            relax_event_thresholds(s, held.work, dt, time)
            held.work.failed = 0
        touch = touching(scratch.contacts, s) | s.closed | s.hit
        bare = held is None and settings.law == col.COULOMB
        a, _, G, _ = loads(case, motion.ax, motion.az, case.scale / dt, s.k, s.tau)
        if bare and why == col.CLOSED and pivot_on_landing(scratch.contacts, touch, case, s, a, G):
            s.floor_impacts += 1
        else:
            why = _handle_event(scratch, touch, case, s, held, motion, settings.law, why)
        _record_event(output.events, case, s, held, dt, why, before)
    return False


@inner
def _run_case(case, scratch, s, held, motion, settings, output):
    """Run one case from its initial state, which is set; otherwise as `_continue_case`."""
    touch = touching(scratch.contacts, s) | s.closed
    s.hit = closing_contacts(scratch.contacts, touch & ~s.closed, s, CLOSING)
    before = s.kind, s.closed, s.d
    _handle_event(scratch, touch, case, s, held, motion, settings.law, col.CLOSED)
    failed = 0 if held is None else held.work.failed
    if s.hit or failed:
        s.events += 1
        _record_event(output.events, case, s, held, motion.dt, col.CLOSED, before)
    record_sample(output.history, case, s)
    if held is not None:
        note_forces_of_links(output.forces, held.links, s)
    return _continue_case(case, scratch, s, held, motion, settings, output)


@inner
def _run_held_case(case, scratch, s, held, motion, settings, output):
    """Run one case with devices; where none of them does anything, as one without."""
    initialize_state(case, scratch.contacts, s)
    _initialize_devices(case, s, held, motion.dt)
    if no_element_left(held.links):
        _run_case(case, scratch, s, None, motion, settings, output)
        return
    if _run_case(case, scratch, s, held, motion, settings, output):
        _continue_case(case, scratch, s, None, motion, settings, output)
    for n in range(held.devices.shape[0]):
        for i in range(2):
            held.devices[n].plastic[i] = held.links[n].plastic[i]


@entry
def run_batch(cases, held, motion, settings, scratch, states, output, results):
    """Run an array of cases one after another: the only entry point of the solver.

    Parameters
    ----------
    cases : CASE[m]
        The cases; a single one where there is output.
    held : BatchDevices or None
        Their devices; none of them has any where it is None.
    motion, settings, scratch, output : Excitation, SolverSettings, Scratch, Output
        See `stayput.mechanics.records`.
    states : STATE[1]
        Working memory for the state.
    results : RESULT[m]
        Set to the results of the cases.
    """
    s = states[0]
    for n in range(cases.shape[0]):
        case = cases[n]
        if held is None:
            initialize_state(case, scratch.contacts, s)
            _run_case(case, scratch, s, None, motion, settings, output)
        else:
            works = held.works
            mine = CaseDevices(held.elements[n], held.links, held.devices[n], works[0], works[1])
            _run_held_case(case, scratch, s, mine, motion, settings, output)
        _record_result(results[n], case, s, motion.dt)
