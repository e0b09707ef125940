"""Synthetic motions and suites, which stand in where the user has no records.

Noise under an envelope gets the Fourier amplitude of source, path and site (Boore 2003). A near-fault
motion has a velocity pulse too, a basin's has late surface waves. Suites keep their motions in a cache.
"""

from __future__ import annotations

import math
import threading
from dataclasses import dataclass
from typing import Any

import numpy as np
from cachetools import LRUCache, cached
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import instance_of, whole_within, word_of
from stayput.model.parameters import arguments, quantity
from stayput.motion.processing import ending_at_rest, fft_length
from stayput.motion.record import Motion
from stayput.motion.suites import families as familie
from stayput.motion.suites.suite import Suite
from stayput.motion.suites.target import DEFAULT_BAND, TargetSpectrum
from stayput.motion.synthetic import mavroeidis_papageorgiou

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


def _random_factor(
    f: NDArray[np.float64], common: NDArray[np.float64], draw: familie.Draws
) -> NDArray[np.float64]:
    """Return a random smooth factor on each frequency, partly common to all components."""
    alone = draw.noise(len(_OCTAVES))
    knots = ROUGHNESS * (math.sqrt(SHARED) * common + math.sqrt(1.0 - SHARED) * alone)
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
    waves: familie.BasinWaves,
    arrival: float,
    body: float,
    draw: familie.Draws,
) -> NDArray[np.complex128]:
    """Return the transform of a narrow band about the basin's period, the longer waves first.

    The group delay is ``dispersion`` · log₂(f T) later than the start; its phase is −2π∫ delay df.
    """
    octaves = np.log2(np.maximum(f, 1e-4) * waves.period)
    band = np.exp(-0.5 * (octaves / 0.35) ** 2)
    noise = draw.noise(len(t)) * familie.saragoni_hart(t, arrival + waves.delay, waves.length)
    phase = -2.0 * math.pi * waves.dispersion * f * (octaves - 1.0 / math.log(2.0))
    return _shaped(noise, waves.strength * body * band, n_fft) * np.exp(1j * phase)


def _acceleration(
    family: familie.Family,
    params: familie.Parameters,
    component: _Component,
    n: int,
    common: NDArray[np.float64],
    draw: familie.Draws,
) -> NDArray[np.float64]:
    """Return the acceleration of one component [m/s²], shape (n,)."""
    t = familie.DT * np.arange(n, dtype=np.float64)
    # Four periods of the low cut of zeros at the end, so that its tail does not wrap around to the start.
    n_fft = fft_length(n + round(4.0 / (family.low_cut * familie.DT)))
    f = np.fft.rfftfreq(n_fft, familie.DT).astype(np.float64)
    crust = familie.crust_amplification(f) ** component.crust_power
    amplitude = component.strength * params.source.amplitude(f, component.kappa) * crust
    amplitude *= params.soil.amplification(f, component.velocity) * _random_factor(f, common, draw)
    velocity_pulse = np.zeros(n)
    if params.pulse is not None:
        velocity_pulse = _pulse(t, params.pulse, component, familie.s_arrival(params), draw)
        covered = familie.DT * np.abs(np.fft.rfft(velocity_pulse, n_fft))
        # The pulse is a part of the spectrum, noise the rest (Mavroeidis and Papageorgiou 2003).
        amplitude = np.maximum(amplitude - covered, 0.0)
    noise = draw.noise(n) * familie.envelope(t, params, component.p_waves)
    transform = _shaped(noise, amplitude, n_fft)
    if params.waves is not None:
        body = component.basin_waves * float(np.interp(1.0 / params.waves.period, f, amplitude))
        transform += _late_waves(t, f, n_fft, params.waves, familie.s_arrival(params), body, draw)
    a = np.fft.irfft(transform * _low_cut(f, family.low_cut), n_fft)[:n] / familie.DT
    return ending_at_rest(a * familie.cosine_taper(t, TAPER) + velocity_pulse)


