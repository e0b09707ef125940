"""`ShearModel`: a building as masses on storeys that shear."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from stayput.building.modes import Modes, natural_modes
from stayput.errors import InputError, within

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from numpy.typing import NDArray

    from stayput.building.many import FloorPeaks
    from stayput.building.response import FloorResponse
    from stayput.motion import Motion

MOST_STOREYS = 200
"""Most masses that are accepted."""


@dataclass(frozen=True)
class ShearModel:
    """Masses, one above the other, each on a storey that shears; the ground moves under the lowest.

    Storey 1 stands on the ground, storey n on mass n − 1, and the highest mass is the roof. Where
    ``isolated`` is true the lowest stiffness is a layer of isolators without a storey of its own: storey 1
    stands on the lowest mass, storey n on mass n.

    Parameters
    ----------
    masses : sequence of float
        Of the floors [kg], bottom to top, without the ground.
    stiffnesses : sequence of float
        Shear stiffness of the storey below each [N/m].
    damping : float or sequence of float
        Damping ratio of every mode, or one for each mode, the slowest first.
    yield_shears : sequence of float, optional
        Shear at which each storey yields [N]. With it every answer is that of the nonlinear building;
        without it that of the linear one.
    post_yield : float or sequence of float
        Ratio of a storey's stiffness after yielding to that before it: one, or one for each storey.
    isolated : bool
        Whether the lowest stiffness is a layer of isolators.
    vertical_amplification : float
        Factor on the vertical motion at the roof; it grows linearly from 1 at storey 1. The default 1
        passes it through.
    name : str
        What the building is called.

    Raises
    ------
    InputError
        A value out of range, or lists of different lengths.
    """

    masses: Sequence[float]
    stiffnesses: Sequence[float]
    damping: float | Sequence[float]
    yield_shears: Sequence[float] | None = None
    post_yield: float | Sequence[float] = 0.05
    isolated: bool = False
    vertical_amplification: float = 1.0
    name: str = ""

    def __post_init__(self) -> None:
        masses = self._row("masses", self.masses, 1e-3, 1e12, "kg")
        if not int(self.isolated) < len(masses) <= MOST_STOREYS:
            least = 1 + int(self.isolated)
            raise InputError(f"ShearModel has {len(masses)} masses; it must have {least} to {MOST_STOREYS}.")
        self._row("stiffnesses", self.stiffnesses, 1e-9, 1e18, "N/m")
        self._row("damping", self.damping, 0.0, 0.9)
        self._row("post_yield", self.post_yield, 0.0, 0.95)
        if self.yield_shears is not None:
            self._row("yield_shears", self.yield_shears, 1e-6, 1e18, "N")
        within("Vertical amplification", self.vertical_amplification, 0.0, 10.0)
        if not self.name:
            object.__setattr__(self, "name", f"{len(masses)}-mass shear model")

    def _row(
        self, field: str, given: float | Sequence[float], low: float, high: float, unit: str = ""
    ) -> tuple[float, ...]:
        """Check a field and keep it as a tuple of floats, one for each mass."""
        count = len(tuple(self.masses))
        values = (given,) * count if isinstance(given, int | float) else tuple(given)
        if len(values) != count:
            raise InputError(
                f"ShearModel {field} has {len(values)} values; it must have {count}, one a mass."
            )
        row = tuple(within(f"ShearModel {field}", value, low, high, unit) for value in values)
        object.__setattr__(self, field, row)
        return row

    @property
    def storeys(self) -> int:
        """Number of storeys; the roof is storey ``storeys`` + 1."""
        return len(self.masses) - int(self.isolated)

    @property
    def yields(self) -> bool:
        """Whether the storeys yield."""
        return self.yield_shears is not None

    @cached_property
    def modes(self) -> Modes:
        """The natural modes, before yielding."""
        return natural_modes(np.array(self.masses), np.array(self.stiffnesses))

    @property
    def periods(self) -> NDArray[np.float64]:
        """Natural periods [s], shape (number of masses,), the longest first."""
        return self.modes.periods

    def place(self, storey: int) -> str:
        """Return what a storey's floor is called: "storey 5", or "roof".

        Raises
        ------
        InputError
            No such storey.
        """
        if storey not in range(1, self.storeys + 2):
            raise InputError(
                f"The storey is {storey!r}; it must be a whole number from 1 to {self.storeys}, "
                f"or {self.storeys + 1} for the roof."
            )
        return "roof" if storey == self.storeys + 1 else f"storey {int(storey)}"

    def respond(self, motion: Motion) -> FloorResponse:
        """Return what all floors do when the ground moves.

        Parameters
        ----------
        motion : Motion
            The ground's motion; x and y act on the same model, each for itself.
        """
        from stayput.building.response import respond  # Numba takes its time to load

        return respond(self, motion)

    def floor_motion(self, motion: Motion, storey: int) -> Motion:
        """Return the motion of the floor on which the furniture of a storey stands.

        Parameters
        ----------
        motion : Motion
            The ground's motion.
        storey : int
            From 1; the roof is the number of storeys + 1.
        """
        from stayput.building.response import floor_motions_of

        return floor_motions_of(self, motion, (storey,))[0]

    def floor_motions(
        self, motions: Iterable[Motion], storeys: Sequence[int], *, threads: int | None = None
    ) -> Iterator[tuple[Motion, ...]]:
        """Give, motion by motion in their order, the floor motions of the wanted storeys.

        A few motions are under way at a time, so that memory does not grow with their number.

        Parameters
        ----------
        motions : iterable of Motion
            The ground's motions.
        storeys : sequence of int
            The wanted storeys.
        threads : int, optional
            Threads; as many as there are cores by default. The bits do not depend on them.
        """
        from stayput.building.many import floor_motions

        return floor_motions(self, motions, storeys, threads)

    def floor_peaks(
        self, motions: Iterable[Motion], *, component: str = "x", threads: int | None = None
    ) -> FloorPeaks:
        """Return the peaks of all floors under many motions, without keeping the histories.

        Parameters
        ----------
        motions : iterable of Motion
            The ground's motions.
        component : str
            "x" or "y".
        threads : int, optional
            Threads; as many as there are cores by default. The bits do not depend on them.
        """
        from stayput.building.many import floor_peaks

        return floor_peaks(self, motions, component, threads)
