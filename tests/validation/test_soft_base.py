"""How a piece stands: bases on floors that give, landings over a region, feet inside the outline.

The law is `stayput.model.soft_base`; beside it a body on a row of springs and dampers, stepped in time by
Runge and Kutta's method, which knows nothing of fulcrums, impacts and restitution.
"""

import math

import numba
import numpy as np
import pytest

import stayput as sp
from stayput.model.soft_base import LEAST, landing_factor, rigid_half_base

GRAVITY = 9.80665
STICKING = 5.0


def moment(a: float, z: float, settlement: float, tilt: np.ndarray) -> np.ndarray:
    """Return the restoring moment over m g of a base on springs: whole, then partly lifted [m]."""
    whole = a * a * tilt / (3.0 * settlement) - z * tilt
    lifted = a - z * tilt - (2.0 / 3.0) * np.sqrt(a * settlement / np.maximum(tilt, 1e-12))
    return np.where(tilt < settlement / a, whole, lifted)


@pytest.mark.parametrize("settlement", [1e-6, 2e-5, 3e-4, 1e-3, 2e-3])
@pytest.mark.parametrize(("a", "z"), [(0.15, 0.9), (0.34, 0.91), (0.2, 0.3), (0.05, 0.4)])
def test_the_energy_to_overturn_is_that_of_the_rigid_base(a: float, z: float, settlement: float) -> None:
    tilt = np.concatenate(
        (np.linspace(0.0, settlement / a, 20_001), np.geomspace(settlement / a, a / z, 200_001))
    )
    held = moment(a, z, settlement, tilt)
    work = np.concatenate(([0.0], np.cumsum(0.5 * (held[1:] + held[:-1]) * np.diff(tilt))))
    rigid = float(rigid_half_base(a, z, settlement))
    least = (LEAST * a) ** 2 / (2.0 * z)
    assert rigid**2 / (2.0 * z) == pytest.approx(max(work.max(), least), rel=2e-4)


def test_barnett_2020_a_carpet_may_lower_tip_resistance_by_40_percent() -> None:
    """A four-drawer file cabinet, 15 × 52 in: the force that tips it on a carpet that sinks in by 1.1 mm."""
    a, z = 0.5 * 15.0 * 0.0254, 0.5 * 52.0 * 0.0254
    held = moment(a, z, 1.1e-3, np.linspace(1e-6, a / z, 100_001))
    assert held.max() / a == pytest.approx(0.6, abs=0.01)


def test_a_rigid_floor_changes_nothing_to_the_bit() -> None:
    halves = np.array([0.1, 0.15, 0.34])
    assert np.array_equal(rigid_half_base(halves, 0.9, np.zeros(3)), halves)
    assert landing_factor(1.0, 0.02, 0.9, 0.28) == 1.0


def test_a_floor_too_soft_leaves_a_fifth_of_the_base() -> None:
    assert float(rigid_half_base(0.15, 0.9, 0.05)) == pytest.approx(0.03)


def peaks(run: sp.Run) -> np.ndarray:
    size = np.abs(run.tilt)
    return size[1:-1][(size[1:-1] > size[:-2]) & (size[1:-1] >= size[2:])]


@pytest.mark.parametrize("place", [1.0, 2.0 / 3.0, 0.5, 0.0])
@pytest.mark.parametrize(("a", "z"), [(0.15, 0.9), (0.34, 0.91)])
def test_landings_have_the_ratio_of_angular_momentum_about_their_place(
    a: float, z: float, place: float
) -> None:
    """r(ξ) = (K − ξa²)/(K + ξa²), K = J_G/m + z²: Housner's 1 − ³⁄₂ sin²α at ξ = 1, no loss at 0."""
    alpha = math.atan2(a, z)
    floor = sp.Floor(STICKING, STICKING, landing_place=place)
    still = sp.Motion(dt=0.0005, x=np.zeros(6000))
    run = sp.simulate(sp.Body(2 * a, 2 * z, 100.0), sp.Room(floor), still, initial=sp.State(tilt=0.5 * alpha))
    raised = np.cos(alpha - np.concatenate(([0.5 * alpha], peaks(run)))) - math.cos(alpha)
    K = (a * a + z * z) / 3.0 + z * z
    ratio = (K - place * a * a) / (K + place * a * a)
    if place == 1.0:
        assert ratio == pytest.approx(1.0 - 1.5 * math.sin(alpha) ** 2)
    assert np.sqrt(raised[1:3] / raised[:2]) == pytest.approx(ratio, rel=1e-4)


