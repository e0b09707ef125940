"""What the floors of a building do under one motion of the ground."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.building.histories import component_response, horizontal
from stayput.errors import InputError
from stayput.motion.integrals import peak_velocity
from stayput.motion.processing import refine

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    import xarray as xr
    from numpy.typing import NDArray

    from stayput.building.histories import Energy
    from stayput.building.model import ShearModel
    from stayput.motion.record import Motion


@dataclass(frozen=True, slots=True, eq=False)
class FloorResponse:
    """All floors of a building under one motion of the ground.

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
        return _motion_of(self.model, self.motion, storey, self.dt, rows)

    def to_dataset(self) -> xr.Dataset:
        """Return histories and peaks with units: ``acceleration_x`` over time and storey, ``drift_x``, ..."""
        import xarray as xr

        data = xr.Dataset(
            coords={
                "time": ("time", self.time, {"units": "s"}),
                "storey": (
                    "storey",
                    self.storeys,
                    {"long_name": "storey on the floor; the last is the roof"},
                ),
                "layer": (
                    "layer",
                    np.arange(1, len(self.model.masses) + 1),
                    {"long_name": "what lies below each mass, from the ground"},
                ),
            },
            attrs={
                "building": self.model.name,
                "motion": self.motion.name,
                "synthetic": int(self.motion.synthetic),
                "period": float(self.model.periods[0]),
                "nonlinear": int(self.model.yields),
            },
        )
        for key, dims, values, unit, meaning in self._variables():
            data[key] = (dims, values, {"units": unit, "long_name": meaning})
        return data

    def _variables(self) -> Iterator[tuple[str, tuple[str, ...], NDArray[np.float64], str, str]]:
        for name, a in self.acceleration.items():
            floors, layers = ("storey",), ("layer",)
            yield f"acceleration_{name}", ("time", "storey"), a, "m/s²", f"absolute acceleration, {name}"
            yield f"drift_{name}", ("time", "layer"), self.drift[name], "m", f"drift, {name}"
            acceleration, velocity = self.peak_acceleration(name), self.peak_velocity(name)
            yield f"peak_acceleration_{name}", floors, acceleration, "m/s²", f"peak acceleration, {name}"
            yield f"peak_velocity_{name}", floors, velocity, "m/s", f"peak absolute velocity, {name}"
            yield f"peak_drift_{name}", layers, self.peak_drift(name), "m", f"peak drift, {name}"

    def _of(self, table: dict[str, NDArray[np.float64]], component: str) -> NDArray[np.float64]:
        if component not in table:
            raise InputError(f"The component is {component!r}; this response has {', '.join(table)}.")
        return table[component]


def _motion_of(
    model: ShearModel, ground: Motion, storey: int, dt: float, rows: dict[str, NDArray[np.float64]]
) -> Motion:
    """Return a floor's motion from its horizontal accelerations and the ground's vertical one."""
    place = model.place(storey)
    note = f"computed: {place} of {model.name}, T1 = {model.periods[0]:.3g} s"
    z = None
    if ground.z is not None:
        factor = 1.0 + (model.vertical_amplification - 1.0) * (storey - 1) / model.storeys
        z = factor * refine(ground.z, round(ground.dt / dt))
    return replace(
        ground,
        dt=dt,
        x=rows["x"],
        y=rows.get("y"),
        z=z,
        name=f"{ground.name}, {place} of {model.name}".removeprefix(", "),
        source=f"{ground.source}; {note}".removeprefix("; "),
    )


def floor_motions_of(model: ShearModel, ground: Motion, storeys: Sequence[int]) -> tuple[Motion, ...]:
    """Return the floor motions of the wanted storeys, and compute no others."""
    for storey in storeys:
        model.place(storey)
    found = {name: component_response(model, a, ground.dt, storeys) for name, a in horizontal(ground).items()}
    dt = found["x"].dt
    return tuple(
        _motion_of(model, ground, storey, dt, {name: one.acceleration[:, i] for name, one in found.items()})
        for i, storey in enumerate(storeys)
    )


def respond(model: ShearModel, ground: Motion) -> FloorResponse:
    """Return what all floors do under a motion of the ground."""
    storeys = range(1, model.storeys + 2)
    found = {
        name: component_response(model, a, ground.dt, storeys, drifts=True)
        for name, a in horizontal(ground).items()
    }
    return FloorResponse(
        model,
        ground,
        found["x"].dt,
        {name: one.acceleration for name, one in found.items()},
        {name: one.drift for name, one in found.items()},
        {name: one.energy for name, one in found.items() if one.energy is not None},
    )
