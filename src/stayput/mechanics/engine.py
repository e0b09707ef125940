"""Event loop of the solver: integrate in one mode to the next event, handle it, choose the next mode."""

from __future__ import annotations

import math

from stayput.compiled import entry, inline, inner
from stayput.mechanics.columns import (
    C_CEILING,
    CEILING_IMPACT_EVENT,
    CLOSED,
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
    LEAN_MODE,
    LEANING,
    LIFT_OFF_EVENT,
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
from stayput.mechanics.impact import closing_contacts, impact_without_collision, land
from stayput.mechanics.modes import choose_mode, set_pivot_velocity
from stayput.mechanics.paper import choose_paper_mode, collide_by_paper
from stayput.mechanics.pivot_impact import pivot_on_landing
from stayput.mechanics.sampling import loads, public_mode, record_sample

COULOMB, PAPER = 0, 1


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


@inline
def advance(rows, contacts, case, s, ax, az, dt, extremes, tolerance, max_step, lifts, history):
    """Advance the body in its mode to the next event."""
    kind = s.kind
    if kind == REST:
        return advance_rest(case, s, ax, az, dt, extremes, history)
    if kind == SLIDE:
        s.moved |= MOVED_SLIDING
        friction = slide_friction(contacts, case, s)
        return advance_slide(contacts, case, s, ax, az, dt, friction, lifts, history)
    if kind in (ROCK, SLIDE_ROCK):
        s.moved |= MOVED_ROCKING if kind == ROCK else MOVED_ROCKING | MOVED_SLIDING
        return advance_fulcrum(contacts, case, s, ax, az, dt, tolerance, max_step, history)
    s.moved |= MOVED_FLYING
    if kind == FLIGHT:
        return advance_flight(contacts, case, s, ax, az, dt, history)
    return advance_lean(rows, contacts, case, s, ax, az, dt, tolerance, max_step, history)


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
def record_event(events, case, s, dt, why, kind, closed):
    """Write an event into its row of the list, if it has one; ``kind`` and ``closed`` are those before it."""
    if s.events > events.shape[0]:
        return
    row = events[s.events - 1]
    row[E_TIME], row[E_KIND] = s.k * dt + s.tau, _kind_of_event(s, why, kind, closed)
    row[E_MODE] = OVERTURNED_MODE if s.kind == OVERTURNED else public_mode(s)
    row[E_TILT], row[E_TILT_RATE] = s.theta - s.rest, s.omega
    row[E_SLIDE], row[E_SLIDE_RATE] = slide_of(case, s)


@inner
def is_finite(s):
    """Whether the state is finite; a run whose state is not ends as failed, never as a body that stands."""
    return math.isfinite(s.x + s.z + s.theta + s.vx + s.vz + s.omega + s.peak_tilt + s.peak_slide + s.tau)


@inner
def _outcome_of(s):
    """Public outcome of a run, from its final state."""
    if s.kind == FAILED or not is_finite(s) or s.tau < 0.0:
        return FAILED_OUTCOME
    if s.kind == OVERTURNED:
        return OVERTURNED_OUTCOME
    if public_mode(s) == LEAN_MODE:
        return LEANING
    if s.moved & ~MOVED_SLIDING:
        return ROCKED
    return SLID if s.moved else RESTED


@inner
def record_result(result, case, s, dt):
    """Write the result of a completed case."""
    result.outcome, result.end = _outcome_of(s), s.k * dt + s.tau
    result.residual_slide, result.residual_tilt = slide_of(case, s)[0], s.theta - s.rest
    result.peak_slide, result.peak_tilt = s.peak_slide, s.peak_tilt
    result.floor_impacts, result.wall_impacts = s.floor_impacts, s.wall_impacts
    result.events, result.steps = s.events, s.steps


@inner
def _update_mode(rows, contacts, touch, settle_rate, case, s, ax, az, dt, law):
    """Choose the mode at the present time, under either contact law.

    Where no active set is consistent (Painlevé), an impact without collision stops the slip first.
    """
    a, a_rate, G, G_rate = loads(case, ax, az, case.scale / dt, s.k, s.tau)
    if law == PAPER:
        choose_paper_mode(contacts, case, s, touch, a, a_rate)
        return
    choose_mode(rows, contacts, touch, settle_rate, case, s, a, a_rate, G, G_rate)
    if s.kind == FAILED:
        impact_without_collision(contacts, touch, case, s)
        choose_mode(rows, contacts, touch, settle_rate, case, s, a, a_rate, G, G_rate)


@inner
def _pivots_on_landing(contacts, touch, case, s, ax, az, dt):
    """Handle a landing by the fast path of `pivot_impact`, if it applies; whether it did."""
    a, _, G, _ = loads(case, ax, az, case.scale / dt, s.k, s.tau)
    return pivot_on_landing(contacts, touch, case, s, a, G)


@inner
def _handle_impacts(rows, contacts, touch, case, s, law):
    """Apply the impact of the contacts that close, if any do, and count it."""
    if law == COULOMB:
        # also contacts that close in the same instant as another one, or as a force reaches its limit
        s.hit |= closing_contacts(contacts, touch & ~s.closed, s)
    if not s.hit:
        return
    if s.hit & FLOOR_BITS:
        s.floor_impacts += 1
    else:
        s.wall_impacts += 1
    if law == PAPER:
        collide_by_paper(contacts, case, s)
    else:
        land(rows, contacts, s.closed, touch & ~s.closed, case, s)


@inner
def continue_case(
    case, ax, az, dt, extremes, law, tolerance, max_step, max_events, contacts, rows, s, history, events
):
    """Run a case from its present state and mode to its end; arguments as for `run_batch`.

    Each pass of the loop: integrate to the next event; stop at the end of the record, on overturning or on
    failure; apply impacts; choose the next mode; list the event.
    """
    lifts = law == COULOMB
    last = ax.shape[0] - 1
    while s.kind != FAILED:
        kind, closed = s.kind, s.closed
        why = advance(rows, contacts, case, s, ax, az, dt, extremes, tolerance, max_step, lifts, history)
        update_peaks(case, s)
        if why == ENDED:
            break
        s.events += 1
        if s.events >= max_events or not is_finite(s):
            s.kind = FAILED
        elif why == TURNED_OVER:
            s.kind = OVERTURNED
        if s.kind == FAILED or s.kind == OVERTURNED or s.k >= last:
            record_event(events, case, s, dt, why, kind, closed)
            break
        if why != CLOSED:
            s.hit = 0
        touch = touching(contacts, s) | s.closed | s.hit
        if why == CLOSED and lifts and _pivots_on_landing(contacts, touch, case, s, ax, az, dt):
            s.floor_impacts += 1
        else:
            _handle_impacts(rows, contacts, touch, case, s, law)
            if s.hit:
                why = CLOSED
            _update_mode(
                rows, contacts, touch, s.settle_rate if s.hit else STICK_RATE, case, s, ax, az, dt, law
            )
        record_event(events, case, s, dt, why, kind, closed)


@inner
def run_case(
    case, ax, az, dt, extremes, law, tolerance, max_step, max_events, contacts, rows, s, history, events
):
    """Run one case from its initial state to its end; arguments as for `run_batch`."""
    initialize_state(case, contacts, s)
    touch = touching(contacts, s) | s.closed
    s.hit = closing_contacts(contacts, touch & ~s.closed, s)
    _handle_impacts(rows, contacts, touch, case, s, law)
    kind, closed = s.kind, s.closed
    _update_mode(rows, contacts, touch, s.settle_rate if s.hit else STICK_RATE, case, s, ax, az, dt, law)
    if s.hit:
        s.events += 1
        record_event(events, case, s, dt, CLOSED, kind, closed)
    record_sample(history, case, s)
    continue_case(
        case, ax, az, dt, extremes, law, tolerance, max_step, max_events, contacts, rows, s, history, events
    )


@entry
def run_batch(
    cases,
    ax,
    az,
    dt,
    extremes,
    law,
    tolerance,
    max_step,
    max_events,
    contacts,
    rows,
    states,
    history,
    events,
    results,
):
    """Run an array of cases one after another: the only entry point, so that the solver is compiled once.

    Parameters
    ----------
    cases : CASE[m]
        The cases; a single one where history or events are kept.
    ax, az : float64[n]
        Floor acceleration at the samples, + right and + up [m/s²].
    dt : float
        Time between samples [s].
    extremes : tuple of four float64 arrays
        Smallest and largest ax and az over blocks of samples.
    law : int
        COULOMB or PAPER.
    tolerance, max_step : float
        Largest last term of the tilt's series in a step [rad]; longest step [s].
    max_events : int
        Events after which a run is stopped (FAILED).
    contacts, rows, states : CONTACT[8], ROW[8], STATE[1]
        Work arrays for the contact tables and the state.
    history : float64[n or 0, HISTORY]
        Filled at the samples reached; may be empty.
    events : float64[k, EVENT]
        Filled with the first k events; may be empty.
    results : RESULT[m]
        Set to the results of the cases.
    """
    s = states[0]
    for n in range(cases.shape[0]):
        run_case(
            cases[n],
            ax,
            az,
            dt,
            extremes,
            law,
            tolerance,
            max_step,
            max_events,
            contacts,
            rows,
            s,
            history,
            events,
        )
        record_result(results[n], cases[n], s, dt)
