"""Event detection within a step of a body with elements: the first margin that crosses its level.

Margins are the gaps of open contacts, the forces and slip rates of closed ones, those of the elements' lines,
and the rotation left to 90°. A step is first taken whole. Where a margin is negative at its end, or a quintic
or parabola suggests that it is negative inside, the least of the margins is bracketed on the dense output.
That is as accurate as the step, so it also provides the state at the event.
"""

from stayput.compiling import inline, inner
from stayput.mechanics.columns import CONTACTS, ROCK
from stayput.mechanics.devices.lines import (
    event_weight,
    first_crossing_candidate,
    least_weighted_line,
    set_line_weights,
    weighted_margin,
)
from stayput.mechanics.devices.moment import tilt_at
from stayput.mechanics.devices.step import contact_margins, evaluate_state, project_on_constraints, set_state
from stayput.mechanics.geometry import RIGHT_ANGLE, gap, gap_rates, sin_cos, state_of
from stayput.mechanics.roots import (
    MIN_START_VALUE,
    closed_level,
    first_closing,
    horner,
    illinois_update,
    parabola_negative_at,
    quintics,
    secant,
)

SEARCH_TOLERANCE, LOCATED = 1e-10, 1e-12
"""Tolerance of the event search, and least advance beyond it to where a margin is negative [s]."""

MOST_LATER = 1e3
"""Factor by which that advance may grow at a time."""

CLOSE_ENOUGH = 1e-8
"""Newton step after which another would be less than the tolerance [s]."""

F_WEIGHT, G_WEIGHT, TURN_WEIGHT = CONTACTS, CONTACTS + 1, CONTACTS + 2


@inline
def _gap(contacts, s, work, c):
    """Gap of a contact [m]; on a sticking fulcrum a function of the tilt alone."""
    if s.kind == ROCK:
        reach = work.reach[c]
        return reach[0] + (reach[1] * s.cos + reach[2] * s.sin)
    return gap(contacts[c], s)


@inline
def least_margin(contacts, s, work, levels, f, g, least):
    """Least of all margins above their levels; ``least`` is that of the lines.

    The state has just been evaluated. ``s.hit`` gets the bits of the contacts that have closed.
    """
    least = min(least, f - levels[0], g - levels[1], RIGHT_ANGLE - abs(s.theta))
    s.hit = 0
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1:
            work.gap[c] = _gap(contacts, s, work, c)
            over = work.gap[c] - work.level[c]
            if over < 0.0:
                s.hit |= 1 << c
            least = min(least, over)
    return least


@inner
def _set_weights(contacts, s, work, levels, f, g):
    """Set the scales for a search that ends where `least_margin` has just been evaluated."""
    weight = work.weight
    weight[F_WEIGHT], weight[G_WEIGHT] = event_weight(f - levels[0]), event_weight(g - levels[1])
    weight[TURN_WEIGHT] = event_weight(RIGHT_ANGLE - abs(s.theta))
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        weight[c] = event_weight(work.gap[c] - work.level[c]) if others >> c & 1 else 0.0
    set_line_weights(work)


@inner
def _least_weighted(contacts, s, work, levels, theta, f, g, at_start):
    """Least of the margins that are negative at the end of a search, each scaled to −1 there.

    Scaling makes gaps, forces and rates comparable, so that margins of other sizes do not mislead the
    secants. The tilt and the two margins of the contacts are those of the present state or, ``at_start``,
    of the start of the step.
    """
    weight = work.weight
    least = min(
        weighted_margin(f - levels[0], weight[F_WEIGHT]),
        weighted_margin(g - levels[1], weight[G_WEIGHT]),
        weighted_margin(RIGHT_ANGLE - abs(theta), weight[TURN_WEIGHT]),
        least_weighted_line(work, at_start),
    )
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1 and weight[c] > 0.0:
            now = work.gap0[c] if at_start else _gap(contacts, s, work, c)
            least = min(least, weight[c] * (now - work.level[c]))
    return least


@inner
def note_gaps(contacts, s, work):
    """Store the gaps of the open contacts in the state of s."""
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1:
            work.gap[c] = _gap(contacts, s, work, c)


@inline
def set_gap_levels(s, work):
    """Set the gaps at which the open contacts close in the step that begins."""
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1:
            work.gap0[c] = work.gap[c]
            work.level[c] = closed_level(work.gap[c])


@inline
def _gap_rates(contacts, s, work, c, y, k, sin, cos):
    """Gap of a contact in a state, with its first and second derivatives."""
    if s.kind == ROCK:
        reach = work.reach[c]
        lever, fall = reach[2] * cos - reach[1] * sin, reach[1] * cos + reach[2] * sin
        return reach[0] + fall, y[5] * lever, k[2] * lever - y[5] * y[5] * fall
    return gap_rates(contacts[c], y, k, sin, cos)


