"""The built-in near-fault record, computed from a closed form and a fixed seed."""

from __future__ import annotations

import math
import random
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.motion.record import Motion
from stayput.motion.synthetic import mavroeidis_papageorgiou

if TYPE_CHECKING:
    from numpy.typing import NDArray

_DT = 0.01
_SAMPLES = 3001
_SEED = 19950117
_PULSE_TIME = 7.0
_QUANTUM = 1e-6  # m/s²: samples are whole multiples, so that no library's last bit shows
_PARTS = {  # velocity of the pulse [m/s], its ν, strength of the rest [m/s²], its corner frequency [Hz]
    "x": (0.95, 0.4, 1.7, 3.0),
    "y": (0.30, 2.0, 1.7, 3.0),
    "z": (0.15, 1.0, 1.3, 7.0),
}


def _rise(t: NDArray[np.float64], start: float, end: float) -> NDArray[np.float64]:
    """Return a smooth step from 0 at ``start`` to 1 at ``end``: τ³(10 − 15τ + 6τ²)."""
    tau = np.clip((t - start) / (end - start), 0.0, 1.0)
    return tau**3 * (10.0 - 15.0 * tau + 6.0 * tau**2)


def _envelope(t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the strength with time: a weak P phase from 2 s, the strong part to 11 s, a decay."""
    onset = 0.15 * _rise(t, 2.0, 4.0) + 0.85 * _rise(t, 5.0, 6.5)
    decay = np.exp(-0.28 * np.logaddexp(0.0, t - 11.0))
    return onset * decay * _rise(t[-1] - t, 0.0, 6.0)


def _band(t: NDArray[np.float64], corner: float, draw: random.Random) -> NDArray[np.float64]:
    """Return a random band, 0.3–20 Hz and strongest below ``corner``, of unit mean square in its strong part.

    The envelope shapes the displacement, so that velocity and displacement come back to zero.
    """
    f = np.arange(0.3, 20.0, 1.0 / t[-1])
    size = (f / 0.6) ** 2 / (1.0 + (f / 0.6) ** 2) / (1.0 + (f / corner) ** 2)
    phase = np.array([2.0 * math.pi * draw.random() for _ in f])
    w = 2.0 * math.pi * f
    waves = size / (w * w) @ np.cos(w[:, None] * t + phase[:, None])
    shaped = np.pad(_envelope(t) * waves, 1)
    return np.diff(shaped, 2) / _DT**2 / math.sqrt(0.5 * float(size @ size))


def _ending_at_rest(a: NDArray[np.float64], t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Take off two smooth bumps so that velocity and displacement end at zero, in whole quanta.

    `stayput.motion.processing.ending_at_rest` does so to the last quantum; this record keeps the bits
    that it always had.
    """
    window = np.sin(math.pi * t / t[-1]) ** 2
    bumps = np.stack((window, window * (t / t[-1] - 0.5)))
    moments = np.stack((np.ones_like(t), t))  # ∫a dt and ∫a t dt: both ends of the record are zero
    a = a - np.linalg.solve(moments @ bumps.T, moments @ a) @ bumps
    whole = np.rint(a / _QUANTUM)
    excess = int(whole.sum())
    first = (len(whole) - abs(excess)) // 2
    whole[first : first + abs(excess)] -= math.copysign(1.0, excess)
    return whole * _QUANTUM


@cache
def near_fault() -> Motion:
    """Make the built-in near-fault record: synthetic, three components, the same bits every time.

    A Mavroeidis–Papageorgiou velocity pulse of 0.9 s period, as large as the 1995 Kobe earthquake's, and
    a random band around it under an envelope. It shows what such shaking does; it is no
    recorded earthquake and no code's design motion.

    Returns
    -------
    Motion
        30 s at 0.01 s; velocity and displacement end at zero.

    Examples
    --------
    >>> import stayput as sp
    >>> motion = sp.near_fault()
    >>> for name, peaks in motion.peaks().items():
    ...     print(f"{name}: {peaks.pga:.1f} m/s², {100 * peaks.pgv:.0f} cm/s, {100 * peaks.pgd:.0f} cm")
    x: 7.3 m/s², 89 cm/s, 15 cm
    y: 5.5 m/s², 63 cm/s, 15 cm
    z: 3.8 m/s², 26 cm/s, 5 cm
    >>> round(motion.intensity, 1)  # JMA's
    6.3
    """
    t = _DT * np.arange(_SAMPLES, dtype=np.float64)
    draw = random.Random(_SEED)
    samples: dict[str, Any] = {}
    for name, (velocity, nu, strength, corner) in _PARTS.items():
        pulse = velocity * mavroeidis_papageorgiou(t - _PULSE_TIME, 1.0 / 0.9, 2.0, nu)
        samples[name] = _ending_at_rest(pulse + strength * _band(t, corner, draw), t)
    source = "Mavroeidis-Papageorgiou pulse and a random band, fixed seed; not a recorded earthquake"
    return Motion(_DT, **samples, name="synthetic near-fault motion", synthetic=True, source=source)
