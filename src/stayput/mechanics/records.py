"""What compiled functions pass on together; the floor's motion between samples, and the history at them."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from stayput.compiling import inline, inner
from stayput.mechanics import columns as col
from stayput.mechanics.geometry import slide_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Excitation(NamedTuple):
    """The floor's motion: n samples, between which its acceleration is linear.

    Attributes
    ----------
    ax : ndarray
        Acceleration, + right [m/s²], shape [n].
    az : ndarray
        The same, + up.
    dt : float
        Time between samples [s].
    extremes : tuple of ndarray
        Smallest and largest ax, and az, over blocks of samples, by which rest is skipped.
    """

    ax: NDArray[np.float64]
    az: NDArray[np.float64]
    dt: float
    extremes: tuple[NDArray[np.float64], ...]


class SolverSettings(NamedTuple):
    """How a case is solved.

    Attributes
    ----------
    law : int
        COULOMB or PAPER.
    tolerance : float
        Largest last term of the tilt's Taylor series in a step [rad].
    error : float
        Largest error of a step with devices [m, rad].
    max_step : float
        Longest step [s].
    max_events : int
        Events after which a case is stopped and reported as failed.
    """

    law: int
    tolerance: float
    error: float
    max_step: float
    max_events: int


class Scratch(NamedTuple):
    """Working memory, filled for each case.

    Attributes
    ----------
    contacts : ndarray
        The contacts, CONTACT[8].
    rows : ndarray
        The closed contacts, ROW[8].
    """

    contacts: NDArray[np.void]
    rows: NDArray[np.void]


class CaseDevices(NamedTuple):
    """The devices of a case; None stands for a case without any.

    Attributes
    ----------
    elements : ndarray
        ELEMENT[e].
    links : ndarray
        Their present states, LINK[e].
    devices : ndarray
        Their results, DEVICE[e].
    work : record
        Working memory, WORK.
    spare : record
        The same, for facets on trial.
    """

    elements: NDArray[np.void]
    links: NDArray[np.void]
    devices: NDArray[np.void]
    work: np.void
    spare: np.void


class BatchDevices(NamedTuple):
    """The devices of an array of cases; see `CaseDevices`.

    Attributes
    ----------
    elements : ndarray
        ELEMENT[m, e].
    links : ndarray
        LINK[e].
    devices : ndarray
        DEVICE[m, e].
    works : ndarray
        WORK[2].
    """

    elements: NDArray[np.void]
    links: NDArray[np.void]
    devices: NDArray[np.void]
    works: NDArray[np.void]


class Output(NamedTuple):
    """What is recorded of a single case; each may be empty.

    Attributes
    ----------
    history : ndarray
        The state at the samples reached, [n or 0, HISTORY].
    forces : ndarray
        Forces of the devices at these samples [N/kg], [n or 0, e, FORCES].
    events : ndarray
        The first events, [k, EVENT].
    """

    history: NDArray[np.float64]
    forces: NDArray[np.float64]
    events: NDArray[np.float64]


@inline
def loads(case, ax, az, per_second, k, tau):
    """Floor acceleration and g + z̈_G at a time tau after sample k, with their rates.

    ``per_second`` is the scale factor of the motion divided by the time step [1/s].
    """
    a_rate = per_second * (ax[k + 1] - ax[k])
    G_rate = per_second * (az[k + 1] - az[k])
    return case.scale * ax[k] + a_rate * tau, a_rate, case.gravity + case.scale * az[k] + G_rate * tau, G_rate


@inline
def lowest_product(p, low, high):
    """Minimum of p × value over values between low and high, as of a load within a block of the record."""
    return p * low if p >= 0.0 else p * high


@inner
def public_mode(s):
    """Public mode (`stayput.Mode`) of the state."""
    on_floor = s.closed & col.FLOOR_BITS
    if s.kind == col.REST:
        return col.REST_MODE if on_floor == col.FLOOR_BITS else col.LEAN_MODE
    if not on_floor:
        return col.FLIGHT_MODE
    if s.kind == col.SLIDE:
        return col.SLIDE_MODE
    if s.kind == col.ROCK:
        return col.ROCK_MODE
    if s.kind == col.SLIDE_ROCK:
        return col.SLIDE_ROCK_MODE
    return col.FLIGHT_MODE if s.kind == col.FLIGHT else col.LEAN_MODE


@inner
def record_sample(history, case, s):
    """Write the state into the history's row of sample k, unless no history is kept."""
    if history.shape[0] == 0:
        return
    row = history[s.k]
    row[col.H_X], row[col.H_Z], row[col.H_TILT], row[col.H_TILT_RATE] = s.x, s.z, s.theta - s.rest, s.omega
    row[col.H_SLIDE], row[col.H_SLIDE_RATE] = slide_of(case, s)
    row[col.H_MODE], row[col.H_REACHED] = public_mode(s), 1.0


@inline
def advance_clock(s, h, dt):
    """Advance the clock by a step that ends no later than the next sample; True at the sample."""
    if s.tau + h >= dt * (1.0 - 1e-14):  # rounding must not leave a sliver of a step before the sample
        s.k += 1
        s.tau = 0.0
        return True
    s.tau += h
    return False
