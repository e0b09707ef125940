"""Contact problem: the consistent forces, or impulses, at all closed contacts at once.

Forces and impulses obey the same relation. With the rows j of a contact (its normal n or tangent t,
and the lever about G) and unit mass, M = diag(1, 1, I), rate⁺ = bias + Σ (j M⁻¹ jᵀ) λ, where the rates
are accelerations and λ forces, or velocities and λ impulses. An *active set* says which contacts press and
whether each sticks (T free) or slips (T = −μ d N); it is consistent when N ≥ 0, |T| ≤ μN where it sticks,
it slips in the direction assumed, and no inactive contact closes further (Shenton 1996 for one block).
"""

import math

from stayput.compiling import inner
from stayput.mechanics.columns import A_FLOOR, B_FLOOR, CONTACTS, PLANE
from stayput.mechanics.geometry import arm_at, own_friction, to_plane_axes, value_or

PAINLEVE_LIMIT = 1e-6
"""Least (I + kσ)/I at which slip can continue; at zero no finite force is consistent (Painlevé 1895)."""

CLOSING_SLACK = 100.0
"""Closing rate, in tolerances, up to which a contact may be inactive.

Larger than one, so that a contact force within the tolerance is accepted whether it is in the active set or
not.
"""


@inner
def fill_rows(rows, contacts, closed, sin, cos, case):
    """Fill one row per closed contact: normal, tangent, lever arms and coefficients of friction."""
    count = 0
    for c in range(CONTACTS):
        if closed >> c & 1:
            con, row = contacts[c], rows[count]
            sigma, kappa = arm_at(con, sin, cos)
            row.nx, row.nz, row.nl = -con.sin, con.cos, -sigma
            row.tx, row.tz, row.tl = con.cos, con.sin, -kappa
            row.mu_stick = row.flat_stick = con.mu_static
            row.mu_slip = row.flat_slip_right = row.flat_slip_left = con.mu_kinetic
            row.index = c
            count += 1
    if count >= 2 and rows[0].index == A_FLOOR and rows[1].index == B_FLOOR:
        right = base_friction(case, rows[1].mu_slip, -rows[1].nl, -rows[1].tl)
        left = base_friction(case, rows[0].mu_slip, rows[0].nl, -rows[0].tl)
        for k in range(2):
            row = rows[k]
            static, kinetic = own_friction(case, k)
            row.flat_stick = value_or(static, case.static_friction)
            row.flat_slip_right, row.flat_slip_left = value_or(kinetic, right), value_or(kinetic, left)
    return count


@inner
def base_friction(case, edge, reach, kappa):
    """Kinetic coefficient of the flat base, G being ``reach`` behind the leading corner and κ above it.

    A body tips when its friction is larger than reach/κ. If the edge's own friction is too small to keep
    it tipped, the base's falls with the load on the trailing corner to the ratio at which that is zero.
    A corner with a friction of its own has that whether the base is flat or not.
    """
    return min(case.kinetic_friction, max(edge, reach / kappa))


@inner
def cross(px, pz, qx, qz):
    """Cross product p × q: positive where q lies counterclockwise of p."""
    return px * qz - pz * qx


@inner
def is_single_ray(lx, lz, hx, hz):
    """Whether a cone of loads is a single ray (frictionless floor), which excludes the opposite ray."""
    return cross(lx, lz, hx, hz) == 0.0 and lx * hx + lz * hz > 0.0


