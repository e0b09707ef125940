"""The reference cases of the validation page: known numbers, and what stayput computes for them.

Each function is one case and yields its rows. b and h are half sizes here, as in the literature on
rocking blocks; g = 9.81 m/s². Nothing is fitted; a reference is a closed form or a separate solution of
the nonlinear equations, and `Row.source` says which.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

G = 9.81
CLOSED = "closed form"
SOLVED = "numerical solution of the nonlinear equations"


@dataclass(frozen=True, slots=True)
class Row:
    """One line of the table; ``tolerance`` is the largest relative error that passes."""

    case: str
    quantity: str
    source: str
    reference: float
    computed: float
    tolerance: float

    @property
    def error(self) -> float:
        """Relative error."""
        return abs(self.computed / self.reference - 1.0)


def block(b: float, h: float) -> sp.Body:
    """Return a uniform block of half sizes b and h [m]."""
    return sp.Body(width=2 * b, height=2 * h, mass=100.0)


def slenderness(b: float, h: float) -> tuple[float, float]:
    """Return R [m] and α [rad]."""
    return math.hypot(b, h), math.atan2(b, h)


def room(static: float, kinetic: float | None = None) -> sp.Room:
    """Return a floor alone; 3 is the friction of a corner that does not slip."""
    return sp.Room(sp.Floor(static_friction=static, kinetic_friction=static if kinetic is None else kinetic))


STICKING = room(3.0)


def still(duration: float, dt: float = 1e-3) -> sp.Motion:
    """Return a floor that does not move."""
    return sp.Motion(dt, np.zeros(round(duration / dt) + 1), name="still")


def steady(acceleration: float, duration: float, dt: float) -> sp.Motion:
    """Return a floor of constant acceleration from t = 0 [m/s²]."""
    return sp.Motion(dt, np.full(round(duration / dt) + 1, acceleration), name="steady")


def simulate(body: sp.Body, place: sp.Room, motion: sp.Motion, **state: float) -> sp.Run:
    """Simulate with this page's gravity."""
    return sp.simulate(body, place, motion, initial=sp.State(**state), gravity=G)


def impacts(run: sp.Run) -> list[float]:
    """Return the times of the floor impacts [s]."""
    return [event.time for event in run.events if event.kind is sp.EventKind.FLOOR_IMPACT]


def threshold(overturns: Callable[[float], bool], low: float, high: float, width: float = 1e-6) -> float:
    """Return where ``overturns`` changes, by bisection; both ends are checked first."""
    first = overturns(low)
    if overturns(high) == first:
        raise RuntimeError(f"No threshold between {low} and {high}.")
    while high - low > width:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if overturns(middle) == first else (low, middle)
    return 0.5 * (low + high)


def free_rocking() -> Iterator[Row]:
    """Release at α/2 on a sticking fulcrum; Housner's loss at each impact."""
    case, b, h = "1. Free rocking from α/2, b = 0.2, h = 0.8", 0.2, 0.8
    _, alpha = slenderness(b, h)
    run = simulate(block(b, h), STICKING, still(2.4), tilt=alpha / 2)
    times = impacts(run)
    for n, known in enumerate((0.441671, 1.160493, 1.770421)):
        yield Row(case, f"impact {n + 1} [s]", SOLVED, known, times[n], 1e-3)
    for n, known in enumerate((0.386714, 0.306397, 0.246057)):
        between = (run.time > times[n]) & (run.time < times[n + 1])
        peak = float(np.abs(run.tilt[between]).max()) / alpha
        yield Row(case, f"peak {n + 1} of \\|θ\\|/α", SOLVED, known, peak, 1e-3)
    radius = math.hypot(b, h)
    thin = 1e-3  # α: so slender that the equation is linear
    body = block(radius * math.sin(thin), radius * math.cos(thin))
    first = impacts(simulate(body, STICKING, still(0.6), tilt=thin / 2))[0]
    known = math.acosh(2.0) / math.sqrt(0.75 * G / radius)
    yield Row(case, "quarter period, slender limit [s]", f"{CLOSED}: acosh(1/(1−θ₀/α))/p", known, first, 1e-3)


def sudden_velocity() -> Iterator[Row]:
    """A sudden velocity of the floor is an initial rate 3V cos α/(4R)."""
    for b, h in ((0.2, 0.8), (0.1, 0.9)):
        radius, alpha = slenderness(b, h)
        known = math.sqrt(8.0 * G * radius * (1.0 - math.cos(alpha)) / (3.0 * math.cos(alpha) ** 2))
        body, floor, factor = block(b, h), still(20.0, 0.01), 0.75 * math.cos(alpha) / radius

        def overturns(v: float, body=body, floor=floor, factor=factor) -> bool:
            return simulate(body, STICKING, floor, tilt_rate=factor * v).overturned

        found = threshold(overturns, 0.5 * known, 2.0 * known)
        case = f"2. Sudden velocity of the floor, b = {b}, h = {h}"
        yield Row(case, "least V that overturns [m/s]", f"{CLOSED}: balance of energy", known, found, 2e-3)


