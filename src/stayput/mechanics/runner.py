"""Python interface of the compiled solver in the plane: one case with its history, or a batch of cases."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import not_allowed, too_many
from stayput.mechanics import columns as col
from stayput.mechanics.devices import columns as el
from stayput.mechanics.engine import run_batch
from stayput.mechanics.flat import BLOCK, block_extremes
from stayput.mechanics.records import BatchDevices, Excitation, Output, Scratch, SolverSettings

MAX_EVENTS = 1_000_000
"""Events after which a run is stopped and reported as failed."""

EVENT = np.dtype([(name, "f8") for name in col.EVENT_FIELDS])
"""An event of a run."""

_ALLOWED: tuple[tuple[tuple[str, ...], Callable[[NDArray[Any]], NDArray[np.bool_]], str], ...] = (
    (("kind",), lambda values: np.isin(values, (el.AXIAL, el.PLANAR)), "known_kind"),
    (("u", "v", "cos", "sin", "length"), np.isfinite, "finite"),
    (("x", "z"), lambda values: ~np.isinf(values), "anchor"),
    (("stiffness", "damping"), lambda values: (values >= 0.0) & np.isfinite(values), "not_negative"),
    (("slack_plus", "slack_minus"), lambda values: values > -np.inf, "slack"),
    (("limit_plus", "limit_minus", "ultimate"), lambda values: values >= 0.0, "not_negative"),
    (("friction",), lambda values: ~(values < 0.0), "friction"),
)
"""Fields of an ELEMENT, which of their values may be, and what is said where they are not."""

TOLERANCE = 1e-10
"""Largest last term of the tilt's Taylor series in a step [rad]."""

DEVICE_TOLERANCE = 1e-7
"""Largest error of a step with devices [m, rad]."""


@dataclass(frozen=True, slots=True, eq=False)
class Traced:
    """A run with what was recorded of it; modes, kinds of events and outcome are integer codes (`columns`).

    Attributes
    ----------
    result : RESULT record
        Outcome, peaks and counts.
    history : ndarray of float64, shape [samples, HISTORY]
        The state at the samples reached.
    events : recarray, shape [k]
        The events, without internal ones: `columns.EVENT_FIELDS`.
    devices : ndarray of DEVICE, shape [n]
        Result of each element.
    forces : ndarray of float64, shape [samples, n, 2]
        Normal and tangential force of each at the samples reached [N/kg]: + where it pulls the body's point
        back against a positive elongation.
    """

    result: np.void
    history: NDArray[np.float64]
    events: np.recarray[Any, Any]
    devices: NDArray[np.void]
    forces: NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Shaking:
    """A motion prepared for the solver, for one contact law."""

    floor: Excitation
    law: int


def shaking(along: NDArray[np.float64], up: NDArray[np.float64] | None, dt: float, law: int) -> Shaking:
    """Prepare a motion for the solver, once for all cases under it.

    Parameters
    ----------
    along, up : ndarray of float64, shape [n]
        Acceleration of the floor, + right and + up [m/s²]; without ``up`` there is no vertical one.
    dt : float
        Time between samples [s].
    law : int
        0 for "coulomb", 1 for "paper", whose rules have no vertical motion.
    """
    along = np.array(along, np.float64)  # copied: compiled code is for writable arrays
    up = np.zeros(len(along)) if up is None or law == 1 else np.array(up, np.float64)
    return Shaking(Excitation(along, up, dt, (*extremes(along), *extremes(up))), law)


