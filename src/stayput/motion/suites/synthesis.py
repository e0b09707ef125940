"""From drawn parameters to a three-component motion.

Noise under an envelope gets the Fourier amplitude of source, path and site (Boore 2003). A near-fault
motion has a velocity pulse too, a basin's has late surface waves.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.motion.record import Motion
from stayput.motion.suites.draws import Draws
from stayput.motion.suites.envelopes import ends_tapered, saragoni_hart
from stayput.motion.suites.families import FAMILIES, drawn, kind_of
from stayput.motion.suites.settling import fft_length, settled
from stayput.motion.suites.site import crust
from stayput.motion.suites.timing import DT, envelope, s_arrival, steps
from stayput.motion.synthetic import mavroeidis_papageorgiou

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.suites.families import BasinWaves, Family, Parameters, Pulse

TAPER = 1.5
"""Over which a motion fades in and out [s]."""

ROUGHNESS = 0.40
"""Standard deviation of ln A(f) about the smooth model, in waves as wide as an octave (low confidence)."""

SHARED = 0.7
"""Share of that variance which all components have in common (low confidence)."""

_OCTAVES = np.log(0.02) + math.log(2.0) * np.arange(12)


@dataclass(frozen=True, slots=True)
class _Component:
    """How a component differs: P waves over S waves, κ, velocity in the soil, strength, pulse, basin waves.

    The vertical one has stronger P waves, less damping and faster waves, so that its peaks lie at shorter
    periods (default, low confidence).
    """

    p_waves: float
    kappa: float
    faster: float
    strength: float
    crust_power: float
    pulse: tuple[float, float]
    waves: float


COMPONENTS = {
    "x": _Component(0.15, 1.0, 1.0, 1.0, 1.0, (1.0, 1.0), 1.0),
    "y": _Component(0.15, 1.0, 1.0, 1.0, 1.0, (0.2, 0.5), 1.0),
    "z": _Component(0.60, 0.6, 3.0, 0.75, 0.6, (0.1, 0.25), 0.5),
}


def _rough(f: NDArray[np.float64], common: NDArray[np.float64], draw: Draws) -> NDArray[np.float64]:
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


def _of_component(
    kind: Family, parts: Parameters, like: _Component, n: int, common: NDArray[np.float64], draw: Draws
) -> NDArray[np.float64]:
    """Return the acceleration of one component [m/s²], shape (n,)."""
    t = DT * np.arange(n, dtype=np.float64)
    n_fft = fft_length(n + round(4.0 / (kind.low_cut * DT)))
    f = np.fft.rfftfreq(n_fft, DT).astype(np.float64)
    amplitude = like.strength * parts.source.amplitude(f, like.kappa) * crust(f) ** like.crust_power
    amplitude *= parts.soil.amplification(f, like.faster) * _rough(f, common, draw)
    velocity_pulse = np.zeros(n)
    if parts.pulse is not None:
        velocity_pulse = _pulse(t, parts.pulse, like, s_arrival(parts), draw)
        covered = DT * np.abs(np.fft.rfft(velocity_pulse, n_fft))
        amplitude = np.maximum(amplitude - covered, 0.0)  # Mavroeidis and Papageorgiou (2003)
    noise = draw.noise(n) * envelope(t, parts, like.p_waves)
    transform = _shaped(noise, amplitude, n_fft)
    if parts.waves is not None:
        body = like.waves * float(np.interp(1.0 / parts.waves.period, f, amplitude))
        transform += _late_waves(t, f, n_fft, parts.waves, s_arrival(parts), body, draw)
    a = np.fft.irfft(transform * _low_cut(f, kind.low_cut), n_fft)[:n] / DT
    return settled(a * ends_tapered(t, TAPER) + velocity_pulse)


def _pulse(
    t: NDArray[np.float64], pulse: Pulse, like: _Component, arrival: float, draw: Draws
) -> NDArray[np.float64]:
    """Return the pulse's acceleration in a component [m/s²]: it begins with the S waves."""
    velocity = pulse.velocity * draw.uniform(*like.pulse)
    nu = pulse.nu if like.pulse == COMPONENTS["x"].pulse else draw.uniform(0.0, 2.0 * math.pi)
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
    kind = kind_of(family)
    key = (whole("Seed", seed, 0, 2**32 - 1), FAMILIES.index(family), whole("Number", number, 1, 1_000_000))
    parts = drawn(kind, Draws(*key))
    n = steps(kind, parts) + 1
    common = Draws(*key, 1).noise(len(_OCTAVES))
    found = {
        name: _of_component(kind, parts, like, n, common, Draws(*key, 2 + place))
        for place, (name, like) in enumerate(COMPONENTS.items())
    }
    source = f"synthetic, not a recorded earthquake: {parts}; seed {seed}; residual displacement 0"
    return Motion(DT, **found, name=f"synthetic {kind.label} {number}", synthetic=True, source=source)


def whole(name: str, value: int, low: int, high: int) -> int:
    """Return a whole number, or raise `InputError` when it is none or not from low to high."""
    try:
        number = int(value)
    except (TypeError, ValueError, OverflowError):
        number = low - 1
    if number != value or not low <= number <= high:
        raise InputError(f"{name} is {value!r}; it must be a whole number from {low} to {high}.")
    return number
