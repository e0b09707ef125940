"""One case from its first sample to its last: modes, and the events between them."""

from __future__ import annotations

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
    FLAT,
    FLIGHT,
    FLOOR_BITS,
    FLOOR_IMPACT_EVENT,
    HELD,
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
    REST_EVENT,
    RESTED,
    ROCKED,
    SLID,
    SLIP,
    SLIP_EVENT,
    STICK,
    STICK_EVENT,
    TURNED_OVER,
    UPLIFT_EVENT,
    WALL_IMPACT_EVENT,
    WALL_RELEASE_EVENT,
)
from stayput.mechanics.contact import STUCK
from stayput.mechanics.flat import advance_flat, advance_held, flat_friction
from stayput.mechanics.free import advance_flight, advance_lean
from stayput.mechanics.fulcrum import advance_fulcrum
from stayput.mechanics.geometry import above, across, note_peaks, set_up, slide_of, touching, turn_to
from stayput.mechanics.impact import closing, land, unjam
from stayput.mechanics.modes import choose_mode, pivot_on
from stayput.mechanics.motion import loads, named_mode, note_sample
from stayput.mechanics.paper import choose_paper_mode, collide_by_paper
from stayput.mechanics.rocking_on import rocks_on

COULOMB, PAPER = 0, 1


@inner
def start(case, contacts, s):
    """Set the initial state: the body on the floor, tilted about one corner or flat."""
    set_up(case, contacts, s)
    s.omega = case.tilt_rate
    right = case.tilt > 0.0 or (case.tilt == 0.0 and case.tilt_rate > 0.0)
    s.i, s.j, s.d, s.dj = (1 if right else 0), -1, 0, 0
    if case.tilt == 0.0:
        s.x += case.slide
        s.kind = FLAT if case.tilt_rate == 0.0 else STICK
        s.closed = FLOOR_BITS
    else:
        turn_to(s, s.rest + case.tilt)
        s.x = case.slide + (s.foot_b if right else s.foot_a) - across(case, s.i, s)
        s.z = -above(case, s.i, s)
        s.kind = STICK
        s.closed = 1 << s.i
    pivot_on(contacts[s.i], s)
    s.vx += case.slide_rate
    if s.kind == STICK and case.slide_rate != 0.0:
        s.kind = SLIP
    s.alpha = s.tau = 0.0
    s.k = s.floor_impacts = s.wall_impacts = s.events = s.steps = s.moved = s.hit = 0
    s.peak_tilt = s.peak_slide = 0.0
    note_peaks(case, s)


@inline
def advance(rows, contacts, case, s, ax, az, dt, extremes, tolerance, max_step, lifts, history):
    """Move the body in its mode to the next event."""
    kind = s.kind
    if kind == HELD:
        return advance_held(case, s, ax, az, dt, extremes, history)
    if kind == FLAT:
        s.moved |= MOVED_SLIDING
        friction = flat_friction(contacts, case, s)
        return advance_flat(contacts, case, s, ax, az, dt, friction, lifts, history)
    if kind in (STICK, SLIP):
        s.moved |= MOVED_ROCKING if kind == STICK else MOVED_ROCKING | MOVED_SLIDING
        return advance_fulcrum(contacts, case, s, ax, az, dt, tolerance, max_step, history)
    s.moved |= MOVED_FLYING
    if kind == FLIGHT:
        return advance_flight(contacts, case, s, ax, az, dt, history)
    return advance_lean(rows, contacts, case, s, ax, az, dt, tolerance, max_step, history)


@inner
def _kind_of_event(s, why, kind, closed):
    """What the user calls an event, from the mode and contacts before it and after."""
    if s.kind == FAILED:
        return FAILED_EVENT
    if s.kind == OVERTURNED:
        return OVERTURNED_EVENT
    if why == CLOSED:
        if s.hit & FLOOR_BITS:
            return FLOOR_IMPACT_EVENT
        return CEILING_IMPACT_EVENT if s.hit >> C_CEILING else WALL_IMPACT_EVENT
    if s.kind == HELD:
        return REST_EVENT
    if closed & FLOOR_BITS and not s.closed & FLOOR_BITS:
        return LIFT_OFF_EVENT
    if closed & ~FLOOR_BITS and not s.closed & ~FLOOR_BITS:
        return WALL_RELEASE_EVENT
    if kind in (HELD, FLAT) and s.kind in (STICK, SLIP):
        return UPLIFT_EVENT
    return STICK_EVENT if s.kind == STICK else SLIP_EVENT


@inner
def list_event(events, case, s, dt, why, kind, closed):
    """Write an event into its row of the list, if there is one; ``kind`` and ``closed`` were before it."""
    if s.events > events.shape[0]:
        return
    row = events[s.events - 1]
    row[E_TIME], row[E_KIND] = s.k * dt + s.tau, _kind_of_event(s, why, kind, closed)
    row[E_MODE] = OVERTURNED_MODE if s.kind == OVERTURNED else named_mode(s)
    row[E_TILT], row[E_TILT_RATE] = s.theta, s.omega
    row[E_SLIDE], row[E_SLIDE_RATE] = slide_of(case, s)


