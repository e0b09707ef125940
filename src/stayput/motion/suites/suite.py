"""`Suite`: an ordered collection of motions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, cast, overload

import numpy as np

from stayput.errors import InputError
from stayput.motion.intensity import jma_intensity
from stayput.motion.record import Motion
from stayput.motion.spectrum import DAMPING, PERIODS, spectra
from stayput.motion.suites.target import DEFAULT_BAND, band_periods

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion.suites.target import TargetSpectrum


@dataclass(frozen=True, slots=True)
class Deviation:
    """How far the geometric mean of a suite's spectra is from a target, over a band.

    Parameters
    ----------
    mean : float
        Mean of the size of ratio − 1.
    worst : float
        Largest of it.
    worst_period : float
        Where that is [s].
    """

    mean: float
    worst: float
    worst_period: float


@dataclass(frozen=True, repr=False)
class Suite(Sequence[Motion]):
    """An immutable, ordered collection of motions.

    Parameters
    ----------
    motions : sequence of Motion
        At least one.
    name : str
        What the suite is called.

    Raises
    ------
    InputError
        No motions, or something else than motions.

    Examples
    --------
    >>> from stayput.motion.suites import synthetic_suite
    >>> suite = synthetic_suite("crustal", 3).to_intensity(6.0)
    >>> len(suite), suite[0].name
    (3, 'synthetic crustal 1')
    """

    motions: tuple[Motion, ...]
    name: str = ""

    def __post_init__(self) -> None:
        motions = tuple(self.motions)
        if not motions:
            raise InputError("The suite has no motions; it must have at least one.")
        for one in motions:
            if not isinstance(one, Motion):  # pyright: ignore[reportUnnecessaryIsInstance]
                raise InputError(f"The suite holds a {type(one).__name__}; it must hold motions only.")
        object.__setattr__(self, "motions", motions)

    def __repr__(self) -> str:
        return f"Suite({self.name!r}, {len(self)} motions)"

    def __len__(self) -> int:
        return len(self.motions)

    @overload
    def __getitem__(self, index: int) -> Motion: ...
    @overload
    def __getitem__(self, index: slice) -> Suite: ...
    def __getitem__(self, index: int | slice) -> Motion | Suite:
        if isinstance(index, slice):
            return replace(self, motions=self.motions[index])
        return self.motions[index]

    @property
    def synthetic(self) -> bool:
        """Whether any motion was computed, not recorded."""
        return any(motion.synthetic for motion in self.motions)

    @property
    def intensities(self) -> NDArray[np.float64]:
        """JMA's instrumental intensities of the motions, not rounded, shape (n,)."""
        return np.array([jma_intensity(motion) for motion in self.motions])

    def spectra(
        self, periods: ArrayLike = PERIODS, damping: float = DAMPING, component: str = "x"
    ) -> NDArray[np.float64]:
        """Return the absolute-acceleration spectra Sa of the motions [m/s²], shape (n, m).

        Parameters
        ----------
        periods : array_like, shape (m,)
            Periods [s].
        damping : float
            Damping ratio.
        component : str
            "x", "y" or "z".
        """
        found = spectra(self.motions, periods, damping, component)
        return np.array([spectrum.sa for spectrum in found])

    def median(
        self, periods: ArrayLike = PERIODS, damping: float = DAMPING, component: str = "x"
    ) -> NDArray[np.float64]:
        """Return the geometric mean of the spectra [m/s²], shape (m,): the median of a lognormal scatter."""
        return cast("NDArray[np.float64]", np.exp(self._logs(periods, damping, component).mean(axis=0)))

    def log_std(
        self, periods: ArrayLike = PERIODS, damping: float = DAMPING, component: str = "x"
    ) -> NDArray[np.float64]:
        """Return the sample standard deviation of ln Sa, shape (m,): the record-to-record variability.

        Raises
        ------
        InputError
            Only one motion.
        """
        if len(self) < 2:
            raise InputError("The suite has 1 motion; a standard deviation needs at least 2.")
        return self._logs(periods, damping, component).std(axis=0, ddof=1)

    def scaled(self, factor: float) -> Suite:
        """Return the suite with every motion times ``factor``."""
        return self._with([motion.scaled(factor) for motion in self.motions])

    def to_intensity(self, intensity: float | str) -> Suite:
        """Return the suite with each motion scaled to a JMA intensity, exactly; see `Motion.to_intensity`."""
        return self._with([motion.to_intensity(intensity) for motion in self.motions])

    def to_spectrum(self, target: TargetSpectrum, band: tuple[float, float] = DEFAULT_BAND) -> Suite:
        """Return the suite with each motion times the factor that brings ln Sa of x nearest to a target's.

        Least squares over periods that are equally spaced in their logarithm: ln k is the mean of
        ln(target/Sa). All components get the factor, so shapes and variability of shape stay.

        Parameters
        ----------
        target : TargetSpectrum
            What they are scaled to.
        band : (float, float)
            Shortest and longest period that count [s].

        Raises
        ------
        InputError
            A band outside the target, or a motion whose x is still.
        """
        factors = np.exp(self._misfits(target, band).mean(axis=1))
        return self._with([m.scaled(float(k)) for m, k in zip(self.motions, factors, strict=True)])

    def matched(
        self, target: TargetSpectrum, band: tuple[float, float] = DEFAULT_BAND, *, together: bool = False
    ) -> Suite:
        """Return the suite with its Fourier amplitudes changed till its spectra meet a target.

        x and y each meet it, z 0.8 of it at short periods and 0.5 at long ones (default, low confidence);
        phases stay, and so does the envelope. Motions get longer by twice the band's longest period at
        either end; velocity and displacement end at zero. What was recorded is synthetic from then on.

        Parameters
        ----------
        target : TargetSpectrum
            What they meet.
        band : (float, float)
            Shortest and longest period that count [s].
        together : bool
            Whether one filter serves all, so that the geometric mean of the suite meets the target and
            the record-to-record variability stays; by default each motion meets it.

        Raises
        ------
        InputError
            A band outside the target, or a still component.
        """
        from stayput.motion.suites.matching import matched

        return self._with(matched(self.motions, target, band, together=together))

    def selected(self, target: TargetSpectrum, n: int, band: tuple[float, float] = DEFAULT_BAND) -> Suite:
        """Return the n motions nearest in spectral shape to a target, the nearest first, unscaled.

        The distance is the standard deviation of ln(target/Sa) of x over the band: what is left after
        the best factor.

        Parameters
        ----------
        target : TargetSpectrum
            What they are compared with.
        n : int
            How many, 1 to all.
        band : (float, float)
            Shortest and longest period that count [s].

        Raises
        ------
        InputError
            More motions asked for than there are, or a band outside the target.
        """
        from stayput.motion.suites.synthesis import whole

        count = whole("Number of selected motions", n, 1, len(self))
        order = np.argsort(self._misfits(target, band).std(axis=1), kind="stable")
        return self._with([self.motions[i] for i in order[:count]])

    def deviation(self, target: TargetSpectrum, band: tuple[float, float] = DEFAULT_BAND) -> Deviation:
        """Return how far the geometric mean of the suite's Sa of x is from a target over a band."""
        off = np.abs(np.exp(-self._misfits(target, band).mean(axis=0)) - 1.0)
        worst = int(np.argmax(off))
        return Deviation(float(off.mean()), float(off[worst]), float(band_periods(band)[worst]))

    def plot(self, path: str | Path | None = None, target: TargetSpectrum | None = None) -> Figure:
        """Plot the spectra and their variability; see `stayput.report.suite.plot_suite`."""
        from stayput.report.suite import plot_suite

        return plot_suite(self, path, target)

    def _with(self, motions: list[Motion]) -> Suite:
        return replace(self, motions=tuple(motions))

    def _logs(self, periods: ArrayLike, damping: float, component: str) -> NDArray[np.float64]:
        sa = self.spectra(periods, damping, component)
        for motion, row in zip(self.motions, sa, strict=True):
            if not np.all(row > 0.0):
                raise InputError(f"The {component} component of {motion.name!r} is still; its ln Sa is none.")
        return np.log(sa)

    def _misfits(self, target: TargetSpectrum, band: tuple[float, float]) -> NDArray[np.float64]:
        """Return ln(target/Sa) of x over a band, shape (n, m)."""
        periods = band_periods(band)
        wanted = np.log(target(periods))
        return wanted - self._logs(periods, target.damping, "x")
