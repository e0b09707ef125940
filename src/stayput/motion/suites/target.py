"""Spectra that motions are made to meet: Japan's design spectrum, ASCE 7's, a user's own table; and how.

To meet one, a motion's Fourier amplitudes are changed and its phases kept. Where a spectrum is too low at
period T, the amplitudes about the frequency 1/T are raised by the ratio, and so again till nothing more is to
be won (as SIMQKE does; Gasparini and Vanmarcke 1976). The filter is smooth, so a motion keeps its envelope.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput import errors
from stayput.catalogue import phrase
from stayput.execution import Pool
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.floors import of_the_ground
from stayput.motion.processing import LARGEST_ACCELERATION, ending_at_rest, fft_length
from stayput.motion.readers.text import file_bytes, rows_of, text_of
from stayput.motion.record import COMPONENTS, Motion
from stayput.motion.response import DAMPING, PERIOD_RANGE, checked_periods, spectrum_of_samples
from stayput.motion.suites.families import cosine_taper
from stayput.motion.units import unit_factor
from stayput.progress import bar

if TYPE_CHECKING:
    import os

DEFAULT_BAND = (0.1, 5.0)
"""Shortest and longest period over which a target counts where nothing is said [s]."""

PER_DECADE = 30
"""Periods in a factor of ten of a band."""

LEVELS = {"very rare": 1.0, "rare": 0.2}
"""Levels of Japan's design spectrum, and their factors."""

SITE_GV = {2: 2.03, 3: 2.7}
"""gv of soft soils: the site factor at long periods."""


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class TargetSpectrum:
    """A spectrum of absolute acceleration as a table, log-log linear between its points.

    Parameters
    ----------
    periods : array_like, shape (m,)
        Periods, increasing [s].
    sa : array_like, shape (m,)
        Sa there, above 0 [m/s²].
    name : str
        What it is called.
    damping : float
        Damping ratio.
    of_the_ground : bool
        Whether it is one of the ground, as those of codes are: motions of upper floors are then refused.

    Raises
    ------
    InputError
        Fewer than two periods, different lengths, or a value out of range.

    Examples
    --------
    >>> import numpy as np
    >>> import stayput as sp
    >>> target = sp.TargetSpectrum(np.array([0.02, 0.5, 5.0]), np.array([4.0, 8.0, 1.0]), name="asked for")
    >>> target([0.1, 0.5, 1.0]).round(1).tolist()  # between its points, on log-log axes [m/s²]
    [5.7, 8.0, 4.3]
    """

    periods: NDArray[np.float64]
    sa: NDArray[np.float64]
    name: str = "target spectrum"
    damping: float = DAMPING
    of_the_ground: bool = False

    if TYPE_CHECKING:  # taken as whatever NumPy makes an array of, and kept as arrays

        def __init__(
            self,
            periods: ArrayLike,
            sa: ArrayLike,
            name: str = ...,
            damping: float = DAMPING,
            of_the_ground: bool = False,
        ) -> None: ...

    def __post_init__(self) -> None:
        errors.instance_of("of_the_ground", self.of_the_ground, bool)
        periods = checked_periods(self.periods)
        if len(periods) < 2:
            name, shape = phrase("common.shape_of", name="periods"), str(periods.shape)
            raise errors.not_allowed(name, shape, "motion.two_or_more", "periods")
        sa = errors.numbers("sa", self.sa, "sa", len(periods))
        for value in sa:
            errors.within("sa", value, 1e-6, LARGEST_ACCELERATION, "m/s²", "sa")
        errors.within("damping", self.damping, 0.0, 0.95, field="damping")
        for array in (periods, sa):
            array.setflags(write=False)
        object.__setattr__(self, "periods", periods)
        object.__setattr__(self, "sa", sa)

    def __repr__(self) -> str:
        first, last = float(self.periods[0]), float(self.periods[-1])
        return f"TargetSpectrum({self.name!r}, {first:g} to {last:g} s, damping={self.damping:g})"

    def __call__(self, periods: ArrayLike) -> NDArray[np.float64]:
        """Return Sa at periods [s] [m/s²], shape of them.

        Raises
        ------
        InputError
            A period outside the table.
        """
        asked = np.asarray(periods, np.float64)
        low, high = float(self.periods[0]), float(self.periods[-1])
        outside = asked[(asked < low * (1.0 - 1e-9)) | (asked > high * (1.0 + 1e-9))]
        if outside.size:
            name = phrase("motion.name_target_period", target=self.name)
            errors.within(name, float(outside.flat[0]), low, high, "s", "periods")
        return np.exp(np.interp(np.log(asked), np.log(self.periods), np.log(self.sa)))

    def refuse_floors(self, motions: Iterable[Motion]) -> None:
        """Refuse motions of an upper floor where the spectrum is one of the ground."""
        if self.of_the_ground:
            for motion in motions:
                of_the_ground(motion, "here")