@inline
def excursion_bound(case, y0, y1, h):
    """Upper bound of the distance by which a corner can approach a plane and return in a step [m]."""
    reach = abs(case.u[0]) + abs(case.u[1]) + abs(case.v[0]) + abs(case.v[2])
    return h * (abs(y0[3]) + abs(y0[4]) + abs(y1[3]) + abs(y1[4]) + reach * (abs(y0[5]) + abs(y1[5])))


@inline
def gaps_stay_open(s, work, excursion):
    """Whether no gap can close in a step within which corners move no farther than ``excursion``."""
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1 and work.gap[c] < excursion:
            return False
    return True


@inner
def _first_gap_candidate(contacts, s, work, y0, k0, base, y1, k1, excursion, h):
    """Earliest time at which a gap closes within a step, or h; and its contact."""
    first, contact = h, -1
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1 and work.gap[c] < excursion:
            g0, v0, c0 = _gap_rates(contacts, s, work, c, y0, k0, base[1], base[2])
            g1, v1, c1 = _gap_rates(contacts, s, work, c, y1, k1, s.sin, s.cos)
            t, _ = first_closing(g0, v0, c0, g1, v1, c1, h)
            if 0.0 <= t < first:
                first, contact = t, c
    return first, contact


@inner
def set_dense_output(s, work, start, end, h):
    """Set the dense output of a completed step; on a sticking fulcrum it is the series of the tilt."""
    if s.kind == ROCK:
        return
    x, z, theta = quintics(start[0], start[1], end[0], end[1], h)
    curve = work.curve
    curve[0, 0], curve[0, 1], curve[0, 2], curve[0, 3], curve[0, 4], curve[0, 5] = x
    curve[1, 0], curve[1, 1], curve[1, 2], curve[1, 3], curve[1, 4], curve[1, 5] = z
    curve[2, 0], curve[2, 1], curve[2, 2], curve[2, 3], curve[2, 4], curve[2, 5] = theta


@inline
def _curve_at(work, c, u):
    row = work.curve[c]
    return horner((row[0], row[1], row[2], row[3], row[4], row[5]), u)


@inner
def set_inside(s, work, base, h, t):
    """Set the state to a time t into a step, by its dense output; on a sticking fulcrum only the tilt."""
    if s.kind == ROCK:
        s.theta, s.omega = tilt_at(work, t)
    else:
        u = t / h
        s.x, vx = _curve_at(work, 0, u)
        s.z, vz = _curve_at(work, 1, u)
        s.theta, omega = _curve_at(work, 2, u)
        s.vx, s.vz, s.omega = vx / h, vz / h, omega / h
    s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])


@inner
def _closing_time(contacts, s, work, base, c, t, h):
    """Time near t at which the gap of contact c closes on the dense output: Newton's method."""
    zero = (0.0, 0.0, 0.0)
    for _ in range(4):
        set_inside(s, work, base, h, t)
        over, rate, _ = _gap_rates(contacts, s, work, c, state_of(s), zero, s.sin, s.cos)
        if rate >= 0.0:
            break
        step = (over - work.level[c]) / rate
        t = min(h, max(0.5 * t, t - step))
        if abs(step) <= CLOSE_ENOUGH:
            break
    return t


@inner
def _candidate_inside(contacts, rows, case, s, work, base, load, start, end, near, inactive, h, levels):
    """Earliest time at which a parabola through start, middle and end has a margin below its level, or h.

    The margins of the contacts are looked at where they are ``near`` their limits, those of the lines unless
    all are ``inactive``. The state stays that at the end.
    """
    sin, cos = s.sin, s.cos
    set_inside(s, work, base, h, 0.5 * h)
    first = h
    if near:
        f, g = contact_margins(contacts, rows, case, s, work, load, 0.5 * h)
        u = parabola_negative_at(start[2] - levels[0], f - levels[0], end[2] - levels[0])
        v = parabola_negative_at(start[3] - levels[1], g - levels[1], end[3] - levels[1])
        first = h * min(u if u > 0.0 else 1.0, v if v > 0.0 else 1.0)
    if not inactive:
        moves = s.kind != ROCK
        crossing = first_crossing_candidate(work, s.sin, s.cos, moves, s.x, s.z, s.vx, s.vz, s.omega)
        first = min(first, h * crossing)
    s.x, s.z, s.theta, s.vx, s.vz, s.omega = end[0]
    s.sin, s.cos = sin, cos
    return first