def rectangular_pulse() -> Iterator[Row]:
    """One rectangular pulse, then a still floor."""
    for length, known in ((0.1, 0.97221), (0.2, 0.55697), (0.5, 0.32219)):

        def overturns(a: float, length=length) -> bool:
            motion = sp.pulse("rectangular", a * G, duration=length, dt=1e-4)
            return simulate(block(0.2, 0.8), STICKING, motion).overturned

        found = threshold(overturns, 0.26, 1.5)
        case = "3. Rectangular pulse, b = 0.2, h = 0.8"
        yield Row(case, f"overturns from, {length} s [g]", SOLVED, known, found, 3e-3)


def half_sine() -> Iterator[Row]:
    """One half sine, then a still floor."""
    radius, alpha = slenderness(0.2, 0.8)
    p = math.sqrt(0.75 * G / radius)
    for ratio, known in ((3.0, 2.2973), (5.0, 3.2989), (8.0, 4.8073)):

        def overturns(a: float, ratio=ratio) -> bool:
            motion = sp.pulse("half-sine", a * G * math.tan(alpha), duration=math.pi / (ratio * p), dt=5e-4)
            return simulate(block(0.2, 0.8), STICKING, motion).overturned

        found = threshold(overturns, 1.05, 8.0)
        case = "4. Half-sine pulse, b = 0.2, h = 0.8"
        yield Row(case, f"overturns from, ω/p = {ratio:g} [g tan α]", SOLVED, known, found, 3e-3)


def full_sine() -> Iterator[Row]:
    """One full sine of 0.5 s: overturning with and without an impact, and a safe gap between."""

    def overturns(a: float) -> bool:
        motion = sp.sine(a * G, 2.0, 0.5, dt=1e-3, quiet=12.0)
        return simulate(sp.Body(0.4, 1.8), STICKING, motion).overturned

    edges = (("overturns from [g]", 0.45479, 0.40, 0.60), ("safe again from [g]", 1.29455, 1.2, 1.33))
    for name, known, low, high in (*edges, ("overturns again from [g]", 1.36757, 1.33, 1.5)):
        case = "5. One full sine of 0.5 s, 0.4 m × 1.8 m (full sizes)"
        yield Row(case, name, SOLVED, known, threshold(overturns, low, high), 2e-2)


def time_history() -> Iterator[Row]:
    """One sine of 0.4 g and 0.5 s, from rest."""
    case, (_, alpha) = "6. One sine of 0.4 g and 0.5 s, b = 0.225, h = 0.9", slenderness(0.225, 0.9)
    run = simulate(block(0.225, 0.9), STICKING, sp.sine(0.4 * G, 2.0, 0.5, dt=1e-3, quiet=3.0))
    uplift = next(event.time for event in run.events if event.kind is sp.EventKind.UPLIFT)
    times = impacts(run)
    yield Row(case, "uplift [s]", f"{CLOSED}: asin(tan α/0.4)/ω", 0.053725, uplift, 5e-3)
    yield Row(case, "impact 1 [s]", SOLVED, 0.363999, times[0], 5e-3)
    yield Row(case, "impact 2 [s]", SOLVED, 1.19991, times[1], 5e-3)
    yield Row(case, "largest \\|θ\\|/α", SOLVED, 0.41983, run.peak_tilt / alpha, 1e-2)


def starting_mode() -> Iterator[Row]:
    """Which mode a step of acceleration starts, and with which accelerations."""
    dt = 1e-5
    cases = (
        (0.4, 0.2, 0.0, 1.962),
        (0.4, 0.26, 0.3487, 1.0763),
        (0.4, 0.28, 1.0612, 0.2688),
        (0.4, 0.6, 1.2984, 0.0),
        (0.6, 0.3, 1.7945, 1.3997),
    )
    for a, mu, turning, slipping in cases:
        run = simulate(block(0.2, 0.8), room(mu), steady(a * G, 10 * dt, dt))
        case = f"7. Step of {a} g, μ = {mu}, b = 0.2, h = 0.8: {run.mode[1]}"
        if turning:
            yield Row(case, "\\|θ̈\\| [rad/s²]", CLOSED, turning, abs(run.tilt_rate[1]) / dt, 1e-2)
        if slipping:
            yield Row(case, "slip acceleration [m/s²]", CLOSED, slipping, abs(run.slide_rate[1]) / dt, 1e-2)
    gamma, a = 4.0, 0.4

    def slips(mu: float) -> bool:
        return str(simulate(block(0.2, 0.8), room(mu), steady(a * G, 10 * dt, dt)).mode[1]) == "slide-rock"

    known = ((4.0 + gamma**2) * a + 3.0 * gamma) / (1.0 + 4.0 * gamma**2 + 3.0 * gamma * a)
    found = threshold(slips, 0.26, 0.5)
    yield Row("7. Step of 0.4 g, b = 0.2, h = 0.8", "rock from μ =", CLOSED, known, found, 1e-2)


