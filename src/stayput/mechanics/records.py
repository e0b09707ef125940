"""What compiled functions pass on together: the floor's motion, settings, working memory, devices, output."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Excitation(NamedTuple):
    """The floor's motion: n samples, between which its acceleration is linear."""

    ax: NDArray[np.float64]
    """Acceleration, + right [m/s²], shape [n]."""
    az: NDArray[np.float64]
    """The same, + up."""
    dt: float
    """Time between samples [s]."""
    extremes: tuple[NDArray[np.float64], ...]
    """Smallest and largest ax, and az, over blocks of samples, by which rest is skipped."""


class SolverSettings(NamedTuple):
    """How a case is solved."""

    law: int
    """COULOMB or PAPER."""
    tolerance: float
    """Largest last term of the tilt's Taylor series in a step [rad]."""
    error: float
    """Largest error of a step with devices [m, rad]."""
    max_step: float
    """Longest step [s]."""
    max_events: int
    """Events after which a case is stopped and reported as failed."""


class Scratch(NamedTuple):
    """Working memory, filled for each case."""

    contacts: NDArray[np.void]
    """The contacts, CONTACT[8]."""
    rows: NDArray[np.void]
    """The closed contacts, ROW[8]."""


class CaseDevices(NamedTuple):
    """The devices of a case; None stands for a case without any."""

    elements: NDArray[np.void]
    """ELEMENT[e]."""
    links: NDArray[np.void]
    """Their present states, LINK[e]."""
    devices: NDArray[np.void]
    """Their results, DEVICE[e]."""
    work: np.void
    """Working memory, WORK."""
    spare: np.void
    """The same, for facets on trial."""


class BatchDevices(NamedTuple):
    """The devices of an array of cases; see `CaseDevices`."""

    elements: NDArray[np.void]
    """ELEMENT[m, e]."""
    links: NDArray[np.void]
    """LINK[e]."""
    devices: NDArray[np.void]
    """DEVICE[m, e]."""
    works: NDArray[np.void]
    """WORK[2]."""


class Output(NamedTuple):
    """What is recorded of a single case; each may be empty."""

    history: NDArray[np.float64]
    """The state at the samples reached, [n or 0, HISTORY]."""
    forces: NDArray[np.float64]
    """Forces of the devices at these samples [N/kg], [n or 0, e, FORCES]."""
    events: NDArray[np.float64]
    """The first events, [k, EVENT]."""
