"""A verification as a job: which options it compares, and its verdict as plain data."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app.refusals import problem
from stayput.app.replies import Words
from stayput.app.running import own_measures
from stayput.app.scenes import motions_of, too_many
from stayput.app.verdict_replies import EverydayReply, JobReply, VerdictReply, ZoneReply
from stayput.fragility.curve import METHOD, CurveState
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures import hold
from stayput.report.summary import by_language
from stayput.report.verdict.data import everyday_data, verdict_data
from stayput.report.verdict.tables import estimate_rows
from stayput.scenario import Scenario
from stayput.scenario.measures import table_of
from stayput.scenario.option import YOURS
from stayput.verification.contents import runs_of_contents
from stayput.verification.events import CELL
from stayput.verification.notes import everyday_note, shaken_notes
from stayput.verification.options import compared_options, usual, weakest
from stayput.verification.room_words import tags
from stayput.verification.words import asides

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.app.jobs import Job
    from stayput.app.limits import Limits
    from stayput.fragility.curve import FragilityCurve
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

CURVE_POINTS = 91
"""Intensities at which a curve is sent, over what was run: ten from level to level."""


def with_options(scenario: Scenario, data: dict[str, Any], compare_usual: bool) -> Scenario:
    """Return a scene with all options that are to be compared; not all usual ones need be possible.

    Parameters
    ----------
    scenario : Scenario
        The scene with the user's set, if there is one.
    data : dict
        The scene as it came, which has passed as ``scenario``.
    compare_usual : bool
        Whether the usual measures are compared besides the user's.

    Raises
    ------
    InputError
        A measure of the user's that cannot be applied.
    """
    yours = own_measures(scenario)
    if not yours:
        compared_options(scenario)
        return scenario
    alone = [(measure,) for measure in yours]
    body, room = scenario.piece.body(), scenario.room.room()
    for measures in (yours, *alone):
        hold(body, room, measures)
    others = [option.measures for option in usual() if compare_usual]
    tables: dict[str, dict[str, Any]] = {}
    for measures in dict.fromkeys([yours, *alone, *others]):
        name = YOURS if measures == yours else " + ".join(measure.kind for measure in measures)
        while name in tables:  # the same kind with parameters of the user's
            name += ", as usual"
        tables[name] = {"name": name, "combine": [table_of(measure) for measure in measures]}
    return Scenario.parse({**data, "measures": [*tables.values()]}, scenario.folder)


def runs_of(scenario: Scenario, limits: Limits, levels: int) -> int:
    """Return how many simulations a verification makes at most.

    Raises
    ------
    RefusedError
        More than this server allows.
    """
    (compared, _), shaking = compared_options(scenario), scenario.shaking
    options = len(compared)
    motions = motions_of(shaking)
    most = max(1, -(-scenario.samples // motions))
    badly = 1 if scenario.uncertainty.badly(1.0) > 0.0 else 0
    runs = options * motions * most * (1 + badly + levels)
    if scenario.contents is not None:
        runs += options * runs_of_contents(scenario.contents, motions)
    allowed = limits.runs if scenario.dimensions == 2 else limits.runs_in_space
    if runs > allowed:
        raise too_many("uncertainty.samples", runs, allowed, "app.runs")
    return runs


def job_reply(job: Job, rewrite: Callable[[str], str]) -> JobReply:
    """Return the state of a job, with its verdict as far as it is known.

    Parameters
    ----------
    job : Job
        The job.
    rewrite : callable
        Puts the users' names for their files into a sentence.
    """
    state, verdict = job.state, job.verdict  # in this order: the final verdict is there when the job is done
    return JobReply.from_attributes(
        job,
        state=state,
        progress=1.0 if state == "done" else min(1.0, job.done / max(1, job.total)),
        seconds=round(job.seconds, 3),
        error=None if job.error is None else problem(job.error.rewritten(rewrite)),
        result=verdict and verdict_reply(verdict),
    )


def verdict_reply(verdict: Verdict) -> VerdictReply:
    """Return a verdict as its JSON file has it, with what the page says and draws beside it."""
    data, scenario = verdict_data(verdict), verdict.scenario
    for key in ("assumptions", "scenario_toml"):  # they are in the report
        del data[key]
    for result, option in zip(verdict.options, data["options"], strict=True):
        _extend_option(option, result, verdict)
        if scenario.plan is not None:
            _extend_room(option, result, verdict)
    if scenario.alone:
        data["estimates"]["rows"] = _estimates(verdict)
    return VerdictReply.model_validate(
        {
            **data,
            "complete": verdict.complete,
            "notes": [by_language(note) for note in shaken_notes(verdict, _looked_at(verdict).option)],
            "everyday": everyday_reply(verdict) if scenario.alone else None,
            "cell_m": None if scenario.plan is None else CELL,
        }
    )


def everyday_reply(verdict: Verdict) -> EverydayReply:
    """Return what the piece of a verdict withstands without an earthquake."""
    return EverydayReply(sentence=Words.of(everyday_note(verdict)), cases=everyday_data(verdict.scenario))


def _estimates(verdict: Verdict) -> list[dict[str, dict[str, str]]]:
    rows = zip(estimate_rows(verdict, "en"), estimate_rows(verdict, "ja"), strict=True)
    keys = ("formula", "says", "beside")
    return [dict(zip(keys, map(by_language, zip(*row, strict=True)), strict=True)) for row in rows]


def _looked_at(verdict: Verdict) -> OptionVerdict:
    """Return the option that the page's reader has put together: without measures where there is none."""
    yours = (each for each in verdict.options if each.option.name == YOURS and each.option.measures)
    return next(yours, verdict.without)


