"""What became of bodies in space, and what they are called, in words."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from stayput.catalogue import phrase, say
from stayput.errors import InputError, list_of
from stayput.report.space.histories import slid
from stayput.report.summary import length, piece_name, with_first_failure
from stayput.simulation.outcome import Outcome

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.catalogue import Phrase
    from stayput.simulation.space_run import SpaceRun


def names_of(run: SpaceRun, names: Sequence[str] | None, language: str) -> tuple[str, ...]:
    """Return what the bodies are called: the names given, or by their numbers where there are several.

    Raises
    ------
    InputError
        Names that are no texts, or not one for each body.
    """
    count = len(run.standing)
    if names is None:
        if count == 1:
            return (say("runs.body", language),)
        return tuple(say("space.numbered", language, number=number) for number in range(1, count + 1))
    given = list_of("names", names, str)
    if len(given) != count:
        raise InputError("space.number_of_names", "names", count=len(given), bodies=count)
    return given


def became(run: SpaceRun, names: Sequence[str]) -> Phrase:
    """Return what became of the bodies of a run, in one sentence."""
    if len(names) == 1:
        return _of_one(run, names[0])
    times = np.fmin(run.overturn_time, run.fall_time).tolist()
    fallen = [b for b, time in enumerate(times) if math.isfinite(time)]
    if not fallen:
        return phrase("space.none_fell", count=len(names))
    each = [
        phrase("space.fell_at", name=names[b], time=times[b]) for b in sorted(fallen, key=times.__getitem__)
    ]
    commas = phrase("common.listed")
    which = tuple(comma.join(texts) for comma, texts in zip(commas, zip(*each, strict=True), strict=True))
    return phrase("space.some_fell", fallen=len(fallen), count=len(names), which=which)


def piece_became(run: SpaceRun, preset: str | None, own_name: str | None = None) -> Phrase:
    """Return what became of a piece of furniture, and the first device that failed.

    Parameters
    ----------
    run : SpaceRun
        The run of the piece alone.
    preset, own_name : str, optional
        Its preset, and what the user calls it.
    """
    english, japanese = piece_name(preset, own_name)
    outcome = _of_one(run, english)[0], _of_one(run, japanese)[1]
    return with_first_failure(outcome, run.devices)


def _of_one(run: SpaceRun, name: str) -> Phrase:
    if run.overturned[0]:
        return phrase("space.overturned", name=name, time=float(run.overturn_time[0]))
    angle = float(np.degrees(run.tilt.max()))
    way = float(slid(run).max())
    if run.outcome is Outcome.RESTED:
        return phrase("runs.rested", name=name)
    tilt = phrase("space.least_angle") if angle < 0.1 else phrase("space.up_to_angle", angle=angle)
    slide = phrase("runs.slid_least") if way < 1e-3 else phrase("runs.slid_up_to", length=length(way))
    return phrase("space.upright", name=name, tilt=tilt, slide=slide)
