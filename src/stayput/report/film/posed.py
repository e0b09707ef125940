"""A run in the plane as a picture in space draws it: a body with a length, walls, and devices along it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.measures.measure import Held, element_rows
from stayput.model.flat_fields import case_columns
from stayput.report.history import sampled, with_overturning
from stayput.simulation.placing import held_body
from stayput.simulation.space_records import planes_of

if TYPE_CHECKING:
    from stayput.simulation.run import Run


def posed(run: Run) -> Run:
    """Return a run with all that a picture in space draws; one in space, or made so before, as it is.

    A body without a length is as long as it is wide. Like devices of a measure, which in the plane act as
    one, are each drawn where they hold. A body that has overturned lies as it fell until the motion ends.
    """
    if run.standing:
        return run
    held, motion = run.piece.held, run.motion
    assert held is not None  # only of solids, which the plane does not take
    length = held.body.length or held.body.width
    body, parts = replace(held.body, length=length), [part.spread(length) for part in held.elements]
    case = case_columns(body, held.room, run.initial, run.gravity)[0]
    each = Held(body, held.room, tuple(element for part in parts for element in part))
    stood = held_body(case, element_rows(each))
    first = [float(stood.pose[axis]) for axis in "xyz"]
    whole = with_overturning(run)
    lasting = sampled(whole, np.minimum(np.arange(len(motion)), len(whole.time) - 1))
    return replace(
        lasting,
        time=motion.time,
        motion=replace(motion, y=None),
        place=lasting.place + (np.array(first) - run.place[0, 0]),
        standing=(stood.piece,),
        planes=planes_of([stood.piece], case),
        springs=stood.springs,
        devices=tuple(device for part, device in zip(parts, run.devices, strict=True) for _ in part),
    )
