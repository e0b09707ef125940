"""`FloorResponse` and `FloorPeaks`: what the floors of a building do under motions of the ground."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from stayput.errors import word_of
from stayput.motion.processing import peak_velocity
from stayput.wording import check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.building.model import ShearModel
    from stayput.building.superposition import Energy
    from stayput.motion.record import Motion

FloorDrawing = Literal["acceleration", "velocity", "spectra"]
"""What `FloorResponse.plot` draws: peaks over the storeys, or floor spectra."""


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class FloorResponse:
    """Response of all floors of a building to one motion of the ground.

    Parameters
    ----------
    model : ShearModel
        The building.
    motion : Motion
        The ground's motion.
    dt : float
        Time step of the histories [s]: the motion's, or a whole part of it.
    acceleration : dict of str to ndarray, shape (n, storeys + 1)
        Absolute acceleration under the furniture of each storey, then of the roof, for each horizontal
        component [m/s²].
    drift : dict of str to ndarray, shape (n, masses)
        Drift of what lies below each mass [m].
    energy : dict of str to Energy
        Energies for each component where storeys may yield; else empty.
    """

    model: ShearModel
    motion: Motion
    dt: float
    acceleration: dict[str, NDArray[np.float64]]
    drift: dict[str, NDArray[np.float64]]
    energy: dict[str, Energy]

    def __repr__(self) -> str:
        peaks = ", ".join(f"{name} {self.peak_acceleration(name)[-1]:.3g}" for name in self.acceleration)
        return f"FloorResponse({self.model.name!r}, {self.motion.name!r}, peaks of the roof [m/s²]: {peaks})"

    def plot(
        self,
        ax: Axes | None = None,
        *,
        what: FloorDrawing = "acceleration",
        storeys: Sequence[int] | None = None,
        language: str = "en",
    ) -> Axes:
        """Draw the floors' peaks over the storeys, or floor spectra of x, on axes.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"acceleration", "velocity", "spectra"}
            Peak acceleration beside the ground's times 1 + 2z/h, peak velocity, or spectra at 5 % damping.
        storeys : sequence of int, optional
            Floors whose spectra are drawn; default one in the middle, and the roof.
        language : str
            Language of the texts, "en" or "ja".

        Raises
        ------
        InputError
            Something else to draw, or a storey that the building has not.
        """
        from stayput.report.building import draw_floors
        from stayput.report.figures import plotted

        return plotted(ax, draw_floors, self, what, storeys, check_language(language))

    def figure(
        self, title: str = "", *, storeys: Sequence[int] | None = None, language: str = "en"
    ) -> Figure:
        """Return a figure with the floors' peaks over the storeys, and floor spectra."""
        from stayput.report.building import plot_building

        return plot_building(self, None, storeys, title=title, language=check_language(language))

    @property
    def storeys(self) -> NDArray[np.int64]:
        """1, 2, ... up to the roof, shape (storeys + 1,)."""
        return np.arange(1, self.model.storeys + 2)

    @property
    def time(self) -> NDArray[np.float64]:
        """Times of the histories [s], shape (n,)."""
        return np.arange(len(self.acceleration["x"]), dtype=np.float64) * self.dt

    def peak_acceleration(self, component: str = "x") -> NDArray[np.float64]:
        """Return the largest magnitude of each floor's absolute acceleration [m/s²], shape (storeys + 1,)."""
        return np.abs(self._of(self.acceleration, component)).max(axis=0)

    def peak_velocity(self, component: str = "x") -> NDArray[np.float64]:
        """Return the largest magnitude of each floor's absolute velocity [m/s], shape (storeys + 1,)."""
        columns = self._of(self.acceleration, component).T
        return np.array([peak_velocity(np.ascontiguousarray(a), self.dt) for a in columns])

    def peak_drift(self, component: str = "x") -> NDArray[np.float64]:
        """Return the largest magnitude of the drift below each mass [m], shape (masses,)."""
        return np.abs(self._of(self.drift, component)).max(axis=0)

    def floor(self, storey: int) -> Motion:
        """Return the motion under the furniture of a storey (the roof's is that of the storeys + 1)."""
        self.model.place(storey)
        rows = {name: a[:, int(storey) - 1] for name, a in self.acceleration.items()}
        return self.model.motion_of(self.motion, storey, self.dt, rows)

    def _of(self, table: dict[str, NDArray[np.float64]], component: str) -> NDArray[np.float64]:
        return table[word_of("motion.the_component", component, table, "component")]


@dataclass(frozen=True, slots=True, eq=False)
class FloorPeaks:
    """Peaks of all floors under many motions.

    Parameters
    ----------
    storeys : ndarray, shape (storeys + 1,)
        1, 2, ...; the last is the roof.
    acceleration : ndarray, shape (motions, storeys + 1)
        Largest magnitude of the absolute acceleration [m/s²].
    velocity : ndarray, shape (motions, storeys + 1)
        Largest magnitude of the absolute velocity, between the samples too [m/s].
    """

    storeys: NDArray[np.int64]
    acceleration: NDArray[np.float64]
    velocity: NDArray[np.float64]
