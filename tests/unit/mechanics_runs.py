"""Short runs of one body that the tests of the solver's modules share."""

from __future__ import annotations

import numpy as np

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import Shaking, Traced, no_elements, shaking, trace
from stayput.model.flat_fields import case_columns

G = 9.81
BLOCK = sp.Body(0.4, 1.6, 100.0)
STICKING = sp.Room(sp.Floor(3.0, 3.0))


def case_of(body: sp.Body = BLOCK, room: sp.Room = STICKING, **state: float) -> np.void:
    """Return a CASE record."""
    return case_columns(body, room, sp.State(**state), G)[0]


def steady(along: float, duration: float, *, up: float = 0.0, dt: float = 0.01, law: int = 0) -> Shaking:
    """Return a constant acceleration of the floor [m/s²]."""
    n = round(duration / dt) + 1
    return shaking(np.full(n, along), np.full(n, up), dt, law)


def traced(motion: Shaking, body: sp.Body = BLOCK, room: sp.Room = STICKING, **state: float) -> Traced:
    """Run a case with its history and events."""
    return trace(case_of(body, room, **state), motion)


def kinds(run: Traced) -> list[sp.EventKind]:
    """Return the kinds of the events in their order."""
    return [list(sp.EventKind)[int(kind)] for kind in run.events.kind]


def modes(run: Traced) -> list[sp.Mode]:
    """Return the modes at the samples."""
    from stayput.mechanics.columns import H_MODE

    return [list(sp.Mode)[int(mode)] for mode in run.history[:, H_MODE]]


def tie(point: tuple[float, float], anchor: tuple[float, float], **fields: object) -> np.ndarray:
    """Return an axial element, shape [1]; its line pulls from ``slack_plus`` (0) on."""
    (x, z), (u, v) = anchor, point
    rows = no_elements(1)
    rows["kind"] = el.AXIAL
    rows["u"], rows["v"], rows["x"], rows["z"] = u, v, x, z
    rows["length"] = np.hypot(x - u, z - (v + 0.8))  # BLOCK stands at x = 0 with G 0.8 m high
    rows["slack_plus"][:, 0], rows["stiffness"][:, 0] = 0.0, 1000.0
    return _with(rows, fields)


def plate(point: tuple[float, float], **fields: object) -> np.ndarray:
    """Return a bonded planar element on the floor's directions, shape [1], normal and tangent alike."""
    rows = no_elements(1)
    rows["kind"] = el.PLANAR
    rows["u"], rows["v"] = point
    rows["slack_plus"] = rows["slack_minus"] = 0.0
    rows["stiffness"] = 1000.0
    return _with(rows, fields)


def _with(rows: np.ndarray, fields: dict[str, object]) -> np.ndarray:
    for name, value in fields.items():
        rows[name] = value
    return rows
