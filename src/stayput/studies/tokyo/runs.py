"""Runs of the test's furniture with each device, in every direction that it may face."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.motion.units import STANDARD_GRAVITY
from stayput.studies.tokyo.published import BODIES, FAR, LEVELS, ROOM, SOME
from stayput.verification.draws import draws, rows_of
from stayput.verification.hazard import Floors
from stayput.verification.runs import run_level

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.body import Body
    from stayput.motion import Motion
    from stayput.room import Room
    from stayput.verification import Option
    from stayput.verification.runs import Runs


def facings(motion: Motion) -> dict[str, Motion]:
    """Return the motion as a piece feels it that faces +x, −x and, where there is a y, +y and −y."""
    found = {"+x": motion, "−x": motion.flipped()}
    if motion.y is not None:
        found |= {"+y": motion.rotated(math.pi / 2.0), "−y": motion.rotated(-math.pi / 2.0)}
    return found


def runs_of(
    body: Body,
    room: Room,
    options: Sequence[Option],
    motions: Sequence[Motion],
    level: float,
    samples: int,
    seed: int,
) -> list[Runs]:
    """Run all options at a level, under the same draws of what is not known."""
    drawn = draws(len(motions), samples, seed)
    rows = [rows_of(option, body, room, drawn, STANDARD_GRAVITY) for option in options]
    return run_level(rows, Floors(tuple(motions), np.full(len(motions), level), {}))


QUANTITIES: dict[str, tuple[Callable[[Runs], NDArray[np.generic]], dict[str, str]]] = {
    "overturned": (lambda runs: runs.overturned, {"long_name": "whether it turns over"}),
    "given_up": (lambda runs: runs.missing, {"long_name": "whether the run was given up"}),
    "device_failed": (lambda runs: runs.device_failed, {"long_name": "whether a device failed"}),
    "peak_slide": (lambda runs: runs.slide, {"units": "m", "long_name": "largest magnitude of the slide"}),
    "peak_tilt": (lambda runs: runs.tilt, {"units": "rad", "long_name": "largest magnitude of the tilt"}),
}
"""What is kept of the runs."""


def tested(
    motion: Motion, options: Sequence[Option], samples: int, seed: int, tell: Callable[[int], None]
) -> xr.Dataset:
    """Run the furniture of the test with each option, in each direction, at each level.

    Returns
    -------
    xarray.Dataset
        Over ``body``, ``level``, ``device``, ``facing`` and ``sample``: `QUANTITIES`.
    """
    felt = facings(motion)
    over = ("body", "level", "device", "facing", "sample")
    by_body: list[list[list[Runs]]] = []
    for body in BODIES.values():
        by_level: list[list[Runs]] = []
        for level in LEVELS:
            by_level.append(runs_of(body, ROOM, options, tuple(felt.values()), level, samples, seed))
            tell(len(options) * len(felt) * samples)
        by_body.append(by_level)
    return xr.Dataset(
        {
            name: (over, np.array([[[of(r) for r in row] for row in rows] for rows in by_body]), about)
            for name, (of, about) in QUANTITIES.items()
        },
        {
            "body": list(BODIES),
            "level": ("level", list(LEVELS), {"long_name": "factor on the record"}),
            "device": [option.name for option in options],
            "facing": list(felt),
        },
    )


def shares(runs: xr.Dataset) -> xr.Dataset:
    """Return shares of the draws in each facing, of those not given up.

    Returns
    -------
    xarray.Dataset
        Over ``body``, ``level``, ``device`` and ``facing``: ``overturned``; of those that stand, ``far`` that
        move 30 cm or more, ``some`` 10 to 30 cm and ``little`` less; ``failed``: overturned or far.
    """
    known = ~runs["given_up"]
    stands, slide = ~runs["overturned"], runs["peak_slide"]
    kinds = {
        "overturned": runs["overturned"],
        "far": stands & (slide >= FAR),
        "some": stands & (slide >= SOME) & (slide < FAR),
        "little": stands & (slide < SOME),
    }
    found = xr.Dataset({name: kind.where(known).mean("sample") for name, kind in kinds.items()})
    return found.assign(failed=found["overturned"] + found["far"])


def severest(found: xr.Dataset, alone: Sequence[str]) -> str:
    """Return the facing in which most overturn, over both pieces and all devices alone at the first level."""
    mean = found["overturned"].sel(device=list(alone)).isel(level=0).mean(("body", "device"))
    return str(mean["facing"].to_numpy()[int(np.argmax(mean.to_numpy()))])