def _extend_option(data: dict[str, Any], result: OptionVerdict, verdict: Verdict) -> None:
    """Put into an option's data what the page says of it, and its curve as it is drawn."""
    option, curve = result.option, result.curves.get(JMA_INTENSITY)
    counted = {row["measure"]: row["levels"] for row in data.pop("curves")}
    data |= {
        "measures": [table_of(measure) for measure in option.measures],
        "weakest": [by_language(item.label) for item in weakest(option, verdict.scenario)],
        "asides": [by_language(aside) for aside in asides(result, verdict)],
        "yours": option.name == YOURS,
        "curve": None if curve is None else _curve(curve, counted[JMA_INTENSITY.key]),
    }


def _extend_room(data: dict[str, Any], result: OptionVerdict, verdict: Verdict) -> None:
    """Put into an option's data what a page of a room draws, and which changes make it."""
    names = verdict.scenario.names
    for piece, of_piece in zip(data["pieces"], result.pieces, strict=True):
        zones = of_piece.zones
        piece["outline_m"] = None if zones is None else zones.outline.tolist()
        piece["fell"], piece["stood"] = (
            (None, None) if zones is None else (_zone(zones.fell), _zone(zones.stood))
        )
    data["tags"] = [by_language(tag) for tag in tags(result)]
    data["changes"] = [
        {
            "what": change.what,
            "table": "furniture" if change.what in names else "places",
            "measures": None if change.measure is None else [table_of(change.measure)],
            "drilled": change.measure is not None and change.measure.drilled,
            "at_m": None if change.at is None else list(change.at),
            "heading_rad": change.heading,
        }
        for change in verdict.changes(result)
    ]


def _curve(curve: FragilityCurve, levels: list[dict[str, Any]]) -> dict[str, Any]:
    grid, fitted = curve.grid(CURVE_POINTS), curve.state is CurveState.FITTED
    low, high = curve.band(grid)
    banded = fitted and not curve.one_motion
    return {
        "state": str(curve.state),
        "method": METHOD,
        "text": curve.text,
        "intensity": grid.round(3).tolist(),
        "probability": _shares(curve.probability(grid)) if fitted else None,
        "low": _shares(low) if banded else None,
        "high": _shares(high) if banded else None,
        "observed": levels,
    }


def _shares(values: NDArray[np.float64]) -> list[float]:
    return np.round(values, 5).tolist()


def _zone(shares: NDArray[np.float64]) -> ZoneReply:
    nx, ny = shares.shape
    steps = np.round(255.0 * shares).astype(np.uint8)
    return ZoneReply(nx=nx, ny=ny, shares=base64.b64encode(steps.tobytes()).decode("ascii"))
