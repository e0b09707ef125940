"""The elements of a case at an event and at rest: anchors, forces, branches, static equilibrium.

The forces that friction allows at contacts which do not slip form a cone, spanned by the two edges of each,
in the space of (f_x, f_z, f_θ). A body with elements is at rest while the load (ẍ_G − F_x, G − F_z, −F_θ) is
in it; the element forces are constant at rest. The facets of the cone are linear in the load, so the time at
which rest ends is exact, and blocks of the record can be skipped.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.columns import PLANE
from stayput.mechanics.devices import columns as col
from stayput.mechanics.devices.device_law import (
    clipped,
    force_of,
    note_force,
    push_of,
    reset_branch,
    set_law,
    update_element,
)
from stayput.mechanics.elementary import sine_and_cosine
from stayput.mechanics.records import lowest_product


@inner
def set_up_elements(elements, links, devices, case, s):
    """Initialize the elements of a case: anchors for the body at rest at slide 0, branches, results."""
    sin, cos = sine_and_cosine(s.rest)
    x = s.foot_a - (case.u[0] * cos + case.v[0] * sin)
    z = case.u[0] * sin - case.v[0] * cos
    for n in range(elements.shape[0]):
        el, link, device = elements[n], links[n], devices[n]
        at_point = math.isnan(el.x)
        link.x = x + el.u * cos + el.v * sin if at_point else el.x
        link.z = z + el.v * cos - el.u * sin if at_point else el.z
        link.lines = 0
        for i in range(2):
            reset_branch(el, link, i)
            device.plastic[i] = 0.0
        if el.kind != col.NONE:
            link.lines = 1 if el.kind == col.AXIAL or el.stiffness[col.TANGENT] == 0.0 else 2
        link.push = link.push_rate = 0.0
        device.peak_pull = device.peak_push = device.peak_shear = 0.0
        device.failure, device.failure_time = col.HOLDS, math.nan


@inline
def _along_normal(el, dx, dz):
    """Unit vector and elongation of the normal line [m]."""
    if el.kind != col.AXIAL:
        return -el.sin, el.cos, el.cos * dz - el.sin * dx
    far = math.sqrt(dx * dx + dz * dz)
    if far == 0.0:
        return 0.0, 0.0, -el.length
    return dx / far, dz / far, far - el.length


@inline
def evaluate_elements(elements, links, sin, cos, x, z, vx, vz, omega):
    """Force on the body and its moment about G, + clockwise; elongations and forces are stored in the links.

    The body is at the tilt of this sine and cosine, with G at (x, z) and these rates.
    """
    fx = fz = fl = 0.0
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        if link.lines == 0:
            continue
        right, up = el.u * cos + el.v * sin, el.v * cos - el.u * sin
        dx, dz = x + right - link.x, z + up - link.z
        wx, wz = vx + omega * up, vz - omega * right
        nx, nz, e = _along_normal(el, dx, dz)
        rate = nx * wx + nz * wz
        line = link.law[col.NORMAL]
        set_law(line, el, link, col.NORMAL)
        F = force_of(line, e, rate, 0.0)
        link.e[col.NORMAL], link.rate[col.NORMAL], link.force[col.NORMAL] = e, rate, F
        px, pz = -F * nx, -F * nz
        if link.lines == 2:
            push, push_rate = push_of(line, F, rate)
            e, rate = el.cos * dx + el.sin * dz, el.cos * wx + el.sin * wz
            set_law(link.law[col.TANGENT], el, link, col.TANGENT)
            F = force_of(link.law[col.TANGENT], e, rate, push)
            link.e[col.TANGENT], link.rate[col.TANGENT], link.force[col.TANGENT] = e, rate, F
            link.push, link.push_rate = push, push_rate
            px, pz = px - F * el.cos, pz - F * el.sin
        fx, fz, fl = fx + px, fz + pz, fl + (px * up - pz * right)
    return fx, fz, fl


@inner
def update_elements(elements, links, devices, time):
    """Update all branches for the state last evaluated; return the number of devices that failed."""
    failed = 0
    for n in range(elements.shape[0]):
        if links[n].lines > 0 and update_element(elements[n], links[n], devices[n], time):
            failed += 1
    return failed


@inner
def no_element_left(links):
    """Whether no element is active any more."""
    for n in range(links.shape[0]):
        if links[n].lines > 0:
            return False
    return True


@inner
def note_forces(elements, links, devices):
    """Update the peak forces; the branches must be up to date."""
    for n in range(devices.shape[0]):
        link = links[n]
        for i in range(link.lines):
            set_law(link.law[i], elements[n], link, i)
            note_force(devices[n], i, clipped(link.law[i], link.force[i], link.push))


@inner
def note_forces_of_links(forces, links, s):
    """Write the forces into the force history, if it is kept."""
    if forces.shape[0] == 0:
        return
    for n in range(forces.shape[1]):
        for i in range(col.FORCES):
            forces[s.k, n, i] = links[n].force[i]


PARALLEL_SINE = 1e-9
"""Sine of the angle below which two edges of a cone are taken as parallel."""

FLAT_CONE_SLACK = 1e-10
"""Tolerance of a load off a degenerate (flat) cone, as on a frictionless floor [m/s²]."""


@inline
def _edge(rows, p, lifted, root):
    """Edge p of the cone of contact forces; the moment is divided by √I to have the unit of the forces."""
    row = rows[p >> 1]
    if p >> 1 == lifted:
        return 0.0, 0.0, 0.0
    mu = (1.0 - 2.0 * (p & 1)) * (row.flat_stick if lifted < 0 else row.mu_stick)
    return row.nx + mu * row.tx, row.nz + mu * row.tz, (row.nl + mu * row.tl) / root


@inline
def _unit_normal(p, q):
    """Unit vector normal to two vectors, and the sine of the angle between them."""
    x, z, l = p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]
    size = math.sqrt(x * x + z * z + l * l)
    whole = math.sqrt((p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]))
    if size <= PARALLEL_SINE * whole or whole == 0.0:
        return (0.0, 0.0, 0.0), 0.0
    return (x / size, z / size, l / size), size / whole


@inline
def _extent(rows, first, count, lifted, n, root):
    """Smallest and largest component of the edges along a unit vector."""
    low = high = 0.0
    for p in range(2 * first, 2 * (first + count)):
        x, z, l = _edge(rows, p, lifted, root)
        part = n[0] * x + n[1] * z + n[2] * l
        low, high = min(low, part), max(high, part)
    return low, high


@inner
def _add_facet(work, n, root, slack):
    """Add a facet, unless it exists or there is no room; `add_wrench` adds the elements' force later."""
    c0, c1, c2 = slack, n[0], n[1]
    c3 = n[2] / root
    for f in work.facet[: work.facets]:
        if abs(f[1] - c1) + abs(f[2] - c2) + abs(f[3] - c3) < 1e-9:
            return
    if work.facets < col.MAX_FACETS:
        f = work.facet[work.facets]
        f[0], f[1], f[2], f[3] = c0, c1, c2, c3
        work.facets += 1


