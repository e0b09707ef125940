"""`Motion`: how the floor shakes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, fields, replace
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Self, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.errors import InputError, finite, instance_of, shown, visible, whole_within, within, word_of
from stayput.files import check_target, draft
from stayput.motion import processing
from stayput.motion.channels import Listing, check_horizontal, motion_fields, one_record
from stayput.motion.floors import of_the_ground
from stayput.motion.intensity import factor_to_intensity, jma_intensity, possible_intensity
from stayput.motion.response import DAMPING, PERIODS, ResponseSpectrum, spectrum_of_samples
from stayput.motion.seismogram import channels_of_traces
from stayput.motion.writers import FORMATS
from stayput.wording import check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MotionHistory = Literal["acceleration", "velocity", "displacement"]
"""What `Motion.plot` draws over time."""

COMPONENTS = ("x", "y", "z")
"""Names of a motion's components: along the shaking, across it, up."""


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Motion:
    """The floor's acceleration, linear between equally spaced samples; the floor starts at rest.

    The arrays are copied and cannot be written to. ``pga``, ``pgv``, ``pgd``, ``arias``,
    ``significant_duration``, ``velocity`` and ``displacement`` are those of x, of the piecewise linear
    record itself (with the peaks between samples), without any baseline correction; `peaks` has all's.

    Parameters
    ----------
    dt : float
        Time step [s].
    x : array_like, shape (n,)
        Acceleration along the shaking, + right [m/s²].
    y : array_like, shape (n,), optional
        Acceleration across it [m/s²].
    z : array_like, shape (n,), optional
        Vertical acceleration, + up, without gravity [m/s²].
    name : str
        What the record is called.
    synthetic : bool
        Whether it was computed, not recorded.
    source : str
        Where it comes from: format, unit, what was done to it.
    floor : str
        Upper floor of a building that it is of, recorded or computed: "floor 42", "storey 5", "roof"; or
        "borehole"; "" of the ground, or where nothing is known.
    listing : Listing, optional
        The channels of the file that it was read from.

    Raises
    ------
    InputError
        A time step or a sample that is not finite or not sane, fewer than two samples, or components
        of different lengths.

    Examples
    --------
    >>> import stayput as sp
    >>> import numpy as np
    >>> motion = sp.Motion(dt=0.01, x=np.array([0.0, 1.0, -2.0, 0.0]), name="three steps")
    >>> motion.pga, motion.duration
    (2.0, 0.03)
    """

    dt: float
    x: NDArray[np.float64]
    y: NDArray[np.float64] | None = None
    z: NDArray[np.float64] | None = None
    name: str = ""
    synthetic: bool = False
    source: str = ""
    floor: str = ""
    listing: Listing | None = None

    if TYPE_CHECKING:  # samples are taken as whatever NumPy makes an array of, and kept as arrays

        def __init__(
            self,
            dt: float,
            x: ArrayLike,
            y: ArrayLike | None = None,
            z: ArrayLike | None = None,
            name: str = "",
            synthetic: bool = False,
            source: str = "",
            floor: str = "",
            listing: Listing | None = None,
        ) -> None: ...

    def __post_init__(self) -> None:
        object.__setattr__(self, "dt", within("motion.name_dt", self.dt, *processing.STEP_RANGE, "s", "dt"))
        for name in ("name", "source", "floor"):  # a file's header may hold anything
            object.__setattr__(self, name, visible(instance_of(name, getattr(self, name), str)))
        for name in COMPONENTS:
            values = getattr(self, name)
            if name == "x" or values is not None:
                object.__setattr__(self, name, processing.checked_samples(name, values))
        for name, values in self.components.items():
            if len(values) != len(self.x):
                raise InputError("common.so_many_values", name, count=len(values), wanted=len(self.x))

    def __repr__(self) -> str:
        peaks = ", ".join(f"{name} {np.abs(a).max():.4g}" for name, a in self.components.items())
        return f"Motion({self.name!r}, {len(self)} samples, dt={self.dt:g} s, peaks [m/s²]: {peaks})"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import motion_html

        return motion_html(self)

    def __len__(self) -> int:
        return len(self.x)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Motion):
            return NotImplemented
        mine, theirs = self.components, other.components
        return (
            (self.dt, self.name, self.synthetic, self.source, self.floor)
            == (other.dt, other.name, other.synthetic, other.source, other.floor)
            and mine.keys() == theirs.keys()
            and all(np.array_equal(mine[name], theirs[name]) for name in mine)
        )

    def __hash__(self) -> int:
        return hash((self.dt, self.name, len(self), self.x.tobytes()))

    def __reduce__(self) -> tuple[Any, ...]:  # so that a pickled motion comes back checked and read-only
        return Motion, tuple(getattr(self, field.name) for field in fields(self))

    @classmethod
    def given(cls, value: object, name: str = "motion") -> Self:
        """Return a motion, warning of an offset in arrays; or refuse what is none with how to make one of it.

        Raises
        ------
        InputError
            It is something else: bare samples have neither a time step nor a unit.
        """
        if isinstance(value, cls):
            if value.listing is None and not value.synthetic:  # neither checked when it was read nor computed
                processing.check_baseline(value)
            return value
        if isinstance(value, str | PathLike):
            path = repr(str(cast("object", value)))
            raise InputError("common.only_a_path", name, value=path, reader="read_motion")
        if isinstance(value, Sequence) or hasattr(value, "__array__"):
            raise InputError("motion.only_samples", name, name=name, value=shown(cast("object", value)))
        return instance_of(name, value, cls)

    @property
    def components(self) -> dict[str, NDArray[np.float64]]:
        """The components that are there, x first: name → acceleration [m/s²], shape (n,)."""
        axes = {"x": self.x, "y": self.y, "z": self.z}
        return {name: values for name, values in axes.items() if values is not None}

    @property
    def horizontal(self) -> dict[str, NDArray[np.float64]]:
        """Those of them that are horizontal, x first."""
        return {name: values for name, values in self.components.items() if name != "z"}

    @property
    def duration(self) -> float:
        """Time from the first to the last sample [s]."""
        return (len(self) - 1) * self.dt

    @property
    def time(self) -> NDArray[np.float64]:
        """Times of the samples [s], shape (n,)."""
        return np.arange(len(self), dtype=np.float64) * self.dt

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocity of x at the samples [m/s], shape (n,)."""
        return processing.velocity(self.x, self.dt)

    @property
    def displacement(self) -> NDArray[np.float64]:
        """Displacement of x at the samples [m], shape (n,)."""
        return processing.displacement(self.x, self.dt)

    @property
    def pga(self) -> float:
        """Largest magnitude of the acceleration of x [m/s²]."""
        return float(np.abs(self.x).max())

    @property
    def pgv(self) -> float:
        """Largest magnitude of the velocity of x [m/s]."""
        return processing.peak_velocity(self.x, self.dt)

    @property
    def pgd(self) -> float:
        """Largest magnitude of the displacement of x [m]."""
        return processing.peak_displacement(self.x, self.dt)

    @property
    def arias(self) -> float:
        """Arias intensity of x, π/(2g)·∫a² dt [m/s] (Arias 1970)."""
        return processing.arias_intensity(self.x, self.dt)

    @property
    def significant_duration(self) -> float:
        """D5–95 of x: time in which ∫a² dt grows from 5 % to 95 % [s] (Trifunac and Brady 1975)."""
        return processing.significant_duration(self.x, self.dt)

    @property
    def intensity(self) -> float:
        """JMA's instrumental intensity, not rounded; −inf if still; of an upper floor not the place's."""
        return jma_intensity(self.components.values(), self.dt)

    def spectrum(
        self, periods: ArrayLike = PERIODS, damping: float = DAMPING, component: str = "x"
    ) -> ResponseSpectrum:
        """Return the response spectrum of a component, by periods [s]; see `ResponseSpectrum`."""
        return spectrum_of_samples(self.component(component).x, self.dt, periods, damping)

    def plot(
        self,
        ax: Axes | None = None,
        *,
        what: MotionHistory = "acceleration",
        component: str = "x",
        language: str = "en",
        **line: Any,
    ) -> Axes:
        """Draw one history of one component on axes, the integrals without any correction.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"acceleration", "velocity", "displacement"}
            In m/s², cm/s and cm.
        component : str
            "x", "y" or "z".
        language : str
            Language of the texts, "en" or "ja".
        **line
            How the line looks, as for ``Axes.plot``; with a ``label`` it stands in the legend in the place
            of the peak.

        Raises
        ------
        InputError
            Another history, or a component that is not there.
        """
        from stayput.report.figures import plotted
        from stayput.report.plot import draw_motion

        return plotted(ax, draw_motion, self, what, component, check_language(language), **line)

    def figure(self, title: str = "", *, language: str = "en") -> Figure:
        """Return a figure with acceleration, velocity and displacement of every component."""
        from stayput.report.plot import plot_motion

        return plot_motion(self, title=title, language=check_language(language))

    def write(self, path: str | Path) -> Path:
        """Write the motion to a file by its ending: columns (.csv, all components) or PEER (.at2, x alone).

        Raises
        ------
        InputError
            An unknown ending, a folder that does not exist, or several components for AT2.
        """
        target = check_target(path, tuple(FORMATS))
        text = self.text(target.suffix.lower())
        with draft(target) as unfinished:
            unfinished.write_text(text, encoding="utf-8")
        return target

    def text(self, ending: str = ".csv") -> str:
        """Return the text of the file that `write` writes, in the format ".csv" or ".at2".

        Raises
        ------
        InputError
            Another ending, or several components for AT2.
        """
        return FORMATS[word_of("ending", ending, FORMATS)](self)

    def component(self, name: str) -> Motion:
        """Return one component ("x", "y" or "z") as a motion of its own, along its x."""
        word_of("motion.the_component", name, self.components, "component")
        listing = self.listing and self.listing.of(x=name)
        return replace(self, x=self.components[name], y=None, z=None, listing=listing)

    def peaks(self) -> dict[str, processing.Peaks]:
        """Return the peaks of every component that is there, x first."""
        return {name: processing.Peaks.of(a, self.dt) for name, a in self.components.items()}

    def _each(self, change: Callable[[NDArray[np.float64]], NDArray[np.float64]], **fields: Any) -> Motion:
        changed: dict[str, Any] = {name: change(values) for name, values in self.components.items()}
        return replace(self, **changed, **fields)

    def _note(self, what: str) -> str:
        return f"{self.source}; {what}" if self.source else what

    def scaled(self, factor: float) -> Motion:
        """Return the motion with every component times ``factor``."""
        k = finite("factor", factor, "factor")
        return self._each(lambda a: k * a, source=self._note(f"scaled by {k:g}"))

    def to_intensity(self, intensity: float | str) -> Motion:
        """Return the motion scaled to a JMA intensity: a number, or a class such as "6-upper" (its middle).

        Raises
        ------
        InputError
            A still floor, an upper floor, or an intensity that is not known or needs an absurd factor.
        """
        value = possible_intensity(intensity)
        scaled = self.scaled(factor_to_intensity(of_the_ground(self, "strength").intensity, value))
        return replace(scaled, source=f"{scaled.source} (to JMA intensity {value:g})")

    def flipped(self) -> Motion:
        """Return the motion turned by half a turn about the vertical: x and y change sign, z does not."""
        y = None if self.y is None else -self.y
        return replace(self, x=-self.x, y=y, source=self._note("turned by 180°"))

    def rotated(self, angle: float) -> Motion:
        """Return the motion as felt along a direction ``angle`` [rad] from x towards y.

        Raises
        ------
        InputError
            There is no y component.
        """
        turn = finite("angle", angle, "angle")
        if self.y is None:
            raise InputError("motion.rotation_without_y")
        c, s = math.cos(turn), math.sin(turn)
        source = self._note(f"turned by {math.degrees(turn):g}°")
        x, y = c * self.x + s * self.y, c * self.y - s * self.x
        return replace(self, x=x, y=y, source=source, listing=self.listing and self.listing.of(z="z"))

    def pointing(self, direction: float) -> Motion:
        """Return the motion of a floor whose x points elsewhere in plan [rad], from x towards y."""
        both = self if self.y is not None else replace(self, y=np.zeros_like(self.x))
        return both.rotated(-direction) if direction else self

    def trimmed(self, start: float = 0.0, end: float | None = None) -> Motion:
        """Return the samples with start ≤ t ≤ end [s]; the floor is at rest at the first of them."""
        last = longest = self.duration
        if end is not None:  # a duration that was printed and rounded up is the end too
            last = within("end", end, 0.0, longest + 1e-9, "s", "end")
        first = within("start", start, 0.0, longest, "s", "start")
        i, j = math.ceil(first / self.dt - 1e-6), math.floor(last / self.dt + 1e-6)
        if j - i < 1:
            raise InputError("motion.trim_too_short", "end", start=first, end=last)
        return self._each(
            lambda a: a[i : j + 1], source=self._note(f"trimmed to {i * self.dt:g}-{j * self.dt:g} s")
        )

    def padded(self, before: float = 0.0, after: float = 0.0) -> Motion:
        """Return the motion with a still floor before and after it [s], in whole time steps.

        A record that does not begin or end at zero is joined to the still part by one time step's ramp.
        """
        most = processing.MOST_SAMPLES * self.dt
        lead, tail = (
            round(within(field, time, 0.0, most, "s", field) / self.dt)
            for field, time in (("before", before), ("after", after))
        )
        source = self._note(f"padded by {lead * self.dt:g} s and {tail * self.dt:g} s")
        return self._each(lambda a: np.pad(a, (lead, tail)), source=source)

    def resampled(self, dt: float) -> Motion:
        """Return the motion at another time step [s], which must be a whole part or multiple of its own.

        To a whole part of the step the record stays the same function, bit by bit at its own samples.
        To a multiple it passes a zero-phase low-pass first (−6 dB at 0.8 of the new Nyquist frequency),
        so nothing is folded down; what is faster than that is lost, and up to one new step at the end.
        For any other step do one after the other.
        """
        longest = min(processing.STEP_RANGE[1], self.duration * (1.0 + 1e-6))  # so that two samples are left
        step = within("motion.name_dt", dt, processing.STEP_RANGE[0], longest, "s", "dt")
        source = self._note(f"resampled from {self.dt:g} s to {step:g} s")
        if parts := processing.whole_ratio(self.dt, step):
            return self._each(lambda a: processing.refine(a, parts), dt=self.dt / parts, source=source)
        if steps := processing.whole_ratio(step, self.dt):
            return self._each(lambda a: processing.coarsen(a, steps), dt=step, source=source)
        raise InputError("motion.resampling_ratio", "dt", step=step, dt=self.dt)

    def baseline_corrected(self, order: int = 1) -> Motion:
        """Return the motion less a polynomial of time, fitted to the velocity by least squares.

        The order is that of what is taken from the acceleration: 0 a constant, 1 a line, up to 5.
        """
        whole_within("order", order, 0, 5, field="order")
        source = f"baseline of order {order} removed"
        return self._each(lambda a: processing.without_baseline(a, self.dt, order), source=self._note(source))

    @classmethod
    def combine(
        cls, x: Motion, y: Motion | None = None, z: Motion | None = None, name: str | None = None
    ) -> Motion:
        """Make one motion of up to three read from a file each: the x of each becomes x, y and z.

        Lengths may differ by 1 %, as they do in published triples; the longer ones are cut at their end.

        Parameters
        ----------
        x, y, z : Motion
            Along the shaking, across it, up.
        name : str, optional
            Default: the name of ``x``.

        Raises
        ------
        InputError
            The time steps differ, or the lengths by more than 1 %; or they are of two events, stations or
            sensors, of one direction, or have the same samples. Where the files do not say, it is warned.
        """
        parts = {key: motion for key, motion in (("x", x), ("y", y), ("z", z)) if motion is not None}
        length, cut = one_record(parts)
        sources = "; ".join(f"{key}: {motion.name} ({motion.source})" for key, motion in parts.items())
        samples: dict[str, Any] = {key: motion.x[:length] for key, motion in parts.items()}
        labels = {key: motion.listing.labels["x"] if motion.listing else "" for key, motion in parts.items()}
        return cls(
            x.dt,
            **samples,
            name=x.name if name is None else name,
            synthetic=any(motion.synthetic for motion in parts.values()),
            source=f"{sources}{cut}",
            floor=x.floor,
            listing=x.listing and x.listing._replace(labels=labels),
        )

    @classmethod
    def from_obspy(
        cls,
        traces: Iterable[Any],
        unit: str,
        *,
        component: str | None = None,
        name: str | None = None,
        location: str | None = None,
        remove_mean: bool = False,
    ) -> Motion:
        """Make a motion of an ObsPy Stream (or of traces), for the formats that ObsPy reads.

        Parameters
        ----------
        traces : iterable of obspy.Trace
            One complete trace a channel, all of one station, one start and one time step.
        unit : str
            Unit of the traces' numbers as they stand; ``stats.calib`` is *not* applied.
        component, remove_mean
            As for `read_motion`.
        name : str, optional
            Default: network and station.
        location : str, optional
            Code of the sensor ("00"), where the station has several; "--" of the one without a code.

        Raises
        ------
        InputError
            Gaps, different starts or steps, several stations or sensors, an unknown unit or component, a mean
            that is gravity.
        """
        channels = channels_of_traces(traces, unit, name, location)
        check_horizontal(channels, component, refuse=False)
        motion = cls(**motion_fields(channels, component, f"ObsPy traces [{unit}]"))
        return processing.checked_record(motion, remove_mean=remove_mean)
