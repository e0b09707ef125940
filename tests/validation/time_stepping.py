"""An integrator that shares nothing with stayput's: the time stepping of Moreau (1988) and Jean (1999).

Each step of fixed length solves the velocities and impulses of all contacts that its middle touches, by
Gauss–Seidel sweeps: Newton's restitution, Coulomb's friction with a static and a kinetic coefficient (in an
impact the static one for a contact that did not slip before it, as in stayput's law). It knows no modes and
no events, and errs by about its step in place and time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numba import njit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput import Body, Room, State

STICKS = 10.0
"""A contact has static friction where its slip is below what this many g bring up in a step.

More than zero: a corner that sticks leaves its plane by a rounding error now and then, free for a step.
"""


@dataclass(frozen=True)
class Stepped:
    """Tilt from rest [rad], slide of the lower corner [m] and (ẋ, ż, θ̇) at the samples of the motion."""

    tilt: NDArray[np.float64]
    slide: NDArray[np.float64]
    rates: NDArray[np.float64]


# Loops over the three numbers of a row, since arrays that are made anew take Numba ten times as long.


@njit(cache=True)
def _rate(row, v):
    """Rate of a contact along its row."""
    return row[0] * v[0] + row[1] * v[1] + row[2] * v[2]


@njit(cache=True)
def _push(row, step, weight, v):
    """Add an impulse along a row to the velocities."""
    for i in range(3):
        v[i] += weight[i] * row[i] * step


@njit(cache=True)
def _sweep(jn, jt, target, mu, weight, v, pn, pt, count, sweeps):
    """Gauss–Seidel on impulses: pn ≥ 0 ⊥ rate ≥ target, |pt| ≤ μ pn."""
    for _ in range(sweeps):
        change = 0.0
        for c in range(count):
            wn = wt = 0.0
            for i in range(3):
                wn += jn[c, i] * jn[c, i] * weight[i]
                wt += jt[c, i] * jt[c, i] * weight[i]
            new = max(0.0, pn[c] + (target[c] - _rate(jn[c], v)) / wn)
            step = new - pn[c]
            pn[c] = new
            _push(jn[c], step, weight, v)
            change = max(change, abs(step) * wn)
            most = mu[c] * pn[c]
            new = min(most, max(-most, pt[c] - _rate(jt[c], v) / wt))
            step = new - pt[c]
            pt[c] = new
            _push(jt[c], step, weight, v)
            change = max(change, abs(step) * wt)
        if change < 1e-14:
            break


@njit(cache=True)
def _step(corners, planes, pairs, coefficients, inertia, g, ax, az, dt, substeps, q, v, tilts, places, rates):
    h = dt / substeps
    weight = np.array([1.0, 1.0, 1.0 / inertia])
    count = pairs.shape[0]
    jn, jt = np.zeros((count, 3)), np.zeros((count, 3))
    target, mu, slips = np.zeros(count), np.zeros(count), np.zeros(count)
    pn, pt = np.zeros(count), np.zeros(count)
    kinetic, which = np.zeros(count), np.zeros(count, np.int64)
    for k in range(ax.shape[0]):
        tilts[k], rates[k] = q[2], v
        places[k, 0], places[k, 1] = q[0], q[1]
        if k == ax.shape[0] - 1 or abs(q[2]) >= math.pi / 2:
            return k + 1
        for m in range(substeps):
            part = (m + 0.5) / substeps
            a = ax[k] + part * (ax[k + 1] - ax[k])
            up = az[k] + part * (az[k + 1] - az[k])
            x, z, theta = q[0] + 0.5 * h * v[0], q[1] + 0.5 * h * v[1], q[2] + 0.5 * h * v[2]
            sin, cos = math.sin(theta), math.cos(theta)
            active, impact = 0, False
            for c in range(count):
                u, w = corners[pairs[c, 0]]
                right, over = u * cos + w * sin, w * cos - u * sin
                px, pz, offset = planes[pairs[c, 1]]  # inward normal, and its offset
                if px * (x + right) + pz * (z + over) + offset > 0.0:
                    continue
                # rates of the corner: ẋ + θ̇ over, ż − θ̇ right
                jn[active, 0], jn[active, 1], jn[active, 2] = px, pz, px * over - pz * right
                jt[active, 0], jt[active, 1], jt[active, 2] = pz, -px, pz * over + px * right
                before_n, before_t = _rate(jn[active], v), _rate(jt[active], v)
                target[active] = -coefficients[c, 2] * before_n if before_n < 0.0 else 0.0
                impact = impact or before_n < -STICKS * g * h
                slips[active] = abs(before_t)
                mu[active] = coefficients[c, 0] if slips[active] <= STICKS * g * h else coefficients[c, 1]
                kinetic[active] = coefficients[c, 1]
                which[active] = c
                active += 1
            free_x, free_z, free_turn = v[0] + h * -a, v[1] + h * (-g - up), v[2]
            for attempt in range(2):
                v[0], v[1], v[2] = free_x, free_z, free_turn
                pn[:active] = pt[:active] = 0.0
                _sweep(jn, jt, target, mu, weight, v, pn, pt, active, 2000)
                again = False
                for c in range(active if not impact else 0):  # what static friction cannot hold slips
                    if attempt == 0 and mu[c] > kinetic[c] and abs(_rate(jt[c], v)) > 1e-11:
                        mu[c] = kinetic[c]
                        again = True
                if not again:
                    break
            for i in range(3):
                q[i] += h * v[i]
    return ax.shape[0]


def time_stepping(
    body: Body,
    room: Room,
    ax: NDArray[np.float64],
    dt: float,
    *,
    initial: State,
    az: NDArray[np.float64] | None = None,
    step: float = 1e-5,
    gravity: float = 9.80665,
) -> Stepped:
    """Integrate a body without devices, beside walls if there are any, with steps of about ``step``."""
    (u_a, v_a), (u_b, v_b), *_ = body.corners
    rest = math.atan2(v_b - v_a, u_b - u_a)
    corners = np.array(body.corners)

    def turned(theta: float) -> NDArray[np.float64]:
        sin, cos = math.sin(theta), math.cos(theta)
        u, v = corners[:, 0], corners[:, 1]
        return np.column_stack([u * cos + v * sin, v * cos - u * sin])

    still = turned(rest)
    middle = -0.5 * (still[0, 0] + still[1, 0])
    places_at_rest = still[:, 0] + middle
    floor = room.floor
    planes, pairs, coefficients = [(0.0, 1.0, 0.0)], [], []
    for corner in (0, 1):
        pairs.append((corner, 0))
        coefficients.append((floor.static_friction, floor.kinetic_friction, floor.normal_restitution))
    if room.right_wall is not None:
        wall = room.right_wall
        planes.append((-1.0, 0.0, max(places_at_rest) + wall.gap))
        for corner in (1, 3):
            pairs.append((corner, len(planes) - 1))
            coefficients.append((wall.friction, wall.friction, wall.restitution))
    if room.left_wall is not None:
        wall = room.left_wall
        planes.append((1.0, 0.0, wall.gap - min(places_at_rest)))
        for corner in (0, 2):
            pairs.append((corner, len(planes) - 1))
            coefficients.append((wall.friction, wall.friction, wall.restitution))

    theta = rest + initial.tilt
    foot = 1 if initial.tilt > 0.0 or (initial.tilt == 0.0 and initial.tilt_rate > 0.0) else 0
    now = turned(theta)
    q = np.array([initial.slide + places_at_rest[foot] - now[foot, 0], -now[foot, 1], theta])
    omega = initial.tilt_rate
    v = np.array([initial.slide_rate - omega * now[foot, 1], omega * now[foot, 0], omega])
    samples = len(ax)
    tilts, places, rates = np.zeros(samples), np.zeros((samples, 2)), np.zeros((samples, 3))
    inertia = body.inertia_about_cg / body.mass
    reached = _step(
        corners,
        np.array(planes),
        np.array(pairs),
        np.array(coefficients),
        inertia,
        gravity,
        np.asarray(ax, np.float64),
        np.zeros(samples) if az is None else np.asarray(az, np.float64),
        dt,
        max(1, round(dt / step)),
        q,
        v,
        tilts,
        places,
        rates,
    )
    tilts, places = tilts[:reached], places[:reached]
    lower = (tilts > rest).astype(int)
    arms = np.array([turned(tilt)[corner, 0] for tilt, corner in zip(tilts, lower, strict=True)])
    return Stepped(tilts - rest, places[:, 0] + arms - places_at_rest[lower], rates[:reached])
