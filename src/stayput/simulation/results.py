"""The results of a case: histories and columns, with their units and meanings, for every table of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.measures.element import failures_of
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT
from stayput.simulation.outcome import Outcome

if TYPE_CHECKING:
    from numpy.typing import NDArray


HISTORIES: dict[str, tuple[str, str]] = {
    "slide": ("m", "displacement of the base relative to the floor, + right"),
    "slide_rate": ("m/s", "rate of the slide"),
    "tilt": ("rad", "rotation, + clockwise"),
    "tilt_rate": ("rad/s", "rate of the tilt"),
    "x": ("m", "centre of gravity right of where the middle of the base stood"),
    "z": ("m", "centre of gravity above the floor"),
}
"""Unit and meaning of each history."""

RESULTS: dict[str, tuple[str, str]] = {
    "overturn_time": ("s", "time at which the tilt reached 90°, or nan"),
    "peak_slide": ("m", "largest magnitude of the slide"),
    "residual_slide": ("m", "slide at the end"),
    "peak_tilt": ("rad", "largest magnitude of the tilt"),
    "residual_tilt": ("rad", "tilt at the end"),
    "device_failure_time": ("s", "time at which the first device failed, or nan"),
    "device_utilisation": ("", "largest force in a device over its strength; at least 1 where one failed"),
}
"""Unit and meaning of each result that is a quantity."""

COUNTS: dict[str, str] = {
    "floor_impacts": "landings on the floor",
    "wall_impacts": "hits on the walls and the ceiling",
    "device_failures": "devices that failed",
}
"""Meaning of each result that is a number of events."""


@dataclass(frozen=True, slots=True)
class ResultColumn:
    """A column of results."""

    name: str
    dtype: str
    unit: str
    meaning: str

    @property
    def attributes(self) -> dict[str, Any]:
        """What a dataset says of it; of the outcome also what its flags mean."""
        about: dict[str, Any] = {"long_name": self.meaning} | ({"units": self.unit} if self.unit else {})
        if self.name == "outcome":
            meanings = " ".join(outcome.replace(" ", "_") for outcome in OUTCOMES)
            about |= {"flag_values": np.arange(len(OUTCOMES), dtype=np.int8), "flag_meanings": meanings}
        return about


QUANTITIES = (
    ResultColumn("outcome", "i1", "", "what became of the body: the flag's place in flag_meanings"),
    ResultColumn("overturned", "?", "", "whether the tilt reached 90°"),
    *(ResultColumn(name, "f8", unit, meaning) for name, (unit, meaning) in RESULTS.items()),
    *(ResultColumn(name, "i4", "", meaning) for name, meaning in COUNTS.items()),
    ResultColumn("events", "i4", "", "all events"),
)
"""The columns of results."""

CASE_RESULT = np.dtype(
    [
        *((name, RESULT[name]) for name in RESULT.names or ()),
        ("device_failures", "i4"),
        ("device_failure_time", "f8"),  # of the first [s], NaN where none fails
        ("device_utilisation", "f8"),
    ],
    align=True,
)
"""Result of one case: the fields of `mechanics.columns.RESULT`, and a summary of its devices."""


def case_results(
    elements: NDArray[np.void], results: NDArray[np.void], devices: NDArray[np.void]
) -> NDArray[np.void]:
    """Return rows of `CASE_RESULT`, shape [m], from ELEMENT [m, n], RESULT [m] and DEVICE [m, n]."""
    rows, failures = np.zeros(len(results), CASE_RESULT), failures_of(elements, devices)
    for name in RESULT.names or ():
        rows[name] = results[name]
    rows["device_failures"] = failures.count
    rows["device_failure_time"] = failures.first
    rows["device_utilisation"] = failures.utilisation
    return rows


OUTCOMES = tuple(outcome.value for outcome in Outcome)
"""Names of the outcomes, in the order of the flags."""


def empty_columns(count: int) -> dict[str, NDArray[np.generic]]:
    """Return columns for the results of ``count`` cases, by name, to be filled."""
    return {column.name: np.zeros(count, column.dtype) for column in QUANTITIES}


def fill_columns(columns: dict[str, NDArray[np.generic]], start: int, results: NDArray[np.void]) -> None:
    """Write rows of `CASE_RESULT` into the columns, from ``start`` on."""
    place = slice(start, start + len(results))
    overturned = results["outcome"] == OVERTURNED_OUTCOME
    for name, column in columns.items():
        if name == "overturned":
            column[place] = overturned
        elif name == "overturn_time":
            column[place] = np.where(overturned, results["end"], np.nan)
        else:
            column[place] = results[name]
