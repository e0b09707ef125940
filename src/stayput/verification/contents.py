"""What comes out of the furniture with each set of measures: one run of each motion is followed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.contents.carrier import Carrier
from stayput.contents.spill import spill_of
from stayput.contents.weight import emptied, opened
from stayput.errors import InputError
from stayput.execution import Call, ThreadExecutor
from stayput.fragility import Probability, probability
from stayput.fragility.probabilities import probability_of_counts
from stayput.montecarlo.hazard import FloorMotions
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import DrawTable, draws, rows_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.contents import Contents
    from stayput.model.body import Body
    from stayput.montecarlo.sampling import Rows
    from stayput.scenario import Scenario
    from stayput.verification.options import Option

OPEN = 0.5
"""How far the drawers of the bound with open drawers are out, as a part of the depth."""


MOTIONS = 40
"""Most motions under which contents are followed, the first ones: a run takes some 10 ms.

It is the size of the usual suite, whose kinds of earthquakes follow each other in turn.
"""


@dataclass(frozen=True, slots=True)
class ContentsVerdict:
    """What comes out with one option, over one run of each motion, `MOTIONS` at most, with its first draw.

    Parameters
    ----------
    out : Probability
        Share of the items that come out, on average over the runs; those of a run are alike, which the
        interval accounts for. It counts all items of a piece that overturns, but behind doors that hold.
    toppled : float
        Share of the items that turn over.
    mass_out : float
        Mass of what comes out, on average [kg].
    rigid : Probability
        Of overturning in these runs, with all contents fixed to the piece.
    emptied : Probability
        The same without the contents: the other bound of what sliding contents do to the piece.
    opened : Probability, optional
        The same with all drawers half out; none without drawers.
    """

    out: Probability
    toppled: float
    mass_out: float
    rigid: Probability
    emptied: Probability
    opened: Probability | None


def contents_verdicts(
    options: Sequence[Option], scenario: Scenario, floors: FloorMotions, seed: int, threads: int | None
) -> list[ContentsVerdict | None]:
    """Follow what is in the furniture; none of each option where the scenario says nothing of contents.

    Parameters
    ----------
    options : sequence of Option
        The options.
    scenario : Scenario
        The furniture, what is in it, and where it stands.
    floors : FloorMotions
        The motions at the scenario's shaking.
    seed : int
        Seed of the draws.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    """
    contents = scenario.contents
    if contents is None:
        return [None] * len(options)
    body, measured = scenario.furniture.body(), scenario.uncertainty.as_stated
    drawn = draws(len(floors.motions), 1, seed, as_stated=measured)
    floors, drawn = _first(floors, drawn)
    rows = [_rows(body, option, scenario, drawn) for option in options]
    followed = _followed(rows, body, contents, floors, threads)
    less = _bound(emptied(body, contents), options, scenario, drawn, floors, threads)
    wide: Sequence[Probability | None] = [None] * len(options)
    if contents.drawers != "none":
        wide = _bound_of_open_drawers(body, contents, options, scenario, drawn, floors, threads)
    return [
        _verdict(followed[place], empty, open_, contents)
        for place, (empty, open_) in enumerate(zip(less, wide, strict=True))
    ]


def _first(floors: FloorMotions, drawn: DrawTable) -> tuple[FloorMotions, DrawTable]:
    """Return the first `MOTIONS` motions, or all where there are fewer, with their draws."""
    measures = {measure: values[:MOTIONS] for measure, values in floors.measures.items()}
    columns = {name: column[:MOTIONS] for name, column in drawn.columns.items()}
    return FloorMotions(floors.motions[:MOTIONS], floors.scales[:MOTIONS], measures), DrawTable(columns)


def _rows(body: Body, option: Option, scenario: Scenario, drawn: DrawTable) -> Rows:
    room, initial = scenario.room.room(), scenario.initial.state()
    return rows_of(body, room, option.measures, drawn, scenario.gravity, initial)


COLUMNS = ("out", "toppled", "mass", "overturned", "failed")


def _followed(
    rows: Sequence[Rows], body: Body, contents: Contents, floors: FloorMotions, threads: int | None
) -> NDArray[np.float64]:
    """Return `COLUMNS` of each run, shape [options, motions, columns]: shares, mass [kg], and 0 or 1."""
    found = np.zeros((len(rows), len(floors.motions), len(COLUMNS)))

    def follow(place: int, number: int) -> tuple[int, int, tuple[float, ...]]:
        case = rows[place].cases[number].copy()
        case["scale"] = floors.scales[number]
        carrier = Carrier.of(case, rows[place].elements[number], floors.motions[number], body.height)
        if carrier.failed:
            return place, number, (0.0, 0.0, 0.0, 0.0, 1.0)
        spilt = spill_of(carrier, body, contents, followed=False)
        fell = float(carrier.overturned)
        return place, number, (spilt.share_out, spilt.share_toppled, spilt.mass_out, fell, 0.0)

    places = np.ndindex(found.shape[:2])
    with ThreadExecutor(threads) as executor:
        for _, (place, number, values) in executor.as_completed(Call(follow, *at) for at in places):
            found[place, number] = values
    return found


def _verdict(
    followed: NDArray[np.float64], empty: Probability, open_: Probability | None, contents: Contents
) -> ContentsVerdict:
    out, toppled, mass, fell, failed = followed.T
    made = failed == 0.0
    each = contents.levels * contents.items
    count = np.where(made, each, 0)
    return ContentsVerdict(
        out=probability_of_counts(np.rint(each * out).astype(int), count, each - count),
        toppled=float(toppled[made].mean()) if made.any() else np.nan,
        mass_out=float(mass[made].mean()) if made.any() else np.nan,
        rigid=probability(fell[:, np.newaxis] > 0.0, ~made[:, np.newaxis]),
        emptied=empty,
        opened=open_,
    )


def _bound(
    body: Body,
    options: Sequence[Option],
    scenario: Scenario,
    drawn: DrawTable,
    floors: FloorMotions,
    threads: int | None,
) -> list[Probability]:
    """Return how often another body overturns, by option."""
    rows = [_rows(body, option, scenario, drawn) for option in options]
    return [probability(runs.overturned, runs.missing) for runs in run_level(rows, floors, threads=threads)]


def _bound_of_open_drawers(
    body: Body,
    contents: Contents,
    options: Sequence[Option],
    scenario: Scenario,
    drawn: DrawTable,
    floors: FloorMotions,
    threads: int | None,
) -> list[Probability]:
    try:
        wide = opened(body, contents, OPEN * body.width)
    except InputError:  # it falls as the drawers open, before anything shakes it
        fallen = np.ones(drawn.shape, np.bool_)
        return [probability(fallen, ~fallen)] * len(options)
    return _bound(wide, options, scenario, drawn, floors, threads)
