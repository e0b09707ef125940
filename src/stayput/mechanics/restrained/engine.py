"""One case with elements from its first sample to its last: modes, and the events between them."""

from __future__ import annotations

from stayput.compiled import entry, inner
from stayput.mechanics.columns import (
    CLOSED,
    DEVICE_FAILURE_EVENT,
    E_KIND,
    ENDED,
    FAILED,
    FLAT,
    HELD,
    LIMIT,
    MOVED_FLYING,
    MOVED_ROCKING,
    MOVED_SLIDING,
    OVERTURNED,
    SLIP,
    STICK,
    TURNED_OVER,
)
from stayput.mechanics.contact import STUCK
from stayput.mechanics.engine import carry_on, list_event, note_result, run_case, start
from stayput.mechanics.geometry import note_peaks, touching
from stayput.mechanics.impact import closing
from stayput.mechanics.motion import note_sample
from stayput.mechanics.restrained.elements import none_left, note_forces_of_links, set_up_elements
from stayput.mechanics.restrained.holding import advance_held
from stayput.mechanics.restrained.moving import STILL, advance_moving
from stayput.mechanics.restrained.transitions import meet, mind_crowds, next_mode

UNNAMED = -1
"""Kind of an event that users are not told of: an element goes slack, say, and the mode stays."""

TOLERANCE_ALONE = 1e-10
"""Tolerance of the first kernel, which carries on where all devices are gone [rad]."""


@inner
def _note_how_it_moves(s):
    kind = s.kind
    if kind == FLAT:
        s.moved |= MOVED_SLIDING
    elif kind in (STICK, SLIP):
        s.moved |= MOVED_ROCKING if kind == STICK else MOVED_ROCKING | MOVED_SLIDING
    else:
        s.moved |= MOVED_FLYING


@inner
def _list(events, case, s, work, dt, why, kind, closed, d):
    """List an event: a failure of a device goes before, and one of elements alone has no name."""
    list_event(events, case, s, dt, why, kind, closed)
    if s.events > events.shape[0] or s.kind == FAILED or s.kind == OVERTURNED:
        return
    row = events[s.events - 1]
    if work.failed:
        row[E_KIND] = DEVICE_FAILURE_EVENT
    elif why == LIMIT and s.kind == kind and s.closed == closed and s.d == d:
        row[E_KIND] = UNNAMED


@inner
def _forget(work, dt):
    work.foot = 0.0
    work.still = STILL
    work.longest = dt
    work.patience = 1.0
    work.crowded = work.failed = work.facets = 0


@inner
def _run_restrained_case(
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
    """Run one case with elements to its end; arguments as of `run_restrained_batch`."""
    work, spare = works[0], works[1]
    start(case, contacts, s)
    _forget(work, dt)
    set_up_elements(elements, links, devices, case, s)
    if none_left(links):
        run_case(
            case,
            ax,
            az,
            dt,
            extremes,
            law,
            TOLERANCE_ALONE,
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
    s.hit = closing(contacts, touch & ~s.closed, s)
    meet(rows, contacts, touch, case, s)
    kind, closed = s.kind, s.closed
    settle = s.settle if s.hit else STUCK
    next_mode(elements, links, devices, rows, contacts, touch, settle, case, s, work, spare, ax, az, dt)
    if s.hit or work.failed:
        s.events += 1
        _list(events, case, s, work, dt, CLOSED, kind, closed, s.d)
    note_sample(history, case, s)
    note_forces_of_links(forces, links, s)
    while s.kind != FAILED:
        kind, closed, d = s.kind, s.closed, s.d
        before = s.k * dt + s.tau
        if kind == HELD:
            why = advance_held(case, links, s, work, ax, az, dt, extremes, history, forces)
        elif none_left(links):
            carry_on(
                case,
                ax,
                az,
                dt,
                extremes,
                law,
                TOLERANCE_ALONE,
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
            _note_how_it_moves(s)
            why = advance_moving(
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
        mind_crowds(s, work, dt, before)
        if why != CLOSED:
            s.hit = 0
        touch = touching(contacts, s) | s.closed | s.hit
        meet(rows, contacts, touch, case, s)
        if s.hit:
            why = CLOSED
        settle = s.settle if s.hit else STUCK
        work.failed = 0
        next_mode(elements, links, devices, rows, contacts, touch, settle, case, s, work, spare, ax, az, dt)
        _list(events, case, s, work, dt, why, kind, closed, d)
    for n in range(devices.shape[0]):
        for i in range(2):
            devices[n].plastic[i] = links[n].plastic[i]


@entry
def run_restrained_batch(
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
    """Run a column of cases, each with its row of elements; as `run_batch` of the first kernel.

    Parameters
    ----------
    elements : ELEMENT[m, e]
        The devices.
    law : int
        COULOMB; for the first kernel, which carries on without devices.
    tolerance : float
        Largest error of a step [m, rad].
    works : WORK[2]
        Room for what the kernel remembers.
    links : LINK[e]
        Room for where the elements stand.
    forces : float64[samples or 0, e, FORCES]
        Filled with the forces at the samples reached [N/kg]; may be empty.
    devices : DEVICE[m, e]
        Set to what became of the elements.
    """
    s = states[0]
    for n in range(cases.shape[0]):
        _run_restrained_case(
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
        note_result(results[n], cases[n], s, dt)
