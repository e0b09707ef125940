"""The results: Parquet files with a row for each piece and event, written atomically."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.files import arrow
from stayput.fragility.paired import score_interval
from stayput.fragility.probabilities import CONFIDENCE, probability_of_counts
from stayput.inventory.folder import Workspace, digest_of
from stayput.inventory.items import NO_MEASURE
from stayput.inventory.store import GROUND
from stayput.montecarlo.counting import EVENTS, OVERTURNED, RANKING_ORDER, RANKING_RESOLUTION, SLID
from stayput.verification.words import SAFE, SMALL

if TYPE_CHECKING:
    from stayput.inventory.work import Work

PIECES = "pieces"
ENDS = ("", "_low", "_high")
"""An estimate, and the ends of its interval."""

OUT = "contents_out_share"
"""Share of the contents that come out."""

_NUMBERS = (
    *(f"{event}{end}" for event in EVENTS for end in ENDS),
    *("slide_median", "slide_p90", "slide_mean"),
    *(f"{OUT}{end}" for end in ENDS),
)
"""Columns of the numbers in a record."""


class Finding(StrEnum):
    """What the runs show of a row: a statement that holds over its intervals, not for its estimates alone."""

    NEEDS_NONE = "needs_none"
    HELPED = "helped"
    MAY_BE_CHANCE = "may_be_chance"
    NOT_HELPED = "not_helped"
    NONE_POSSIBLE = "none_possible"
    NONE_COMPARED = "none_compared"
    TOO_FEW_RUNS = "too_few_runs"


@cache
def least_motions() -> int:
    """Return from how many motions on a piece that never overturned can be known to need no measure."""
    return next(n for n in itertools.count(2) if probability_of_counts(np.zeros(n), np.ones(n)).high < SAFE)


def schema(metadata: Mapping[str, str]) -> Any:
    """Return the schema of the results; each field's metadata says its unit and meaning."""
    pa = arrow()

    def number(name: str, about: str, kind: Any = None) -> Any:
        return pa.field(name, kind or pa.float64(), metadata={"about": about})

    def chances(of: str) -> list[Any]:
        return [
            field
            for event in EVENTS
            for field in interval(event, "probability", f": {event.replace('_', ' ')}{of}")
        ]

    def interval(name: str, about: str, of: str = "") -> list[Any]:
        meanings = zip(ENDS, (about, "95 % interval from", "95 % interval to"), strict=True)
        return [number(f"{name}{end}", f"{meaning}{of}") for end, meaning in meanings]

    slides = [
        number("slide_median", "median of the peak slide [m], infinite where so many overturn"),
        number("slide_p90", "90 % quantile of the peak slide [m], infinite where so many overturn"),
        number("slide_mean", "expected peak slide of those that stay upright [m]"),
    ]
    inside = interval(OUT, "expected share of the contents that come out; null where nothing is said of them")
    option = pa.struct(
        [
            pa.field("name", pa.string()),
            *(pa.field(column.name, column.type) for column in (*chances(""), *slides, *inside)),
            pa.field("cost", pa.float64()),
            pa.field("expected_loss", pa.float64()),
        ]
    )
    fields = [
        number("row", "row of the inventory, the header being row 1", pa.int64()),
        number("id", "the piece", pa.string()),
        number("name", "what the table calls the piece; null where it says nothing", pa.string()),
        number("event", "the earthquake", pa.string()),
        number("station", "the scenario that was taken", pa.string()),
        number(GROUND[0], "JMA intensity of the ground, median of the motions"),
        number(GROUND[1], "Sa of the ground [g] that a shake map tells; null without such a map"),
        number(GROUND[2], "peak acceleration of the ground [m/s²] that a shake map tells; null without such"),
        number(GROUND[3], "peak velocity of the ground [cm/s] that a shake map tells; null without such"),
        number(
            "shaking_scatter",
            "standard deviation of what a shake map tells: of the intensity, else of the common logarithm",
        ),
        number("building", "the building; null on the ground", pa.string()),
        number("storey", "the storey, below 0 in a basement; null on the ground", pa.int32()),
        number("lat", "latitude [°]"),
        number("lon", "longitude [°]"),
        number("count", "pieces of this kind", pa.int32()),
        number("value", "loss if one of them overturns"),
        number("fixed", "measures that fix it already, in every set; null where none do", pa.string()),
        number("motions", "motions", pa.int32()),
        number("runs", "simulations without a measure that were not given up", pa.int32()),
        number("given_up", "simulations that were given up", pa.int32()),
        *(column for column in chances(", without a measure") if not column.name.startswith("device_failed")),
        *slides,
        *inside,
        number("expected_loss", "count · value · probability of overturning, without a measure"),
        number(
            "best",
            "the set of measures that lowers the risk most: of overturning, else of sliding too far, of a "
            "device that fails, of hitting the wall; 'none' where none does",
            pa.string(),
        ),
        *interval("best_overturned", "probability of overturning with it"),
        number(
            "best_lessens",
            "the event that ranks the best first; beside overturning, or that it overturns",
            pa.string(),
        ),
        number("best_change", "probability of that event with the best less that without, run by run"),
        number("best_change_low", "95 % interval from, which holds for all sets that are compared together"),
        number("best_change_high", "95 % interval to"),
        number(
            "finding",
            "helped: the interval of best_change is below 0; may_be_chance: it is not; needs_none: no set is "
            f"better, and the intervals of overturning and sliding too far end below {SAFE}; too_few_runs: "
            "they do not, though it hardly happened; not_helped: no set is seen to help; none_possible, "
            "none_compared: there was none to compare; null: no runs",
            pa.string(),
        ),
        number(f"best_{OUT}", "expected share of the contents that come out with the best"),
        number("risk_reduction", "probability of overturning without a measure less that with the best"),
        number("best_expected_loss", "count · value · probability of overturning with the best"),
        number("best_by_cost", "the measure that is most worth its cost; 'none' where none is", pa.string()),
        number("best_by_cost_gain", "loss avoided less cost (with a value), or risk reduction per cost"),
        pa.field("options", pa.list_(option), metadata={"about": "each set of measures, none first"}),
        number(
            "not_possible",
            "sets of measures that cannot be put in place, with the reason",
            pa.list_(pa.struct([(name, pa.string()) for name in ("name", "reason", "reason_ja")])),
        ),
    ]
    return pa.schema(fields, metadata=dict(metadata))


