"""ICC-ES AC156, shake-table testing of nonstructural components: the spectrum required, and a motion of it.

The ordinates are those of public code that tests by AC156, in the forms that go with ASCE 7-16 and 7-22; the
criteria's own text was not read, so neither its rules for enveloping the spectrum nor those for the table's
coherence are here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from stayput.errors import instance_of, within, word_of
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.record import Motion
from stayput.motion.suites.families import Draws
from stayput.motion.suites.target import TargetSpectrum, matched

EDITIONS = ("7-16", "7-22")
"""Editions of ASCE 7 whose floor amplification the spectrum has."""

FLEXIBLE_FROM, FLEXIBLE_TO, RIGID_FROM = 1.3, 8.3, 33.3
"""Frequencies at which the plateau begins and ends, and from which on a component is rigid [Hz]."""

RISE_FACTOR, RISE_POWER = 0.7902, 0.8977
"""The spectrum below the plateau: this part of A_flx times the frequency in hertz to this power."""

VERTICAL_FLEXIBLE, VERTICAL_RIGID = 0.67, 0.27
"""Vertical A_flx and A_rig over S_DS."""

DUCTILITY = 1.3
"""R_u of ASCE 7-22 above the ground; 1 at the ground."""

LOWEST_CUTOFF, HIGHEST_CUTOFF = 1.3, 3.5
"""Limits of the frequency from which on a test must meet the spectrum [Hz]."""

DAMPING = 0.05
"""Damping ratio of the spectrum."""

BUILD, HOLD, DECAY = 5.0, 20.0, 5.0
"""Parts of the motion's envelope [s]: 30 s of broadband noise."""

DT = 0.005
"""Time step of the motion [s]: six to a period at 33.3 Hz."""

_PERIODS = np.unique(
    np.concatenate((np.geomspace(0.02, 10.0, 271), 1.0 / np.array([FLEXIBLE_FROM, FLEXIBLE_TO, RIGID_FROM])))
)
_KEY = 156
"""First part of the key of the noise."""


@dataclass(frozen=True, slots=True)
class RequiredSpectrum:
    """The required response spectrum (RRS) of AC156 at a height in a building; made by `ac156`.

    Attributes
    ----------
    sds : float
        S_DS, the design acceleration at short periods [g].
    height_ratio : float
        z/h: 0 at the ground, 1 at the roof.
    edition : str
        Edition of ASCE 7.
    flexible, rigid : float
        Horizontal A_flx and A_rig [g].
    """

    sds: float
    height_ratio: float
    edition: str
    flexible: float
    rigid: float

    @property
    def horizontal(self) -> TargetSpectrum:
        """The horizontal spectrum, 0.02 to 10 s, 5 %."""
        return _target(self.flexible, self.rigid, f"{self.name}, horizontal")

    @property
    def vertical(self) -> TargetSpectrum:
        """The vertical spectrum, 0.67 and 0.27 S_DS at every height, 0.02 to 10 s, 5 %."""
        return _target(VERTICAL_FLEXIBLE * self.sds, VERTICAL_RIGID * self.sds, f"{self.name}, vertical")

    @property
    def name(self) -> str:
        """What it is called: "AC156 (ASCE 7-16), S_DS 1 g, z/h 0.5"."""
        return f"AC156 (ASCE {self.edition}), S_DS {self.sds:g} g, z/h {self.height_ratio:g}"


def _target(flexible: float, rigid: float, name: str) -> TargetSpectrum:
    f = 1.0 / _PERIODS
    rise = RISE_FACTOR * flexible * f**RISE_POWER
    fall = np.exp(np.interp(np.log(f), np.log([FLEXIBLE_TO, RIGID_FROM]), np.log([flexible, rigid])))
    sa = np.where(f < FLEXIBLE_FROM, np.minimum(rise, flexible), fall)
    return TargetSpectrum(_PERIODS, STANDARD_GRAVITY * sa, name, DAMPING)


