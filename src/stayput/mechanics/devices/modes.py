"""Mode selection with devices: the active sets of `mechanics.modes`, with element forces in the biases."""

from __future__ import annotations

import math

from stayput.compiled import inner
from stayput.mechanics.columns import A_FLOOR, B_FLOOR, FAILED, FLIGHT, FLOOR_BITS, PLANE, REST, SLIDE
from stayput.mechanics.contact import fill_rows, no_contact_closes
from stayput.mechanics.devices.accelerations import shared_friction
from stayput.mechanics.devices.elements import evaluate_elements, update_elements
from stayput.mechanics.devices.equilibrium import (
    add_floor_limits,
    add_wrench,
    cone_facets,
    load_within_facets,
)
from stayput.mechanics.geometry import own_friction, slip_rate, stand_flat, to_plane_axes, value_or
from stayput.mechanics.modes import (
    FLAT_TOLERANCE,
    LOOKAHEAD,
    TOLERANCE,
    close_slow_contacts,
    set_mode,
    try_to_slide,
    try_to_slip,
    try_to_stick,
)


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
        row.flat_slip_right, row.flat_slip_left = value_or(own, to_right), value_or(own, to_left)


@inner
def _fill_rows_ahead(rows, contacts, closed, case, s, work, a, G, wrench):
    """Fill the rows of the closed contacts at `LOOKAHEAD`, with the accelerations by loads and elements."""
    fx, fz, fl = wrench
    turn = LOOKAHEAD * s.omega
    omega = s.omega + LOOKAHEAD * s.alpha
    count = fill_rows(rows, contacts, closed, s.sin + turn * s.cos, s.cos - turn * s.sin, case)
    for k in range(count):
        row = rows[k]
        con = contacts[row.index]
        tangential, normal = to_plane_axes(con, fx - a, fz - G)
        spin = fl / case.inertia
        row.bias_n = normal - omega * omega * row.tl + row.nl * spin
        row.bias_t = tangential + omega * omega * row.nl + row.tl * spin
        row.target = 0.0
        slip = slip_rate(con, s)
        row.slipping = 0.0 if abs(slip) <= work.still_rate else (1.0 if slip > 0.0 else -1.0)
    if count >= 2 and rows[0].index == A_FLOOR and rows[1].index == B_FLOOR:
        _share_base_friction(rows, case, a, G, wrench)
    return count


@inner
def _is_still(closed, case, s, work):
    """Whether the body may be at rest: two or more contacts are closed, and it does not move."""
    two = closed & (closed - 1) != 0
    return two and max(abs(s.vx), abs(s.vz), math.sqrt(case.inertia) * abs(s.omega)) <= work.still_rate


@inner
def _wrench_ahead(elements, links, s):
    """Force of the elements at the position `LOOKAHEAD` later, with the present rates for the dampers.

    Later rates would come from the old mode's accelerations, which may be far from those of the new mode.
    """
    t, turn = LOOKAHEAD, LOOKAHEAD * s.omega
    return evaluate_elements(
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
def _set_rest(elements, links, closed, case, s, work):
    set_mode(s, REST, -1, 0, -1, 0)
    s.closed = closed
    s.vx = s.vz = s.omega = s.alpha = 0.0
    if closed & FLOOR_BITS == FLOOR_BITS and abs(s.theta - s.rest) < FLAT_TOLERANCE:
        stand_flat(case, s)
    add_wrench(work, evaluate_elements(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0))


@inner
def _rest_on_plane(elements, links, rows, count, closed, case, s, work, a, G, wrench):
    """Try rest on two corners of one plane; whether it is consistent."""
    for k in range(count - 1):
        if PLANE[rows[k].index] != PLANE[rows[k + 1].index]:
            continue
        if cone_facets(rows, k, 2, -1, case.inertia, work) and load_within_facets(work, a, G, wrench):
            _set_rest(elements, links, closed, case, s, work)
            return True
    return False


@inner
def _rest_on_all(elements, links, rows, count, closed, case, s, work, spare, a, G, wrench):
    """Try rest on all closed contacts, or all but an unloaded base corner; whether it is consistent."""
    both = closed & FLOOR_BITS == FLOOR_BITS
    for lifted in range(-1, 2 if both and count > 2 else 0):
        if cone_facets(rows, 0, count, lifted, case.inertia, work) and load_within_facets(work, a, G, wrench):
            add_floor_limits(rows, count, lifted, a, G, wrench, case.inertia, work, spare)
            _set_rest(elements, links, closed, case, s, work)
            return True
    return False


@inner
def choose_device_mode(
    elements,
    links,
    devices,
    rows,
    contacts,
    touching,
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
):
    """Set the mode of a body with elements whose gaps ``touching`` are zero; see `mechanics.modes`."""
    closed = close_slow_contacts(contacts, touching, settle_rate, case, s)
    at_rest = _is_still(closed, case, s, work)
    a, G = a + LOOKAHEAD * a_rate, G + LOOKAHEAD * G_rate
    held_wrench = (0.0, 0.0, 0.0)
    if at_rest:  # elements stop slipping, and dampers carry nothing
        held_wrench = evaluate_elements(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0)
        work.failed += update_elements(elements, links, devices, time)
        held_wrench = evaluate_elements(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0)
    wrench = _wrench_ahead(elements, links, s)
    count = _fill_rows_ahead(rows, contacts, closed, case, s, work, a, G, wrench)
    if no_contact_closes(rows, count, TOLERANCE):
        set_mode(s, FLIGHT, -1, 0, -1, 0)
        s.alpha = 0.0
    elif not (
        (at_rest and _rest_on_plane(elements, links, rows, count, closed, case, s, work, a, G, held_wrench))
        or try_to_stick(rows, count, contacts, case, s)
        or try_to_slide(rows, count, contacts, case, s, True)
        or try_to_slip(rows, count, contacts, case, s)
        or (
            at_rest
            and _rest_on_all(elements, links, rows, count, closed, case, s, work, spare, a, G, held_wrench)
        )
        or try_to_slide(rows, count, contacts, case, s, False)
    ):
        set_mode(s, FAILED, -1, 0, -1, 0)
    if s.kind != REST and s.kind != SLIDE:
        s.alpha += wrench[2] / case.inertia