def _pulse(
    t: NDArray[np.float64], pulse: familie.Pulse, component: _Component, arrival: float, draw: familie.Draws
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
    chosen = familie.KINDS[word_of("motion.family", family, familie.FAMILIES, "family")]
    key = familie.Draws.key(seed, familie.FAMILIES.index(family), number)
    params = familie.draw_parameters(chosen, familie.Draws(*key))
    n = familie.step_count(chosen, params) + 1
    common = familie.Draws(*key, 1).noise(len(_OCTAVES))
    samples: dict[str, Any] = {
        name: _acceleration(chosen, params, component, n, common, familie.Draws(*key, 2 + place))
        for place, (name, component) in enumerate(COMPONENTS.items())
    }
    source = f"synthetic, not a recorded earthquake: {params}; seed {seed}; residual displacement 0"
    name = f"synthetic {chosen.label} {number}"
    return Motion(familie.DT, **samples, name=name, synthetic=True, source=source)


MIXED = "mixed"
"""Name of the suite of all families."""

COUNT_RANGE = (1, 1000)
"""Fewest and most motions of a suite."""

CACHE_SIZE = 128 * 1024 * 1024
"""Most bytes of samples in the cache: 40 mixed motions have 9 MB, 100 of the longest kind 60 MB."""


_CACHE: LRUCache[Any, Motion] = LRUCache(
    CACHE_SIZE, getsizeof=lambda motion: sum(samples.nbytes for samples in motion.components.values())
)

_cached_motion = cached(_CACHE, lock=threading.Lock())(synthetic_motion)
"""One cache for the process: a verification, its report and the next one ask for the same motions."""


def mixed_order(count: int) -> list[str]:
    """Return the families of the first ``count`` motions of a mixed suite.

    Each is the family that lags most behind its share, so that any first n motions have about the shares.
    """
    order: list[str] = []
    for place in range(1, count + 1):
        order.append(max(familie.MIX, key=lambda family: familie.MIX[family] * place - order.count(family)))
    return order


@arguments(
    count=quantity("", *COUNT_RANGE, phrase("motion.name_count")),
    seed=quantity("", *familie.SEED_RANGE, phrase("common.seed")),
)
def synthetic_suite(
    family: str = MIXED,
    count: int = 40,
    seed: int = 1,
    target: TargetSpectrum | None = None,
    band: tuple[float, float] = DEFAULT_BAND,
    *,
    together: bool = False,
) -> Suite:
    """Make a suite of synthetic motions of three components.

    Their amplitudes are those of the magnitudes and distances that are drawn (scale them with
    `Suite.to_intensity` or `Suite.to_spectrum`) or, with a target, the target's. The first n motions of
    a larger suite are the suite of n. Motions stay in a cache for the next call.

    Parameters
    ----------
    family : str
        "near-fault", "crustal", "subduction", "basin", or "mixed": all, in the shares of ``MIX``.
    count : int
        Number of motions, 1 to 1,000.
    seed : int
        The same seed gives the same motions; 0 to 2³² − 1.
    target : TargetSpectrum, optional
        Spectrum to be met; see `Suite.matched`.
    band : (float, float)
        Periods over which the target counts [s].
    together : bool
        Whether only the suite's geometric mean meets the target: each motion is scaled to it, then one
        filter serves all, and the variability of their shapes stays.

    Raises
    ------
    InputError
        No such family; a count or a seed out of range; a band outside the target.

    Examples
    --------
    >>> import stayput as sp
    >>> for motion in sp.synthetic_suite("mixed", count=4).to_intensity(6.0):
    ...     print(f"{motion.name}: {motion.pga:.1f} m/s², {100 * motion.pgv:.0f} cm/s")
    synthetic crustal 1: 7.7 m/s², 33 cm/s
    synthetic subduction 1: 7.4 m/s², 101 cm/s
    synthetic near-fault 1: 6.2 m/s², 76 cm/s
    synthetic long-period basin 1: 6.5 m/s², 73 cm/s
    """
    word_of("motion.family", family, (MIXED, *familie.FAMILIES), "family")
    if target is not None:
        instance_of("target", target, TargetSpectrum)
    n = whole_within("motion.name_count", count, *COUNT_RANGE, field="count")
    number = whole_within("common.seed", seed, *familie.SEED_RANGE, field="seed")
    families = mixed_order(n) if family == MIXED else [family] * n
    motions = (
        _cached_motion(member, families[:place].count(member), number)
        for place, member in enumerate(families, 1)
    )
    label = MIXED if family == MIXED else familie.KINDS[family].label
    suite = Suite(tuple(motions), f"synthetic {label} suite, seed {number}")
    if target is None:
        return suite
    start = suite.to_spectrum(target, band) if together else suite
    return start.matched(target, band, together=together)
