"""Python interface of the solver with devices: one case with its histories, or a batch of cases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.mechanics import columns as col
from stayput.mechanics.devices import columns as el
from stayput.mechanics.records import BatchDevices
from stayput.mechanics.runner import DEVICE_TOLERANCE, MAX_EVENTS, Shaking, Traced, solve, traced

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class TracedDevices:
    """A run with elements as returned by the solver.

    Attributes
    ----------
    run : Traced
        The body's run.
    devices : ndarray of DEVICE, shape [n]
        Result of each element.
    forces : ndarray of float64, shape [samples, n, 2]
        Normal and tangential force at the samples reached [N/kg]: + where it pulls the body's point back
        against a positive elongation.
    """

    run: Traced
    devices: NDArray[np.void]
    forces: NDArray[np.float64]


def no_elements(count: int, cases: int | None = None) -> NDArray[np.void]:
    """Return inactive ELEMENT rows to be filled in, shape [count] or [cases, count].

    All slacks and strengths are infinite: a line acts once it has a stiffness and a finite slack.
    """
    rows = np.zeros(count if cases is None else (cases, count), el.ELEMENT)
    rows["x"] = rows["z"] = rows["friction"] = np.nan
    rows["cos"] = 1.0
    for name in ("slack_plus", "slack_minus", "limit_plus", "limit_minus"):
        rows[name] = np.inf
    return rows


def check_elements(elements: NDArray[np.void]) -> None:
    """Validate elements, since the compiled solver does not.

    Raises
    ------
    InputError
        Too many elements; a number that is NaN where it may not be, or out of its range.
    """
    if elements.shape[-1] > el.MAX_ELEMENTS:
        raise InputError("mechanics.too_many_elements", count=elements.shape[-1], most=el.MAX_ELEMENTS)
    rows = elements.ravel()
    rows = rows[rows["kind"] != el.NONE]
    _check(np.isin(rows["kind"], (el.AXIAL, el.PLANAR)), rows["kind"], "kind", "mechanics.known_kind")
    for name in ("u", "v", "cos", "sin", "length"):
        _check(np.isfinite(rows[name]), rows[name], name, "mechanics.finite")
    for name in ("x", "z"):
        _check(~np.isinf(rows[name]), rows[name], name, "mechanics.anchor")
    # the comparisons are False for NaN, which is refused; where NaN has a meaning they are negated
    for name in ("stiffness", "damping"):
        _check((rows[name] >= 0.0) & np.isfinite(rows[name]), rows[name], name, "mechanics.not_negative")
    for name in ("slack_plus", "slack_minus"):
        _check(rows[name] > -np.inf, rows[name], name, "mechanics.slack")
    for name in ("limit_plus", "limit_minus", "ultimate"):
        _check(rows[name] >= 0.0, rows[name], name, "mechanics.not_negative")
    _check(~(rows["friction"] < 0.0), rows["friction"], "friction", "mechanics.friction")
    play = rows["slack_plus"] + rows["slack_minus"]
    _check(~(play < 0.0), play, "slack_plus + slack_minus", "mechanics.not_negative")
    # combinations that the force laws do not cover
    damped, ductile = rows["damping"] > 0.0, (rows["ultimate"] > 0.0).any(axis=1)
    lone_damper = damped & (rows["stiffness"] == 0.0)
    _check(~lone_damper, rows["damping"], "damping", "mechanics.no_damping_without_stiffness")
    damped_friction = damped.any(axis=1) & ~np.isnan(rows["friction"])
    damping = rows["damping"].max(axis=1)
    _check(~damped_friction, damping, "damping", "mechanics.no_damping_with_friction")
    interacts = rows["interaction"] != 0
    ultimate = rows["ultimate"].max(axis=1)
    _check(~(interacts & ductile), ultimate, "ultimate", "mechanics.brittle_with_interaction")
    axial = rows["kind"] == el.AXIAL
    _check(~(interacts & axial), rows["interaction"], "interaction", "mechanics.axial_has_no_shear")


def _check(valid: NDArray[np.bool_], values: NDArray[np.float64], name: str, allowed: str) -> None:
    """Refuse the first value that is not valid; ``allowed`` is the catalogue's id of what it must be."""
    if not np.all(valid):
        value = values[~valid].ravel()[0]
        raise InputError("mechanics.element_value", name=name, value=value, allowed=phrase(allowed))


def devices_of(elements: NDArray[np.void], motion: Shaking) -> BatchDevices:
    """Return devices as the solver takes them, shape [m, n].

    Raises
    ------
    InputError
        Elements out of range, or another contact law.
    """
    check_elements(elements)
    if motion.law != col.COULOMB:
        raise InputError("mechanics.elements_need_coulomb", "contact")
    links = np.zeros(elements.shape[1], el.LINK)
    return BatchDevices(elements, links, np.zeros(elements.shape, el.DEVICE), np.zeros(2, el.WORK))


def trace_with_devices(
    case: np.void,
    elements: NDArray[np.void],
    motion: Shaking,
    *,
    tolerance: float = DEVICE_TOLERANCE,
    max_step: float = np.inf,
) -> TracedDevices:
    """Run one case with elements and keep its histories and events.

    Parameters
    ----------
    case : CASE record
        The case.
    elements : ndarray of ELEMENT, shape [n]
        Its devices, with forces per unit mass of the body [N/kg].
    motion : Shaking
        How the floor moves; under the law "coulomb".
    tolerance, max_step : float
        Largest error of a step [m, rad], longest step [s].

    Raises
    ------
    InputError
        Elements out of range, or another contact law.
    """
    held = devices_of(np.ascontiguousarray(elements)[np.newaxis], motion)
    results, output = solve(np.array([case]), held, motion, error=tolerance, max_step=max_step, records=True)
    run = traced(results[0], output)
    return TracedDevices(run, held.devices[0], output.forces[: len(run.history)])


def run_cases_with_devices(
    cases: NDArray[np.void],
    elements: NDArray[np.void],
    motion: Shaking,
    *,
    tolerance: float = DEVICE_TOLERANCE,
    max_step: float = np.inf,
    max_events: int = MAX_EVENTS,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run a column of cases with elements under one motion on this thread.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    elements : ndarray of ELEMENT, shape [m, n]
        The devices of each case, padded with rows of kind NONE.
    motion, tolerance, max_step
        As for `trace_with_devices`.
    max_events : int
        Events after which a case is stopped and reported as failed.

    Returns
    -------
    tuple
        A column of `stayput.mechanics.columns.RESULT`, and DEVICE, shape [m, n].
    """
    if elements.shape[:1] != cases.shape:
        raise InputError("mechanics.element_rows", given=len(elements), cases=len(cases))
    held = devices_of(elements, motion)
    results, _ = solve(cases, held, motion, error=tolerance, max_step=max_step, max_events=max_events)
    return results, held.devices