@inner
def _locate(contacts, rows, case, s, work, base, load, m0, low, high, h, levels):
    """Time of the first crossing before ``high``, where a margin is negative and the scales were set.

    ``m0`` is the least scaled margin at ``low``.
    """
    bracket = (low, max(m0, MIN_START_VALUE), high, -1.0, 0)
    last = high
    for n in range(100):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        if n > 8 and n & 1:  # secants creep where a margin rests at its limit until another one is crossed
            t = 0.5 * (bracket[0] + bracket[2])
        if abs(t - last) <= SEARCH_TOLERANCE or bracket[2] - bracket[0] <= SEARCH_TOLERANCE:
            return t
        m = _least_weighted_at(contacts, rows, case, s, work, base, load, t, h, levels)
        bracket = illinois_update(bracket, t, m)
        last = t
    return bracket[2]


@inner
def _least_weighted_at(contacts, rows, case, s, work, base, load, t, h, levels):
    """Least scaled margin a time t into a step, by its dense output."""
    set_inside(s, work, base, h, t)
    _, f, g, _ = evaluate_state(contacts, rows, case, s, work, load, t)
    return _least_weighted(contacts, s, work, levels, s.theta, f, g, False)


@inner
def _stop_at(contacts, rows, case, s, work, base, load, levels, t, h):
    """Set the state to an event at t in a step of length h, slightly later if no margin is negative yet.

    It is that of the dense output, projected onto the mode's constraints; returned as by `first_event`.
    """
    k, f, g, least = (0.0, 0.0, 0.0), 0.0, 0.0, 0.0
    before, more = -1.0, LOCATED
    for _ in range(6):
        set_inside(s, work, base, h, t)
        project_on_constraints(contacts, case, s, work)
        k, f, g, least = evaluate_state(contacts, rows, case, s, work, load, t)
        m = _least_weighted(contacts, s, work, levels, s.theta, f, g, False)
        if m < 0.0 or t >= h:
            break
        more = LOCATED + more * min(m / (before - m) if before > m else 10.0, MOST_LATER)
        t, before = min(h, t + more), m
    return True, t, k, f, g, least_margin(contacts, s, work, levels, f, g, least)


@inner
def first_event(contacts, rows, case, s, work, base, load, ends, least, near, inactive, excursion, h, levels):
    """First event in a completed step; the state, its margins and those of the lines are moved there.

    ``ends`` are its start and its end, each (state, accelerations, two margins). The search covers, in order:
    the earliest candidate inside the step (closing gaps, parabolas through the margins), then its end.

    Returns
    -------
    tuple
        Whether there is one; its time, or h; accelerations, the contacts' two margins, and the least of all:
        negative at an event, unless the dense output alone had one.
    """
    start, end = ends
    y0, k0, f0, g0 = start
    y1, k1, f1, g1 = end
    closing, contact = _first_gap_candidate(contacts, s, work, y0, k0, base, y1, k1, excursion, h)
    looks = near or not inactive
    if not looks and contact < 0 and least >= 0.0:
        return False, h, k1, f1, g1, least
    set_dense_output(s, work, start, end, h)
    probe = h
    if looks:
        probe = _candidate_inside(
            contacts, rows, case, s, work, base, load, start, end, near, inactive, h, levels
        )
    closes = contact >= 0 and closing <= probe
    if closes:
        probe = min(h, _closing_time(contacts, s, work, base, contact, closing, h) + LOCATED)
    elif probe >= h and least >= 0.0:
        return False, h, k1, f1, g1, least
    low, high = 0.0, h
    f, g = f1, g1
    if probe < h or closes:
        set_inside(s, work, base, h, probe)
        project_on_constraints(contacts, case, s, work)
        k, f, g, of_lines = evaluate_state(contacts, rows, case, s, work, load, probe)
        inside = least_margin(contacts, s, work, levels, f, g, of_lines)
        if inside < 0.0:
            high = probe
            alone = s.hit != 0 and s.hit & (s.hit - 1) == 0
            if closes and alone and min(f - levels[0], g - levels[1], of_lines) >= 0.0:
                return True, probe, k, f, g, inside
        else:
            low = probe
            set_state(s, y1, base)
            _, f, g, _ = evaluate_state(contacts, rows, case, s, work, load, h)
            if least_margin(contacts, s, work, levels, f, g, least) >= 0.0:
                return False, h, k1, f1, g1, least
    _set_weights(contacts, s, work, levels, f, g)
    if low == 0.0:
        m0 = _least_weighted(contacts, s, work, levels, base[0], f0, g0, True)
    else:
        m0 = _least_weighted_at(contacts, rows, case, s, work, base, load, low, h, levels)
    t = _locate(contacts, rows, case, s, work, base, load, m0, low, high, h, levels)
    return _stop_at(contacts, rows, case, s, work, base, load, levels, t, h)