@inner
def _outcome_of(s):
    """What became of the body, as the user knows it."""
    if s.kind == FAILED:
        return FAILED_OUTCOME
    if s.kind == OVERTURNED:
        return OVERTURNED_OUTCOME
    if named_mode(s) == LEAN_MODE:
        return LEANING
    if s.moved & ~MOVED_SLIDING:
        return ROCKED
    return SLID if s.moved else RESTED


@inner
def note_result(result, case, s, dt):
    """Write down what became of a case that has come to its end."""
    result.outcome, result.end = _outcome_of(s), s.k * dt + s.tau
    result.residual_slide, result.residual_tilt = slide_of(case, s)[0], s.theta
    result.peak_slide, result.peak_tilt = s.peak_slide, s.peak_tilt
    result.floor_impacts, result.wall_impacts = s.floor_impacts, s.wall_impacts
    result.events, result.steps = s.events, s.steps


@inner
def _next_mode(rows, contacts, touch, settle, case, s, ax, az, dt, law):
    """Choose the mode at the present time, under either law."""
    a, a_rate, G, G_rate = loads(case, ax, az, case.scale / dt, s.k, s.tau)
    if law == PAPER:
        choose_paper_mode(contacts, case, s, touch, a, a_rate)
        return
    choose_mode(rows, contacts, touch, settle, case, s, a, a_rate, G, G_rate)
    if s.kind == FAILED:
        unjam(contacts, touch, case, s)
        choose_mode(rows, contacts, touch, settle, case, s, a, a_rate, G, G_rate)


@inner
def _rocks_on(contacts, touch, case, s, ax, az, dt):
    """Carry out the commonest event, if it is one; see `rocking_on`."""
    a, _, G, _ = loads(case, ax, az, case.scale / dt, s.k, s.tau)
    return rocks_on(contacts, touch, case, s, a, G)


@inner
def _meet(rows, contacts, touch, case, s, law):
    """Carry out the impact of the contacts that close, if any do."""
    if law == COULOMB:
        # contacts that close in the same instant as another, or as a force reaches its limit, collide too
        s.hit |= closing(contacts, touch & ~s.closed, s)
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
def carry_on(
    case, ax, az, dt, extremes, law, tolerance, max_step, max_events, contacts, rows, s, history, events
):
    """Run a case on from the mode that its state is in, to its end; arguments as of `run_batch`."""
    lifts = law == COULOMB
    last = ax.shape[0] - 1
    while s.kind != FAILED:
        kind, closed = s.kind, s.closed
        why = advance(rows, contacts, case, s, ax, az, dt, extremes, tolerance, max_step, lifts, history)
        note_peaks(case, s)
        if why == ENDED:
            break
        s.events += 1
        if s.events >= max_events:
            s.kind = FAILED
        elif why == TURNED_OVER:
            s.kind = OVERTURNED
        if s.kind == FAILED or s.kind == OVERTURNED or s.k >= last:
            list_event(events, case, s, dt, why, kind, closed)
            break
        if why != CLOSED:
            s.hit = 0
        touch = touching(contacts, s) | s.closed | s.hit
        if why == CLOSED and lifts and _rocks_on(contacts, touch, case, s, ax, az, dt):
            s.floor_impacts += 1
        else:
            _meet(rows, contacts, touch, case, s, law)
            if s.hit:
                why = CLOSED
            _next_mode(rows, contacts, touch, s.settle if s.hit else STUCK, case, s, ax, az, dt, law)
        list_event(events, case, s, dt, why, kind, closed)


@inner
def run_case(
    case, ax, az, dt, extremes, law, tolerance, max_step, max_events, contacts, rows, s, history, events
):
    """Run one case from rest, or its initial state, to its end; arguments as of `run_batch`."""
    start(case, contacts, s)
    touch = touching(contacts, s) | s.closed
    s.hit = closing(contacts, touch & ~s.closed, s)
    _meet(rows, contacts, touch, case, s, law)
    kind, closed = s.kind, s.closed
    _next_mode(rows, contacts, touch, s.settle if s.hit else STUCK, case, s, ax, az, dt, law)
    if s.hit:
        s.events += 1
        list_event(events, case, s, dt, CLOSED, kind, closed)
    note_sample(history, case, s)
    carry_on(
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
    """Run a column of cases one after another: the one way in, so that the mechanics is compiled once.

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
        Events after which a run is given up (FAILED).
    contacts, rows, states : CONTACT[8], ROW[8], STATE[1]
        Room for the contact tables and the state.
    history : float64[n or 0, HISTORY]
        Filled at the samples reached; may be empty.
    events : float64[k, EVENT]
        Filled with the first k events; may be empty.
    results : RESULT[m]
        Set to what became of the cases.
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
        note_result(results[n], cases[n], s, dt)