def slide_rock() -> Iterator[Row]:
    """A sustained step under which the block rocks on a slipping fulcrum."""
    case = "8. Slide-rock under a sustained 0.6 g, μ = 0.3, b = 0.2, h = 0.8"
    run = simulate(block(0.2, 0.8), room(0.3), steady(0.6 * G, 0.3, 0.01))
    known = ((10, 0.009270, 6.745), (20, 0.040824, 23.794), (30, 0.107112, 40.724))
    for sample, tilt, slip in known:
        when = f"at {run.time[sample]:.1f} s"
        yield Row(case, f"\\|θ\\| {when} [rad]", SOLVED, tilt, abs(run.tilt[sample]), 5e-3)
        yield Row(case, f"slip of the fulcrum {when} [mm]", SOLVED, slip, 1e3 * abs(run.slide[sample]), 5e-3)


def sliding() -> Iterator[Row]:
    """A block too squat to rock."""
    squat, case = sp.Body(2.0, 0.4), "9. Sliding only"
    run = simulate(squat, room(0.3), sp.pulse("rectangular", 0.6 * G, duration=0.3, quiet=2.0, dt=1e-4))
    known = 0.6 * (0.6 - 0.3) * G * 0.3**2 / (2.0 * 0.3)
    source = f"{CLOSED}: A(A−μ)g t²/(2μ)"
    yield Row(case, "slip after 0.6 g for 0.3 s, μ = 0.3 [m]", source, known, abs(run.residual_slide), 1e-3)
    run = simulate(squat, room(0.2), sp.sine(0.5 * G, 1.0, 60.0, dt=1e-3))
    last = run.slide[run.time > 55.0]
    omega = 2.0 * math.pi
    known = 2.0 * 0.5 * G / omega**2 * math.sqrt(1.0 - (math.pi * 0.2 / (2.0 * 0.5)) ** 2)
    source = f"{CLOSED}: (2Ag/ω²)√(1−(πμ/2A)²)"
    found = float(last.max() - last.min())
    yield Row(case, "steady range, 0.5 g at 1 Hz, μ = 0.2 [m]", source, known, found, 1e-3)


def landing() -> Iterator[Row]:
    """The loss of a landing depends on whether the floor holds the landing corner."""
    gamma = 4.0
    for mu in (0.5, 0.1, 0.0):
        run = simulate(block(0.2, 0.8), room(mu), still(0.01), tilt=1e-9, tilt_rate=-1.0)
        after = next(event.tilt_rate for event in run.events if event.kind is sp.EventKind.FLOOR_IMPACT)
        holds = mu >= 3.0 * gamma / (1.0 + 4.0 * gamma**2)
        friction = 3.0 * mu * gamma
        known = 1.0 - 1.5 / (1.0 + gamma**2)
        if not holds:
            known = (gamma**2 - 2.0 + friction) / (gamma**2 + 4.0 - friction)
        source = f"{CLOSED}: " + ("Housner 1963" if holds else "(γ²−2+3μγ)/(γ²+4−3μγ)")
        yield Row("10. Landing, h/b = 4", f"ratio of rates, μ = {mu}", source, known, abs(after), 1e-4)


def frictionless() -> Iterator[Row]:
    """Release at α/2 on ice: G falls straight down."""
    case, (_, alpha) = "11. Release from α/2 without friction, b = 0.2, h = 0.8", slenderness(0.2, 0.8)
    dt = 1e-5
    run = simulate(block(0.2, 0.8), room(0.0), still(0.25, dt), tilt=alpha / 2)
    when = impacts(run)[0]
    sample = math.floor(when / dt)
    pace = (run.tilt_rate[sample] - run.tilt_rate[sample - 1]) / dt
    rate = abs(run.tilt_rate[sample] + pace * (when - run.time[sample]))
    yield Row(case, "landing [s]", SOLVED, 0.229554, when, 1e-3)
    yield Row(case, "\\|θ̇\\| just before [rad/s]", f"{SOLVED}, balance of energy", 1.164870, rate, 1e-3)


CASES: tuple[Callable[[], Iterator[Row]], ...] = (
    free_rocking,
    sudden_velocity,
    rectangular_pulse,
    half_sine,
    full_sine,
    time_history,
    starting_mode,
    slide_rock,
    sliding,
    landing,
    frictionless,
)


def all_rows() -> list[Row]:
    """Run every case."""
    return [row for case in CASES for row in case()]