def extremes(values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return minimum and maximum over blocks of the record, by which rest is skipped."""
    blocks = max(1, -(-(len(values) - 1) // BLOCK))
    low, high = np.empty(blocks), np.empty(blocks)
    block_extremes(values, low, high)
    return low, high


def _solve(
    cases: NDArray[np.void],
    held: BatchDevices | None,
    motion: Shaking,
    *,
    tolerance: float = TOLERANCE,
    error: float = DEVICE_TOLERANCE,
    max_step: float = np.inf,
    max_events: int = MAX_EVENTS,
    records: bool = False,
) -> tuple[NDArray[np.void], Output]:
    """Run cases under one motion on this thread; return RESULT, shape [m], and what was recorded.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
        The cases; a single one where ``records`` are kept.
    held : BatchDevices or None
        Their devices, whose results are written into it.
    motion : Shaking
        How the floor moves, and the contact law.
    tolerance : float
        Largest last term of the tilt's Taylor series in a step [rad].
    error : float
        Largest error of a step with devices [m, rad].
    max_step : float
        Longest step [s].
    max_events : int
        Events after which a case is stopped and reported as failed.
    records : bool
        Whether history, forces and events are kept.
    """
    samples, listed = (len(motion.floor.ax), MAX_EVENTS) if records else (0, 0)
    devices = 0 if held is None else len(held.links)
    output = Output(
        history=np.zeros((samples, col.HISTORY)),
        forces=np.zeros((samples, devices, el.FORCES)),
        events=np.zeros((listed, col.EVENT)),  # pages that are not written take no memory
    )
    results = np.zeros(len(cases), col.RESULT)
    settings = SolverSettings(motion.law, tolerance, error, max_step, max_events)
    scratch = Scratch(np.zeros(col.CONTACTS, col.CONTACT), np.zeros(col.CONTACTS, col.ROW))
    run_batch(cases, held, motion.floor, settings, scratch, np.zeros(1, col.STATE), output, results)
    return results, output


def trace(
    case: np.void, motion: Shaking, elements: NDArray[np.void] | None = None, **settings: Any
) -> Traced:
    """Run one case and keep its histories and events.

    Parameters
    ----------
    case : CASE record
        The case.
    motion : Shaking
        How the floor moves, and the contact law.
    elements : ndarray of ELEMENT, shape [n], optional
        Its devices, with forces per unit mass of the body [N/kg]; under the law "coulomb" alone.
    **settings
        ``tolerance``, ``error`` and ``max_step`` as for `_solve`.

    Raises
    ------
    InputError
        Elements out of range, or another contact law.
    """
    held = None
    if elements is not None and len(elements):
        held = _devices_of(np.ascontiguousarray(elements)[np.newaxis], motion)
    results, output = _solve(np.array([case]), held, motion, records=True, **settings)
    reached = int(output.history[:, col.H_REACHED].sum())
    listed = output.events[: results[0]["events"]]
    listed = listed[listed[:, col.E_KIND] != col.INTERNAL_EVENT]
    return Traced(
        result=results[0],
        history=output.history[:reached],
        events=np.rec.fromarrays(listed.T, dtype=EVENT),
        devices=np.zeros(0, el.DEVICE) if held is None else held.devices[0],
        forces=output.forces[:reached],
    )


def run_cases(cases: NDArray[np.void], motion: Shaking, **settings: Any) -> NDArray[np.void]:
    """Run a column of cases under one motion on this thread; return a column of `columns.RESULT`.

    ``settings`` are ``tolerance``, ``max_step`` and ``max_events`` as for `_solve`.
    """
    return _solve(cases, None, motion, **settings)[0]


def run_cases_with_devices(
    cases: NDArray[np.void], elements: NDArray[np.void], motion: Shaking, **settings: Any
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run a column of cases with elements under one motion on this thread.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    elements : ndarray of ELEMENT, shape [m, n]
        The devices of each case, padded with rows of kind NONE.
    motion : Shaking
        How the floor moves; under the law "coulomb".
    **settings
        ``error``, ``max_step`` and ``max_events`` as for `_solve`.

    Returns
    -------
    tuple
        A column of `stayput.mechanics.columns.RESULT`, and DEVICE, shape [m, n].
    """
    held = _devices_of(elements, motion)
    return _solve(cases, held, motion, **settings)[0], held.devices


def _devices_of(elements: NDArray[np.void], motion: Shaking) -> BatchDevices:
    """Return devices as the solver takes them, shape [m, n].

    Raises
    ------
    InputError
        Elements out of range, or another contact law.
    """
    check_elements(elements)
    if motion.law != col.COULOMB:
        raise not_allowed("model.contact", repr("paper"), "mechanics.elements_need_coulomb", "contact")
    links = np.zeros(elements.shape[1], el.LINK)
    return BatchDevices(elements, links, np.zeros(elements.shape, el.DEVICE), np.zeros(2, el.WORK))


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
        raise too_many("mechanics.the_body", elements.shape[-1], "mechanics.elements", el.MAX_ELEMENTS)
    rows = elements.ravel()
    rows = rows[rows["kind"] != el.NONE]
    # comparisons are False for NaN, which is refused; where NaN has a meaning they are negated
    checks = [
        (name, rows[name], is_valid(rows[name]), allowed)
        for names, is_valid, allowed in _ALLOWED
        for name in names
    ]
    damping, ultimate = rows["damping"].max(axis=1), rows["ultimate"].max(axis=1)
    interaction, play = rows["interaction"], rows["slack_plus"] + rows["slack_minus"]
    slips, axial = ~np.isnan(rows["friction"]), rows["kind"] == el.AXIAL
    bare = (rows["damping"] > 0.0) & (rows["stiffness"] == 0.0)
    checks += [  # combinations that the force laws do not cover
        ("slack_plus + slack_minus", play, ~(play < 0.0), "not_negative"),
        ("damping", rows["damping"], ~bare, "no_damping_without_stiffness"),
        ("damping", damping, ~(slips & (damping > 0.0)), "no_damping_with_friction"),
        ("ultimate", ultimate, ~((interaction != 0) & (ultimate > 0.0)), "brittle_with_interaction"),
        ("interaction", interaction, ~((interaction != 0) & axial), "axial_has_no_shear"),
    ]
    for name, values, valid, allowed in checks:
        if not np.all(valid):
            called = phrase("mechanics.element_value", name=name)
            raise not_allowed(called, f"{values[~valid].ravel()[0]:g}", f"mechanics.{allowed}")
