"""All elements of a case together, at an event: their force on the body, and their branches."""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.acting import note_force
from stayput.mechanics.restrained.columns import AXIAL, F_NORMAL, F_TANGENT, HOLDS, NONE, NORMAL, TANGENT
from stayput.mechanics.restrained.lines import elastic_push, first_branch, force, settle


@inner
def set_up_elements(elements, links, devices, case, s):
    """Place the anchors, for a body at rest at slide 0, and forget what was before."""
    sin, cos = math.sin(s.rest), math.cos(s.rest)
    x = s.foot_a - (case.u[0] * cos + case.v[0] * sin)
    z = case.u[0] * sin - case.v[0] * cos
    for n in range(elements.shape[0]):
        el, link, device = elements[n], links[n], devices[n]
        here = math.isnan(el.x)
        link.x = x + el.u * cos + el.v * sin if here else el.x
        link.z = z + el.v * cos - el.u * sin if here else el.z
        link.lines = 0
        for i in range(2):
            first_branch(el, link, i)
            device.plastic[i] = 0.0
        if el.kind != NONE:
            link.lines = 1 if el.kind == AXIAL or el.stiffness[TANGENT] == 0.0 else 2
        link.push = link.push_rate = 0.0
        device.peak_pull = device.peak_push = device.peak_shear = 0.0
        device.failure, device.failure_time = HOLDS, math.nan


@inline
def _along_normal(el, dx, dz):
    """Unit vector of the normal line, and its elongation [m]."""
    if el.kind != AXIAL:
        return -el.sin, el.cos, el.cos * dz - el.sin * dx
    far = math.sqrt(dx * dx + dz * dz)
    if far == 0.0:
        return 0.0, 0.0, -el.length
    return dx / far, dz / far, far - el.length


@inline
def measure(elements, links, sin, cos, x, z, vx, vz, omega):
    """Force on the body and its moment about G, + clockwise; the links keep elongations and forces.

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
        F = force(el, link, NORMAL, e, rate, 0.0)
        link.e[NORMAL], link.rate[NORMAL], link.force[NORMAL] = e, rate, F
        px, pz = -F * nx, -F * nz
        if link.lines == 2:
            push, push_rate = elastic_push(el, link, e, rate)
            e, rate = el.cos * dx + el.sin * dz, el.cos * wx + el.sin * wz
            F = force(el, link, TANGENT, e, rate, push)
            link.e[TANGENT], link.rate[TANGENT], link.force[TANGENT] = e, rate, F
            link.push, link.push_rate = push, push_rate
            px, pz = px - F * el.cos, pz - F * el.sin
        fx, fz, fl = fx + px, fz + pz, fl + (px * up - pz * right)
    return fx, fz, fl


@inner
def settle_elements(elements, links, devices, time):
    """Bring all branches up to date with what was last measured; return how many devices failed."""
    failed = 0
    for n in range(elements.shape[0]):
        if links[n].lines > 0 and settle(elements[n], links[n], devices[n], time):
            failed += 1
    return failed


@inner
def none_left(links):
    """Whether no element acts any more."""
    for n in range(links.shape[0]):
        if links[n].lines > 0:
            return False
    return True


@inner
def note_forces(links, devices):
    """Keep the largest forces so far."""
    for n in range(devices.shape[0]):
        for i in range(links[n].lines):
            note_force(devices[n], i, links[n].force[i])


@inner
def note_forces_of_links(forces, links, s):
    """Write the forces down at a sample, where they are kept."""
    if forces.shape[0] == 0:
        return
    for n in range(forces.shape[1]):
        forces[s.k, n, F_NORMAL], forces[s.k, n, F_TANGENT] = links[n].force[NORMAL], links[n].force[TANGENT]