def band_periods(band: tuple[float, float]) -> NDArray[np.float64]:
    """Return periods over a band, both ends and 30 a decade [s], shape (m,).

    Raises
    ------
    InputError
        A band out of range, or shorter than a tenth of its start.
    """
    ends = errors.numbers("band", band, "band", count=2)
    low = errors.within("motion.name_band_shortest", ends[0], *PERIOD_RANGE, "s", "band")
    high = errors.within("motion.name_band_longest", ends[1], 1.1 * low, PERIOD_RANGE[1], "s", "band")
    return np.geomspace(low, high, max(2, 1 + round(PER_DECADE * np.log10(high / low))))


def japanese_design(level: str = "very rare", soil: int = 2) -> TargetSpectrum:
    """Return the design spectrum of Japan's building code at the ground's surface, 0.01 to 10 s.

    At the engineering bedrock, very rare: 3.2 + 30T (T < 0.16 s), 8.0 (to 0.64 s), 5.12/T m/s²; rare is a
    fifth. Times the site factor Gs: 1.5 at short periods; at long ones 1.35 (soil 1), 2.03 (2) or 2.7 (3).
    Notification 1457 of the Ministry of Construction (2000), as it is commonly known, not re-checked.

    Parameters
    ----------
    level : str
        "very rare" (extremely rare, safety limit) or "rare" (damage limit).
    soil : int
        Class of the ground: 1 firm, 2 middle, 3 soft.

    Raises
    ------
    InputError
        No such level or class of ground.

    Examples
    --------
    >>> import stayput as sp
    >>> for level in ("rare", "very rare"):  # at 0.1, 0.5 and 2 s [m/s²]
    ...     print(level, sp.japanese_design(level, soil=2)([0.1, 0.5, 2.0]).round(2))
    rare [1.86 2.4  1.04]
    very rare [ 9.3 12.   5.2]
    """
    errors.word_of("level", level, LEVELS, "level")
    soil = errors.whole_within("soil", soil, 1, max(SITE_GV), field="soil")
    corners = [0.16, 0.64] + ([0.576] if soil == 1 else [0.64 * SITE_GV[soil] / 1.5])
    t = _table_periods(corners)
    bedrock = np.where(t < 0.16, 3.2 + 30.0 * t, np.where(t < 0.64, 8.0, 5.12 / t))
    site = np.clip(0.864 / t, 1.35, 1.5) if soil == 1 else np.clip(1.5 * t / 0.64, 1.5, SITE_GV[soil])
    name = f"Japanese design spectrum, {level}, soil {soil}"
    return TargetSpectrum(t, LEVELS[level] * bedrock * site, name, of_the_ground=True)


def asce7(sds: float, sd1: float, tl: float = 8.0) -> TargetSpectrum:
    """Return the two-period design spectrum of ASCE 7, 0.01 to 10 s.

    SDS (0.4 + 0.6 T/T0) to T0 = 0.2 SD1/SDS, SDS to TS = SD1/SDS, SD1/T to TL, SD1 TL/T² beyond. ASCE/SEI
    7-16, section 11.4.6, as it is commonly known, not re-checked.

    Parameters
    ----------
    sds, sd1 : float
        Design accelerations at short periods and at 1 s [g].
    tl : float
        Long-period transition TL [s].

    Raises
    ------
    InputError
        A value out of range, or TS = SD1/SDS beyond TL.

    Examples
    --------
    >>> import stayput as sp
    >>> target = sp.asce7(sds=1.0, sd1=0.6)
    >>> (target([0.2, 1.0, 4.0]) / 9.80665).round(2).tolist()  # g
    [1.0, 0.6, 0.15]
    """
    short = errors.within("SDS", sds, 0.001, 10.0, "g", "sds")
    long = errors.within("SD1", sd1, 0.001, 10.0, "g", "sd1")
    late = errors.within("TL", tl, 0.1, 100.0, "s", "tl")
    ts = errors.within("TS = SD1/SDS", long / short, 0.01, late, "s", "sd1")
    t0 = 0.2 * ts
    t = _table_periods([t0, ts, late])
    rise = short * (0.4 + 0.6 * t / t0)
    falling = np.where(t <= late, long / t, long * late / t**2)
    sa = np.where(t < t0, rise, np.where(t <= ts, short, falling))
    name = f"ASCE 7, SDS {short:g} g, SD1 {long:g} g, TL {late:g} s"
    return TargetSpectrum(t, STANDARD_GRAVITY * sa, name, of_the_ground=True)


