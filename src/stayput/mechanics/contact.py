"""The small contact problem: consistent forces, or impulses, at all closed contacts at once.

Forces and impulses obey the same relation. With the rows j of a contact (its normal n or tangent t,
and the lever about G) and unit mass, M = diag(1, 1, I), rate⁺ = bias + Σ (j M⁻¹ jᵀ) λ, where the rates
are accelerations and λ forces, or velocities and λ impulses. A *pattern* says which contacts press and
whether each sticks (T free) or slips (T = −μ d N); it is consistent when N ≥ 0, |T| ≤ μN where it sticks,
it slips in the direction assumed, and no contact left out closes further (Shenton 1996 for one block).
"""

from __future__ import annotations

import math

from stayput.mechanics.columns import A_FLOOR, B_FLOOR, PLANE
from stayput.mechanics.compiled import inner
from stayput.mechanics.geometry import along, arm, slip_rate

STUCK = 1e-10
"""A contact whose slip rate is not larger than this sticks [m/s]."""


@inner
def tabulate_forces(rows, contacts, closed, theta, omega, a, G):
    """List the closed contacts with the rates that they would have without contact forces."""
    count = 0
    c = 0
    while closed >> c:
        if closed >> c & 1:
            con, row = contacts[c], rows[count]
            sigma, kappa = arm(con, theta)
            row.nx, row.nz, row.nl = -con.sin, con.cos, -sigma
            row.tx, row.tz, row.tl = con.cos, con.sin, -kappa
            tangential, normal = along(con, -a, -G)
            row.bias_n = normal + omega * omega * kappa
            row.bias_t = tangential - omega * omega * sigma
            row.target = 0.0
            row.cone_stick, row.cone_slip = con.mu_static, con.mu_kinetic
            row.index = c
            count += 1
        c += 1
    return count


@inner
def mark_slips(rows, count, contacts, s):
    """Note in which direction each closed contact slips; 0 where it does not."""
    for k in range(count):
        slip = slip_rate(contacts[rows[k].index], s)
        rows[k].slipping = 0.0 if abs(slip) <= STUCK else math.copysign(1.0, slip)


@inner
def use_flat_friction(rows, count, static, kinetic):
    """Give both base corners the flat base's coefficients when both stand on the floor."""
    if count >= 2 and rows[0].index == A_FLOOR and rows[1].index == B_FLOOR:
        rows[0].cone_stick = rows[1].cone_stick = static
        rows[0].cone_slip = rows[1].cone_slip = kinetic


@inner
def holding_limits(rows, count):
    """Range of ẍ_G/G in which the closed contacts can hold the body still.

    The forces that friction allows form a cone spanned by two edges at each contact. Those without moment
    about G are spanned by pairs of edges; their directions bound the range.

    Returns
    -------
    tuple of float
        Lowest and highest ratio; (inf, −inf) where nothing holds the body.
    """
    low, high = math.inf, -math.inf
    for p in range(2 * count):
        rp, op = rows[p >> 1], 1.0 - 2.0 * (p & 1)
        mu = rp.cone_stick
        px, pz, pl = rp.nx + op * mu * rp.tx, rp.nz + op * mu * rp.tz, rp.nl + op * mu * rp.tl
        for q in range(p):
            rq, oq = rows[q >> 1], 1.0 - 2.0 * (q & 1)
            mu = rq.cone_stick
            qx, qz, ql = rq.nx + oq * mu * rq.tx, rq.nz + oq * mu * rq.tz, rq.nl + oq * mu * rq.tl
            if pl * ql > 0.0 or (pl == 0.0 and ql == 0.0):
                continue
            fx, fz = abs(ql) * px + abs(pl) * qx, abs(ql) * pz + abs(pl) * qz
            if fz > 1e-12 * abs(fx):
                low, high = min(low, fx / fz), max(high, fx / fz)
            elif fx > 0.0:
                high = math.inf
            elif fx < 0.0:
                low = -math.inf
    return low, high


