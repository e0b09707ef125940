"""Event loop of the solver with devices: advance to the next event, handle it, choose the next mode."""

from __future__ import annotations

from stayput.compiled import entry, inner
from stayput.mechanics.columns import (
    CLOSED,
    DEVICE_FAILURE_EVENT,
    E_KIND,
    ENDED,
    FAILED,
    LIMIT,
    MOVED_FLYING,
    MOVED_ROCKING,
    MOVED_SLIDING,
    OVERTURNED,
    REST,
    ROCK,
    SLIDE,
    SLIDE_ROCK,
    TURNED_OVER,
)
from stayput.mechanics.contact import STICK_RATE
from stayput.mechanics.devices.elements import no_element_left, note_forces_of_links, set_up_elements
from stayput.mechanics.devices.equilibrium import advance_rest
from stayput.mechanics.devices.stepper import REST_RATE, advance_step_by_step
from stayput.mechanics.devices.transitions import handle_impacts, relax_event_thresholds, update_mode
from stayput.mechanics.engine import (
    continue_case,
    initialize_state,
    is_finite,
    record_event,
    record_result,
    run_case,
)
from stayput.mechanics.geometry import touching, update_peaks
from stayput.mechanics.impact import closing_contacts
from stayput.mechanics.sampling import record_sample

INTERNAL_EVENT = -1
"""Kind of an internal event, excluded from Run.events: a change of an element's branch while the mode stays.
"""

CONTINUATION_TOLERANCE = 1e-10
"""Tolerance of the solver without devices, which takes over once all devices have failed [rad]."""


@inner
def _note_motion(s):
    kind = s.kind
    if kind == SLIDE:
        s.moved |= MOVED_SLIDING
    elif kind in (ROCK, SLIDE_ROCK):
        s.moved |= MOVED_ROCKING if kind == ROCK else MOVED_ROCKING | MOVED_SLIDING
    else:
        s.moved |= MOVED_FLYING


@inner
def _record_event(events, case, s, work, dt, why, kind, closed, d):
    """List an event: as a device failure where one failed, internal where only a branch changed."""
    record_event(events, case, s, dt, why, kind, closed)
    if s.events > events.shape[0] or s.kind == FAILED or s.kind == OVERTURNED:
        return
    row = events[s.events - 1]
    if work.failed:
        row[E_KIND] = DEVICE_FAILURE_EVENT
    elif why == LIMIT and s.kind == kind and s.closed == closed and s.d == d:
        row[E_KIND] = INTERNAL_EVENT


@inner
def _reset_work(work, dt):
    work.foot = 0.0
    work.still_rate = REST_RATE
    work.step_limit = dt
    work.slack_factor = 1.0
    work.crowded_events = work.failed = work.facets = 0


@inner
def _run_device_case(
    case,
    elements,
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
    works,
    links,
    devices,
    history,
    forces,
    events,
):
    """Run one case with elements to its end; arguments as for `run_device_batch`.

    As `mechanics.engine.continue_case`, with element branches updated at each event. Without any active
    element, at the start or once the last has failed, the solver without devices takes over.
    """
    work, spare = works[0], works[1]
    initialize_state(case, contacts, s)
    _reset_work(work, dt)
    set_up_elements(elements, links, devices, case, s)
    if no_element_left(links):
        run_case(
            case,
            ax,
            az,
            dt,
            extremes,
            law,
            CONTINUATION_TOLERANCE,
            max_step,
            max_events,
            contacts,
            rows,
            s,
            history,
            events,
        )
        return
    last = ax.shape[0] - 1
    touch = touching(contacts, s) | s.closed
    s.hit = closing_contacts(contacts, touch & ~s.closed, s)
    handle_impacts(rows, contacts, touch, case, s)
    kind, closed = s.kind, s.closed
    settle_rate = s.settle_rate if s.hit else STICK_RATE
    update_mode(
        elements, links, devices, rows, contacts, touch, settle_rate, case, s, work, spare, ax, az, dt
    )
    if s.hit or work.failed:
        s.events += 1
        _record_event(events, case, s, work, dt, CLOSED, kind, closed, s.d)
    record_sample(history, case, s)
    note_forces_of_links(forces, links, s)
    while s.kind != FAILED:
        kind, closed, d = s.kind, s.closed, s.d
        before = s.k * dt + s.tau
        if kind == REST:
            why = advance_rest(case, links, s, work, ax, az, dt, extremes, history, forces)
        elif no_element_left(links):
            continue_case(
                case,
                ax,
                az,
                dt,
                extremes,
                law,
                CONTINUATION_TOLERANCE,
                max_step,
                max_events,
                contacts,
                rows,
                s,
                history,
                events,
            )
            break
        else:
            _note_motion(s)
            why = advance_step_by_step(
                elements,
                links,
                devices,
                contacts,
                rows,
                case,
                s,
                work,
                ax,
                az,
                dt,
                tolerance,
                max_step,
                history,
                forces,
            )
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
        relax_event_thresholds(s, work, dt, before)
        if why != CLOSED:
            s.hit = 0
        touch = touching(contacts, s) | s.closed | s.hit
        handle_impacts(rows, contacts, touch, case, s)
        if s.hit:
            why = CLOSED
        settle_rate = s.settle_rate if s.hit else STICK_RATE
        work.failed = 0
        update_mode(
            elements, links, devices, rows, contacts, touch, settle_rate, case, s, work, spare, ax, az, dt
        )
        _record_event(events, case, s, work, dt, why, kind, closed, d)
    for n in range(devices.shape[0]):
        for i in range(2):
            devices[n].plastic[i] = links[n].plastic[i]


@entry
def run_device_batch(
    cases,
    elements,
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
    works,
    links,
    history,
    forces,
    events,
    results,
    devices,
):
    """Run an array of cases, each with its row of elements; otherwise as `mechanics.engine.run_batch`.

    Parameters
    ----------
    elements : ELEMENT[m, e]
        The devices.
    law : int
        COULOMB; passed to the solver without devices when it takes over.
    tolerance : float
        Largest error of a step [m, rad].
    works : WORK[2]
        Work records.
    links : LINK[e]
        States of the elements.
    forces : float64[samples or 0, e, FORCES]
        Filled with the forces at the samples reached [N/kg]; may be empty.
    devices : DEVICE[m, e]
        Set to the results of the elements.
    """
    s = states[0]
    for n in range(cases.shape[0]):
        _run_device_case(
            cases[n],
            elements[n],
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
            works,
            links,
            devices[n],
            history,
            forces,
            events,
        )
        record_result(results[n], cases[n], s, dt)