@inner
def cone_facets(rows, first, count, lifted, I, work):
    """Set the facets of the cone of contact forces from row ``first`` on; whether there is such a cone.

    A pair of edges spans a facet if all other edges lie on one side of it.

    ``lifted`` is the row of a base corner that carries no load, so that the other has a corner's friction;
    −1 for none.
    """
    work.facets = 0
    root = math.sqrt(I)
    exists = False
    for p in range(2 * first, 2 * (first + count)):
        for q in range(2 * first, p):
            n, sine = _unit_normal(_edge(rows, p, lifted, root), _edge(rows, q, lifted, root))
            if sine == 0.0:
                continue
            exists = True
            low, high = _extent(rows, first, count, lifted, n, root)
            flat = low >= -PARALLEL_SINE and high <= PARALLEL_SINE
            slack = FLAT_CONE_SLACK if flat else 0.0
            if low >= -PARALLEL_SINE:
                _add_facet(work, n, root, slack)
            if high <= PARALLEL_SINE:
                _add_facet(work, (-n[0], -n[1], -n[2]), root, slack)
            if flat:
                _add_end_facets(rows, first, count, lifted, n, root, work)
    return exists


@inner
def _add_end_facets(rows, first, count, lifted, normal, root, work):
    """Add the bounding facets of a flat cone within its plane."""
    for p in range(2 * first, 2 * (first + count)):
        n, sine = _unit_normal(normal, _edge(rows, p, lifted, root))
        low, high = _extent(rows, first, count, lifted, n, root)
        if sine > 0.0 and low >= -PARALLEL_SINE:
            _add_facet(work, n, root, 0.0)
        if sine > 0.0 and high <= PARALLEL_SINE:
            _add_facet(work, (-n[0], -n[1], -n[2]), root, 0.0)


