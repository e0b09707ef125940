"""`Suite`: an ordered collection of motions, computed, or read from files or the folder of a database."""

from __future__ import annotations

import os
import re
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Unpack, cast, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, InputWarning, excerpt, list_of, not_allowed, warn, whole_within
from stayput.execution import Pool
from stayput.motion.channels import Channel, is_vertical, labels_phrase, plain_origin
from stayput.motion.readers import ReadFile, along, motion_of, read_file, read_shaking
from stayput.motion.record import Motion
from stayput.motion.response import DAMPING, PERIODS, checked_periods
from stayput.motion.suites.target import DEFAULT_BAND, TargetSpectrum, band_periods, matched
from stayput.wording import check_language, joined

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.motion.readers.columns import ReadingOptions


SuiteSpectra = Literal["spectra", "scatter"]
"""What `Suite.plot` draws over the period."""


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
    >>> import stayput as sp
    >>> suite = sp.synthetic_suite("crustal", 3)
    >>> [round(float(value), 1) for value in suite.intensities]  # JMA's, as they are drawn
    [4.1, 4.4, 4.6]
    >>> [round(motion.pgv, 2) for motion in suite.to_intensity("6-upper")]  # m/s
    [0.44, 0.67, 0.53]
    """

    motions: tuple[Motion, ...]
    name: str = ""

    def __post_init__(self) -> None:
        motions = list_of("motions", self.motions, Motion)
        if not motions:
            raise InputError("common.empty", "motions")
        object.__setattr__(self, "motions", motions)

    def __repr__(self) -> str:
        return f"Suite({self.name!r}, {len(self)} motions)"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import suite_html

        return suite_html(self)

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
    def floor(self) -> str:
        """The upper floors that its motions are of; "" where they are of the ground. See `Motion.floor`."""
        return ", ".join(dict.fromkeys(motion.floor for motion in self.motions if motion.floor))

    @property
    def intensities(self) -> NDArray[np.float64]:
        """JMA's instrumental intensities of the motions, not rounded, shape (n,)."""
        return np.array([motion.intensity for motion in self.motions])

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
        checked = checked_periods(periods)
        with Pool() as pool:
            calls = (partial(motion.spectrum, checked, damping, component) for motion in self.motions)
            return np.array([spectrum.sa for spectrum in pool.in_order(calls)])

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
            raise not_allowed("motion.name_count", str(len(self)), "motion.two_or_more")
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
        count = whole_within("motion.name_count", n, 1, len(self), field="n")
        order = np.argsort(self._misfits(target, band).std(axis=1), kind="stable")
        return self._with([self.motions[i] for i in order[:count]])

    def deviation(self, target: TargetSpectrum, band: tuple[float, float] = DEFAULT_BAND) -> Deviation:
        """Return how far the geometric mean of the suite's Sa of x is from a target over a band."""
        off = np.abs(np.exp(-self._misfits(target, band).mean(axis=0)) - 1.0)
        worst = int(np.argmax(off))
        return Deviation(float(off.mean()), float(off[worst]), float(band_periods(band)[worst]))

    def plot(
        self,
        ax: Axes | None = None,
        *,
        what: SuiteSpectra = "spectra",
        target: TargetSpectrum | None = None,
        component: str = "x",
        language: str = "en",
        **line: Any,
    ) -> Axes:
        """Draw all spectra with their median and scatter, or the standard deviation of ln Sa, on axes.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"spectra", "scatter"}
            The spectra, or their standard deviation.
        target : TargetSpectrum, optional
            Drawn with the spectra; its damping is then theirs.
        component : str
            "x", "y" or "z".
        language : str
            Language of the texts, "en" or "ja".
        **line
            How the median, or the standard deviation, looks, as for ``Axes.plot``.

        Raises
        ------
        InputError
            Something else to draw, or a component that is not there.
        """
        from stayput.report.figures import plotted
        from stayput.report.spectra import draw_suite

        return plotted(ax, draw_suite, self, what, target, component, check_language(language), **line)

    def figure(
        self,
        title: str = "",
        *,
        target: TargetSpectrum | None = None,
        component: str = "x",
        language: str = "en",
    ) -> Figure:
        """Return a figure with the spectra, and the standard deviation of ln Sa below."""
        from stayput.report.spectra import plot_suite

        return plot_suite(self, None, target, component, title=title, language=check_language(language))

    def _with(self, motions: list[Motion]) -> Suite:
        return replace(self, motions=tuple(motions))

    def _logs(self, periods: ArrayLike, damping: float, component: str) -> NDArray[np.float64]:
        sa = self.spectra(periods, damping, component)
        for motion, row in zip(self.motions, sa, strict=True):
            if not np.all(row > 0.0):
                raise InputError("motion.still_component", component=component, motion=excerpt(motion.name))
        return np.log(sa)

    def _misfits(self, target: TargetSpectrum, band: tuple[float, float]) -> NDArray[np.float64]:
        """Return ln(target/Sa) of x over a band, shape (n, m)."""
        periods = band_periods(band)
        wanted = np.log(target(periods))
        target.refuse_floors(self.motions)
        return wanted - self._logs(periods, target.damping, "x")


