"""A lone body that turns about an edge whose two corners stick: one degree of freedom, in closed form.

With the edge's direction e, from its middle G at g + b c + a d with c and d cosine and sine of the angle φ
that it has turned since the flow began (g along e, b across it, a = e × b), and the push p of gravity and
shaking,

    I φ'' = m (c a·p − d b·p) + e·M,

M the moment of the devices about the edge. What the floor presses follows from the accelerations: the normal
forces of both corners from the moment across the edge, friction across it from that about the vertical.
Friction along it may be shared as the corners can bear it.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics import dormand_prince as dp
from stayput.mechanics.space.body import attitude, in_body, in_room, place_of, set_attitude, velocity
from stayput.mechanics.space.devices import loads_of
from stayput.mechanics.space.stepping import push_at
from stayput.mechanics.space.touching import lever_of_point
from stayput.mechanics.space.vectors import added, cross, dot, norm, scaled

SERIES_ANGLE = 0.25
"""Angle up to which sine and cosine are their series, exact to rounding [rad]."""


@inline
def _sine_and_cosine(x):
    if abs(x) > SERIES_ANGLE:
        return math.sin(x), math.cos(x)
    y = x * x
    sine = y * (1.0 / 120.0 + y * (-1.0 / 5040.0 + y * (1.0 / 362880.0 - y / 39916800.0)))
    cosine = y * (
        1.0 / 24.0 + y * (-1.0 / 720.0 + y * (1.0 / 40320.0 + y * (-1.0 / 3628800.0 + y / 479001600.0)))
    )
    return x + x * (y * (-1.0 / 6.0) + y * sine), 1.0 + (-0.5 * y + y * cosine)


@inline
def _edge(flow):
    return flow.ex, flow.ey, flow.ez


@inline
def _across(flow):
    return flow.bx, flow.by, flow.bz


@inline
def _ahead(flow):
    return flow.ax, flow.ay, flow.az


@inner
def begin_on_edge(flow, pressing, body, points, s):
    """Note the edge on which a body turns, and its rate about it."""
    r, q = lever_of_point(s, points[pressing[0].point]), lever_of_point(s, points[pressing[1].point])
    way = added(r, -1.0, q)
    length = norm(way)
    e = scaled(1.0 / length, way)
    middle = scaled(0.5, added(r, 1.0, q))
    g = scaled(-1.0, middle)
    along = scaled(dot(g, e), e)
    across = added(g, -1.0, along)
    axis = in_body(s, e)
    moments = body.i1 * axis[0], body.i2 * axis[1], body.i3 * axis[2]
    flow.half, flow.angle = 0.5 * length, 0.0
    flow.qw, flow.qx, flow.qy, flow.qz = attitude(s)
    flow.ex, flow.ey, flow.ez = e
    flow.ox, flow.oy, flow.oz = added(place_of(s), 1.0, middle)
    flow.gx, flow.gy, flow.gz = along
    flow.bx, flow.by, flow.bz = across
    flow.ax, flow.ay, flow.az = cross(e, across)
    flow.ix, flow.iy, flow.iz = moments
    flow.inertia = dot(axis, moments) + body.mass * dot(across, across)
    about = added((s.lx, s.ly, s.lz), body.mass, cross(g, velocity(s)))
    flow.rate = dot(e, about) / flow.inertia


@inner
def set_pose_on_edge(flow, body, angle, rate, s):
    """Set the pose at an angle and a rate."""
    e = _edge(flow)
    sine, cosine = _sine_and_cosine(angle)
    across = added(scaled(cosine, _across(flow)), sine, _ahead(flow))
    s.x, s.y, s.z = added(added((flow.ox, flow.oy, flow.oz), 1.0, (flow.gx, flow.gy, flow.gz)), 1.0, across)
    s.vx, s.vy, s.vz = scaled(rate, cross(e, across))
    k, w = _sine_and_cosine(0.5 * angle)
    x, y, z = scaled(k, e)
    s.lx = s.ly = s.lz = 0.0
    q = (
        w * flow.qw - x * flow.qx - y * flow.qy - z * flow.qz,
        w * flow.qx + x * flow.qw + y * flow.qz - z * flow.qy,
        w * flow.qy + y * flow.qw + z * flow.qx - x * flow.qz,
        w * flow.qz + z * flow.qw + x * flow.qy - y * flow.qx,
    )
    set_attitude(body, s, q)
    s.lx, s.ly, s.lz = scaled(rate, in_room(s, (flow.ix, flow.iy, flow.iz)))
    s.wx, s.wy, s.wz = scaled(rate, e)


@inner
def turn_on_edge(flow, world, held, stage, angle, rate, push):
    """Return the acceleration of the angle; ``stage`` is posed where there are devices."""
    body, moment = world[0][0], 0.0
    if held[0].shape[0] > 0:
        set_pose_on_edge(flow, body, angle, rate, stage[0])
        force, turning = loads_of(held[0], held[1], stage)
        g = added(place_of(stage[0]), -1.0, (flow.ox, flow.oy, flow.oz))
        moment = dot(_edge(flow), added(turning, 1.0, cross(g, force)))
        flow.fx, flow.fy, flow.fz = force
        flow.mx, flow.my, flow.mz = turning
    sine, cosine = _sine_and_cosine(angle)
    moment += body.mass * (cosine * dot(push, _ahead(flow)) - sine * dot(push, _across(flow)))
    return moment / flow.inertia


@inner
def press_on_edge(flow, pressing, body, s, angle, rate, change, push, weight):
    """Set what presses on the edge, and return the least margin, over the weight."""
    e, half, c1, c2 = _edge(flow), flow.half, pressing[0], pressing[1]
    sine, cosine = _sine_and_cosine(angle)
    across = added(scaled(cosine, _across(flow)), sine, _ahead(flow))
    g = added(across, 1.0, (flow.gx, flow.gy, flow.gz))
    a = added(scaled(change, cross(e, g)), -rate * rate, across)
    force = added(scaled(body.mass, added(a, -1.0, push)), -1.0, (flow.fx, flow.fy, flow.fz))
    inertia = in_room(s, (flow.ix, flow.iy, flow.iz))
    moment = added(scaled(change, inertia), rate * rate, cross(e, inertia))
    moment = added(added(moment, -1.0, (flow.mx, flow.my, flow.mz)), 1.0, cross(g, force))
    b = -e[1], e[0], 0.0
    more = -dot(moment, b) / half
    n1, n2 = 0.5 * (force[2] + more), 0.5 * (force[2] - more)
    c1.pn, c2.pn = n1, n2
    flow.px, flow.py, flow.pz = force
    if n1 <= 0.0 or n2 <= 0.0:
        return min(n1, n2) / weight
    aside, along, share = dot(force, b), dot(force, e), n1 / (n1 + n2)
    middle = half * (2.0 * share - 1.0)
    f1 = (moment[2] + (half - (1.0 - c1.kappa) * (half + middle)) * aside) / (2.0 * c1.kappa * half)
    f2 = aside - f1
    # friction along the normal axes of a plane that is level
    c1.ps, c1.pt = f1 * b[0] + share * along * e[0], f1 * b[1] + share * along * e[1]
    c2.ps, c2.pt = f2 * b[0] + (1.0 - share) * along * e[0], f2 * b[1] + (1.0 - share) * along * e[1]
    most1, most2 = c1.mu_static * n1, c2.mu_static * n2
    left = min(most1 - abs(f1), most2 - abs(f2))
    if left > 0.0:
        bears = math.sqrt(most1 * most1 - f1 * f1) + math.sqrt(most2 * most2 - f2 * f2)
        left = min(left, bears - abs(along))
    return min(left, min(n1, n2)) / weight


@inner
def step_on_edge(flow, world, held, stage, a0, a1, t, dt, h, gravity):
    """Take a step of Dormand and Prince's method; return the errors of the angle and of its rate."""
    a, e = dp.RATES, dp.ERROR
    w, k1, at = flow.rate0, flow.change0, flow.angle0
    p = push_at(a0, a1, (t + dp.TIMES[1] * h) / dt, gravity)
    v2 = w + h * a[1, 0] * k1
    k2 = turn_on_edge(flow, world, held, stage, at + h * a[1, 0] * w, v2, p)
    p = push_at(a0, a1, (t + dp.TIMES[2] * h) / dt, gravity)
    v3 = w + h * (a[2, 0] * k1 + a[2, 1] * k2)
    k3 = turn_on_edge(flow, world, held, stage, at + h * (a[2, 0] * w + a[2, 1] * v2), v3, p)
    p = push_at(a0, a1, (t + dp.TIMES[3] * h) / dt, gravity)
    v4 = w + h * (a[3, 0] * k1 + a[3, 1] * k2 + a[3, 2] * k3)
    angle = at + h * (a[3, 0] * w + a[3, 1] * v2 + a[3, 2] * v3)
    k4 = turn_on_edge(flow, world, held, stage, angle, v4, p)
    p = push_at(a0, a1, (t + dp.TIMES[4] * h) / dt, gravity)
    v5 = w + h * (a[4, 0] * k1 + a[4, 1] * k2 + a[4, 2] * k3 + a[4, 3] * k4)
    angle = at + h * (a[4, 0] * w + a[4, 1] * v2 + a[4, 2] * v3 + a[4, 3] * v4)
    k5 = turn_on_edge(flow, world, held, stage, angle, v5, p)
    p = push_at(a0, a1, (t + h) / dt, gravity)
    v6 = w + h * (a[5, 0] * k1 + a[5, 1] * k2 + a[5, 2] * k3 + a[5, 3] * k4 + a[5, 4] * k5)
    angle = at + h * (a[5, 0] * w + a[5, 1] * v2 + a[5, 2] * v3 + a[5, 3] * v4 + a[5, 4] * v5)
    k6 = turn_on_edge(flow, world, held, stage, angle, v6, p)
    b = a[6]
    flow.angle = at + h * (b[0] * w + b[2] * v3 + b[3] * v4 + b[4] * v5 + b[5] * v6)
    flow.rate = w + h * (b[0] * k1 + b[2] * k3 + b[3] * k4 + b[4] * k5 + b[5] * k6)
    flow.change = k7 = turn_on_edge(flow, world, held, stage, flow.angle, flow.rate, p)
    off = h * (e[0] * w + e[2] * v3 + e[3] * v4 + e[4] * v5 + e[5] * v6 + e[6] * flow.rate)
    rate_off = h * (e[0] * k1 + e[2] * k3 + e[3] * k4 + e[4] * k5 + e[5] * k6 + e[6] * k7)
    return abs(off), abs(rate_off)


@inline
def angle_within(flow, h, part):
    """Return the angle and its rate at a part of a step, from the quintic through both ends."""
    a, b = h * flow.rate0, 0.5 * h * h * flow.change0
    p, q, r = flow.angle - flow.angle0 - a - b, h * flow.rate - a - 2.0 * b, h * h * flow.change - 2.0 * b
    c3, c4, c5 = 10.0 * p - 4.0 * q + 0.5 * r, -15.0 * p + 7.0 * q - r, 6.0 * p - 3.0 * q + 0.5 * r
    x = part
    angle = flow.angle0 + x * (a + x * (b + x * (c3 + x * (c4 + x * c5))))
    rate = (a + x * (2.0 * b + x * (3.0 * c3 + x * (4.0 * c4 + x * 5.0 * c5)))) / h
    return angle, rate
