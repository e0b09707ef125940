"""What comes out of the furniture with each set of measures: one run of each motion is followed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, partial
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.contents.carrier import Carrier, parts
from stayput.contents.contents import Contents, emptied, opened
from stayput.contents.spill import Spill, spill_of
from stayput.errors import InputError
from stayput.execution import Pool
from stayput.fragility.paired import Difference, difference
from stayput.fragility.probabilities import Probability, probability, probability_of_counts
from stayput.montecarlo.counting import Members
from stayput.montecarlo.library import trace_draw
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import Rows, draws, rows_of
from stayput.montecarlo.scene_draws import drawn_shaking
from stayput.simulation.many import plane_shaking

if TYPE_CHECKING:
    from stayput.mechanics.runner import Shaking
    from stayput.model.body import Body
    from stayput.scenario.measures import Option
    from stayput.verification.option_runner import OptionRunner

OPEN = 0.5
"""How far the drawers of the bound with open drawers are out, as a part of the depth."""


MOTIONS = 40
"""Most motions under which contents are followed, the first ones: a run takes some 10 ms, in space 50.

It is the size of the usual suite, whose kinds of earthquakes follow each other in turn.
"""


@dataclass(frozen=True, slots=True)
class Leaving:
    """From where and how fast things come out of a piece that stands.

    The first item of each shelf that comes out is followed until it leaves, for all of that shelf: following
    all takes as long as the runs. What falls with a piece that overturns is not in it.

    Parameters
    ----------
    height, highest : float
        Median and largest height of the shelf above the floor [m].
    speed, fast : float
        Median and 90 % quantile of the horizontal speed in the frame of the floor [m/s].
    """

    height: float
    highest: float
    speed: float
    fast: float

    @classmethod
    def of(cls, spilt: Sequence[Spill]) -> Leaving | None:
        """Return how things leave over several runs; none where nothing leaves a piece that stands."""
        standing = (_leaving(spill) for spill in spilt if not spill.overturned)
        heights, speeds = np.concatenate([np.zeros((2, 0)), *standing], axis=1)
        if not len(heights):
            return None
        middle, most = np.median(heights), np.max(heights)
        return cls(float(middle), float(most), float(np.median(speeds)), float(np.quantile(speeds, 0.9)))


def _leaving(spilt: Spill) -> NDArray[np.float64]:
    """Return height [m] and speed [m/s] of what came out, shape [2, items]: those of its shelf's followed."""
    followed = np.isfinite(spilt.time)
    counts = np.count_nonzero(spilt.out, axis=1)[followed.any(axis=1)]
    values = np.stack([spilt.height[followed], np.abs(spilt.speed[followed])])
    return np.repeat(values, counts, axis=1)


@dataclass(frozen=True, slots=True)
class ContentsVerdict:
    """What comes out with one option, over one run of each motion with its first draw.

    There are as many motions as the option has runs in the comparison, `MOTIONS` at most.

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
    emptied : Probability, optional
        The same without the contents: the other bound of what sliding contents do to the piece. Only of the
        piece with nothing in place.
    opened : Probability, optional
        The same with all drawers half out; only of the piece with nothing in place, where it has drawers.
    leaving : Leaving, optional
        From where and how fast; none where nothing comes out of a piece that stands.
    each_out : ndarray, shape (motions, items)
        Whether each item comes out: 1 or 0; NaN of a run that was given up.
    change : Difference, optional
        Share of the items that come out less that without anything, item by item; none of the latter itself.
    """

    out: Probability
    toppled: float
    mass_out: float
    rigid: Probability
    emptied: Probability | None
    opened: Probability | None
    leaving: Leaving | None
    each_out: NDArray[np.float64] = field(compare=False, repr=False)
    change: Difference | None = None


def contents_verdicts(
    runner: OptionRunner, options: Sequence[Option], runs: Sequence[int]
) -> list[ContentsVerdict | None]:
    """Follow what is in the furniture; none of each option where the scenario says nothing of contents.

    Parameters
    ----------
    runner : OptionRunner
        Under whose motions and draws the furniture is run.
    options : sequence of Option
        The options; the first has nothing in place.
    runs : sequence of int
        How many runs each has in the comparison.
    """
    scenario = runner.scenario
    contents = scenario.contents
    if contents is None:
        return [None] * len(options)
    body = scenario.piece.body()
    spilt = spilt_by_option(runner, options, runs, contents, followed=1)
    count = len(spilt[0])
    overturns = partial(_overturns_in_plane if runner.in_plane else _overturns_in_space, runner, options[0])
    less, wide = overturns(emptied(body, contents), count), None
    if contents.drawers != "none":
        try:
            pulled_out = opened(body, contents, OPEN * body.width)
        except InputError:  # it falls as the drawers open, before anything shakes it
            fallen = np.ones((count, 1), np.bool_)
            wide = probability(fallen, ~fallen)
        else:
            wide = overturns(pulled_out, count)
    bare = _verdict(spilt[0], less, wide, contents)
    others = (_verdict(of_option, None, None, contents) for of_option in spilt[1:])
    return [bare, *(replace(other, change=less_out(other, bare, len(options) - 1)) for other in others)]


def less_out(first: ContentsVerdict, second: ContentsVerdict, comparisons: int) -> Difference:
    """Return how much likelier it is that an item comes out with the first option than with the second."""
    both = slice(min(len(first.each_out), len(second.each_out)))
    a, b = first.each_out[both], second.each_out[both]
    return difference(a == 1.0, b == 1.0, np.isnan(a + b), comparisons=comparisons)