def read_suite(
    source: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    component: str | None = None,
    unit: str | None = None,
    *,
    name: str | None = None,
    **options: Unpack[ReadingOptions],
) -> Suite:
    """Read a suite of records, in all the formats of `read_motion`.

    In a folder, files that hold one component each (PEER, K-NET, KiK-net, SAC, ESM) are joined by their
    record number (RSN…) or by the station and event that they state; what holds velocities or displacements,
    is of a borehole, or is no record (``_SearchResults.csv``, pictures) is left out. In a list each file is
    one motion; see `Motion.combine`. Nothing is scaled: see `Suite.to_intensity`, `Suite.to_spectrum` and
    `Suite.selected`.

    Parameters
    ----------
    source : path, or iterable of paths
        A folder, whose files are taken in the order of their names, all but hidden ones and Markdown; or
        the files themselves, in this order.
    component, columns, skip_lines, decimal_comma, location, remove_mean
        As for `read_motion`, for every file; a vertical channel beside horizontal ones is refused.
    unit, dt
        As for `read_motion`, for the files that do not state theirs.
    name : str, optional
        Default: the folder's name.

    Raises
    ------
    InputError
        No folder, no files in it, or a file that cannot be read: its name is in the sentence.

    Warns
    -----
    InputWarning
        Files of the folder are left out.

    Examples
    --------
    >>> import stayput as sp
    >>> for count, motion in enumerate(sp.synthetic_suite("crustal", count=2)):
    ...     _ = motion.write(f"motion{count}.csv")
    >>> len(sp.read_suite(["motion0.csv", "motion1.csv"]))
    2
    """
    if isinstance(source, str | os.PathLike):
        folder = Path(source)
        if not folder.is_dir():
            raise not_allowed("motion.the_suite", repr(str(folder)), "motion.folder_of_records", "source")
        title = folder.resolve().name
        motions = _records_in(folder, title, component, unit, **options)
    else:
        files = list_of("source", source, (str, os.PathLike))
        motions = [read_shaking(file, component, unit, several=True, **options) for file in files]
        title = "records"
    if not motions:
        raise InputError("common.empty", name=repr(title))
    return Suite(tuple(motions), title if name is None else name)


_NO_RECORD = re.compile(
    r"SearchResults\.csv$|\.(?:ps|gz|pdf|png|jpe?g|gif|html?)$|^(?:read[ _-]?me|licen[cs]e|copying)\b",
    re.IGNORECASE,
)
"""Names of PEER's tables of what was found, of pictures and archives, and of texts about the records."""

_LEFT_OUT = {
    "motion.not_acceleration": "no_acceleration",
    "motion.other_instrument": "no_acceleration",
    "motion.unknown_format": "no_record",
}
"""Refusals of files that are left out, and as what."""

_RECORD_NUMBER = re.compile(r"RSN([0-9]{1,7})_", re.IGNORECASE)
_LISTED = 3


def _records_in(
    folder: Path, title: str, component: str | None, unit: str | None, **options: Unpack[ReadingOptions]
) -> list[Motion]:
    """Return the records in a folder, in the order of the files' names.

    Files of one channel each are one record where their names have the same record number (PEER's RSN), or
    where they state the same station, event and sensor.

    Parameters
    ----------
    folder : Path
        The folder.
    title : str
        What the warning calls it.
    component, unit, options
        As for `read_motion`.

    Raises
    ------
    InputError
        A file that cannot be read: its name is in the sentence.

    Warns
    -----
    InputWarning
        Files are left out: velocities and displacements, boreholes, records of the vertical alone, tables and
        pictures.
    """
    records: dict[Hashable, list[ReadFile]] = {}
    left_out: dict[str, list[str]] = {}
    for path in sorted(folder.iterdir()):
        if not path.is_file() or path.name.startswith(".") or path.suffix.lower() == ".md":
            continue
        if _NO_RECORD.search(path.name):
            left_out.setdefault("no_record", []).append(path.name)
            continue
        try:
            file = read_file(path, unit, several=True, **options)
        except InputError as error:
            if error.code not in _LEFT_OUT:
                raise
            left_out.setdefault(_LEFT_OUT[error.code], []).append(path.name)
            continue
        if all(channel.borehole for channel in file.channels):
            left_out.setdefault("in_borehole", []).append(path.name)
        else:
            channel = file.channels[0]
            origin = channel.origin or channel.name
            key = record_key(path.name, origin, channel.label) if len(file.channels) == 1 else None
            records.setdefault(key or path, []).append(file)
    for key, files in list(records.items()):
        if all(is_vertical(channel.label) for file in files for channel in file.channels):
            left_out.setdefault("vertical_only", []).extend(file.path.name for file in records.pop(key))
    if left_out:
        files = joined((_listed(kind, names) for kind, names in left_out.items()), ("; ", "、"))
        warn(InputWarning("motion.suite_left_out", "source", name=title, files=files))
    return [_motion(files, component) for files in records.values()]


def record_key(file: str, origin: str, label: str) -> str | None:
    """Return what tells the record that a file of one channel is of; None where nothing does.

    Parameters
    ----------
    file : str
        The file's name: of PEER it begins with the record's number.
    origin, label : str
        Event, station and sensor, and the channel's direction, as the file states them.
    """
    if number := _RECORD_NUMBER.match(file):
        return f"RSN{int(number[1])}"
    return plain_origin(origin) if label and origin else None


def _motion(files: Sequence[ReadFile], component: str | None) -> Motion:
    """Return the motion of a record's files; x is the first horizontal channel, or the component."""

    def first_horizontal(channels: Sequence[Channel]) -> str | None:
        level = [i for i, channel in enumerate(channels, 1) if not is_vertical(channel.label)]
        return f"channel {level[0]}" if len(level) in (1, 2) else None

    several = component is None and len(files) > 1
    return motion_of(files, first_horizontal if several else along(component))


def _listed(kind: str, names: Sequence[str]) -> Phrase:
    more = phrase("motion.and_more", count=len(names) - _LISTED) if len(names) > _LISTED else ""
    return phrase(f"motion.{kind}", files=labels_phrase(names[:_LISTED]), more=more)