def _table_periods(corners: list[float]) -> NDArray[np.float64]:
    """Return 0.01 to 10 s, 100 a decade, with the corners that lie inside."""
    inside = [corner for corner in corners if 0.01 < corner < 10.0]
    return np.unique(np.concatenate((np.geomspace(0.01, 10.0, 301), inside)))


def read_target(path: str | os.PathLike[str], unit: str = "g") -> TargetSpectrum:
    r"""Read a target spectrum of two columns, period [s] and Sa; lines that begin with # are passed over.

    Parameters
    ----------
    path : str or path
        The file; commas, semicolons, tabs or spaces part the columns.
    unit : str
        Unit of Sa: "g", "m/s²", "gal", ...

    Raises
    ------
    InputError
        The file cannot be read, or a line is not two numbers.

    Examples
    --------
    >>> import stayput as sp
    >>> from pathlib import Path
    >>> _ = Path("target.csv").write_text("0.1,0.8\n1.0,0.6\n2.0,0.3\n")
    >>> sp.read_target("target.csv", unit="g").sa.round(2).tolist()
    [7.85, 5.88, 2.94]
    """
    text, factor, name = text_of(path, file_bytes(path)), unit_factor(unit), Path(path).name

    def values_of(line: str) -> list[str] | None:
        words = re.split(r"[\s,;]+", line.strip())
        return None if not words[0] or words[0].startswith("#") else words

    try:
        table = rows_of(text, 0, 2, values_of)
        return TargetSpectrum(table[:, 0], factor * table[:, 1], name)
    except errors.InputError as error:
        raise error.at(name) from None


VERTICAL = ((0.1, 0.8), (0.3, 0.5))
"""Periods [s] and the vertical over the horizontal spectrum, log-log linear (default, low confidence)."""

ITERATIONS = 8
"""How often the filter is corrected; the best iteration counts."""

RELAXATION = 0.8
"""Share of the misfit of ln Sa that one iteration takes off: all of it overshoots where periods interact."""

PADDING = 2.0
"""Still floor before and after a motion, for its filtered waves to fade in [longest periods of the band]."""

BAND_MARGIN = 1.25
"""Factor by which the filter goes on beyond the band, so that the band's ends are met too."""