def test_landings_inside_the_base_never_create_energy() -> None:
    """Wild bodies, slippery and rough floors, off-centre masses: the energy only falls on a still floor."""
    rng = np.random.default_rng(5)
    still = sp.Motion(dt=0.002, x=np.zeros(2000))
    for _ in range(60):
        b, h = rng.uniform(0.2, 1.2), rng.uniform(0.4, 2.0)
        body = sp.Body(b, h, 100.0, cg_offset=(rng.uniform(-0.3, 0.3) * b, rng.uniform(-0.2, 0.2) * h))
        mu = rng.choice([0.05, 0.2, 0.5, 2.0])
        floor = sp.Floor(mu, mu, landing_place=rng.uniform(0.0, 0.6))
        alpha = min(body.slenderness)
        run = sp.simulate(
            body,
            sp.Room(floor),
            still,
            initial=sp.State(tilt=rng.uniform(0.2, 0.9) * alpha, slide_rate=rng.uniform(-0.5, 0.5)),
        )
        v = np.stack([np.gradient(values, run.time) for values in (run.place[0, :, 0], run.place[0, :, 2])])
        energy = (
            0.5 * (v**2).sum(0) + 0.5 * body.inertia_about_cg / body.mass * run.rotation_rate[0, :, 1] ** 2
        )
        energy = energy + GRAVITY * run.place[0, :, 2]
        # differences blur the velocities over two samples, hence the medians of stretches
        levels = np.array([np.median(part) for part in np.array_split(energy, 25)])
        assert np.diff(levels).max() < 2e-3 * (energy[0] - GRAVITY * run.place[0, :, 2].min() + 1e-3) + 1e-4


def test_a_bouncing_corner_is_no_fulcrum() -> None:
    """A squat box that bounces and lands inside its base comes to rest on a still floor."""
    floor = sp.Floor(10.0, 10.0, normal_restitution=0.3, landing_place=0.7)
    still = sp.Motion(dt=0.005, x=np.zeros(600))
    run = sp.simulate(sp.Body(0.4, 0.3, 10.0), sp.Room(floor), still, initial=sp.State(tilt=0.5564))
    assert not run.overturned
    assert np.abs(run.tilt[-20:]).max() < 0.05


def test_one_number_has_the_bits_of_a_column() -> None:
    """A run that is made again, alone, is that of the ensemble: scalars and columns agree to the last bit."""
    rng = np.random.default_rng(2)
    a, z, w = rng.uniform(0.05, 0.4, 2000), rng.uniform(0.2, 1.0, 2000), rng.lognormal(-8.0, 1.0, 2000)
    alone = [float(rigid_half_base(*one)) for one in zip(a.tolist(), z.tolist(), w.tolist(), strict=True)]
    assert rigid_half_base(a, z, w).tolist() == alone


@numba.njit(fastmath=True)
def rates_on_springs(a, z, inertia, k, c, strips, ground, up, tilt, rate, omega):  # pragma: no cover
    """The accelerations of a body on a row of springs that only push: of the height of G, and of the tilt."""
    s, co = np.sin(tilt), np.cos(tilt)
    push = turning = 0.0
    for j in range(strips):
        at = ((j + 0.5) / strips * 2.0 - 1.0) * a
        below = up - z * co - at * s
        force = -k * below - c * (rate + z * s * omega - at * co * omega)
        if below < 0.0 and force > 0.0:
            push += force
            turning -= force * (at * co - z * s)
    spin = (turning + z * co * (z * s * omega**2 - ground)) / (inertia + (z * co) ** 2)
    return push - GRAVITY, spin


@numba.njit
def falls_on_springs(a, z, inertia, settlement, ratio, strips, x, dt, parts, scale):  # pragma: no cover
    """Whether a body on a row of springs that only push turns over; the middle of its base does not slip."""
    k, c = GRAVITY / (settlement * strips), 2.0 * ratio * np.sqrt(GRAVITY / settlement) / strips
    up, tilt, rate, omega = z - settlement, 0.0, 0.0, 0.0  # height of G, tilt, and their rates
    h = dt / parts
    for n in range(len(x) - 1):
        for part in range(parts):
            u1 = u2 = u3 = u4 = d1 = d2 = d3 = d4 = 0.0  # sums of the slopes, and the last of them
            for stage in range(4):
                f = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
                weight = 1.0 if stage in (0, 3) else 2.0
                ground = scale * (x[n] + (x[n + 1] - x[n]) * (part + f) / parts)
                v, w = rate + f * h * d3, omega + f * h * d4
                rise, spin = rates_on_springs(
                    a, z, inertia, k, c, strips, ground, up + f * h * d1, tilt + f * h * d2, v, w
                )
                d1, d2, d3, d4 = v, w, rise, spin
                u1, u2, u3, u4 = u1 + weight * d1, u2 + weight * d2, u3 + weight * d3, u4 + weight * d4
            up, tilt = up + h / 6.0 * u1, tilt + h / 6.0 * u2
            rate, omega = rate + h / 6.0 * u3, omega + h / 6.0 * u4
            if abs(tilt) > 1.3:
                return True
    return False


