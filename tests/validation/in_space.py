"""What the validation tests in space share: motions, tilted bodies, energies, and a rim that rolls.

g = 9.80665 m/s², the engine's own. Bodies begin upright; a tilted one is the same body in a turned frame.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from scipy.integrate import solve_ivp

import stayput as sp

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

G = 9.80665
UP = np.array([0.0, 0.0, 1.0])
STICKING = sp.Room(sp.Floor(5.0, 5.0, rolling_resistance=0.0))
"""A floor on which nothing slips."""


def still(duration: float, dt: float = 0.01) -> sp.Motion:
    """Return a floor that does not move."""
    return sp.Motion(dt=dt, x=np.zeros(round(duration / dt) + 1), name="still")


def steady(x: float, y: float, duration: float, dt: float = 0.01) -> sp.Motion:
    """Return a floor of constant acceleration from t = 0 [m/s²]."""
    count = round(duration / dt) + 1
    return sp.Motion(dt=dt, x=np.full(count, x), y=np.full(count, y), name="steady")


def about(axis: tuple[float, float, float], angle: float) -> Array:
    """Return the rotation by an angle about an axis, shape (3, 3) (Rodrigues)."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


def turned(convex: sp.Body, turn: Array) -> sp.Body:
    """Return the same body with its frame turned back, so that it begins turned."""
    rims = convex.solid.rims
    return sp.Body.hull(
        convex.solid.vertices @ turn.T,
        convex.mass,
        centre_of_gravity=turn @ convex.solid.centre_of_gravity,
        inertia=turn @ convex.solid.inertia @ turn.T,
        rims=np.column_stack((rims[:, :3] @ turn.T, rims[:, 3:6] @ turn.T, rims[:, 6])) if len(rims) else (),
    )


def lifted(convex: sp.Body, gap: float = 0.0) -> tuple[float, float, float]:
    """Return where the frame of a body is when its lowest corner or rim is a gap [m] above the floor."""
    lows = [convex.solid.vertices[:, 2].min()]
    lows += [rim[2] - rim[6] * math.hypot(rim[3], rim[4]) for rim in convex.solid.rims]
    return (0.0, 0.0, gap - float(min(lows)))


def inertia_over_time(run: sp.Run, body: int = 0) -> Array:
    """Return the inertia about G in the room's axes at the samples, shape (samples, 3, 3) [kg m²]."""
    turn = run.turn[body]
    return turn @ run.standing[body].solid.inertia @ turn.transpose(0, 2, 1)


def energy(run: sp.Run, body: int = 0) -> Array:
    """Return kinetic and potential energy of a body at the samples [J]."""
    mass, spin = run.standing[body].solid.mass, run.rotation_rate[body]
    turning = 0.5 * np.einsum("si,sij,sj->s", spin, inertia_over_time(run, body), spin)
    return turning + 0.5 * mass * (run.velocity[body] ** 2).sum(axis=1) + mass * G * run.place[body, :, 2]


def lowest(run: sp.Run, body: int = 0) -> Array:
    """Return the height of the lowest corner of a body at the samples [m]."""
    solid = run.standing[body].solid
    arms = solid.vertices - solid.centre_of_gravity
    return (run.place[body, :, 2, np.newaxis] + run.turn[body][:, 2] @ arms.T).min(axis=1)


def axis_over_time(run: sp.Run, axis: Array) -> Array:
    """Return a direction of the first body's frame in the room at the samples, shape (samples, 3)."""
    return run.turn[0] @ axis