def spilt_by_option(
    runner: OptionRunner,
    options: Sequence[Option],
    runs: Sequence[int],
    contents: Contents,
    followed: int = 0,
) -> list[list[Spill | None]]:
    """Follow what is in a piece with each option; None where the piece's run is given up.

    Parameters
    ----------
    runner, options, runs
        As for `contents_verdicts`.
    contents : Contents
        What is in it.
    followed : int
        How many items of each shelf are followed until they leave a piece that stands.
    """
    body = runner.scenario.piece.body()
    carrier = (_carriers_in_plane if runner.in_plane else _carriers_in_space)(runner, options)
    most = min(runner.settings.motions, MOTIONS)
    each = [(place, motion) for place, of in enumerate(runs) for motion in range(min(of, most))]

    def follow(place: int, motion: int) -> Spill | None:
        carried = carrier(place, motion)
        if carried.failed:
            return None
        return spill_of(carried, body, contents, followed=0 if carried.overturned else followed)

    with Pool(runner.threads) as pool:
        spilt = [*pool.in_order(partial(follow, *at) for at in each)]
    return [
        [spill for at, spill in zip(each, spilt, strict=True) if at[0] == place]
        for place in range(len(options))
    ]


Carriers: TypeAlias = "Callable[[int, int], Carrier]"
"""How the piece moves with an option under a motion, with its first draw."""


def _rows_in_plane(runner: OptionRunner, body: Body, option: Option) -> Rows:
    """Return a body with an option in the plane under the first draw of each motion."""
    scenario, settings = runner.scenario, runner.settings
    motions = min(settings.motions, MOTIONS)
    drawn = draws(motions, 1, settings.seed, as_stated=settings.as_stated, quantities=settings.quantities)
    stands = settings.gravity, scenario.initial.state()
    return rows_of(body, scenario.room.room(), option.measures, drawn, *stands)


def _overturns_in_plane(runner: OptionRunner, option: Option, other: Body, count: int) -> Probability:
    """Return how often another body with an option overturns under so many motions."""
    floors = runner.floors
    floors = replace(floors, motions=floors.motions[:MOTIONS], scales=floors.scales[:MOTIONS])
    (runs,) = run_level([_rows_in_plane(runner, other, option)], floors, threads=runner.threads)
    return runs.chosen(slice(count)).probability_of_overturning()


def _overturns_in_space(runner: OptionRunner, option: Option, other: Body, count: int) -> Probability:
    scene = runner.scene(option)
    other_scene = replace(scene, pieces=[replace(piece, body=other) for piece in scene.pieces])
    # a library of its own: as in the plane its runs do not count
    anew = runner.scene_runner.anew(lambda _runs: runner.advance(0))
    with runner.scenario.naming_keys():
        (runs,) = anew.run([other_scene], Members.of_samples(count, 1))
    return runs.probability_of_overturning()


def _carriers_in_plane(runner: OptionRunner, options: Sequence[Option]) -> Carriers:
    body, floors = runner.scenario.piece.body(), runner.floors
    rows = [_rows_in_plane(runner, body, option) for option in options]

    @cache
    def shaking(motion: int) -> Shaking:
        return plane_shaking(floors.motions[motion])

    def carrier(place: int, motion: int) -> Carrier:
        case = rows[place].cases[motion].copy()
        case["scale"] = floors.scales[motion]
        return Carrier.of(case, rows[place].elements[motion], shaking(motion), body.height)

    return carrier


def _carriers_in_space(runner: OptionRunner, options: Sequence[Option]) -> Carriers:
    scenario, floors, gravity = runner.scenario, runner.floors, runner.settings.gravity
    scenes, stands = [*map(runner.scene, options)], scenario.initial.state()

    def carrier(place: int, motion: int) -> Carrier:
        scene, draw = scenes[place], runner.scene_runner.library.draws.draw(motion, 0, ("0",))
        shaken = drawn_shaking(floors.motions[motion], float(floors.scales[motion]), draw, gravity)
        fine = shaken.refined(parts(shaken.dt))
        traced = trace_draw(scene, draw, fine, gravity, scene.names, stands)
        return Carrier.of_trace(fine, traced, scenario.piece.body().height)

    return carrier


def runs_of_contents(contents: Contents, motions: int) -> int:
    """Return how many simulations the contents take for each option: of the piece, and of its items.

    Parameters
    ----------
    contents : Contents
        What is in the furniture.
    motions : int
        Motions of the verification.
    """
    return min(motions, MOTIONS) * (1 + contents.levels * contents.items)


def share_out(spilt: Sequence[Spill | None], contents: Contents) -> Probability:
    """Return the share of the items that come out, over the runs that were not given up."""
    each = contents.levels * contents.items
    items = np.array([0 if spill is None else each for spill in spilt])
    out = np.array([0 if spill is None else np.count_nonzero(spill.out) for spill in spilt])
    return probability_of_counts(out, items, each - items)


def _verdict(
    spilt: Sequence[Spill | None], empty: Probability | None, open_: Probability | None, contents: Contents
) -> ContentsVerdict:
    made = [spill for spill in spilt if spill is not None]
    unknown = np.full(contents.levels * contents.items, np.nan)
    fell = np.array([spill is not None and spill.overturned for spill in spilt])
    return ContentsVerdict(
        out=share_out(spilt, contents),
        toppled=float(np.mean([spill.share_toppled for spill in made])) if made else np.nan,
        mass_out=float(np.mean([spill.mass_out for spill in made])) if made else np.nan,
        rigid=probability(fell[:, np.newaxis], np.array([spill is None for spill in spilt])[:, np.newaxis]),
        emptied=empty,
        opened=open_,
        leaving=Leaving.of(made),
        each_out=np.array([unknown if spill is None else spill.out.ravel() for spill in spilt], np.float64),
    )
