"""A verification as a job: which options it compares, and its verdict as plain data."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import ConfigDict, Field

from stayput.app.messages import Problem, Reply, Words
from stayput.app.running import own_measures
from stayput.app.scenes import motions_of, refusal, too_many
from stayput.errors import InputError
from stayput.fragility.curve import METHOD, FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures import hold
from stayput.report.summary import by_language
from stayput.report.verdict.data import everyday_data, verdict_data
from stayput.report.verdict.tables import estimate_rows
from stayput.scenario import Scenario
from stayput.scenario.measures import YOURS, table_of
from stayput.verification.contents import runs_of_contents
from stayput.verification.events import CELL
from stayput.verification.notes import everyday_note, left_out_of_held, shaken_notes
from stayput.verification.options import compared_options, usual, weakest
from stayput.verification.room_words import tags
from stayput.verification.words import asides

if TYPE_CHECKING:
    from stayput.app.limits import Limits
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

CURVE_POINTS = 61
"""Intensities at which a curve is sent."""


class PartReply(Reply):
    """A part of a verdict, with all that the verdict's JSON file says of it."""

    model_config = ConfigDict(extra="allow")


class ShareReply(PartReply):
    """A probability with its 95 % interval, or a change of one."""

    estimate: float | None
    low: float | None
    high: float | None


class CurveReply(Reply):
    """Probability of overturning over the ground's JMA intensity: a fit to all runs, with its 95 % band."""

    method: str
    text: str
    intensity: list[float]
    probability: list[float]
    low: list[float]
    high: list[float]
    observed: list[ShareReply] = Field(description="Shares of groups of runs, each of an intensity `im`.")


class ZoneReply(Reply):
    """A share of the runs on each cell of the floor."""

    nx: int
    ny: int
    shares: str = Field(description="Base 64 of bytes, 255 being 1: all y of the first x, then the next.")


class PieceVerdictReply(PartReply):
    """What becomes of a piece with an option."""

    name: str
    probabilities: dict[str, ShareReply]
    falls: bool = Field(description="Whether it overturns so often that it is to be held.")
    fell: ZoneReply | None = Field(
        default=None, description="Where it lies in a room having overturned: its fall zone."
    )
    stood: ZoneReply | None = Field(
        default=None, description="Where it ends there without having overturned: its slide zone."
    )


class ChangeReply(Reply):
    """What an option changes of a room as it is."""

    what: str
    table: str = Field(description="Where it is in the scene: furniture or places.")
    measures: list[dict[str, Any]] | None = Field(description="What is put on the piece, as in a scene.")
    drilled: bool
    at_m: list[float] | None
    heading_rad: float | None


class OptionReply(PartReply):
    """One of the things that may be done."""

    rank: int
    name: str
    label: Words
    measures: list[dict[str, Any]] = Field(description="On all pieces, as a scene has them.")
    reason: Words
    asides: list[Words] = Field(
        description="What comes out, and how often it overturns as people install it, where that is asked."
    )
    grade: str = Field(description="How well founded its numbers are: A, B or C; see grades.")
    weakest: list[Words] = Field(description="The inputs of that grade.")
    yours: bool
    runs: int = Field(description="How often it ran; what is not as good may have run less often.")
    probabilities: dict[str, ShareReply]
    overturned_change: ShareReply | None = Field(description="Less the probability without measures.")
    pieces: list[PieceVerdictReply]
    people: dict[str, Any] | None = Field(description="What happens to people in a room.")
    changes: list[ChangeReply] = Field(default=[], description="What it changes of a room as it is.")
    tags: list[Words] = Field(default=[], description="What is clearly better or worse with it in a room.")
    helps: bool
    curve: CurveReply | None


class EverydayReply(Reply):
    """What the piece withstands without an earthquake."""

    sentence: Words = Field(description="The worst case.")
    cases: list[dict[str, Any]] = Field(description="Moments about the front edge, least margin first.")


class VerdictReply(PartReply):
    """The outcome of a verification, the best option first."""

    complete: bool = Field(description="Whether it is final; else more runs are still to come.")
    verdict: Words
    left_out: Words | None = Field(description="What the numbers leave out of the shaking.")
    notes: list[Words] = Field(description="What must be said beside the numbers.")
    grades: dict[str, Words] = Field(description="What each grade of inputs means.")
    jma_intensity: float | None
    motions: int
    runs: int = Field(description="Of all options together.")
    seconds: float
    options: list[OptionReply]
    not_possible: list[dict[str, Any]] = Field(description="Options that cannot be put in place, and why.")
    estimates: dict[str, Any] | None = Field(
        description="Of a lone piece, by formulas, without measures; `rows` are in words."
    )
    everyday: EverydayReply | None
    cell_m: float | None = Field(description="Side of a cell of the floor of a room.")


class JobReply(Reply):
    """A verification that is under way or done."""

    id: str
    state: Literal["waiting", "running", "done", "cancelled", "failed"]
    done: int
    total: int
    progress: float
    seconds: float
    position: int | None = Field(description="How many jobs have their turn before it, while it waits.")
    error: Problem | None
    result: VerdictReply | None = Field(description="As far as it is known; final once it is `complete`.")


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


def runs_of(scenario: Scenario, limits: Limits) -> int:
    """Return how many simulations a verification makes at most: of a room, those of it as it is.

    Raises
    ------
    RefusedError
        More than this server allows, or a piece that cannot stand where it does in its room.
    """
    motions = motions_of(scenario.shaking)
    runs = motions * max(1, -(-scenario.samples // motions))
    if scenario.plan is not None:
        allowed = limits.runs_of_room
        try:
            with scenario.naming_keys():
                scenario.scene().refuse_wrong_places()
        except InputError as error:
            raise refusal(error) from None
    else:
        allowed = limits.runs if scenario.dimensions == 2 else limits.runs_in_space
        options = len(compared_options(scenario)[0])
        runs *= options * (1 + (scenario.uncertainty.badly(1.0) > 0.0))
        if scenario.contents is not None:
            runs += options * runs_of_contents(scenario.contents, motions)
    if runs > allowed:
        raise too_many("uncertainty.samples", runs, allowed, "app.runs")
    return runs


def verdict_reply(verdict: Verdict) -> VerdictReply:
    """Return a verdict as its JSON file has it, with what the page says and draws beside it."""
    data, scenario = verdict_data(verdict), verdict.scenario
    for key in ("assumptions", "scenario_toml"):  # they are in the report
        del data[key]
    for result, option in zip(verdict.options, data["options"], strict=True):
        _extend_option(option, result, verdict)
        if scenario.plan is not None:
            _extend_room(option, result, verdict)
    if verdict.estimates is not None:
        data["estimates"]["rows"] = _estimates(verdict)
    left_out = left_out_of_held(verdict)
    return VerdictReply.model_validate(
        {
            **data,
            "complete": verdict.complete,
            "left_out": None if left_out is None else Words.of(left_out),
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
    grid = curve.grid(CURVE_POINTS)
    low, high = curve.band(grid)
    return {
        "method": METHOD,
        "text": curve.text,
        "intensity": grid.round(3).tolist(),
        "probability": _shares(curve.probability(grid)),
        "low": _shares(low),
        "high": _shares(high),
        "observed": levels,
    }


def _shares(values: NDArray[np.float64]) -> list[float]:
    return np.round(values, 5).tolist()


def _zone(shares: NDArray[np.float64]) -> ZoneReply:
    nx, ny = shares.shape
    steps = np.round(255.0 * shares).astype(np.uint8)
    return ZoneReply(nx=nx, ny=ny, shares=base64.b64encode(steps.tobytes()).decode("ascii"))