@inner
def load_within_facets(work, a, G, wrench):
    """Whether the load, with the elements' wrench, is inside all facets."""
    fx, fz, fl = wrench
    for f in work.facet[: work.facets]:
        if f[0] + f[1] * (a - fx) + f[2] * (G - fz) - f[3] * fl < 0.0:
            return False
    return True


@inner
def add_floor_limits(rows, count, lifted, a, G, wrench, I, work, spare):
    """Add the limits of the floor alone that the load satisfies: walls only resist what presses on them.

    Where the floor supports one corner, that is the sign of the moment about it: the load must go on pressing
    the body to the wall that stops its rotation.
    """
    fx, fz, fl = wrench
    on_floor = 0
    while on_floor < count and PLANE[rows[on_floor].index] == 0:
        on_floor += 1
    if (on_floor == 1 and count > 1) or lifted >= 0:
        foot = rows[1 if lifted == 0 else 0]
        nl, tl = foot.nl, foot.tl
        moment = tl * (a - fx) + nl * (G - fz) + fl
        side = 1.0 if moment >= 0.0 else -1.0
        size = side / math.sqrt(tl * tl + nl * nl + 1.0)
        _add_facet(work, (size * tl, size * nl, -size), 1.0, 0.0)
    elif on_floor == 2 and count > 2:
        cone_facets(rows, 0, 2, -1, I, spare)
        for f in spare.facet[: spare.facets]:
            if f[0] + f[1] * (a - fx) + f[2] * (G - fz) - f[3] * fl >= 0.0:
                _add_facet(work, (f[1], f[2], f[3]), 1.0, f[0])


@inner
def add_wrench(work, wrench):
    """Put the constant wrench of the elements into the facets, which leaves c₀ + c₁ẍ_G + c₂G."""
    fx, fz, fl = wrench
    for f in work.facet[: work.facets]:
        f[0] -= f[1] * fx + f[2] * fz + f[3] * fl


@inner
def range_within_facets(work, a0, a1, z0, z1):
    """Whether all loads with ẍ_G from a0 to a1 and G from z0 to z1 are inside all facets."""
    for f in work.facet[: work.facets]:
        if f[0] + lowest_product(f[1], a0, a1) + lowest_product(f[2], z0, z1) < 0.0:
            return False
    return True


@inner
def time_within_facets(work, a0, G0, a1, G1, h):
    """Time in a step, with these loads at its ends, at which they leave the facets, or h."""
    first = h
    for f in work.facet[: work.facets]:
        m0, m1 = f[0] + f[1] * a0 + f[2] * G0, f[0] + f[1] * a1 + f[2] * G1
        if m1 < 0.0:
            first = min(first, 0.0 if m0 <= 0.0 else h * m0 / (m0 - m1))
    return first
