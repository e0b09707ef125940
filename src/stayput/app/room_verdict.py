"""A verdict on a room as plain data, as the page reads it."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING

import numpy as np

from stayput.app.room_replies import RoomVerdictReply, ZoneReply
from stayput.report.room.data import room_data
from stayput.scenario.measures import table_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.rooms.verdict import RoomVerdict


def room_verdict_reply(verdict: RoomVerdict) -> RoomVerdictReply:
    """Return a verdict as plain data: that of its JSON file, as the page reads it."""
    data = room_data(verdict)
    data["complete"] = verdict.complete
    run = verdict.typical
    data["typical"] = None if run is None else {"member": run.member, "direction_rad": run.direction}
    for piece, result in zip(data["pieces"], verdict.pieces, strict=True):
        piece["fell"], piece["stood"] = _zone(result.fell), _zone(result.stood)
    for change, result in zip(data["changes"], verdict.changes, strict=True):
        measure = result.change.measure
        change["measures"] = None if measure is None else [table_of(measure)]
        change["table"] = "furniture" if result.change.what in verdict.scenario.names else "places"
    return RoomVerdictReply.model_validate(data)


def _zone(shares: NDArray[np.float64]) -> ZoneReply:
    nx, ny = shares.shape
    steps = np.round(255.0 * shares).astype(np.uint8)
    return ZoneReply(nx=nx, ny=ny, shares=base64.b64encode(steps.tobytes()).decode("ascii"))
