"""Transition at an event: impacts, update of the element branches, choice of the next mode."""

from __future__ import annotations

from stayput.compiled import inner
from stayput.mechanics.columns import FAILED, FLOOR_BITS
from stayput.mechanics.devices.elements import evaluate_elements, note_forces, update_elements
from stayput.mechanics.devices.modes import choose_device_mode
from stayput.mechanics.impact import closing_contacts, impact_without_collision, land
from stayput.mechanics.sampling import loads

NEAR_SIMULTANEOUS = 1e-8
"""Interval below which two events count as simultaneous [s]."""

CROWDED_EVENTS = 8
"""Near-simultaneous events in a row after which each further one relaxes the event thresholds tenfold."""

MAX_SLACK_FACTOR = 1e6
"""Largest factor by which event thresholds are relaxed."""


@inner
def handle_impacts(rows, contacts, touch, case, s):
    """Apply the impact of the contacts that close, if any do; elements give no impulse."""
    s.hit |= closing_contacts(contacts, touch & ~s.closed, s)
    if not s.hit:
        return
    if s.hit & FLOOR_BITS:
        s.floor_impacts += 1
    else:
        s.wall_impacts += 1
    land(rows, contacts, s.closed, touch & ~s.closed, case, s)


@inner
def _update_branches(elements, links, devices, s, work, time):
    """Update the element branches for the state, repeatedly, as a failure shifts force to other elements."""
    for _ in range(3):
        evaluate_elements(elements, links, s.sin, s.cos, s.x, s.z, s.vx, s.vz, s.omega)
        failed = update_elements(elements, links, devices, time)
        work.failed += failed
        if failed == 0:
            break


@inner
def update_mode(
    elements, links, devices, rows, contacts, touch, settle_rate, case, s, work, spare, ax, az, dt
):
    """Update the elements, and choose the mode at the present time."""
    time = s.k * dt + s.tau
    a, a_rate, G, G_rate = loads(case, ax, az, case.scale / dt, s.k, s.tau)
    for attempt in range(2):
        if attempt == 1:
            impact_without_collision(contacts, touch, case, s)
        _update_branches(elements, links, devices, s, work, time)
        choose_device_mode(
            elements,
            links,
            devices,
            rows,
            contacts,
            touch,
            settle_rate,
            case,
            s,
            work,
            spare,
            a,
            a_rate,
            G,
            G_rate,
            time,
        )
        if s.kind != FAILED:
            break
    # only now: the branches from before an impact do not hold for the rates after it
    note_forces(elements, links, devices)


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