@inner
def _coupling(jx, jz, jl, fx, fz, fl, I):
    return jx * fx + jz * fz + jl * fl / I


@inner
def _push(row, side, mu):
    """Force per unit normal force of a contact that slips to ``side``."""
    return row.nx - side * mu * row.tx, row.nz - side * mu * row.tz, row.nl - side * mu * row.tl


@inner
def _rates(row, fx, fz, fl, I):
    """Normal and tangential rate of a contact under a total force."""
    return (
        row.bias_n + _coupling(row.nx, row.nz, row.nl, fx, fz, fl, I),
        row.bias_t + _coupling(row.tx, row.tz, row.tl, fx, fz, fl, I),
    )


@inner
def _others_stay_open(rows, count, i, j, fx, fz, fl, I, tolerance):
    for k in range(count):
        if k != i and k != j and _rates(rows[k], fx, fz, fl, I)[0] < rows[k].target - tolerance:
            return False
    return True


@inner
def one_sticks(rows, count, i, I, tolerance):
    """Only contact i presses, and sticks: total force, and whether that is consistent."""
    row = rows[i]
    nn = _coupling(row.nx, row.nz, row.nl, row.nx, row.nz, row.nl, I)
    tt = _coupling(row.tx, row.tz, row.tl, row.tx, row.tz, row.tl, I)
    nt = row.nl * row.tl / I
    bn, bt = row.target - row.bias_n, -row.bias_t
    det = nn * tt - nt * nt
    N, T = (bn * tt - bt * nt) / det, (bt * nn - bn * nt) / det
    fx, fz, fl = N * row.nx + T * row.tx, N * row.nz + T * row.tz, N * row.nl + T * row.tl
    ok = N >= 0.0 and abs(T) <= row.cone_stick * N + tolerance
    return ok and _others_stay_open(rows, count, i, i, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def one_slips(rows, count, i, side, I, tolerance):
    """Only contact i presses, and slips to ``side``."""
    row = rows[i]
    fx, fz, fl = _push(row, side, row.cone_slip)
    press = _coupling(row.nx, row.nz, row.nl, fx, fz, fl, I)
    N = (row.target - row.bias_n) / press
    fx, fz, fl = N * fx, N * fz, N * fl
    ok = press > 0.0 and N >= 0.0
    if ok and row.slipping == 0.0:
        ok = side * _rates(row, fx, fz, fl, I)[1] >= -tolerance
    return ok and _others_stay_open(rows, count, i, i, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def press_of_two(ri, side_i, rj, side_j, I):
    """Normal forces of two contacts that slip, and the total force; the first is NaN where they jam."""
    ix, iz, il = _push(ri, side_i, ri.cone_slip)
    jx, jz, jl = _push(rj, side_j, rj.cone_slip)
    ii = _coupling(ri.nx, ri.nz, ri.nl, ix, iz, il, I)
    ij = _coupling(ri.nx, ri.nz, ri.nl, jx, jz, jl, I)
    ji = _coupling(rj.nx, rj.nz, rj.nl, ix, iz, il, I)
    jj = _coupling(rj.nx, rj.nz, rj.nl, jx, jz, jl, I)
    bi, bj = ri.target - ri.bias_n, rj.target - rj.bias_n
    det = ii * jj - ij * ji
    if abs(det) < 1e-14:
        return math.nan, 0.0, 0.0, 0.0, 0.0
    Ni, Nj = (bi * jj - bj * ij) / det, (bj * ii - bi * ji) / det
    return Ni, Nj, Ni * ix + Nj * jx, Ni * iz + Nj * jz, Ni * il + Nj * jl


@inner
def both_slip(rows, count, i, side_i, j, side_j, I, tolerance):
    """Contacts i and j press, and slip to their sides."""
    ri, rj = rows[i], rows[j]
    Ni, Nj, fx, fz, fl = press_of_two(ri, side_i, rj, side_j, I)
    ok = Ni >= 0.0 and Nj >= 0.0
    if ok and ri.slipping == 0.0:
        ok = side_i * _rates(ri, fx, fz, fl, I)[1] >= -tolerance
    if ok and rj.slipping == 0.0:
        ok = side_j * _rates(rj, fx, fz, fl, I)[1] >= -tolerance
    return ok and _others_stay_open(rows, count, i, j, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def sticks_beside(rows, count, i, j, side_j, I, tolerance):
    """Contact i sticks while j presses: on one plane j sticks with it, else it slips to ``side_j``."""
    ri, rj = rows[i], rows[j]
    same_plane = PLANE[ri.index] == PLANE[rj.index]
    jx, jz, jl = _push(rj, 0.0 if same_plane else side_j, rj.cone_slip)
    # unknowns N_i, T_i, N_j; rows n_i, t_i, n_j
    a11 = _coupling(ri.nx, ri.nz, ri.nl, ri.nx, ri.nz, ri.nl, I)
    a12 = _coupling(ri.nx, ri.nz, ri.nl, ri.tx, ri.tz, ri.tl, I)
    a13 = _coupling(ri.nx, ri.nz, ri.nl, jx, jz, jl, I)
    a22 = _coupling(ri.tx, ri.tz, ri.tl, ri.tx, ri.tz, ri.tl, I)
    a23 = _coupling(ri.tx, ri.tz, ri.tl, jx, jz, jl, I)
    a31 = _coupling(rj.nx, rj.nz, rj.nl, ri.nx, ri.nz, ri.nl, I)
    a32 = _coupling(rj.nx, rj.nz, rj.nl, ri.tx, ri.tz, ri.tl, I)
    a33 = _coupling(rj.nx, rj.nz, rj.nl, jx, jz, jl, I)
    b1, b2, b3 = ri.target - ri.bias_n, -ri.bias_t, rj.target - rj.bias_n
    m1, m2, m3 = a22 * a33 - a23 * a32, a12 * a33 - a13 * a32, a12 * a23 - a13 * a22
    det = a11 * m1 - a12 * m2 + a31 * m3
    if abs(det) < 1e-14:
        return False, 0.0, 0.0, 0.0
    Ni = (b1 * m1 - b2 * m2 + b3 * m3) / det
    T = (-b1 * (a12 * a33 - a23 * a31) + b2 * (a11 * a33 - a13 * a31) - b3 * (a11 * a23 - a12 * a13)) / det
    Nj = (b1 * (a12 * a32 - a22 * a31) - b2 * (a11 * a32 - a12 * a31) + b3 * (a11 * a22 - a12 * a12)) / det
    fx, fz, fl = (
        Ni * ri.nx + T * ri.tx + Nj * jx,
        Ni * ri.nz + T * ri.tz + Nj * jz,
        Ni * ri.nl + T * ri.tl + Nj * jl,
    )
    carried = Ni + Nj if same_plane else Ni
    ok = Ni >= 0.0 and Nj >= 0.0 and abs(T) <= ri.cone_stick * carried + tolerance
    if ok and not same_plane and rj.slipping == 0.0:
        ok = side_j * _rates(rj, fx, fz, fl, I)[1] >= -tolerance
    return ok and _others_stay_open(rows, count, i, j, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def none_presses(rows, count, tolerance):
    """Whether no contact closes without a force."""
    return _others_stay_open(rows, count, -1, -1, 0.0, 0.0, 0.0, 1.0, tolerance)


@inner
def touching(contacts, present, x, z, theta, tolerance):
    """Bits of the contacts whose gap is not larger than the tolerance."""
    bits = 0
    c = 0
    while present >> c:
        if present >> c & 1:
            con = contacts[c]
            _, kappa = arm(con, theta)
            if along(con, x, z)[1] + con.offset - kappa <= tolerance:
                bits |= 1 << c
        c += 1
    return bits
