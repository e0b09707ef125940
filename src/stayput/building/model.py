"""`ShearModel`: a building as masses on storeys that shear, its modes, and the response of its floors.

Stiffnesses by Japanese seismic design, with storey shears of the Building Standard Law of Japan, enforcement
order, article 88, and notification 1793 of 1980.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from numbers import Real
from typing import TYPE_CHECKING, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from stayput.building.response import FloorPeaks, FloorResponse
from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, not_allowed, whole_within, within, word_of
from stayput.execution import Pool
from stayput.model.parameters import parameter, parameters, quantity
from stayput.motion.floors import of_the_ground
from stayput.motion.processing import refine
from stayput.motion.record import Motion
from stayput.motion.suites.suite import Suite
from stayput.wording import check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.building.superposition import Histories


STEPS_IN_A_PERIOD = 10.0
"""Fewest steps in a period of the modes that matter; lines through such samples of a sine cut off ≤ 5 %."""

MASS_THAT_MATTERS = 0.95
"""Share of the mass that the modes that matter move together."""


@dataclass(frozen=True, slots=True, eq=False)
class Modes:
    """Modes of K φ = ω² M φ with φᵀMφ = 1, the slowest first.

    Parameters
    ----------
    omega : ndarray, shape (n,)
        Natural circular frequencies ω [rad/s].
    shapes : ndarray, shape (n, n)
        φ: a row for each mass, bottom to top, a column for each mode [1/√kg].
    participation : ndarray, shape (n,)
        Γ = φᵀM1 [√kg]; the signs of the modes are such that none is negative.
    """

    omega: NDArray[np.float64]
    shapes: NDArray[np.float64]
    participation: NDArray[np.float64]

    @property
    def periods(self) -> NDArray[np.float64]:
        """Natural periods [s], shape (n,), the longest first."""
        return 2.0 * math.pi / self.omega

    @property
    def effective_mass(self) -> NDArray[np.float64]:
        """Share of the whole mass that each mode moves, Γ²/ΣM, shape (n,); the sum is 1."""
        square = self.participation**2
        return square / square.sum()

    @property
    def drifts(self) -> NDArray[np.float64]:
        """Drift of each storey in each mode, φᵢ − φᵢ₋₁ [1/√kg], shape (n, n)."""
        return np.diff(self.shapes, axis=0, prepend=0.0)


def natural_modes(masses: NDArray[np.float64], stiffnesses: NDArray[np.float64]) -> Modes:
    """Return the modes of masses [kg] on storeys of given stiffness [N/m], both shape (n,), bottom to top.

    M^(−1/2) K M^(−1/2) is tridiagonal, and its solver calls no threaded library: the same bits every time.
    """
    from scipy.linalg import eigh_tridiagonal  # pyright: ignore[reportUnknownVariableType]

    root = np.sqrt(masses)
    diagonal = (stiffnesses + np.append(stiffnesses[1:], 0.0)) / masses
    beside = -stiffnesses[1:] / (root[1:] * root[:-1])
    squares, vectors = diagonal, np.ones((1, 1))
    if len(masses) > 1:
        squares, vectors = cast("tuple[NDArray[np.float64], ...]", eigh_tridiagonal(diagonal, beside))
    shapes = vectors / root[:, None]
    gamma = (masses[:, None] * shapes).sum(axis=0)
    sign = np.where(gamma < 0.0, -1.0, 1.0)
    return Modes(np.sqrt(squares), np.ascontiguousarray(shapes * sign), gamma * sign)


def strain_energy_damping(
    modes: Modes, stiffnesses: NDArray[np.float64], ratios: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the damping ratio of each mode: the storeys' ratios, weighted by their strain energies.

    ζⱼ = Σₛ ζₛ Eₛⱼ / Σₛ Eₛⱼ with Eₛⱼ = ½ kₛ (φₛⱼ − φₛ₋₁,ⱼ)² (composite damping).

    Parameters
    ----------
    modes : Modes
        The modes.
    stiffnesses : ndarray, shape (n,)
        Of the storeys [N/m], bottom to top.
    ratios : ndarray, shape (n,)
        Damping ratio of each storey.
    """
    energy = stiffnesses[:, None] * modes.drifts**2
    return (ratios[:, None] * energy).sum(axis=0) / energy.sum(axis=0)


def parts_of_step(modes: Modes, dt: float) -> int:
    """Return into how many parts to divide a record's step, so that the floors' motion is well sampled.

    The solution is exact at any step, but a floor's motion is taken as linear between its samples from then
    on. Counted are the slowest modes that together move `MASS_THAT_MATTERS` of the mass. Modes faster than
    two of the record's steps (its Nyquist frequency) are not, as the record does not contain their motion.
    """
    share = np.cumsum(modes.effective_mass)
    shortest = float(modes.periods[min(int(np.searchsorted(share, MASS_THAT_MATTERS)), len(share) - 1)])
    return max(1, math.ceil(STEPS_IN_A_PERIOD * dt / max(shortest, 2.0 * dt) - 1e-9))


CORNER_PERIOD = 0.6
"""Period from which the spectral factor falls, medium ground (default, low confidence) [s]."""


