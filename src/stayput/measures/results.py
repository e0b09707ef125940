"""What became of devices: peak forces, failures and how much of their strength was used."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.mechanics.devices.columns import (
    DRAWN_OUT,
    DROPPED_OUT,
    F_NORMAL,
    F_TANGENT,
    HOLDS,
    NONE,
    NORMAL,
    PULLED,
    PUSHED,
    SHEARED,
    TANGENT,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.measures.element import Element
    from stayput.measures.measure import Held

CAUSES: dict[int, str | None] = {
    HOLDS: None,
    PULLED: "pulled off",
    PUSHED: "pushed in",
    SHEARED: "sheared off",
    DRAWN_OUT: "drawn out",
    DROPPED_OUT: "dropped out",
}
"""Why a device failed, by the mechanics' numbers; None: it holds."""


@dataclass(frozen=True, slots=True, eq=False)
class DeviceResult:
    """What became of one device, which is one element of a measure.

    Attributes
    ----------
    kind : str
        The measure that it belongs to.
    label : tuple of str
        What it is called, in English and Japanese.
    place : str
        Tells it from others of the same measure: "front".
    peak_pull, peak_push, peak_shear : float
        Largest forces at any time [N].
    utilisation : float
        Largest peak force over its strength; at least 1 where it failed, 0 where it has no strength to reach.
    failed : bool
        Whether it is gone for good.
    failure_time : float
        When it failed [s], or nan.
    cause : str or None
        Why it failed.
    pull, shear : ndarray of float64, shape [samples]
        Forces along its normal, + where it pulls, and along its tangent, at the samples of the run [N].
    weakest : Phrase or None
        What gave way, or what would first where it holds: "the screws pull out of the plasterboard"; None
        where nothing can.
    member : int or None
        The number of the piece that it holds, in an assembly; None of a joint.
    between : tuple of int or None
        The numbers of the bodies that a joint joins.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt
    >>> room = sp.Room(left_wall=sp.Wall(0.02))
    >>> run = sp.simulate(sp.Body(0.3, 1.8, 90.0), room, sp.near_fault(), [Belt()])
    >>> device = run.devices[0]
    >>> device.label[0], device.failed, device.peak_pull > 0.0
    ('Belts', False, True)
    """

    kind: str
    label: tuple[str, str]
    place: str
    peak_pull: float
    peak_push: float
    peak_shear: float
    utilisation: float
    failed: bool
    failure_time: float
    cause: str | None
    pull: NDArray[np.float64]
    shear: NDArray[np.float64]
    weakest: Phrase | None = None
    member: int | None = None
    between: tuple[int, int] | None = None


def utilisation(elements: NDArray[np.void], devices: NDArray[np.void]) -> NDArray[np.float64]:
    """Return the largest peak force over its strength, of any shape; at least 1 where a device failed.

    Parameters
    ----------
    elements : ndarray of ELEMENT
        The devices.
    devices : ndarray of DEVICE
        What became of them.
    """
    shear = np.minimum(elements["limit_plus"][..., TANGENT], elements["limit_minus"][..., TANGENT])
    pairs = (
        (devices["peak_pull"], elements["limit_plus"][..., NORMAL]),
        (devices["peak_push"], elements["limit_minus"][..., NORMAL]),
        (devices["peak_shear"], shear),
    )
    used = np.zeros(devices.shape)
    for peak, strength in pairs:
        used = np.maximum(used, np.divide(peak, strength, out=np.zeros_like(used), where=strength > 0.0))
    return np.where(devices["failure"] != HOLDS, np.maximum(used, 1.0), used)


def weakest(element: Element, devices: NDArray[np.void]) -> Phrase | None:
    """Return what gave way most often in runs with a device, or where it held, what was used most.

    Parameters
    ----------
    element : Element
        The device.
    devices : ndarray of DEVICE, shape [m]
        What became of it; forces of any one unit.
    """
    failed = devices[devices["failure"] != HOLDS]
    counted = failed if failed.size else devices
    dropped = np.count_nonzero(counted["failure"] == DROPPED_OUT)
    if 2 * dropped > counted.size:
        return phrase("measures.drops_out")
    normal, tangent = element.normal, element.tangent
    along = np.maximum(counted["peak_pull"] / normal.limit_plus, counted["peak_push"] / normal.limit_minus)
    across = counted["peak_shear"] / min(tangent.limit_plus, tangent.limit_minus)
    line = tangent if 2 * np.count_nonzero(across > along) > counted.size else normal
    return line.weakest


@dataclass(frozen=True, slots=True, eq=False)
class Failures:
    """The devices of cases together, shape [m] each.

    Attributes
    ----------
    count : ndarray of int32
        Devices that failed.
    first : ndarray of float64
        When the first one failed [s], or nan.
    utilisation : ndarray of float64
        Largest utilisation; 0 without devices.
    """

    count: NDArray[np.int32]
    first: NDArray[np.float64]
    utilisation: NDArray[np.float64]


def failures_of(elements: NDArray[np.void], devices: NDArray[np.void]) -> Failures:
    """Sum up the devices of cases, shape [m, n]."""
    failed = (devices["failure"] != HOLDS) & (elements["kind"] != NONE)
    times = np.where(failed, devices["failure_time"], math.inf)
    first = times.min(axis=-1, initial=math.inf)
    used = np.where(elements["kind"] != NONE, utilisation(elements, devices), 0.0)
    return Failures(
        failed.sum(axis=-1).astype(np.int32),
        np.where(np.isfinite(first), first, math.nan),
        used.max(axis=-1, initial=0.0),
    )


def device_results(
    held: Held,
    elements: NDArray[np.void],
    devices: NDArray[np.void],
    forces: NDArray[np.float64],
    mass: float,
    member: int | None = None,
) -> tuple[DeviceResult, ...]:
    """Name what the mechanics returned in numbers.

    Parameters
    ----------
    held : Held
        The body and its devices.
    elements, devices : ndarray, shape [n]
        The mechanics' rows.
    forces : ndarray of float64, shape [samples, n, 2]
        Forces at the samples.
    mass : float
        By what the mechanics' forces are multiplied: the body's mass [kg] where they are per unit mass.
    member : int, optional
        The number of the body in an assembly.
    """
    labels = {measure.kind: measure.label for measure in held.measures}
    used, m = utilisation(elements, devices), mass
    return tuple(
        DeviceResult(
            element.kind,
            labels[element.kind],
            element.place,
            m * float(device["peak_pull"]),
            m * float(device["peak_push"]),
            m * float(device["peak_shear"]),
            float(used[n]),
            int(device["failure"]) != HOLDS,
            float(device["failure_time"]),
            CAUSES[int(device["failure"])],
            m * forces[:, n, F_NORMAL],
            m * forces[:, n, F_TANGENT],
            weakest(element, devices[n : n + 1]),
            member,
        )
        for n, (element, device) in enumerate(zip(held.elements, devices, strict=True))
    )