@inner
def holding_cone(rows, first, count, lifted):
    """Cone of loads (ẍ_G, G) that sticking contacts can balance.

    The forces that friction allows form a cone spanned by two edges at each contact. Those without moment
    about G are spanned by pairs of edges; they form the cone of loads.

    Parameters
    ----------
    first, count : int
        The rows of the contacts: from ``first``, ``count`` of them.
    lifted : int
        Row of a base corner that carries no load, so that the other has a corner's friction; −1 for none.

    Returns
    -------
    tuple
        Whether there is such a cone, and its two rays, the one with the lowest ẍ_G first; all zeros where
        it is the whole plane.
    """
    lx = lz = hx = hz = 0.0
    exists = opposed = False
    for n in range(4 * count):  # twice where a later ray tells which side of two opposite ones is meant
        if n == 2 * count and not opposed:
            break
        p = 2 * first + n % (2 * count)
        rp = rows[p >> 1]
        mu = (1.0 - 2.0 * (p & 1)) * (rp.flat_stick if lifted < 0 else rp.mu_stick)
        px, pz, pl = rp.nx + mu * rp.tx, rp.nz + mu * rp.tz, rp.nl + mu * rp.tl
        for q in range(2 * first, p):
            rq = rows[q >> 1]
            mu = (1.0 - 2.0 * (q & 1)) * (rq.flat_stick if lifted < 0 else rq.mu_stick)
            qx, qz, ql = rq.nx + mu * rq.tx, rq.nz + mu * rq.tz, rq.nl + mu * rq.tl
            none = p >> 1 == lifted or q >> 1 == lifted
            if none or pl * ql > 0.0 or (pl == 0.0 and ql == 0.0):
                continue
            fx, fz = abs(ql) * px + abs(pl) * qx, abs(ql) * pz + abs(pl) * qz
            if fz > 1e-12 * abs(fx):  # rays are scaled to G = 1 where they can be
                fx, fz = fx / fz, 1.0
            if not exists:
                exists, lx, lz, hx, hz = True, fx, fz, fx, fz
                continue
            before_low, behind_high = cross(fx, fz, lx, lz) < 0.0, cross(hx, hz, fx, fz) < 0.0
            if before_low and behind_high:
                return True, 0.0, 0.0, 0.0, 0.0
            if before_low:
                lx, lz = fx, fz
            elif behind_high:
                hx, hz = fx, fz
            elif fx * lx + fz * lz < 0.0:
                opposed = True
    return exists, lx, lz, hx, hz


@inner
def _coupling(jx, jz, jl, fx, fz, fl, I):
    return jx * fx + jz * fz + jl * fl / I


@inner
def _force_per_normal(row, side, mu):
    """Contact force per unit normal force, for slip to ``side``."""
    return row.nx - side * mu * row.tx, row.nz - side * mu * row.tz, row.nl - side * mu * row.tl


@inner
def _normal_rate(row, fx, fz, fl, I):
    """Normal rate of a contact under the total contact force."""
    return row.bias_n + _coupling(row.nx, row.nz, row.nl, fx, fz, fl, I)


@inner
def _tangential_rate(row, fx, fz, fl, I):
    """Tangential rate of a contact under the total contact force."""
    return row.bias_t + _coupling(row.tx, row.tz, row.tl, fx, fz, fl, I)


@inner
def _others_stay_open(rows, count, i, j, fx, fz, fl, I, tolerance):
    for k in range(count):
        if (
            k != i
            and k != j
            and _normal_rate(rows[k], fx, fz, fl, I) < rows[k].target - CLOSING_SLACK * tolerance
        ):
            return False
    return True


