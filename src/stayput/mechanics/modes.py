"""Mode selection after an event: the consistent active set of contacts, and velocities that agree with it.

Active sets are tried from the fewest contacts to the most, except that a body which can rest on one plane
does: a wall or ceiling presses only where the body would move into it, never by self-stress that nothing has
set up. At the instant of an event a force is exactly at its limit, so the choice is made for the loads and
the state a moment later (`LOOKAHEAD`). The forces of devices act beside the loads.
"""

import math

from stayput.compiling import inner
from stayput.mechanics import columns as col
from stayput.mechanics.contact import (
    both_slip,
    cross,
    fill_rows,
    holding_cone,
    is_single_ray,
    no_contact_closes,
    one_slips,
    one_sticks,
)
from stayput.mechanics.devices.elements import (
    add_floor_limits,
    add_wrench,
    cone_facets,
    evaluate_elements,
    load_within_facets,
    update_elements,
)
from stayput.mechanics.devices.step import shared_friction
from stayput.mechanics.geometry import (
    FLAT_TOLERANCE,
    STICK_RATE,
    gap_rate,
    own_friction,
    project_on_plane,
    project_pair,
    remove_gap_rates,
    set_pivot_velocity,
    slip_rate,
    stand_flat,
    to_plane_axes,
    value_or,
)

LOOKAHEAD = 1e-9
"""Time ahead of the event at which the contact forces are evaluated to choose the mode [s]."""

TOLERANCE = 1e-11
"""Tolerance of the inequalities between accelerations [m/s²]."""


@inner
def set_mode(s, kind, i, d, j, dj):
    """Set the mode, its contacts and their slip directions; all other contacts are open."""
    s.kind, s.i, s.d, s.j, s.dj = kind, i, d, j, dj
    s.closed = 0
    if i >= 0:
        s.closed |= 1 << i
    if j >= 0:
        s.closed |= 1 << j


@inner
def close_slow_contacts(contacts, touching, settle_rate, case, s):
    """Bits of the contacts that open no faster than ``settle_rate``, their gap rates removed."""
    closed, moving = 0, 0.0
    for c in range(col.CONTACTS):
        if touching >> c & 1:
            rate = gap_rate(contacts[c], s)
            if rate <= settle_rate:
                closed |= 1 << c
                moving = max(moving, abs(rate))
    if moving > STICK_RATE:
        remove_gap_rates(contacts, closed, settle_rate, case.inertia, s)
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
        row, stated = rows[k], own_friction(case, k)[1]
        row.flat_slip_right, row.flat_slip_left = value_or(stated, to_right), value_or(stated, to_left)


@inner
def _fill_rows_ahead(scratch, closed, case, s, still_rate, a, G, wrench):
    """Fill the rows of the closed contacts at `LOOKAHEAD`: accelerations by loads and devices, and slip."""
    fx, fz, fl = wrench
    turn = LOOKAHEAD * s.omega
    omega = s.omega + LOOKAHEAD * s.alpha
    contacts, rows = scratch.contacts, scratch.rows
    count = fill_rows(rows, contacts, closed, s.sin + turn * s.cos, s.cos - turn * s.sin, case)
    spin = fl / case.inertia
    for row in rows[:count]:
        con = contacts[row.index]
        tangential, normal = to_plane_axes(con, fx - a, fz - G)
        row.bias_n = normal - omega * omega * row.tl + row.nl * spin
        row.bias_t = tangential + omega * omega * row.nl + row.tl * spin
        row.target = 0.0
        slip = slip_rate(con, s)
        row.slipping = 0.0 if abs(slip) <= still_rate else (1.0 if slip > 0.0 else -1.0)
    return count


@inner
def _nothing_slips(rows, count):
    for k in range(count):
        if rows[k].slipping != 0.0:
            return False
    return True


@inner
def _is_still(closed, case, s, work):
    """Whether the body may be at rest: two or more contacts are closed, and it does not move."""
    two = closed & (closed - 1) != 0
    return two and max(abs(s.vx), abs(s.vz), math.sqrt(case.inertia) * abs(s.omega)) <= work.still_rate


@inner
def _wrench_at_rest(held, s, time):
    """Force of the devices on a body at rest: they stop slipping, and dampers carry nothing."""
    evaluate_elements(held.elements, held.links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0)
    held.work.failed += update_elements(held.elements, held.links, held.devices, time)
    return evaluate_elements(held.elements, held.links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0)