@pytest.mark.parametrize(
    ("a", "z", "settlement", "place"),
    [(0.15, 0.9, 1e-4, 0.5), (0.15, 0.9, 1e-3, 0.9), (0.34, 0.91, 5e-4, 0.3)],
)
def test_a_soft_body_overturns_as_early_as_its_rigid_base(
    a: float, z: float, settlement: float, place: float
) -> None:
    """Capacities under six motions: 0.8 to 1.2 of those by the law, and well below the ideal block's.

    The damping is 0.3 of the critical one; the landing places are those of free rocking on the springs.
    """
    inertia = (a * a + z * z) / 3.0
    body = sp.Body(2.0 * a, 2.0 * z, 100.0)
    by_law, by_ideal = [], []
    for motion in (*sp.synthetic_suite("crustal", 3, 3), *sp.synthetic_suite("near-fault", 3, 4)):
        shaking = motion.component("x").padded(0.0, 3.0)
        scales = np.geomspace(0.4, 6.0, 40) * GRAVITY * a / z / shaking.pga
        parts = math.ceil(shaking.dt / (0.2 * math.sqrt(settlement / GRAVITY)))
        soft = [
            falls_on_springs(a, z, inertia, settlement, 0.3, 24, shaking.x, shaking.dt, parts, scale)
            for scale in scales
        ]

        step = math.log(scales[1] / scales[0])
        for found, floor in (
            (by_law, sp.Floor(STICKING, STICKING, landing_place=place, settlement=settlement)),
            (by_ideal, sp.Floor(STICKING, STICKING)),
        ):
            data = sp.sweep(sp.Case(body, sp.Room(floor), shaking), {"motion.scale": scales})
            found.append(step * (int(data.overturned.sum()) - sum(soft)))
    assert 0.8 < math.exp(np.mean(by_law)) < 1.2
    assert math.exp(np.mean(by_ideal)) < 0.85


def test_feet_inside_the_outline_are_a_narrower_base() -> None:
    """A free piece on insets moves as one of the smaller width with the same mass, height and inertia."""
    motion = sp.near_fault()
    wide = sp.Body(0.4, 1.8, 100.0, cg_offset=(0.01, -0.1), base_insets=(0.03, 0.05))
    narrow = sp.Body(
        0.32, 1.8, 100.0, cg_offset=(0.02, -0.1), inertia=sp.Body(0.4, 1.8, 100.0).inertia_about_cg
    )
    one, other = (sp.simulate(body, sp.Room(sp.Floor(0.4, 0.3)), motion) for body in (wide, narrow))
    assert one.outcome == other.outcome
    assert one.peak_tilt == pytest.approx(other.peak_tilt, rel=1e-9)
    assert one.peak_slide == pytest.approx(other.peak_slide, rel=1e-9)


def test_a_piece_on_feet_meets_the_wall_with_its_side() -> None:
    """Sliding upright into a wall it stops against its whole side face, not its top corner alone."""
    body = sp.Body(0.6, 0.8, 50.0, base_insets=(0.05, 0.05))
    still = sp.Motion(dt=0.01, x=np.zeros(200))
    room = sp.Room(sp.Floor(0.02, 0.02), right_wall=sp.Wall(0.1, restitution=0.0, friction=0.0))
    run = sp.simulate(body, room, still, initial=sp.State(slide_rate=0.4))
    assert run.wall_impacts > 0
    assert run.peak_tilt < 1e-3
    assert run.residual_slide == pytest.approx(0.1, abs=1e-6)


@pytest.mark.parametrize(
    ("insets", "part"),
    [((0.3, 0.0), "base inset"), ((-0.01, 0.0), "base inset"), ((0.0,), "2 numbers"), ((0.0, 0.2), "centre")],
)
def test_insets_that_carry_nothing_are_refused(insets: tuple[float, ...], part: str) -> None:
    with pytest.raises(sp.InputError, match=part):
        sp.Body(0.5, 1.0, 100.0, cg_offset=(0.1, 0.0), base_insets=insets)  # type: ignore[arg-type]
