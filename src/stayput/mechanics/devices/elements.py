"""The elements of a case at an event: anchors, force on the body, update of their branches."""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.devices.columns import AXIAL, F_NORMAL, F_TANGENT, HOLDS, NONE, NORMAL, TANGENT
from stayput.mechanics.devices.device_law import (
    branch_of,
    clipped,
    force_of,
    note_force,
    push_of,
    reset_branch,
    update_element,
)
from stayput.mechanics.elementary import sine_and_cosine


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
        if el.kind != NONE:
            link.lines = 1 if el.kind == AXIAL or el.stiffness[TANGENT] == 0.0 else 2
        link.push = link.push_rate = 0.0
        device.peak_pull = device.peak_push = device.peak_shear = 0.0
        device.failure, device.failure_time = HOLDS, math.nan


@inline
def _along_normal(el, dx, dz):
    """Unit vector and elongation of the normal line [m]."""
    if el.kind != AXIAL:
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
        line = branch_of(el, link, NORMAL)
        F = force_of(line, e, rate, 0.0)
        link.e[NORMAL], link.rate[NORMAL], link.force[NORMAL] = e, rate, F
        px, pz = -F * nx, -F * nz
        if link.lines == 2:
            push, push_rate = push_of(line, F, rate)
            e, rate = el.cos * dx + el.sin * dz, el.cos * wx + el.sin * wz
            F = force_of(branch_of(el, link, TANGENT), e, rate, push)
            link.e[TANGENT], link.rate[TANGENT], link.force[TANGENT] = e, rate, F
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
            line = branch_of(elements[n], link, i)
            note_force(devices[n], i, clipped(line, link.force[i], link.push))


@inner
def note_forces_of_links(forces, links, s):
    """Write the forces into the force history, if it is kept."""
    if forces.shape[0] == 0:
        return
    for n in range(forces.shape[1]):
        forces[s.k, n, F_NORMAL], forces[s.k, n, F_TANGENT] = links[n].force[NORMAL], links[n].force[TANGENT]