@inner
def _wrench_ahead(held, s):
    """Force of the devices at the position `LOOKAHEAD` later, with the present rates for the dampers.

    Later rates would come from the old mode's accelerations, which may be far from those of the new mode.
    """
    t, turn = LOOKAHEAD, LOOKAHEAD * s.omega
    sin, cos = s.sin + turn * s.cos, s.cos - turn * s.sin
    x, z = s.x + t * s.vx, s.z + t * s.vz
    return evaluate_elements(held.elements, held.links, sin, cos, x, z, s.vx, s.vz, s.omega)


@inner
def choose_mode(scratch, touching, settle_rate, case, s, held, load, time):
    """Set the mode of a body whose gaps ``touching`` are zero, and velocities that agree with it.

    A contact that opens no faster than ``settle_rate`` [m/s] is closed; after an impact that is the rate at
    which a bounce has ended. ``load`` is the floor's acceleration and g + z̈_G now, each before its rate.
    """
    contacts, rows = scratch.contacts, scratch.rows
    closed = close_slow_contacts(contacts, touching, settle_rate, case, s)
    a, G = load[0] + LOOKAHEAD * load[1], load[2] + LOOKAHEAD * load[3]
    wrench = wrench_at_rest = (0.0, 0.0, 0.0)
    if held is None:
        count = _fill_rows_ahead(scratch, closed, case, s, STICK_RATE, a, G, wrench)
        at_rest = _nothing_slips(rows, count)
    else:
        at_rest = _is_still(closed, case, s, held.work)
        if at_rest:
            wrench_at_rest = _wrench_at_rest(held, s, time)
        wrench = _wrench_ahead(held, s)
        count = _fill_rows_ahead(scratch, closed, case, s, held.work.still_rate, a, G, wrench)
        if count >= 2 and rows[0].index == col.A_FLOOR and rows[1].index == col.B_FLOOR:
            _share_base_friction(rows, case, a, G, wrench)

    # The order of cases is the order of preference where several active sets are consistent; see the module.
    if no_contact_closes(rows, count, TOLERANCE):
        set_mode(s, col.FLIGHT, -1, 0, -1, 0)
        s.alpha = 0.0
    elif not (
        (at_rest and _rest_on_plane(rows, count, closed, case, s, held, a, G, wrench_at_rest))
        or try_to_stick(rows, count, contacts, case, s)
        or try_to_slide(rows, count, contacts, case, s, True)
        or try_to_slip(rows, count, contacts, case, s)
        or (at_rest and _rest_on_all(rows, count, closed, case, s, held, a, G, wrench_at_rest))
        or try_to_slide(rows, count, contacts, case, s, False)
    ):
        set_mode(s, col.FAILED, -1, 0, -1, 0)
    if s.kind != col.REST and s.kind != col.SLIDE:
        s.alpha += wrench[2] / case.inertia


@inner
def _load_in_cone(cone, a, G):
    """Whether the load (a, G) lies in a cone from `contact.holding_cone`."""
    exists, lx, lz, hx, hz = cone
    between = cross(a, G, lx, lz) >= 0.0 and cross(hx, hz, a, G) >= 0.0
    return exists and between and (a * lx + G * lz >= 0.0 or not is_single_ray(lx, lz, hx, hz))


@inner
def _set_rest(closed, case, s):
    set_mode(s, col.REST, -1, 0, -1, 0)
    s.closed = closed
    s.vx = s.vz = s.omega = s.alpha = 0.0
    if closed & col.FLOOR_BITS == col.FLOOR_BITS and abs(s.theta - s.rest) < FLAT_TOLERANCE:
        stand_flat(case, s)


@inner
def _rest_in_cone(cone, closed, case, s):
    """Set the body to rest while the load lies in a cone from `contact.holding_cone`."""
    _, s.low, s.low_up, s.high, s.high_up = cone
    _set_rest(closed, case, s)


@inner
def _rest_within_facets(closed, case, s, held):
    """Set the body to rest while load and devices are within the facets of `devices.equilibrium`."""
    _set_rest(closed, case, s)
    elements, links = held.elements, held.links
    add_wrench(held.work, evaluate_elements(elements, links, s.sin, s.cos, s.x, s.z, 0.0, 0.0, 0.0))


@inner
def _rest_on_plane(rows, count, closed, case, s, held, a, G, wrench):
    """Try rest on two corners of one plane; whether it is consistent."""
    for k in range(count - 1):
        if col.PLANE[rows[k].index] != col.PLANE[rows[k + 1].index]:
            continue
        if held is None:
            cone = holding_cone(rows, k, 2, -1)
            if _load_in_cone(cone, a, G):
                _rest_in_cone(cone, closed, case, s)
                return True
        elif cone_facets(rows, k, 2, -1, case.inertia, held.work) and load_within_facets(
            held.work, a, G, wrench
        ):
            _rest_within_facets(closed, case, s, held)
            return True
    return False


