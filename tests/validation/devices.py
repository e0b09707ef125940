"""What the tests of force elements share: rows of elements, and runs of bodies that they hold."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from setups import G

import stayput as sp
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import Traced, no_elements, shaking, trace
from stayput.model.flat_fields import case_columns

if TYPE_CHECKING:
    from numpy.typing import NDArray

FLOOR, RIGHT, LEFT, CEILING = (1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (-1.0, 0.0)
"""Directions of the planes."""

TIME, TILT, TILT_RATE, SLIDE, SLIDE_RATE = -1, 2, 3, 4, 5


def axial(point: tuple[float, float], anchor: tuple[float, float], **fields: float) -> NDArray[np.void]:
    """Return a tie from a body's point (from G) to an anchor in the room; both ways with ``slack_minus``."""
    rows = no_elements(1)
    rows["kind"] = el.AXIAL
    rows["u"], rows["v"] = point
    rows["x"], rows["z"] = anchor
    rows["slack_plus"][:, 0] = 0.0
    return _filled(rows, fields)


def planar(point: tuple[float, float], plane: tuple[float, float], **fields: object) -> NDArray[np.void]:
    """Return an element at a body's point (from G), fixed to a plane where that point is at rest.

    A field is a number, for the normal line, or a pair, for both lines.
    """
    rows = no_elements(1)
    rows["kind"] = el.PLANAR
    rows["u"], rows["v"] = point
    rows["cos"], rows["sin"] = plane
    return _filled(rows, fields)


def _filled(rows: NDArray[np.void], fields: dict[str, object]) -> NDArray[np.void]:
    for name, value in fields.items():
        if rows[name].ndim == 1 or isinstance(value, tuple):
            rows[name] = value
        else:
            rows[name][:, 0] = value
    return rows


def held(
    body: sp.Body,
    place: sp.Room,
    motion: sp.Motion,
    *elements: NDArray[np.void],
    tolerance: float = 1e-10,
    max_step: float = math.inf,
    **state: float,
) -> Traced:
    """Run a body with elements, with the gravity of the reference numbers."""
    case = case_columns(body, place, sp.State(**state), G)[0]
    rows = np.concatenate(elements) if elements else no_elements(1)
    floor = shaking(motion.x, motion.z, motion.dt, 0)
    return trace(case, floor, rows, error=tolerance, max_step=max_step)


def bare(body: sp.Body, place: sp.Room, motion: sp.Motion, **state: float) -> Traced:
    """Run the same body with the first kernel."""
    case = case_columns(body, place, sp.State(**state), G)[0]
    return trace(case, shaking(motion.x, motion.z, motion.dt, 0))
