"""From drawn parameters to a three-component motion.

Noise under an envelope gets the Fourier amplitude of source, path and site (Boore 2003). A near-fault
motion has a velocity pulse too, a basin's has late surface waves.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.motion.processing import ending_at_rest, fft_length, whole
from stayput.motion.record import Motion
from stayput.motion.suites.envelopes import (
    DT,
    cosine_taper,
    envelope,
    s_arrival,
    saragoni_hart,
    step_count,
)
from stayput.motion.suites.families import FAMILIES, Draws, draw_parameters, family_named
from stayput.motion.suites.point_source import crust_amplification
from stayput.motion.synthetic import mavroeidis_papageorgiou

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.suites.families import BasinWaves, Family, Parameters, Pulse

SEED_RANGE = (0, 2**32 - 1)
"""Smallest and largest seed that is accepted."""

TAPER = 1.5
"""Over which a motion fades in and out [s]."""

ROUGHNESS = 0.40
"""Standard deviation of ln A(f) about the smooth model, in waves as wide as an octave (low confidence)."""

SHARED = 0.7
"""Share of that variance which all components have in common (low confidence)."""

_OCTAVES = np.log(0.02) + math.log(2.0) * np.arange(12)


@dataclass(frozen=True, slots=True)
class _Component:
    """How a component differs from a horizontal one without a pulse.

    The vertical one has stronger P waves, less damping and faster waves, so that its peaks lie at shorter
    periods (default, low confidence).

    Parameters
    ----------
    p_waves : float
        Strength of the P waves over the S waves'.
    kappa : float
        Factor on the site damping κ.
    velocity : float
        Velocity of its waves in the soil over that of shear waves.
    strength : float
        Factor on the Fourier amplitude.
    crust_power : float
        Power of the crust's amplification.
    pulse : (float, float)
        Range of the factor on the velocity pulse.
    basin_waves : float
        Factor on the basin's surface waves.
    """

    p_waves: float
    kappa: float
    velocity: float
    strength: float
    crust_power: float
    pulse: tuple[float, float]
    basin_waves: float


COMPONENTS = {
    "x": _Component(0.15, 1.0, 1.0, 1.0, 1.0, (1.0, 1.0), 1.0),
    "y": _Component(0.15, 1.0, 1.0, 1.0, 1.0, (0.2, 0.5), 1.0),
    "z": _Component(0.60, 0.6, 3.0, 0.75, 0.6, (0.1, 0.25), 0.5),
}


def _random_factor(f: NDArray[np.float64], common: NDArray[np.float64], draw: Draws) -> NDArray[np.float64]:
    """Return a random smooth factor on each frequency, partly common to all components."""
    own = draw.noise(len(_OCTAVES))
    knots = ROUGHNESS * (math.sqrt(SHARED) * common + math.sqrt(1.0 - SHARED) * own)
    return np.exp(np.interp(np.log(np.maximum(f, 1e-4)), _OCTAVES, knots))


def _low_cut(f: NDArray[np.float64], corner: float) -> NDArray[np.float64]:
    """Return 1/[1 + (corner/f)⁴]: displacement fades out as f²."""
    u = (f / corner) ** 4
    return u / (1.0 + u)


def _shaped(noise: NDArray[np.float64], amplitude: NDArray[np.float64], n_fft: int) -> NDArray[np.complex128]:
    """Return the transform of noise whose mean square is made 1, times an amplitude."""
    transform = np.fft.rfft(noise, n_fft)
    return transform * (amplitude / math.sqrt(float(np.mean(np.abs(transform) ** 2))))


def _late_waves(
    t: NDArray[np.float64],
    f: NDArray[np.float64],
    n_fft: int,
    waves: BasinWaves,
    arrival: float,
    body: float,
    draw: Draws,
) -> NDArray[np.complex128]:
    """Return the transform of a narrow band about the basin's period, the longer waves first.

    The group delay is ``dispersion`` · log₂(f T) later than the start; its phase is −2π∫ delay df.
    """
    octaves = np.log2(np.maximum(f, 1e-4) * waves.period)
    band = np.exp(-0.5 * (octaves / 0.35) ** 2)
    noise = draw.noise(len(t)) * saragoni_hart(t, arrival + waves.delay, waves.length)
    phase = -2.0 * math.pi * waves.dispersion * f * (octaves - 1.0 / math.log(2.0))
    return _shaped(noise, waves.strength * body * band, n_fft) * np.exp(1j * phase)


def _acceleration(
    family: Family,
    params: Parameters,
    component: _Component,
    n: int,
    common: NDArray[np.float64],
    draw: Draws,
) -> NDArray[np.float64]:
    """Return the acceleration of one component [m/s²], shape (n,)."""
    t = DT * np.arange(n, dtype=np.float64)
    # Four periods of the low cut of zeros at the end, so that its tail does not wrap around to the start.
    n_fft = fft_length(n + round(4.0 / (family.low_cut * DT)))
    f = np.fft.rfftfreq(n_fft, DT).astype(np.float64)
    crust = crust_amplification(f) ** component.crust_power
    amplitude = component.strength * params.source.amplitude(f, component.kappa) * crust
    amplitude *= params.soil.amplification(f, component.velocity) * _random_factor(f, common, draw)
    velocity_pulse = np.zeros(n)
    if params.pulse is not None:
        velocity_pulse = _pulse(t, params.pulse, component, s_arrival(params), draw)
        covered = DT * np.abs(np.fft.rfft(velocity_pulse, n_fft))
        # The pulse is a part of the spectrum, noise the rest (Mavroeidis and Papageorgiou 2003).
        amplitude = np.maximum(amplitude - covered, 0.0)
    noise = draw.noise(n) * envelope(t, params, component.p_waves)
    transform = _shaped(noise, amplitude, n_fft)
    if params.waves is not None:
        body = component.basin_waves * float(np.interp(1.0 / params.waves.period, f, amplitude))
        transform += _late_waves(t, f, n_fft, params.waves, s_arrival(params), body, draw)
    a = np.fft.irfft(transform * _low_cut(f, family.low_cut), n_fft)[:n] / DT
    return ending_at_rest(a * cosine_taper(t, TAPER) + velocity_pulse)


def _pulse(
    t: NDArray[np.float64], pulse: Pulse, component: _Component, arrival: float, draw: Draws
) -> NDArray[np.float64]:
    """Return the pulse's acceleration in a component [m/s²]: it begins with the S waves."""
    velocity = pulse.velocity * draw.uniform(*component.pulse)
    # x has the pulse's own phase; across it and vertically the phase is independent.
    nu = pulse.nu if component.pulse == COMPONENTS["x"].pulse else draw.uniform(0.0, 2.0 * math.pi)
    middle = arrival + 0.5 * pulse.gamma * pulse.period + draw.uniform(0.0, 1.0)
    return velocity * mavroeidis_papageorgiou(t - middle, 1.0 / pulse.period, pulse.gamma, nu)


