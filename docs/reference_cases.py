"""The reference cases of the validation page: known numbers, and what stayput computes for them.

Each function is one case and yields its rows; its docstring is the page's text. b and h are half sizes
here, as in the literature on rocking blocks; g = 9.81 m/s². Nothing is fitted; a reference is a closed
form or a separate solution of the nonlinear equations, and `Row.source` says which.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from reference_setup import (
    CLOSED,
    SOLVED,
    STICKING,
    G,
    Row,
    block,
    impacts,
    room,
    simulate,
    slenderness,
    steady,
    still,
    threshold,
)

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


def free_rocking() -> Iterator[Row]:
    """Free rocking.

    Released at α/2 on a sticking fulcrum, with Housner's loss at each impact (Housner 1963). In the slender
    limit the equation is linear and the quarter period is acosh(1/(1 − θ₀/α))/p, p² = 3g/4R.
    """
    case, b, h = "b = 0.2 m, h = 0.8 m", 0.2, 0.8
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
    yield Row(case, "quarter period, slender limit [s]", CLOSED, known, first, 1e-3)


def sudden_velocity() -> Iterator[Row]:
    """A sudden velocity of the floor.

    It gives the block the rate 3V cos α/(4R); the balance of energy makes it overturn from
    V = √(8gR(1 − cos α)/(3 cos² α)).
    """
    for b, h in ((0.2, 0.8), (0.1, 0.9)):
        radius, alpha = slenderness(b, h)
        known = math.sqrt(8.0 * G * radius * (1.0 - math.cos(alpha)) / (3.0 * math.cos(alpha) ** 2))
        body, floor, factor = block(b, h), still(20.0, 0.01), 0.75 * math.cos(alpha) / radius

        def overturns(v: float, body=body, floor=floor, factor=factor) -> bool:
            return simulate(body, STICKING, floor, tilt_rate=factor * v).overturned

        found = threshold(overturns, 0.5 * known, 2.0 * known)
        case = f"b = {b} m, h = {h} m"
        yield Row(case, "least V [m/s]", CLOSED, known, found, 2e-3)


def rectangular_pulse() -> Iterator[Row]:
    """A rectangular pulse.

    One pulse, then a still floor (Housner 1963).
    """
    for length, known in ((0.1, 0.97221), (0.2, 0.55697), (0.5, 0.32219)):

        def overturns(a: float, length=length) -> bool:
            motion = sp.pulse("rectangular", a * G, duration=length, dt=1e-4)
            return simulate(block(0.2, 0.8), STICKING, motion).overturned

        found = threshold(overturns, 0.26, 1.5)
        case = "b = 0.2 m, h = 0.8 m"
        yield Row(case, f"overturns from, {length} s [g]", SOLVED, known, found, 3e-3)


def half_sine() -> Iterator[Row]:
    """A half-sine pulse.

    One half wave, then a still floor (Makris and Roussos 2000); p² = 3g/4R.
    """
    radius, alpha = slenderness(0.2, 0.8)
    p = math.sqrt(0.75 * G / radius)
    for ratio, known in ((3.0, 2.2973), (5.0, 3.2989), (8.0, 4.8073)):

        def overturns(a: float, ratio=ratio) -> bool:
            motion = sp.pulse("half-sine", a * G * math.tan(alpha), duration=math.pi / (ratio * p), dt=5e-4)
            return simulate(block(0.2, 0.8), STICKING, motion).overturned

        found = threshold(overturns, 1.05, 8.0)
        case = "b = 0.2 m, h = 0.8 m"
        yield Row(case, f"overturns from, ω/p = {ratio:g} [g tan α]", SOLVED, known, found, 3e-3)


def full_sine() -> Iterator[Row]:
    """One full sine of 0.5 s.

    The block overturns with one impact, stands under a somewhat stronger wave, and overturns without an
    impact under a stronger one still (Zhang and Makris 2001).
    """

    def overturns(a: float) -> bool:
        motion = sp.sine(a * G, 2.0, 0.5, dt=1e-3, quiet=12.0)
        return simulate(sp.Body(0.4, 1.8, 100.0), STICKING, motion).overturned

    edges = (("overturns from [g]", 0.45479, 0.40, 0.60), ("safe again from [g]", 1.29455, 1.2, 1.33))
    for name, known, low, high in (*edges, ("overturns again from [g]", 1.36757, 1.33, 1.5)):
        case = "b = 0.2 m, h = 0.9 m"
        yield Row(case, name, SOLVED, known, threshold(overturns, low, high), 2e-2)


def time_history() -> Iterator[Row]:
    """A time history.

    One sine of 0.4 g and 0.5 s, from rest; uplift is at asin(tan α/0.4)/ω.
    """
    case, (_, alpha) = "b = 0.225 m, h = 0.9 m", slenderness(0.225, 0.9)
    run = simulate(block(0.225, 0.9), STICKING, sp.sine(0.4 * G, 2.0, 0.5, dt=1e-3, quiet=3.0))
    uplift = next(event.time for event in run.events if event.kind is sp.EventKind.UPLIFT)
    times = impacts(run)
    yield Row(case, "uplift [s]", CLOSED, 0.053725, uplift, 5e-3)
    yield Row(case, "impact 1 [s]", SOLVED, 0.363999, times[0], 5e-3)
    yield Row(case, "impact 2 [s]", SOLVED, 1.19991, times[1], 5e-3)
    yield Row(case, "largest \\|θ\\|/α", SOLVED, 0.41983, run.peak_tilt / alpha, 1e-2)


def starting_mode() -> Iterator[Row]:
    """The starting mode.

    Which mode a step of the floor's acceleration starts, and with which accelerations; a block rocks
    without slipping from μ = [(4 + γ²)A + 3γ]/[1 + 4γ² + 3γA], γ = h/b, A in g (Shenton 1996).
    Here b = 0.2 m, h = 0.8 m.
    """
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
        case = f"{a} g, μ = {mu}: {run.mode[1]}"
        if turning:
            yield Row(case, "\\|θ̈\\| [rad/s²]", CLOSED, turning, abs(run.rotation_rate[0, 1, 1]) / dt, 1e-2)
        if slipping:
            yield Row(case, "slip [m/s²]", CLOSED, slipping, abs(run.slide_rate[1]) / dt, 1e-2)
    gamma, a = 4.0, 0.4

    def slips(mu: float) -> bool:
        return str(simulate(block(0.2, 0.8), room(mu), steady(a * G, 10 * dt, dt)).mode[1]) == "slide-rock"

    known = ((4.0 + gamma**2) * a + 3.0 * gamma) / (1.0 + 4.0 * gamma**2 + 3.0 * gamma * a)
    found = threshold(slips, 0.26, 0.5)
    yield Row("0.4 g", "rock from μ =", CLOSED, known, found, 1e-2)


def slide_rock() -> Iterator[Row]:
    """Slide-rock.

    The block rocks on a slipping fulcrum under a sustained step.
    """
    case = "0.6 g, μ = 0.3, b = 0.2 m, h = 0.8 m"
    run = simulate(block(0.2, 0.8), room(0.3), steady(0.6 * G, 0.3, 0.01))
    known = ((10, 0.009270, 6.745), (20, 0.040824, 23.794), (30, 0.107112, 40.724))
    for sample, tilt, slip in known:
        when = f"at {run.time[sample]:.1f} s"
        yield Row(case, f"\\|θ\\| {when} [rad]", SOLVED, tilt, abs(run.tilt[sample]), 5e-3)
        yield Row(case, f"slip of the fulcrum {when} [mm]", SOLVED, slip, 1e3 * abs(run.slide[sample]), 5e-3)


def sliding() -> Iterator[Row]:
    """Sliding only.

    A block too squat to rock slides A(A − μ)gt²/(2μ) after a rectangular pulse (Newmark 1965), and to and fro
    by (2Ag/ω²)√(1 − (πμ/2A)²) in a steady sine (Westermo and Udwadia 1983).
    """
    squat, case = sp.Body(2.0, 0.4, 100.0), "2 m × 0.4 m"
    run = simulate(squat, room(0.3), sp.pulse("rectangular", 0.6 * G, duration=0.3, quiet=2.0, dt=1e-4))
    known = 0.6 * (0.6 - 0.3) * G * 0.3**2 / (2.0 * 0.3)
    yield Row(case, "slip after 0.6 g for 0.3 s, μ = 0.3 [m]", CLOSED, known, abs(run.residual_slide), 1e-3)
    run = simulate(squat, room(0.2), sp.sine(0.5 * G, 1.0, 60.0, dt=1e-3))
    last = run.slide[run.time > 55.0]
    omega = 2.0 * math.pi
    known = 2.0 * 0.5 * G / omega**2 * math.sqrt(1.0 - (math.pi * 0.2 / (2.0 * 0.5)) ** 2)
    found = float(last.max() - last.min())
    yield Row(case, "steady range, 0.5 g at 1 Hz, μ = 0.2 [m]", CLOSED, known, found, 1e-3)


def landing() -> Iterator[Row]:
    """Landing with friction.

    Where the floor holds the landing corner the rates' ratio is Housner's, 1 − 3/(2(1 + γ²)); below
    μ = 3γ/(1 + 4γ²) the corner slips and it is (γ² − 2 + 3μγ)/(γ² + 4 − 3μγ).
    """
    gamma = 4.0
    for mu in (0.5, 0.1, 0.0):
        run = simulate(block(0.2, 0.8), room(mu), still(0.01), tilt=1e-9, tilt_rate=-1.0)
        after = next(event.tilt_rate for event in run.events if event.kind is sp.EventKind.FLOOR_IMPACT)
        holds = mu >= 3.0 * gamma / (1.0 + 4.0 * gamma**2)
        friction = 3.0 * mu * gamma
        known = 1.0 - 1.5 / (1.0 + gamma**2)
        if not holds:
            known = (gamma**2 - 2.0 + friction) / (gamma**2 + 4.0 - friction)
        yield Row("h/b = 4", f"ratio of rates, μ = {mu}", CLOSED, known, abs(after), 1e-4)


def frictionless() -> Iterator[Row]:
    """Release without friction.

    From α/2 on ice, the centre of gravity falls straight down; the rate follows from the balance of energy.
    """
    case, (_, alpha) = "b = 0.2 m, h = 0.8 m", slenderness(0.2, 0.8)
    dt = 1e-5
    run = simulate(block(0.2, 0.8), room(0.0), still(0.25, dt), tilt=alpha / 2)
    when = impacts(run)[0]
    sample = math.floor(when / dt)
    pace = (run.rotation_rate[0, sample, 1] - run.rotation_rate[0, sample - 1, 1]) / dt
    rate = abs(run.rotation_rate[0, sample, 1] + pace * (when - run.time[sample]))
    yield Row(case, "landing [s]", SOLVED, 0.229554, when, 1e-3)
    yield Row(case, "\\|θ̇\\| just before [rad/s]", CLOSED, 1.164870, rate, 1e-3)


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
