"""Transition at an event: impacts, update of the devices' branches, choice of the next mode."""

from __future__ import annotations

from stayput.compiling import inner
from stayput.mechanics.columns import COULOMB, FAILED, FLOOR_BITS, PAPER
from stayput.mechanics.devices.elements import evaluate_elements, note_forces, update_elements
from stayput.mechanics.impact import closing_contacts, impact_without_collision, land
from stayput.mechanics.modes import choose_mode
from stayput.mechanics.paper import choose_paper_mode, collide_by_paper
from stayput.mechanics.pivot_impact import stop_on_landing
from stayput.mechanics.sampling import loads

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
    if law == PAPER:
        choose_paper_mode(scratch.contacts, case, s, touch, load[0], load[1])
        return
    for attempt in range(2):
        if attempt == 1:
            impact_without_collision(scratch.contacts, touch, case, s)
        if held is not None:
            _update_branches(held, s, time)
        choose_mode(scratch, touch, settle_rate, case, s, held, load, time)
        if s.kind != FAILED:
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
