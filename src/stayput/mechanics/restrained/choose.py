"""Which mode follows where elements pull: the patterns of `modes`, with the elements' force in the biases."""

from __future__ import annotations

import math

from stayput.compiled import inner
from stayput.mechanics.columns import A_FLOOR, B_FLOOR, FAILED, FLAT, FLIGHT, FLOOR_BITS, HELD, PLANE
from stayput.mechanics.contact import STUCK, none_presses, tabulate
from stayput.mechanics.geometry import along, gap_rate, given_or, own_friction, slip_rate, stand_flat
from stayput.mechanics.modes import (
    ALL_BUT_FLAT,
    MOMENT,
    TOLERANCE,
    set_mode,
    stay_closed,
    try_to_slide,
    try_to_slip,
    try_to_stick,
)
from stayput.mechanics.restrained.elements import measure, settle_elements
from stayput.mechanics.restrained.holding import bears, cone_facets, keep_floors_side, with_wrench
from stayput.mechanics.restrained.rates import shared_friction


@inner
def _close_slow_contacts(contacts, touching, settle, case, s):
    """Bits of the contacts that open no faster than ``settle``; their rates are taken away."""
    closed, moving = 0, 0.0
    c = 0
    while touching >> c:
        if touching >> c & 1:
            rate = gap_rate(contacts[c], s)
            if rate <= settle:
                closed |= 1 << c
                moving = max(moving, abs(rate))
        c += 1
    if moving > STUCK:
        stay_closed(contacts, closed, settle, case.inertia, s)
    return closed


@inner
def _share_base_friction(rows, case, a, G, wrench):
    """Set the kinetic friction of a flat base whose load the elements shift; see `shared_friction`."""
    _, fz, fl = wrench
    if G - fz <= 0.0:
        return
    shift = fl / (G - fz)
    left, right = rows[0], rows[1]
    a, b = (left.mu_slip, -left.nl, -left.tl), (right.mu_slip, -right.nl, -right.tl)
    to_right, to_left = shared_friction(case, a, b, 1.0, shift), shared_friction(case, a, b, -1.0, shift)
    for k in range(2):
        row, own = rows[k], own_friction(case, k)[1]
        row.flat_slip_right, row.flat_slip_left = given_or(own, to_right), given_or(own, to_left)


@inner
def _tabulate_rates(rows, contacts, closed, case, s, work, a, G, wrench):
    """List the closed contacts a moment ahead, with their accelerations under the loads and elements."""
    fx, fz, fl = wrench
    turn = MOMENT * s.omega
    omega = s.omega + MOMENT * s.alpha
    count = tabulate(rows, contacts, closed, s.sin + turn * s.cos, s.cos - turn * s.sin, case)
    for k in range(count):
        row = rows[k]
        con = contacts[row.index]
        tangential, normal = along(con, fx - a, fz - G)
        spin = fl / case.inertia
        row.bias_n = normal - omega * omega * row.tl + row.nl * spin
        row.bias_t = tangential + omega * omega * row.nl + row.tl * spin
        row.target = 0.0
        slip = slip_rate(con, s)
        row.slipping = 0.0 if abs(slip) <= work.still else (1.0 if slip > 0.0 else -1.0)
    if count >= 2 and rows[0].index == A_FLOOR and rows[1].index == B_FLOOR:
        _share_base_friction(rows, case, a, G, wrench)
    return count


@inner
def _is_still(closed, case, s, work):
    """Whether contacts can hold the body where it is: two or more are closed, and it does not move."""
    two = closed & (closed - 1) != 0
    return two and max(abs(s.vx), abs(s.vz), math.sqrt(case.inertia) * abs(s.omega)) <= work.still


@inner
def _wrench_ahead(elements, links, s):
    """Force of the elements a moment ahead in place; their dampers have the rates of now.

    Rates a moment ahead would be those of the old mode's accelerations, which may be far from the new one's.
    """
    t, turn = MOMENT, MOMENT * s.omega
    return measure(
        elements,
        links,
        s.sin + turn * s.cos,
        s.cos - turn * s.sin,
        s.x + t * s.vx,
        s.z + t * s.vz,
        s.vx,
        s.vz,
        s.omega,
    )


@inner
def _stay_held(elements, links, closed, case, s, work):
    set_mode(s, HELD, -1, 0, -1, 0)
    s.closed = closed
    s.vx = s.vz = s.omega = s.alpha = 0.0
    if closed & FLOOR_BITS == FLOOR_BITS and abs(s.theta - s.rest) < ALL_BUT_FLAT:
        stand_flat(case, s)
    with_wrench(work, measure(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0))


@inner
def _hold_on_plane(elements, links, rows, count, closed, case, s, work, a, G, wrench):
    """Try to hold the body still by both its corners on one plane."""
    for k in range(count - 1):
        if PLANE[rows[k].index] != PLANE[rows[k + 1].index]:
            continue
        if cone_facets(rows, k, 2, -1, case.inertia, work) and bears(work, a, G, wrench):
            _stay_held(elements, links, closed, case, s, work)
            return True
    return False


@inner
def _hold(elements, links, rows, count, closed, case, s, work, spare, a, G, wrench):
    """Try to hold the body still by all its contacts, or by all but a base corner that bears nothing."""
    both = closed & FLOOR_BITS == FLOOR_BITS
    for lifted in range(-1, 2 if both and count > 2 else 0):
        if cone_facets(rows, 0, count, lifted, case.inertia, work) and bears(work, a, G, wrench):
            keep_floors_side(rows, count, lifted, a, G, wrench, case.inertia, work, spare)
            _stay_held(elements, links, closed, case, s, work)
            return True
    return False


@inner
def choose_restrained_mode(
    elements,
    links,
    devices,
    rows,
    contacts,
    touching,
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
):
    """Set the mode of a body with elements whose contacts ``touching`` are closed; as `modes.choose_mode`."""
    closed = _close_slow_contacts(contacts, touching, settle, case, s)
    still = _is_still(closed, case, s, work)
    a, G = a + MOMENT * a_rate, G + MOMENT * G_rate
    held = (0.0, 0.0, 0.0)
    if still:  # slips of elements end, and no damper bears
        held = measure(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0)
        work.failed += settle_elements(elements, links, devices, time)
        held = measure(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0)
    wrench = _wrench_ahead(elements, links, s)
    count = _tabulate_rates(rows, contacts, closed, case, s, work, a, G, wrench)
    if none_presses(rows, count, TOLERANCE):
        set_mode(s, FLIGHT, -1, 0, -1, 0)
        s.alpha = 0.0
    elif not (
        (still and _hold_on_plane(elements, links, rows, count, closed, case, s, work, a, G, held))
        or try_to_stick(rows, count, contacts, case, s)
        or try_to_slide(rows, count, contacts, case, s, True)
        or try_to_slip(rows, count, contacts, case, s)
        or (still and _hold(elements, links, rows, count, closed, case, s, work, spare, a, G, held))
        or try_to_slide(rows, count, contacts, case, s, False)
    ):
        set_mode(s, FAILED, -1, 0, -1, 0)
    if s.kind != HELD and s.kind != FLAT:
        s.alpha += wrench[2] / case.inertia