class Rim:
    """A body of revolution that rolls on its rim without slipping, or slides on it without friction.

    Its axis n points up out of the rim's plane; G lies d above that plane. m is its mass, A and C are its
    moments of inertia across and about the axis, r is the radius of the rim.
    """

    def __init__(self, m: float, A: float, C: float, r: float, d: float) -> None:
        self.m, self.A, self.C, self.r, self.d = m, A, C, r, d

    @classmethod
    def of(cls, cylinder: sp.Body) -> Rim:
        """Return what rolls on the lower rim of an upright cylinder."""
        r, d = float(cylinder.solid.rims[0, 6]), float(cylinder.solid.centre_of_gravity[2])
        return cls(cylinder.mass, cylinder.solid.inertia[0, 0], cylinder.solid.inertia[2, 2], r, d)

    def lever(self, n: Array) -> Array:
        """Return the lowest point of the rim from G."""
        down = n[2] * n - UP
        return self.r * down / np.linalg.norm(down) - self.d * n

    def steady_spin(self, tilt: float, precession: float) -> float:
        """Return w = ω·n of steady rolling at a tilt [rad] and a rate of precession Ω [rad/s].

        In axes that turn with Ω about the vertical nothing changes. With n = (sin θ, 0, cos θ), the direction
        u = (cos θ, 0, −sin θ) down to the contact, c = r u − d n and ω = −Ω sin θ u + w n, rolling gives
        G the velocity V along y, V = Ω d sin θ − w r, and the floor's force is m (g z − Ω V x). The moment
        c × F is the rate of the angular momentum, Ω z × L with L = −A Ω sin θ u + C w n, about y:

            Ω sin θ (C w − A Ω cos θ) = m (h Ω V − g X),   h = r sin θ + d cos θ, X = r cos θ − d sin θ,

        which is linear in w.
        """
        m, A, C, r, d, rate = self.m, self.A, self.C, self.r, self.d, precession
        s, c = math.sin(tilt), math.cos(tilt)
        h, X = r * s + d * c, r * c - d * s
        return (A * rate**2 * s * c + m * h * rate**2 * d * s - m * G * X) / (C * rate * s + m * h * rate * r)

    def steady_rotation(self, tilt: float, precession: float) -> Array:
        """Return ω of steady rolling, of an axis that is tilted towards x [rad/s]."""
        n = np.array([math.sin(tilt), 0.0, math.cos(tilt)])
        u = np.array([math.cos(tilt), 0.0, -math.sin(tilt)])
        return -precession * math.sin(tilt) * u + self.steady_spin(tilt, precession) * n

    def rolled(self, n: Array, rotation: Array, times: Array) -> Array:
        """Return the axis n at given times, shape (times, 3), by the equations of rolling, to 1e-10.

        The contact's velocity is zero: v = −ω × c. The floor's force m (v̇ + g z) turns the body:
        J ω̇ + ω × J ω = c × m (g z − ω̇ × c − ω × ċ).
        """

        def rates(_: float, y: Array) -> Array:
            n, w = y[:3], y[3:]
            down = n[2] * n - UP
            size = float(np.linalg.norm(down))
            u = down / size
            c = self.r * u - self.d * n
            n_rate = np.cross(w, n)
            u_rate = n_rate[2] * n + n[2] * n_rate
            u_rate = (u_rate - u * (u @ u_rate)) / size
            c_rate = self.r * u_rate - self.d * n_rate
            J = self.A * np.eye(3) + (self.C - self.A) * np.outer(n, n)
            about_contact = J + self.m * (c @ c * np.eye(3) - np.outer(c, c))
            moment = self.m * np.cross(c, G * UP - np.cross(w, c_rate))
            return np.concatenate((n_rate, np.linalg.solve(about_contact, moment - np.cross(w, J @ w))))

        start = np.concatenate((n, rotation))
        found = solve_ivp(
            rates, (0.0, times[-1]), start, method="DOP853", t_eval=times, rtol=1e-11, atol=1e-12
        )
        return found.y[:3].T

    def standing(self, cylinder: sp.Body, tilt: float, rotation: Array, slips: bool = False) -> sp.Piece:
        """Return an upright cylinder that begins tilted towards x, on its rim, and rolls at ω.

        Where it slips, G moves up and down only, as the contact asks.
        """
        convex = turned(cylinder, about((0.0, 1.0, 0.0), tilt))
        c = self.lever(np.array([math.sin(tilt), 0.0, math.cos(tilt)]))
        velocity = -np.cross(rotation, c)
        if slips:
            velocity[:2] = 0.0
        return sp.Piece(
            convex, at=lifted(convex, 1e-9), velocity=tuple(velocity), rotation_rate=tuple(rotation)
        )
