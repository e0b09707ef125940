"""Python's way into the kernel for bodies with elements: one case with its histories, or a batch of cases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.mechanics import columns as col
from stayput.mechanics.engine import COULOMB
from stayput.mechanics.restrained import columns as el
from stayput.mechanics.restrained.engine import UNNAMED, run_restrained_batch
from stayput.mechanics.runner import LISTED_EVENTS, MAX_EVENTS, Shaking, Traced, traced

if TYPE_CHECKING:
    from numpy.typing import NDArray

TOLERANCE = 1e-7
"""Largest error of a step with elements [m, rad]."""


@dataclass(frozen=True, slots=True, eq=False)
class TracedDevices:
    """A run with elements in numbers.

    Attributes
    ----------
    run : Traced
        The body's run.
    devices : ndarray of DEVICE, shape [n]
        What became of each element.
    forces : ndarray of float64, shape [samples, n, 2]
        Normal and tangential force at the samples reached [N/kg]: + where it pulls the body's point back
        against a positive elongation.
    """

    run: Traced
    devices: NDArray[np.void]
    forces: NDArray[np.float64]


def no_elements(count: int, cases: int | None = None) -> NDArray[np.void]:
    """Return rows of ELEMENT that do nothing, to be filled: shape [count] or [cases, count].

    Every slack and strength is infinite or none: a line acts once it has a stiffness and a finite slack.
    """
    rows = np.zeros(count if cases is None else (cases, count), el.ELEMENT)
    rows["x"] = rows["z"] = rows["friction"] = np.nan
    rows["cos"] = 1.0
    for name in ("slack_plus", "slack_minus", "limit_plus", "limit_minus"):
        rows[name] = np.inf
    return rows


def check_elements(elements: NDArray[np.void]) -> None:
    """Refuse elements that the kernel cannot take.

    Raises
    ------
    InputError
        Too many elements; a number that is NaN where it may not be, or out of its range.
    """
    if elements.shape[-1] > el.MOST_ELEMENTS:
        raise InputError(
            f"The body has {elements.shape[-1]} elements; there may be {el.MOST_ELEMENTS} at most."
        )
    rows = elements.ravel()
    rows = rows[rows["kind"] != el.NONE]
    _refuse(~np.isin(rows["kind"], (el.AXIAL, el.PLANAR)), rows["kind"], "kind", "1 (axial) or 2 (planar)")
    for name in ("u", "v", "cos", "sin", "length"):
        _refuse(~np.isfinite(rows[name]), rows[name], name, "finite")
    for name in ("x", "z"):
        _refuse(np.isinf(rows[name]), rows[name], name, "finite, or NaN for where the point is at rest")
    for name in ("stiffness", "damping"):
        _refuse(~((rows[name] >= 0.0) & np.isfinite(rows[name])), rows[name], name, "0 or more")
    for name in ("slack_plus", "slack_minus"):
        _refuse(~(rows[name] > -np.inf), rows[name], name, "a length, or inf")
    for name in ("limit_plus", "limit_minus", "ultimate"):
        _refuse(~(rows[name] >= 0.0), rows[name], name, "0 or more")
    _refuse(rows["friction"] < 0.0, rows["friction"], "friction", "0 or more, or NaN for none")
    both = rows["slack_plus"] + rows["slack_minus"]
    _refuse(both < 0.0, both, "slack_plus + slack_minus", "0 or more")
    idle = (rows["stiffness"] == 0.0) & (rows["damping"] > 0.0)
    _refuse(idle, rows["damping"], "damping", "0 where there is no stiffness")
    rubbed = ~np.isnan(rows["friction"]) & (rows["damping"] > 0.0).any(axis=1)
    _refuse(rubbed, rows["damping"].max(axis=1), "damping", "0 where the tangent slips by friction")
    tough = (rows["interaction"] != 0) & (rows["ultimate"] > 0.0).any(axis=1)
    _refuse(tough, rows["ultimate"].max(axis=1), "ultimate", "0 where pull and shear act together")
    together = (rows["interaction"] != 0) & (rows["kind"] == el.AXIAL)
    _refuse(together, rows["interaction"], "interaction", "0 for an axial one, which has no shear")


def _refuse(wrong: NDArray[np.bool_], values: NDArray[np.float64], name: str, allowed: str) -> None:
    if np.any(wrong):
        raise InputError(f"Element {name} is {values[wrong].ravel()[0]:g}; it must be {allowed}.")


def _room(count: int) -> tuple[NDArray[np.void], ...]:
    """Return room for contacts, rows, the works and the links."""
    return (
        np.zeros(col.CONTACTS, col.CONTACT),
        np.zeros(col.CONTACTS, col.ROW),
        np.zeros(2, el.WORK),
        np.zeros(count, el.LINK),
    )


def _loads(
    motion: Shaking,
) -> tuple[NDArray[np.float64], NDArray[np.float64], float, tuple[object, ...], int]:
    if motion.law != COULOMB:
        raise InputError("Contact is 'paper'; measures with force elements need 'coulomb'.")
    return motion.along, motion.up, motion.dt, motion.bounds, motion.law


def trace_restrained(
    case: np.void,
    elements: NDArray[np.void],
    motion: Shaking,
    *,
    tolerance: float = TOLERANCE,
    max_step: float = np.inf,
) -> TracedDevices:
    """Run one case with elements and keep its histories and events.

    Parameters
    ----------
    case : CASE record
        The case.
    elements : ndarray of ELEMENT, shape [n]
        Its devices, with forces per unit mass of the body.
    motion : Shaking
        How the floor moves; under the law "coulomb".
    tolerance, max_step : float
        Largest error of a step [m, rad], longest step [s].

    Raises
    ------
    InputError
        Elements out of range, or another contact law.
    """
    check_elements(elements)
    cases, rows_of_elements = np.array([case]), elements[np.newaxis]
    loads = _loads(motion)
    contacts, rows, works, links = _room(len(elements))
    states, results = np.zeros(1, col.STATE), np.zeros(1, col.RESULT)
    devices = np.zeros(rows_of_elements.shape, el.DEVICE)
    samples = len(motion.along)
    listed = np.zeros((LISTED_EVENTS, col.EVENT))
    while True:
        history = np.zeros((samples, col.HISTORY))
        forces = np.zeros((samples, len(elements), el.FORCES))
        run_restrained_batch(
            cases,
            rows_of_elements,
            *loads,
            tolerance,
            max_step,
            MAX_EVENTS,
            contacts,
            rows,
            states,
            works,
            links,
            history,
            forces,
            listed,
            results,
            devices,
        )
        if results["events"][0] <= len(listed):
            break
        listed = np.zeros((results["events"][0], col.EVENT))
    named = listed[: results["events"][0]]
    run = traced(results[0], history, named[named[:, col.E_KIND] != UNNAMED])
    return TracedDevices(run, devices[0], forces[: len(run.history)])


def run_restrained_cases(
    cases: NDArray[np.void],
    elements: NDArray[np.void],
    motion: Shaking,
    *,
    tolerance: float = TOLERANCE,
    max_step: float = np.inf,
    max_events: int = MAX_EVENTS,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run a column of cases with elements under one motion on this thread.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    elements : ndarray of ELEMENT, shape [m, n]
        The devices of each case; rows of kind NONE fill up.
    motion, tolerance, max_step
        As for `trace_restrained`.
    max_events : int
        Events after which a case is given up.

    Returns
    -------
    tuple
        A column of `stayput.mechanics.columns.RESULT`, and DEVICE, shape [m, n].
    """
    check_elements(elements)
    if elements.shape[:1] != cases.shape:
        raise InputError(
            f"There are elements for {len(elements)} cases; there must be one row for each of {len(cases)}."
        )
    loads = _loads(motion)
    contacts, rows, works, links = _room(elements.shape[1])
    results = np.zeros(len(cases), col.RESULT)
    devices = np.zeros(elements.shape, el.DEVICE)
    nothing = (
        np.zeros((0, col.HISTORY)),
        np.zeros((0, elements.shape[1], el.FORCES)),
        np.zeros((0, col.EVENT)),
    )
    states = np.zeros(1, col.STATE)
    run_restrained_batch(
        cases,
        elements,
        *loads,
        tolerance,
        max_step,
        max_events,
        contacts,
        rows,
        states,
        works,
        links,
        *nothing,
        results,
        devices,
    )
    return results, devices