class RiskChange(NamedTuple):
    """How much likelier an event is with an option than without a measure, run by run."""

    estimate: float
    low: float
    high: float


class Choice(NamedTuple):
    """The best of a row's options by risk, and by cost with its gain; options by their place.

    ``event`` is the one that the best lessens, ``change`` by how much; none where none is better.
    """

    best: int
    event: str | None
    change: RiskChange | None
    by_cost: int | None
    gain: float | None


def _change(records: NDArray[np.void], option: int, event: str) -> RiskChange:
    """Return how much likelier an event, or overturning, is with an option than without, run by run."""
    return RiskChange(*records["change"][option, EVENTS.index(event)].tolist())


def choose(
    records: NDArray[np.void], sizes: list[int], costs: list[float] | None, value: float | None
) -> Choice:
    """Choose among options, that without a measure first.

    By risk: by how much less likely than without a measure the events of `RANKING_ORDER` are, run by run,
    since options may have other numbers of runs; a piece that overturns is as bad as one that also slid or
    hit a wall. A measure that does no better than none, or with which it overturns more often by however
    little, is not taken: then none of them helps.
    By cost: with a value, the largest loss avoided less cost; else the largest fall of the probability of
    overturning for its cost. Only an option with which it clearly overturns less often is taken.

    Parameters
    ----------
    records : ndarray of `stayput.inventory.store.RECORD`
        Outcomes of the options.
    sizes : list of int
        Number of measures of each.
    costs : list of float, optional
        Cost of each but the first.
    value : float, optional
        Loss if a piece overturns.
    """
    ordered = [EVENTS.index(event) for event in RANKING_ORDER]
    changes: NDArray[np.float64] = records["change"][:, ordered, 0]
    changes[0] = 0.0
    known = np.isfinite(changes.sum(axis=1))
    steps: list[list[float]] = np.round(
        np.where(known[:, np.newaxis], changes, 1.0) / RANKING_RESOLUTION
    ).tolist()
    no_worse = [n for n in range(len(steps)) if not changes[n, 0] > 0.0]
    best = min(no_worse, key=lambda n: (*steps[n], sizes[n], n))
    event = next((event for event, step in zip(RANKING_ORDER, steps[best], strict=True) if step), None)
    change = None if event is None else _change(records, best, event)
    if change is None or not change.estimate < 0.0:
        best, event, change = 0, None, None
    if costs is None:
        return Choice(best, event, change, None, None)
    seen = -changes[1:, 0]
    clear = [gain > 0.0 and _change(records, n, OVERTURNED).high < 0.0 for n, gain in enumerate(seen, 1)]
    avoided = np.where(clear, seen, 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        cost = np.array(costs)
        gains = np.where(avoided > 0.0, avoided / cost, 0.0) if value is None else value * avoided - cost
    gains = np.nan_to_num(gains, nan=-np.inf)
    place = int(np.argmax(gains))
    if not gains[place] > 0.0:
        return Choice(best, event, change, 0, 0.0)
    return Choice(best, event, change, place + 1, float(gains[place]))


def finding_of(row: Mapping[str, Any], choice: Choice) -> Finding | None:
    """Return what is shown of a row of the plan with the numbers of its first option; none without runs."""
    if not row["runs"]:
        return None
    if choice.change is not None:
        return Finding.HELPED if choice.change.high < 0.0 else Finding.MAY_BE_CHANCE
    if max(row[f"{event}_high"] for event in (OVERTURNED, SLID)) < SAFE:
        return Finding.NEEDS_NONE
    if max(row[OVERTURNED], row[SLID]) < SMALL:
        return Finding.TOO_FEW_RUNS
    if compared := len(row["options"]) - 1:
        seen = any(_may_be_seen(row[event], row["runs"], compared) for event in (OVERTURNED, SLID))
        return Finding.NOT_HELPED if seen else Finding.TOO_FEW_RUNS
    return Finding.NONE_POSSIBLE if row["not_possible"] else Finding.NONE_COMPARED


def _may_be_seen(share: float, runs: int, compared: int) -> bool:
    """Whether so many runs, independent at best, could show beyond chance that a measure prevents a share."""
    return score_interval(0.0, share * runs, runs, 1.0 - (1.0 - CONFIDENCE) / compared)[1] < 0.0


def part_names(parts: int) -> list[str]:
    """Return the names of the parts of the results."""
    return [f"part-{number:06d}.parquet" for number in range(parts)]


def write_results(
    folder: Path, space: Workspace, work: Work, metadata: Mapping[str, str], advance: Callable[[int], None]
) -> None:
    """Write the parts of the results that are not complete yet.

    Parameters
    ----------
    folder : Path
        Where they go.
    space : Workspace
        Makes their files.
    work : Work
        The plan, and the outcomes of all its units.
    metadata : mapping
        Metadata of every part.
    advance : callable
        Called with the number of rows that are complete.
    """
    pa, columns, outcomes = arrow(), schema(metadata), work.outcomes
    folder.mkdir(exist_ok=True)
    for number, name in enumerate(part_names(work.store.facts()["parts"])):
        rows, digest = outcomes.part(name) or (0, None)
        if not (folder / name).exists() or digest_of(folder / name) != digest:
            table = pa.Table.from_pylist(_lines(work.store.part(number), work), schema=columns)
            with space.durable(folder / name) as file:
                arrow("parquet").write_table(table, file, compression="zstd", row_group_size=20_000)
            rows = table.num_rows
            outcomes.complete(name, rows, digest_of(folder / name))
        advance(rows)


def _lines(rows: list[dict[str, Any]], work: Work) -> list[dict[str, Any]]:
    """Return the rows of a part of the results from those of the plan."""
    wanted = np.unique(np.concatenate([row["records"] for row in rows]).astype(np.int64))
    records = work.outcomes.of(wanted)
    chosen: dict[Any, tuple[Choice, list[dict[str, Any]]]] = {}
    lines: list[dict[str, Any]] = []
    for row in rows:
        key = (tuple(row["records"]), tuple(row["options"]), tuple(row["costs"] or ()), row["value"])
        if key not in chosen:
            option_records = records[np.searchsorted(wanted, row["records"])]
            sizes = [0 if name == NO_MEASURE else 1 + name.count("+") for name in row["options"]]
            choice = choose(option_records, sizes, row["costs"], row["value"])
            chosen[key] = choice, [numbers_of(record) for record in option_records]
        lines.append({**_line(row, *chosen[key]), **work.strengths(row["station"], row["level"])})
    return lines


def _line(row: dict[str, Any], choice: Choice, numbers: list[dict[str, Any]]) -> dict[str, Any]:
    count, value = row["count"], row["value"]

    def loss(option: dict[str, Any]) -> float | None:
        return None if value is None else count * value * option[OVERTURNED]

    without, best, change = numbers[0], numbers[choice.best], choice.change
    costs = [None] * len(numbers) if row["costs"] is None else [0.0, *row["costs"]]
    options = [
        {**option, "name": name, "cost": cost, "expected_loss": loss(option)}
        for name, option, cost in zip(row["options"], numbers, costs, strict=True)
    ]
    return {
        **row,
        **without,
        "expected_loss": loss(without),
        "best_expected_loss": loss(best),
        "best": row["options"][choice.best],
        **{f"best_{OVERTURNED}{end}": best[f"{OVERTURNED}{end}"] for end in ENDS},
        **{f"best_change{end}": getattr(change, end.lstrip("_") or "estimate", None) for end in ENDS},
        "best_lessens": choice.event,
        "finding": finding_of({**row, **without}, choice),
        f"best_{OUT}": best[OUT],
        "risk_reduction": without[OVERTURNED] - best[OVERTURNED],
        "best_by_cost": None if choice.by_cost is None else row["options"][choice.by_cost],
        "best_by_cost_gain": choice.gain,
        "options": options,
    }


def numbers_of(record: np.void) -> dict[str, Any]:
    """Return the numbers of an option by their columns."""
    out = [None] * 3 if np.isnan(record["out"][0]) else record["out"].tolist()
    numbers = *record["chances"].ravel().tolist(), *record["slide"].tolist(), *out
    return {
        "motions": int(record["motions"]),
        "runs": int(record["runs"]),
        "given_up": int(record["missing"]),
        **dict(zip(_NUMBERS, numbers, strict=True)),
    }
