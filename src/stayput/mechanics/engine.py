"""Event loop of the solver: integrate in one mode to the next event, handle it, choose the next mode.

There is one loop for bodies with and without devices. Where a case has none, ``held`` is None, and Numba
leaves out what devices need: a bare body compiles in less time, and runs as fast as if they were unknown.
"""

from __future__ import annotations

import math

from stayput.compiling import entry, inline, inner
from stayput.mechanics.columns import (
    C_CEILING,
    CEILING_IMPACT_EVENT,
    CLOSED,
    COULOMB,
    DEVICE_FAILURE_EVENT,
    E_KIND,
    E_MODE,
    E_SLIDE,
    E_SLIDE_RATE,
    E_TILT,
    E_TILT_RATE,
    E_TIME,
    ENDED,
    FAILED,
    FAILED_EVENT,
    FAILED_OUTCOME,
    FLIGHT,
    FLOOR_BITS,
    FLOOR_IMPACT_EVENT,
    INTERNAL_EVENT,
    LEAN_MODE,
    LEANING,
    LIFT_OFF_EVENT,
    LIMIT,
    MOVED_FLYING,
    MOVED_ROCKING,
    MOVED_SLIDING,
    OVERTURNED,
    OVERTURNED_EVENT,
    OVERTURNED_MODE,
    OVERTURNED_OUTCOME,
    REST,
    REST_EVENT,
    RESTED,
    ROCK,
    ROCKED,
    SLID,
    SLIDE,
    SLIDE_ROCK,
    SLIP_EVENT,
    STICK_EVENT,
    TURNED_OVER,
    UPLIFT_EVENT,
    WALL_IMPACT_EVENT,
    WALL_RELEASE_EVENT,
)
from stayput.mechanics.contact import STICK_RATE
from stayput.mechanics.devices.elements import no_element_left, note_forces_of_links, set_up_elements
from stayput.mechanics.devices.equilibrium import advance_held_rest
from stayput.mechanics.devices.stepper import REST_RATE, advance_step_by_step
from stayput.mechanics.flat import advance_rest, advance_slide, slide_friction
from stayput.mechanics.flight_and_lean import advance_flight, advance_lean
from stayput.mechanics.fulcrum import advance_fulcrum
from stayput.mechanics.geometry import (
    corner_right,
    corner_up,
    set_up,
    slide_of,
    touching,
    turn_to,
    update_peaks,
)
from stayput.mechanics.impact import closing_contacts
from stayput.mechanics.pivot_impact import pivot_on_landing
from stayput.mechanics.projection import set_pivot_velocity
from stayput.mechanics.records import CaseDevices
from stayput.mechanics.sampling import loads, public_mode, record_sample
from stayput.mechanics.transitions import handle_impacts, relax_event_thresholds, update_mode


@inner
def initialize_state(case, contacts, s):
    """Set the initial state: the body on the floor, flat or tilted about one corner."""
    set_up(case, contacts, s)
    s.omega = case.tilt_rate
    right = case.tilt > 0.0 or (case.tilt == 0.0 and case.tilt_rate > 0.0)
    s.i, s.j, s.d, s.dj = (1 if right else 0), -1, 0, 0
    if case.tilt == 0.0:
        s.x += case.slide
        s.kind = SLIDE if case.tilt_rate == 0.0 else ROCK
        s.closed = FLOOR_BITS
    else:
        turn_to(s, s.rest + case.tilt)
        s.x = case.slide + (s.foot_b if right else s.foot_a) - corner_right(case, s.i, s)
        s.z = -corner_up(case, s.i, s)
        s.kind = ROCK
        s.closed = 1 << s.i
    set_pivot_velocity(contacts[s.i], s)
    s.vx += case.slide_rate
    if s.kind == ROCK and case.slide_rate != 0.0:
        s.kind = SLIDE_ROCK
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
    if kind == SLIDE:
        s.moved |= MOVED_SLIDING
    elif kind in (ROCK, SLIDE_ROCK):
        s.moved |= MOVED_ROCKING if kind == ROCK else MOVED_ROCKING | MOVED_SLIDING
    elif kind != REST:
        s.moved |= MOVED_FLYING


@inline
def _advance(scratch, case, s, held, motion, settings, output):
    """Advance the body in its mode to the next event."""
    _note_motion(s)
    kind = s.kind
    contacts, history = scratch.contacts, output.history
    if held is not None:
        if kind == REST:
            return advance_held_rest(case, held, s, motion, output)
        return advance_step_by_step(held, contacts, scratch.rows, case, s, motion, settings, output)
    if kind == REST:
        return advance_rest(case, s, motion, history)
    if kind == SLIDE:
        friction = slide_friction(contacts, case, s)
        return advance_slide(contacts, case, s, motion, friction, settings.law == COULOMB, history)
    if kind in (ROCK, SLIDE_ROCK):
        return advance_fulcrum(contacts, case, s, motion, settings, history)
    if kind == FLIGHT:
        return advance_flight(contacts, case, s, motion, history)
    return advance_lean(scratch.rows, contacts, case, s, motion, settings, history)