@inner
def _rest_on_all(rows, count, closed, case, s, held, a, G, wrench):
    """Try rest on all closed contacts, those of walls and ceiling pressed; whether it is consistent."""
    if held is None:
        return _bare_rest_on_all(rows, count, closed, case, s, a, G)
    return _held_rest_on_all(rows, count, closed, case, s, held, a, G, wrench)


@inner
def _bare_rest_on_all(rows, count, closed, case, s, a, G):
    """As `_rest_on_all`, for a body without devices.

    Walls and ceiling stay pressed while the load pushes the body towards them: at the other end the range of
    loads is that of the floor alone.
    """
    both = closed & col.FLOOR_BITS == col.FLOOR_BITS
    tips = col.B_FLOOR if a > 0.0 else col.A_FLOOR  # the corner that the load lifts
    for way in range(3 if both and count > 2 else 1):
        lifted = (-1, tips, 1 - tips)[way]
        cone = holding_cone(rows, 0, count, lifted)
        if not _load_in_cone(cone, a, G):
            continue
        exists, lx, lz, hx, hz = cone
        if both and lifted < 0:
            exists, low_x, low_z, high_x, high_z = holding_cone(rows, 0, 2, -1)
        else:  # the load whose line passes through the foot and G
            exists = closed & col.FLOOR_BITS != 0
            foot = rows[1 if lifted == 0 else 0]
            low_x, low_z = high_x, high_z = foot.nl, -foot.tl
        if exists and cross(high_x, high_z, a, G) < 0.0:
            shorter = (True, low_x, low_z, hx, hz)
        else:
            shorter = (True, lx, lz, high_x, high_z)
        if exists and _load_in_cone(shorter, a, G):
            cone = shorter
        _rest_in_cone(cone, closed, case, s)
        return True
    return False


@inner
def _held_rest_on_all(rows, count, closed, case, s, held, a, G, wrench):
    """As `_rest_on_all`, for a body with devices: on all, or all but an unloaded base corner."""
    work, I = held.work, case.inertia
    both = closed & col.FLOOR_BITS == col.FLOOR_BITS
    for lifted in range(-1, 2 if both and count > 2 else 0):
        if cone_facets(rows, 0, count, lifted, I, work) and load_within_facets(work, a, G, wrench):
            add_floor_limits(rows, count, lifted, a, G, wrench, I, work, held.spare)
            _rest_within_facets(closed, case, s, held)
            return True
    return False


@inner
def try_to_stick(rows, count, contacts, case, s):
    """Try active sets of one sticking contact; whether one is consistent."""
    for i in range(count):
        if rows[i].slipping == 0.0:
            ok, _, _, fl = one_sticks(rows, count, i, case.inertia, TOLERANCE)
            if ok:
                set_mode(s, col.ROCK, rows[i].index, 0, -1, 0)
                s.alpha = fl / case.inertia
                set_pivot_velocity(contacts[s.i], s)
                return True
    return False


@inner
def try_to_slip(rows, count, contacts, case, s):
    """Try active sets of one slipping contact; whether one is consistent."""
    for i in range(count):
        for side in (1.0, -1.0):
            if rows[i].slipping == -side:
                continue
            ok, _, _, fl = one_slips(rows, count, i, side, case.inertia, TOLERANCE)
            if ok:
                set_mode(s, col.SLIDE_ROCK, rows[i].index, int(side), -1, 0)
                s.alpha = fl / case.inertia
                project_on_plane(contacts[s.i], s)
                return True
    return False


@inner
def try_to_slide(rows, count, contacts, case, s, flat):
    """Try active sets of two slipping contacts, on one plane (``flat``) or on two; whether one is consistent.

    On two planes several may be consistent where a corner at a wall does not move; the one with the least
    force is free of self-stress.
    """
    consistent, least = False, math.inf
    I = case.inertia
    for i in range(count):
        for j in range(i + 1, count):
            first, second = rows[i].index, rows[j].index
            if (col.PLANE[first] == col.PLANE[second]) != flat:
                continue
            for side_i in (1.0, -1.0):
                if rows[i].slipping == -side_i:
                    continue
                for side_j in (1.0, -1.0):
                    if (flat and side_i != side_j) or rows[j].slipping == -side_j:
                        continue
                    ok, fx, fz, fl = both_slip(rows, count, i, side_i, j, side_j, I, TOLERANCE)
                    size = fx * fx + fz * fz + fl * fl / I
                    if ok and size < least:
                        consistent, least = True, size
                        set_mode(s, col.SLIDE if flat else col.LEAN, first, int(side_i), second, int(side_j))
                        s.alpha = fl / I
    if consistent:
        project_pair(contacts, case, s)
    return consistent