def weight_above(masses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the mass that each storey carries [kg], shape (n,), bottom to top."""
    return np.cumsum(masses[::-1])[::-1]


def ai_distribution(masses: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Return Ai = 1 + (1/√αi − αi)·2T/(1 + 3T), αi the share of the weight that storey i carries.

    Parameters
    ----------
    masses : ndarray, shape (n,)
        Of the floors above the storeys [kg], bottom to top.
    period : float
        T, the building's fundamental period [s].

    Returns
    -------
    ndarray, shape (n,)
        1 at the lowest storey.
    """
    above = weight_above(masses)
    alpha = above / above[0]
    return 1.0 + (1.0 / np.sqrt(alpha) - alpha) * 2.0 * period / (1.0 + 3.0 * period)


def spectral_factor(period: float) -> float:
    """Return Rt, which reduces the shears of a slow building: 1, then a parabola, then 1.6 Tc/T."""
    ratio = period / CORNER_PERIOD
    if ratio < 1.0:
        return 1.0
    return 1.0 - 0.2 * (ratio - 1.0) ** 2 if ratio < 2.0 else 1.6 / ratio


def storey_stiffnesses(masses: NDArray[np.float64], period: float) -> NDArray[np.float64]:
    """Return the stiffnesses [N/m], shape (n,), under which Ai's shears give every storey the same drift.

    They are scaled so that the first natural period is ``period``.
    """
    shape = ai_distribution(masses, period) * weight_above(masses)
    omega = float(natural_modes(masses, shape).omega[0])
    return shape * (2.0 * math.pi / period / omega) ** 2


Shaken = TypeVar("Shaken", Motion, Suite)

MOST_STOREYS = 200
"""Most masses that are accepted."""

AMPLIFICATION_RANGE = (0.0, 10.0)
"""Smallest and largest factor on the vertical motion at the roof that is accepted."""


class ShakenFloors:
    """What the floors of a building do under motions of the ground, by its shear model."""

    @cached_property
    def model(self) -> ShearModel:
        """The building as masses and stiffnesses."""
        raise NotImplementedError

    def plot(self, ax: Axes | None = None, *, modes: int = 3, language: str = "en") -> Axes:
        """Draw the slowest mode shapes over the height, times their participation factors.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        modes : int
            How many, where the building has them.
        language : str
            Language of the texts, "en" or "ja".
        """
        from stayput.report.building import draw_modes
        from stayput.report.figures import plotted

        number = whole_within("building.modes", modes, 1, MOST_STOREYS, "", "modes")
        return plotted(ax, draw_modes, self.model, number, check_language(language))

    def respond(self, motion: Motion) -> FloorResponse:
        """Return the response of all floors to a motion of the ground.

        Parameters
        ----------
        motion : Motion
            The ground's motion; x and y act on the same model, each for itself.
        """
        ground, model = _ground(motion), self.model
        storeys = range(1, model.storeys + 2)
        histories = {
            name: model.histories(a, ground.dt, storeys, drifts=True) for name, a in ground.horizontal.items()
        }
        return FloorResponse(
            model,
            ground,
            histories["x"].dt,
            {name: component.acceleration for name, component in histories.items()},
            {name: component.drift for name, component in histories.items()},
            {name: component.energy for name, component in histories.items() if component.energy is not None},
        )

    def floor_motion(self, motion: Shaken, storey: int) -> Shaken:
        """Return the motion of the floor on which the furniture of a storey stands; a suite's, as a suite.

        Parameters
        ----------
        motion : Motion or Suite
            The ground's motion, or motions.
        storey : int
            From 1; the roof is the number of storeys + 1.
        """
        grounds = motion if isinstance(motion, Suite) else [motion]
        floors = tuple(floor for (floor,) in self.floor_motions(grounds, (storey,)))
        if isinstance(motion, Suite):
            return replace(motion, motions=floors)
        return floors[0]

    def floor_motions(
        self, motions: Iterable[Motion], storeys: Sequence[int], *, threads: int | None = None
    ) -> Iterator[tuple[Motion, ...]]:
        """Give, motion by motion in their order, the floor motions of the wanted storeys.

        A few motions are computed at a time, so that memory does not grow with their number.

        Parameters
        ----------
        motions : iterable of Motion
            The ground's motions.
        storeys : sequence of int
            The wanted storeys.
        threads : int, optional
            Threads; as many as there are cores by default. The bits do not depend on them.
        """
        wanted, model = tuple(storeys), self.model
        for storey in wanted:
            model.place(storey)

        def floors() -> Iterator[tuple[Motion, ...]]:
            _ = model.modes  # once, not in every thread
            with Pool(threads) as pool:
                yield from pool.in_order(partial(model.floors_of, _ground(m), wanted) for m in motions)

        return floors()

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
        storeys = range(1, self.model.storeys + 2)

        def alone(motion: Motion) -> Motion:
            word_of("motion.the_component", component, _ground(motion).horizontal, "component")
            return motion.component(component)

        floors = self.floor_motions(map(alone, motions), storeys, threads=threads)
        pairs = [[(floor.pga, floor.pgv) for floor in each] for each in floors]
        peaks = np.array(pairs).reshape(-1, len(storeys), 2)
        return FloorPeaks(np.array(storeys), peaks[..., 0], peaks[..., 1])


@dataclass(frozen=True, repr=False)
class ShearModel(ShakenFloors):
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

    Examples
    --------
    >>> import stayput as sp
    >>> frame = sp.ShearModel(masses=[2e5, 2e5], stiffnesses=[2e8, 1.5e8], damping=0.03)
    >>> frame.floor_motion(sp.near_fault(), 2).pga > sp.near_fault().pga
    True
    """

    masses: Sequence[float] = field(
        metadata=quantity("kg", 1e-3, 1e12, ("ShearModel masses", "せん断モデルの質量"))
    )
    stiffnesses: Sequence[float] = field(
        metadata=quantity("N/m", 1e-9, 1e18, ("ShearModel stiffnesses", "せん断モデルの剛性"))
    )
    damping: float | Sequence[float] = field(
        metadata=quantity("", 0.0, 0.9, ("ShearModel damping", "せん断モデルの減衰定数"))
    )
    yield_shears: Sequence[float] | None = parameter(
        None, "N", 1e-6, 1e18, ("ShearModel yield_shears", "せん断モデルの降伏せん断力")
    )
    post_yield: float | Sequence[float] = parameter(
        0.05, "", 0.0, 0.95, ("ShearModel post_yield", "せん断モデルの降伏後の剛性比")
    )
    isolated: bool = False
    vertical_amplification: float = parameter(
        1.0, "", *AMPLIFICATION_RANGE, ("Vertical amplification", "上下動の増幅率")
    )
    name: str = ""

    def __repr__(self) -> str:
        return f"ShearModel({self.name!r}, {len(self.masses)} masses, T1 = {self.modes.periods[0]:.3g} s)"

    def __post_init__(self) -> None:
        instance_of("isolated", self.isolated, bool)
        wanted = len(list_of("masses", self.masses))
        within("building.masses", wanted, 1 + int(self.isolated), MOST_STOREYS, "", "masses")
        for about in parameters(ShearModel):
            name, value = about.name, getattr(self, about.name)
            if name == "vertical_amplification":
                about.check(value)
            elif value is not None:  # one for each mass
                number = isinstance(value, Real) and name != "masses"
                values = (value,) * wanted if number else list_of(name, value)
                if (count := len(values)) != wanted:
                    raise InputError(
                        "common.so_many_values", name, name=about.label, count=count, wanted=wanted
                    )
                object.__setattr__(self, name, tuple(map(about.check, values)))
        if not self.name:
            object.__setattr__(self, "name", f"{wanted}-mass shear model")

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
            raise not_allowed(
                "storey", repr(storey), phrase("scenario.roof", roof=self.storeys + 1), "storey"
            )
        return "roof" if storey == self.storeys + 1 else f"storey {int(storey)}"

    @cached_property
    def model(self) -> ShearModel:
        """Itself."""
        return self

    def histories(
        self, a: NDArray[np.float64], dt: float, storeys: Sequence[int], *, drifts: bool = False
    ) -> Histories:
        """Return the histories of storeys under one component of the ground's motion."""
        from stayput.building.superposition import component_response  # Numba takes its time to load

        # Storey 1 stands on the ground, −1, or above a layer of isolators on the lowest mass, 0.
        floors = [int(storey) - 2 + int(self.isolated) for storey in storeys]
        return component_response(self, a, dt, floors, drifts=drifts)

    def floors_of(self, ground: Motion, storeys: Sequence[int]) -> tuple[Motion, ...]:
        """Return the floor motions of the wanted storeys, and compute no others."""
        histories = {name: self.histories(a, ground.dt, storeys) for name, a in ground.horizontal.items()}
        return tuple(
            self.motion_of(
                ground,
                storey,
                histories["x"].dt,
                {name: component.acceleration[:, i] for name, component in histories.items()},
            )
            for i, storey in enumerate(storeys)
        )

    def motion_of(
        self, ground: Motion, storey: int, dt: float, rows: dict[str, NDArray[np.float64]]
    ) -> Motion:
        """Return a floor's motion from its horizontal accelerations and the ground's vertical one."""
        place = self.place(storey)
        note = f"computed: {place} of {self.name}, T1 = {self.periods[0]:.3g} s"
        z = None
        if ground.z is not None:
            factor = 1.0 + (self.vertical_amplification - 1.0) * (storey - 1) / self.storeys
            z = factor * refine(ground.z, round(ground.dt / dt))
        return replace(
            ground,
            dt=dt,
            x=rows["x"],
            y=rows.get("y"),
            z=z,
            name=f"{ground.name}, {place} of {self.name}".removeprefix(", "),
            source=f"{ground.source}; {note}".removeprefix("; "),
            floor=place if storey > 1 else ground.floor,
        )


def _ground(motion: Motion) -> Motion:
    """Return the motion; refuse one that is not of the ground."""
    return of_the_ground(Motion.given(motion), "building")