@inner
def _kind_of_event(s, why, kind, closed):
    """Public kind of an event, from the modes and contacts before and after it."""
    if s.kind == FAILED:
        return FAILED_EVENT
    if s.kind == OVERTURNED:
        return OVERTURNED_EVENT
    if why == CLOSED:
        if s.hit & FLOOR_BITS:
            return FLOOR_IMPACT_EVENT
        return CEILING_IMPACT_EVENT if s.hit >> C_CEILING else WALL_IMPACT_EVENT
    if s.kind == REST:
        return REST_EVENT
    if closed & FLOOR_BITS and not s.closed & FLOOR_BITS:
        return LIFT_OFF_EVENT
    if closed & ~FLOOR_BITS and not s.closed & ~FLOOR_BITS:
        return WALL_RELEASE_EVENT
    if kind in (REST, SLIDE) and s.kind in (ROCK, SLIDE_ROCK):
        return UPLIFT_EVENT
    return STICK_EVENT if s.kind == ROCK else SLIP_EVENT


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
    row[E_TIME], row[E_KIND] = s.k * dt + s.tau, _kind_of_event(s, why, kind, closed)
    row[E_MODE] = OVERTURNED_MODE if s.kind == OVERTURNED else public_mode(s)
    row[E_TILT], row[E_TILT_RATE] = s.theta - s.rest, s.omega
    row[E_SLIDE], row[E_SLIDE_RATE] = slide_of(case, s)
    if held is not None and s.kind != FAILED and s.kind != OVERTURNED:
        if held.work.failed:
            row[E_KIND] = DEVICE_FAILURE_EVENT
        elif why == LIMIT and s.kind == kind and s.closed == closed and s.d == d:
            row[E_KIND] = INTERNAL_EVENT


@inner
def _is_finite(s):
    """Whether the state is finite; a run whose state is not ends as failed, never as a body that stands."""
    return math.isfinite(s.x + s.z + s.theta + s.vx + s.vz + s.omega + s.peak_tilt + s.peak_slide + s.tau)


@inner
def _outcome_of(s):
    """Public outcome of a run, from its final state."""
    if s.kind == FAILED or not _is_finite(s) or s.tau < 0.0:
        return FAILED_OUTCOME
    if s.kind == OVERTURNED:
        return OVERTURNED_OUTCOME
    if public_mode(s) == LEAN_MODE:
        return LEANING
    if s.moved & ~MOVED_SLIDING:
        return ROCKED
    return SLID if s.moved else RESTED


@inner
def _record_result(result, case, s, dt):
    """Write the result of a completed case."""
    result.outcome, result.end = _outcome_of(s), s.k * dt + s.tau
    result.residual_slide, result.residual_tilt = slide_of(case, s)[0], s.theta - s.rest
    result.peak_slide, result.peak_tilt = s.peak_slide, s.peak_tilt
    result.floor_impacts, result.wall_impacts = s.floor_impacts, s.wall_impacts
    result.events, result.steps = s.events, s.steps


@inner
def _pivots_on_landing(contacts, touch, case, s, motion):
    """Handle a landing by the fast path of `pivot_impact`, if it applies; whether it did."""
    a, _, G, _ = loads(case, motion.ax, motion.az, case.scale / motion.dt, s.k, s.tau)
    return pivot_on_landing(contacts, touch, case, s, a, G)


@inner
def _handle_event(scratch, touch, case, s, held, motion, law, why):
    """Apply impacts, and choose the next mode; return why the last one ended."""
    handle_impacts(scratch, touch, case, s, held, law)
    settle_rate = s.settle_rate if s.hit else STICK_RATE
    update_mode(scratch, touch, settle_rate, case, s, held, motion, law)
    return CLOSED if s.hit else why


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
    while s.kind != FAILED:
        if held is not None and s.kind != REST and no_element_left(held.links):
            return True
        before, time = (s.kind, s.closed, s.d), s.k * dt + s.tau
        why = _advance(scratch, case, s, held, motion, settings, output)
        update_peaks(case, s)
        if why == ENDED:
            break
        s.events += 1
        if s.events >= settings.max_events or not _is_finite(s):
            s.kind = FAILED
        elif why == TURNED_OVER:
            s.kind = OVERTURNED
        if s.kind == FAILED or s.kind == OVERTURNED or s.k >= last:
            _record_event(output.events, case, s, held, dt, why, before)
            break
        if why != CLOSED:
            s.hit = 0
        if held is not None:
            relax_event_thresholds(s, held.work, dt, time)
            held.work.failed = 0
        touch = touching(scratch.contacts, s) | s.closed | s.hit
        bare = held is None and settings.law == COULOMB
        if bare and why == CLOSED and _pivots_on_landing(scratch.contacts, touch, case, s, motion):
            s.floor_impacts += 1
        else:
            why = _handle_event(scratch, touch, case, s, held, motion, settings.law, why)
        _record_event(output.events, case, s, held, dt, why, before)
    return False


@inner
def _run_case(case, scratch, s, held, motion, settings, output):
    """Run one case from its initial state, which is set; otherwise as `_continue_case`."""
    touch = touching(scratch.contacts, s) | s.closed
    s.hit = closing_contacts(scratch.contacts, touch & ~s.closed, s)
    before = s.kind, s.closed, s.d
    _handle_event(scratch, touch, case, s, held, motion, settings.law, CLOSED)
    failed = 0 if held is None else held.work.failed
    if s.hit or failed:
        s.events += 1
        _record_event(output.events, case, s, held, motion.dt, CLOSED, before)
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