def synthetic_motion(family: str, number: int = 1, seed: int = 1) -> Motion:
    """Make one synthetic motion of three components: no recorded earthquake, no code's design motion.

    Amplitudes are those of the drawn magnitude and distance; velocity and displacement end at zero, so
    the residual displacement is zero. The same family, number and seed give the same bits.

    Parameters
    ----------
    family : str
        One of `FAMILIES`: "near-fault", "crustal", "subduction", "basin".
    number : int
        Its number in the family, 1 to 1,000,000.
    seed : int
        0 to 2³² − 1.

    Returns
    -------
    Motion
        x, y and z at 0.01 s, in whole 1e-6 m/s²; ``source`` states what was drawn.

    Raises
    ------
    InputError
        No such family; a number or a seed out of range.
    """
    chosen = family_named(family)
    key = (whole("seed", seed, *SEED_RANGE), FAMILIES.index(family), whole("number", number, 1, 1_000_000))
    params = draw_parameters(chosen, Draws(*key))
    n = step_count(chosen, params) + 1
    common = Draws(*key, 1).noise(len(_OCTAVES))
    samples: dict[str, Any] = {
        name: _acceleration(chosen, params, component, n, common, Draws(*key, 2 + place))
        for place, (name, component) in enumerate(COMPONENTS.items())
    }
    source = f"synthetic, not a recorded earthquake: {params}; seed {seed}; residual displacement 0"
    name = f"synthetic {chosen.label} {number}"
    return Motion(DT, **samples, name=name, synthetic=True, source=source)