@inner
def one_sticks(rows, count, i, I, tolerance):
    """Active set {i sticks}: whether it is consistent, and the total force."""
    row = rows[i]
    nn = _coupling(row.nx, row.nz, row.nl, row.nx, row.nz, row.nl, I)
    tt = _coupling(row.tx, row.tz, row.tl, row.tx, row.tz, row.tl, I)
    nt = row.nl * row.tl / I
    bn, bt = row.target - row.bias_n, -row.bias_t
    det = nn * tt - nt * nt
    N, T = (bn * tt - bt * nt) / det, (bt * nn - bn * nt) / det
    fx, fz, fl = N * row.nx + T * row.tx, N * row.nz + T * row.tz, N * row.nl + T * row.tl
    ok = N >= 0.0 and abs(T) <= row.mu_stick * N + tolerance
    return ok and _others_stay_open(rows, count, i, i, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def one_slips(rows, count, i, side, I, tolerance):
    """Active set {i slips to ``side``}: whether it is consistent, and the total force."""
    row = rows[i]
    fx, fz, fl = _force_per_normal(row, side, row.mu_slip)
    press = _coupling(row.nx, row.nz, row.nl, fx, fz, fl, I)
    if press <= PAINLEVE_LIMIT:
        return False, 0.0, 0.0, 0.0
    N = (row.target - row.bias_n) / press
    fx, fz, fl = N * fx, N * fz, N * fl
    ok = N >= 0.0 and (row.slipping != 0.0 or side * _tangential_rate(row, fx, fz, fl, I) >= -tolerance)
    return ok and _others_stay_open(rows, count, i, i, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def forces_of_slipping_pair(ri, side_i, rj, side_j, I):
    """Normal forces of two slipping contacts, and the total force; the first is NaN where the two jam."""
    mu_i, mu_j = ri.mu_slip, rj.mu_slip
    if PLANE[ri.index] == PLANE[rj.index]:
        mu_i = ri.flat_slip_right if side_i > 0.0 else ri.flat_slip_left
        mu_j = rj.flat_slip_right if side_j > 0.0 else rj.flat_slip_left
    ix, iz, il = _force_per_normal(ri, side_i, mu_i)
    jx, jz, jl = _force_per_normal(rj, side_j, mu_j)
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
def slide_on_two_planes(rows, contacts, case, s, sin, cos, omega, a, G, fl):
    """Accelerations of a body that slides on two planes at once, and its normal forces, as of the pair.

    ``fl`` is the moment of the devices about G; their force is in the loads a and G.
    """
    I = case.inertia
    fill_rows(rows, contacts, s.closed, sin, cos, case)
    for row in rows[:2]:
        row.bias_n = to_plane_axes(contacts[row.index], -a, -G)[1] - omega * omega * row.tl + row.nl * fl / I
        row.target = 0.0
    i, j = (0, 1) if s.i < s.j else (1, 0)
    Ni, Nj, fx, fz, moment = forces_of_slipping_pair(rows[i], float(s.d), rows[j], float(s.dj), I)
    return fx - a, fz - G, (moment + fl) / I, Ni, Nj


@inner
def both_slip(rows, count, i, side_i, j, side_j, I, tolerance):
    """Active set {i and j slip to their sides}: whether it is consistent, and the total force.

    On one plane either normal force may be zero; on two planes a contact that does not press is inactive.
    """
    ri, rj = rows[i], rows[j]
    Ni, Nj, fx, fz, fl = forces_of_slipping_pair(ri, side_i, rj, side_j, I)
    least = -tolerance if PLANE[ri.index] == PLANE[rj.index] else tolerance
    ok = Ni >= least and Nj >= least
    if ok and ri.slipping == 0.0:
        ok = side_i * _tangential_rate(ri, fx, fz, fl, I) >= -tolerance
    if ok and rj.slipping == 0.0:
        ok = side_j * _tangential_rate(rj, fx, fz, fl, I) >= -tolerance
    return ok and _others_stay_open(rows, count, i, j, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def sticks_beside(rows, count, i, j, side_j, I, tolerance):
    """Active set {i sticks; j sticks on the same plane, else slips to ``side_j``}; as `both_slip`."""
    ri, rj = rows[i], rows[j]
    same_plane = PLANE[ri.index] == PLANE[rj.index]
    jx, jz, jl = _force_per_normal(rj, 0.0 if same_plane else side_j, rj.mu_slip)
    # unknowns N_i, T_i, N_j; equations in the directions n_i, t_i, n_j; solved by Cramer's rule
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
    if same_plane:
        ok = (
            Ni >= -tolerance
            and Nj >= -tolerance
            and abs(T) <= ri.flat_stick * Ni + rj.flat_stick * Nj + tolerance
        )
    else:
        ok = Ni >= tolerance and Nj >= tolerance and abs(T) <= ri.mu_stick * Ni + tolerance
    if ok and not same_plane and rj.slipping == 0.0:
        ok = side_j * _tangential_rate(rj, fx, fz, fl, I) >= -tolerance
    return ok and _others_stay_open(rows, count, i, j, fx, fz, fl, I, tolerance), fx, fz, fl


@inner
def no_contact_closes(rows, count, tolerance):
    """Whether no contact would close if all contact forces were zero."""
    for k in range(count):
        if rows[k].bias_n < rows[k].target - CLOSING_SLACK * tolerance:
            return False
    return True