class _FilteredComponent:
    """A component's transform, whose amplitudes are multiplied."""

    def __init__(self, a: NDArray[np.float64], dt: float, longest: float) -> None:
        self.dt, self.pad = dt, math.ceil(PADDING * longest / dt)
        self.n = len(a) + 2 * self.pad
        self.n_fft = fft_length(
            self.n + self.pad
        )  # zeros at the end keep filtered waves from wrapping around
        f = np.fft.rfftfreq(self.n_fft, dt)
        self.transform = np.fft.rfft(np.pad(a, self.pad), self.n_fft)
        self.log_f = np.log(np.maximum(f, 0.1 * f[1]))  # finite at 0 Hz, below all others

    def changed(self, periods: NDArray[np.float64], log_gain: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the acceleration with the gains exp(log_gain) at 1/periods, brought back to rest.

        At longer periods they fall as 1/T², so that no displacement grows that the target does not ask
        for; at shorter ones they stay.
        """
        log_edges = -np.log(periods[::-1])
        fall = np.minimum(self.log_f - log_edges[0], 0.0)
        gain = np.exp(np.interp(self.log_f, log_edges, log_gain[::-1]) + 2.0 * fall)
        a = np.fft.irfft(self.transform * gain, self.n_fft)[: self.n]
        t = self.dt * np.arange(self.n, dtype=np.float64)
        return ending_at_rest(a * cosine_taper(t, self.dt * self.pad))

    def log_sa(
        self, periods: NDArray[np.float64], log_gain: NDArray[np.float64], damping: float
    ) -> NDArray[np.float64]:
        """Return ln Sa at periods, with the gains exp(log_gain) there, shape (m,)."""
        spectrum = spectrum_of_samples(self.changed(periods, log_gain), self.dt, periods, damping)
        return np.log(np.maximum(spectrum.sa, 1e-12))


def matched(
    motions: Sequence[Motion],
    target: TargetSpectrum,
    band: tuple[float, float],
    *,
    together: bool = False,
    threads: int | None = None,
) -> list[Motion]:
    """Return motions whose Fourier amplitudes are changed till their Sa meet a target over a band.

    x and y each meet the target, the vertical component 0.8 of it at short periods and 0.5 at long ones
    (`VERTICAL`). Motions get longer by twice the band's longest period at either end; velocity and
    displacement end at zero. The motions are synthetic from then on.

    Parameters
    ----------
    motions : sequence of Motion
        The motions.
    target : TargetSpectrum
        What they meet.
    band : (float, float)
        Shortest and longest period that count [s].
    together : bool
        Whether one filter serves all, so that only their geometric mean meets the target and their
        variability stays; by default each motion meets it.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.

    Raises
    ------
    InputError
        A still component, or a band outside the target.
    """
    inside = band_periods(band)
    target(inside)
    low = max(float(target.periods[0]), inside[0] / BAND_MARGIN)
    high = min(float(target.periods[-1]), inside[-1] * BAND_MARGIN)
    periods = band_periods((low, high))
    target.refuse_floors(motions)
    for motion in motions:
        for name, a in motion.components.items():
            if not np.any(a):
                raise errors.InputError(
                    "motion.still_component", component=name, motion=errors.excerpt(motion.name)
                )
    which = "one filter for the whole suite" if together else "a filter of its own"
    note = (
        f"Fourier amplitudes changed to {target.name}, {band[0]:g}-{band[1]:g} s, {which}; baseline at rest"
    )
    filtered = [
        {name: _FilteredComponent(a, motion.dt, band[1]) for name, a in motion.components.items()}
        for motion in motions
    ]
    shared = _suite_gains(filtered, target, periods, threads) if together else None

    def match(motion: Motion, parts: dict[str, _FilteredComponent]) -> Motion:
        gains = _suite_gains([parts], target, periods, 1) if shared is None else shared
        changed: dict[str, Any] = {name: part.changed(periods, gains[name]) for name, part in parts.items()}
        source = f"{motion.source}; {note}" if motion.source else note
        return replace(motion, **changed, synthetic=True, source=source)

    results: list[Motion] = []
    with Pool(threads) as pool, bar(len(motions), "progress.matching", unit="progress.motions") as done:
        pairs = zip(motions, filtered, strict=True)
        for motion in pool.in_order(partial(match, *pair) for pair in pairs):
            results.append(motion)
            done(1)
    return results


def _suite_gains(
    filtered: Sequence[dict[str, _FilteredComponent]],
    target: TargetSpectrum,
    periods: NDArray[np.float64],
    threads: int | None,
) -> dict[str, NDArray[np.float64]]:
    """Return the log gains with which the geometric mean of each component that is there meets the target."""
    gains: dict[str, NDArray[np.float64]] = {}
    for name in COMPONENTS:
        parts = [components[name] for components in filtered if name in components]
        if not parts:
            continue
        wanted = np.log(target(periods))
        if name == "z":
            at, ratio = zip(*VERTICAL, strict=True)
            wanted += np.interp(np.log(periods), np.log(at), np.log(ratio))
        gain = gains[name] = np.zeros(len(periods))
        least = np.inf
        with Pool(threads) as pool:
            for _ in range(ITERATIONS):
                calls = (partial(part.log_sa, periods, gain, target.damping) for part in parts)
                misfit = wanted - sum(pool.in_order(calls)) / len(parts)
                error = float(np.mean(np.abs(misfit)))
                if error < least:
                    gains[name], least = gain, error
                gain = gain + RELAXATION * misfit
    return gains