def ac156(sds: float, height_ratio: float = 0.0, edition: str = "7-16") -> RequiredSpectrum:
    """Return the required response spectrum of AC156.

    A_flx = min(1.6 S_DS, S_DS (1 + 2 z/h)) and A_rig = 0.4 S_DS (1 + 2 z/h) with ASCE 7-16; with 7-22
    A_flx = min(1.6 S_DS, S_DS H_f/R_u) and A_rig = 0.4 S_DS H_f/R_u, H_f = 1 + 2.5 z/h, R_u = 1.3 above the
    ground and 1 at it. Ordinates: 0.7902 A_flx f^0.8977 to 1.3 Hz, A_flx to 8.3 Hz, a straight line in the
    logarithms to A_rig at 33.3 Hz.

    Parameters
    ----------
    sds : float
        S_DS [g].
    height_ratio : float
        z/h, 0 to 1.
    edition : str
        Edition of ASCE 7: "7-16" or "7-22".

    Raises
    ------
    InputError
        A value out of range, or an unknown edition.

    Examples
    --------
    >>> required = ac156(1.0, 0.5)
    >>> required.flexible, required.rigid
    (1.6, 0.8)
    >>> round(ac156(1.0, 0.5, "7-22").rigid, 3)
    0.692
    """
    s = within("SDS", sds, 0.001, 10.0, "g", "sds")
    z = within("height_ratio", height_ratio, 0.0, 1.0, field="height_ratio")
    if word_of("edition", edition, EDITIONS, "edition") == "7-16":
        amplified = s * (1.0 + 2.0 * z)
    else:
        amplified = s * (1.0 + 2.5 * z) / (DUCTILITY if z > 0.0 else 1.0)
    return RequiredSpectrum(s, z, edition, min(1.6 * s, amplified), 0.4 * amplified)


def ac156_motion(
    required: RequiredSpectrum, number: int = 1, *, seed: int = 1, lowest: float | None = None
) -> Motion:
    """Return a motion of three independent components whose spectra meet a required one on average.

    Broadband noise under an envelope of 5 s build-up, 20 s of strong shaking and 5 s of decay, matched at 5 %
    from the low cut-off to 33.3 Hz; below the cut-off its amplitudes fall, since no test asks for them. It
    begins and ends at rest.

    Parameters
    ----------
    required : RequiredSpectrum
        What it meets.
    number : int
        Which of the independent motions, 1 to 1,000,000.
    seed : int
        0 to 2³² − 1.
    lowest : float, optional
        Frequency from which on it meets the spectrum [Hz], 0.1 to 3.5; default 1.3, the lowest that
        the test asks for; of a component with a resonance f it is max(1.3, min(3.5, 0.75 f)).

    Returns
    -------
    Motion
        x, y and z at 0.005 s.

    Raises
    ------
    InputError
        A number, a seed or a frequency out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> required = sp.ac156(1.0, 0.5)
    >>> motion, periods = sp.ac156_motion(required), [0.05, 0.1, 0.3, 0.7]  # s
    >>> spectrum = motion.spectrum(periods)
    >>> (spectrum.sa / required.horizontal(periods)).round(1).tolist()  # how near it comes
    [1.0, 1.0, 1.0, 0.9]
    """
    instance_of("required", required, RequiredSpectrum)
    cut = LOWEST_CUTOFF if lowest is None else within("lowest", lowest, 0.1, HIGHEST_CUTOFF, "Hz", "lowest")
    key = Draws.key(seed, _KEY, number)
    t = DT * np.arange(round((BUILD + HOLD + DECAY) / DT) + 1, dtype=np.float64)
    envelope = np.minimum(np.minimum(t / BUILD, 1.0), (t[-1] - t) / DECAY)
    band = 1.0 / RIGID_FROM, 1.0 / cut
    name = f"{required.name}, motion {number}"
    components: dict[str, Any] = {
        component: matched(
            [Motion(DT, STANDARD_GRAVITY * required.rigid * envelope * Draws(*key, place).noise(len(t)))],
            required.vertical if component == "z" else required.horizontal,
            band,
            threads=1,
        )[0].x
        for place, component in enumerate("xyz")
    }
    source = f"noise matched to {required.name}, {cut:g} to {RIGID_FROM:g} Hz, seed {seed}; baseline at rest"
    return Motion(DT, **components, name=name, synthetic=True, source=source)
