"""From one mode to the next: impacts, the branches of the elements, the mode that follows."""

from __future__ import annotations

from stayput.compiled import inner
from stayput.mechanics.columns import FAILED, FLOOR_BITS
from stayput.mechanics.impact import closing, land, unjam
from stayput.mechanics.motion import loads
from stayput.mechanics.restrained.choose import choose_restrained_mode
from stayput.mechanics.restrained.elements import measure, note_forces, settle_elements

CROWDED = 1e-8
"""Events closer to one another than this crowd [s]."""

PATIENCE = 8
"""After so many crowded events in a row each further one widens the slacks of limits tenfold."""

MOST_PATIENCE = 1e6
"""The slacks of limits do not grow by more than this."""


@inner
def meet(rows, contacts, touch, case, s):
    """Carry out the impact of the contacts that close, if any do; elements give no impulse."""
    s.hit |= closing(contacts, touch & ~s.closed, s)
    if not s.hit:
        return
    if s.hit & FLOOR_BITS:
        s.floor_impacts += 1
    else:
        s.wall_impacts += 1
    land(rows, contacts, s.closed, touch & ~s.closed, case, s)


@inner
def next_mode(elements, links, devices, rows, contacts, touch, settle, case, s, work, spare, ax, az, dt):
    """Bring the elements up to date, and choose the mode at the present time."""
    time = s.k * dt + s.tau
    for _ in range(3):  # a failure shifts force to others
        measure(elements, links, s.sin, s.cos, s.x, s.z, s.vx, s.vz, s.omega)
        note_forces(links, devices)
        failed = settle_elements(elements, links, devices, time)
        work.failed += failed
        if failed == 0:
            break
    a, a_rate, G, G_rate = loads(case, ax, az, case.scale / dt, s.k, s.tau)
    for attempt in range(2):
        if attempt == 1:
            unjam(contacts, touch, case, s)
        choose_restrained_mode(
            elements,
            links,
            devices,
            rows,
            contacts,
            touch,
            settle,
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
    note_forces(links, devices)


@inner
def mind_crowds(s, work, dt, before):
    """Widen the slacks of limits where events follow one another with next to no time between them."""
    now = s.k * dt + s.tau
    if now - before > CROWDED:
        work.crowded, work.patience = 0, 1.0
        return
    work.crowded += 1
    if work.crowded > PATIENCE:
        work.patience = min(10.0 * work.patience, MOST_PATIENCE)
