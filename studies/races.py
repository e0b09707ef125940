"""Races of options in scenes of which 800 runs of each option are known.

The runs of a scene are of 400 motions with two draws of each. A race meets 40 of the motions, drawn anew for
each race, with the same draws and at the same levels as a verification: many races of a scene tell how often
its intervals hold what all of the runs say, how often the option that is told to be the best is nearly the
best, and how often what is called clearly better is. What all of the runs say has an interval of its own.
Some of the scenes were looked at only when the race was as it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import pandas as pd
import xarray as xr

from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.fragility.probabilities import Probability, probability, probability_of_counts
from stayput.fragility.trials import Trials
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import DEVICE
from stayput.montecarlo.counting import OFFSETS, SLIDE_LIMIT, Members
from stayput.montecarlo.runs import Runs
from stayput.verification.people import events_of
from stayput.verification.race import Race
from studies.study import COLOURS, Quantity, Study, panels

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

RECORDED = Path(__file__).with_name("races.npz")
"""What became of the runs of all scenes: written by `studies.race_scenes`."""

MOTIONS = 40
"""Motions of a race; an option has 60 runs at most."""

BESIDE = (-0.75, 0.75)
"""Where curves are looked at: JMA's intensity less that which is stated."""

RUNS_BESIDE = 120
"""Runs at each of `BESIDE`, each of a motion of its own."""

NEARLY = 0.05
"""By how much an option that is nearly the best happens more often than the best."""

AIMS = {"intervals": 0.93, "best": 0.95, "clear": 0.975, "curves": 0.93}
"""Shares of races that are asked for."""


@dataclass(frozen=True, eq=False)
class Scene:
    """What became of the runs of a scene.

    Parameters
    ----------
    name : str
        The scene.
    seen : bool
        Whether it was looked at while the race was made.
    fell, slid : ndarray of bool, shape (options, motions, draws)
        Whether a counted piece overturned, and whether one slid too far; the first option is to do nothing.
    energy : ndarray, shape (options, motions, draws, places)
        Energy with which a falling piece hits the place of each person, 0 where none does [J].
    beside : ndarray, shape (2, options)
        Share that overturns at `BESIDE`, of the options that were run there; NaN of others.
    """

    name: str
    seen: bool
    fell: NDArray[np.bool_]
    slid: NDArray[np.bool_]
    energy: NDArray[np.float64]
    beside: NDArray[np.float64]

    @property
    def in_room(self) -> bool:
        """Whether it is a room with people: where they are hit is read first."""
        return self.energy.shape[-1] > 0

    @cached_property
    def truth(self) -> list[Probability]:
        """How often what people read happens at the stated shaking, with each option."""
        options, motions, draws = self.fell.shape
        members = Members.in_turn(motions, motions * draws, beside=not self.in_room)
        stated = members.level.reshape(draws, motions).T == 0
        reads: NDArray[np.bool_] = np.any(self.energy > 0.0, axis=-1) if self.in_room else self.fell
        runs, none = stated.sum(axis=1), np.zeros(motions)
        return [
            probability_of_counts((reads[option] & stated).sum(axis=1), runs, none)
            for option in range(options)
        ]

    @cached_property
    def truth_beside(self) -> list[tuple[int, float, Probability]]:
        """Option, one of `BESIDE`, and how often something overturns there."""
        places = zip(*np.nonzero(np.isfinite(self.beside)), strict=True)
        fallen = np.arange(RUNS_BESIDE)[:, np.newaxis] + 0.5
        return [
            (option, BESIDE[place], probability(fallen < RUNS_BESIDE * self.beside[place, option]))
            for place, option in places
        ]

    def motions_of(self, race: int) -> NDArray[np.intp]:
        """Return the motions of a race of a number; each keeps its family and its levels.

        Levels come again after 25 motions of a suite and families after 20: both after 100.
        """
        rng = np.random.default_rng(race)
        first, which = 25 * rng.integers(4), rng.integers(self.fell.shape[1] // 100, size=MOTIONS)
        return (first + np.arange(MOTIONS)) % 100 + 100 * which


class Replayed:
    """What a race asks of a `stayput.verification.option_runner.OptionRunner`, of runs made before.

    Parameters
    ----------
    scene : Scene
        The runs.
    motions : ndarray of int
        Which of the motions it meets, in their order.
    """

    in_plane = False

    def __init__(self, scene: Scene, motions: NDArray[np.intp]) -> None:
        self.fell, self.slid = scene.fell[:, motions], scene.slid[:, motions]
        self.energy = scene.energy[:, motions]
        self.members = Members.in_turn(MOTIONS, 3 * MOTIONS // 2, beside=not scene.in_room)
        places = [SimpleNamespace(day=1.0, night=1.0)] * scene.energy.shape[-1]
        self._plan = SimpleNamespace(places=places) if scene.in_room else None
        self.scenario = SimpleNamespace(plan=self._plan, alone=not scene.in_room)
        self.settings = SimpleNamespace(precision=None, slide_limit=SLIDE_LIMIT, all_runs=False)

    def plan(self, option: Any) -> Any:
        """Return the plan of the room."""
        return self._plan

    def run(self, options: Iterable[Any], members: Members, *, keep: bool) -> list[Runs]:
        """Return runs of options."""
        return [self._runs(option.number, members) for option in options]

    def _runs(self, number: int, members: Members) -> Runs:
        at, n = (number, members.motion, members.sample), len(members)
        energy = self.energy[at][:, :, np.newaxis]
        slide: NDArray[np.float64] = np.where(self.slid[at], 2.0 * SLIDE_LIMIT, 0.0)
        hits: NDArray[np.float64] = np.stack([energy, energy, energy, np.ones_like(energy)], axis=-1)
        hits[energy == 0.0] = np.nan
        results = np.zeros((n, 1), RESULT)
        results["outcome"] = OVERTURNED_OUTCOME  # a place without energy is hit by nothing
        no, nothing = np.zeros(n, np.bool_), np.zeros((n, 0))
        return Runs(
            members=members,
            overturned=self.fell[at],
            missing=no,
            hit_wall=no,
            device_failed=no,
            slide=slide,
            tilt=np.zeros(n),
            devices=np.zeros((n, 0), DEVICE),
            used=nothing,
            masses=np.zeros(n),
            results=results,
            hits=hits,
            blocked=nothing.astype(np.bool_),
            shut_in=nothing.astype(np.bool_),
            tracks=nothing.astype(object),
        )


class Told(NamedTuple):
    """What a race told: how many runs it took, and what of it is right, each thing by itself.

    The leaders are what is without anything and the best: their intervals once more.
    """

    runs: int
    intervals: list[bool]
    leaders: list[bool]
    best: list[bool]
    clear: list[bool]
    curves: list[bool]


def race_of(scene: Scene, motions: NDArray[np.intp]) -> Told:
    """Run a race under some of the motions of a scene."""
    runner: Any = Replayed(scene, motions)
    options: Any = [SimpleNamespace(number=n, count=n) for n in range(len(scene.fell))]
    race = Race(runner, options)
    for _ in race.looks():
        pass
    runs, truth = race.runs, scene.truth
    reads = [events_of(of)["hit"] if scene.in_room else of.overturned for of in runs]
    chances = [of.probability(read) for of, read in zip(runs, reads, strict=True)]
    changes = [
        of.difference(read, runs[0], reads[0], len(runs) - 1)
        for of, read in zip(runs[1:], reads[1:], strict=True)
    ]
    best = 1 + min(range(len(changes)), key=lambda n: changes[n].estimate)
    share = [known.estimate for known in truth]
    nearly = share[best] <= min(share[1:]) + NEARLY or min(share) >= share[0] - NEARLY
    helps = [n for n, change in enumerate(changes, 1) if change.clear and change.estimate < 0.0]
    curves = list[bool]()
    for n, offset, known in scene.truth_beside:
        im = np.array(OFFSETS)[runs[n].members.level]
        of_option = im, runs[n].overturned, runs[n].missing, runs[n].members.motion
        curve = FragilityCurve("", Trials.of_runs(JMA_INTENSITY, *of_option, len(OFFSETS)))
        (low, high), estimate = curve.band(offset), curve.probability(offset)
        curves.append(
            agree(replace(known, low=float(low), estimate=float(estimate), high=float(high)), known)
        )
    holds = [agree(chance, known) for chance, known in zip(chances, truth, strict=True)]
    return Told(
        sum(len(of.members) for of in runs),
        holds,
        [holds[0], holds[best]],
        [nearly],
        [share[n] < share[0] for n in helps],
        curves,
    )


def agree(told: Probability, known: Probability) -> bool:
    """Return whether an interval holds what is known to within another (as Zou and Donner 2008)."""
    difference = known.estimate - told.estimate
    low = math.hypot(known.estimate - known.low, told.high - told.estimate)
    high = math.hypot(known.high - known.estimate, told.estimate - told.low)
    return -high <= difference <= low


def scenes(recorded: Path = RECORDED) -> list[Scene]:
    """Return the scenes of which runs are recorded."""
    with np.load(recorded) as file:
        return [
            Scene(
                str(name),
                bool(file[f"{name}/seen"]),
                _unpacked(file[f"{name}/fell"], file[f"{name}/shape"]),
                _unpacked(file[f"{name}/slid"], file[f"{name}/shape"]),
                file[f"{name}/energy"].astype(np.float64),
                file[f"{name}/beside"],
            )
            for name in file["names"]
        ]


def _unpacked(bits: NDArray[np.uint8], shape: NDArray[np.intp]) -> NDArray[np.bool_]:
    return np.unpackbits(bits, count=int(np.prod(shape))).astype(np.bool_).reshape(shape)


def races(count: int = 40) -> Study:
    """Run races of the scenes of which runs are recorded, and count what is right of what they tell.

    Parameters
    ----------
    count : int
        Races of each scene.
    """
    chosen = scenes()
    told = {scene: [race_of(scene, scene.motions_of(number)) for number in range(count)] for scene in chosen}

    def percent(of: str, some: Iterable[Scene]) -> float:
        right = [right for scene in some for race in told[scene] for right in getattr(race, of)]
        return 100.0 * float(np.mean(right)) if right else math.nan

    runs = [float(np.mean([race.runs for race in told[scene]])) for scene in chosen]
    rows = [
        {
            "scene": scene.name,
            "looked at": "before" if scene.seen else "at the end",
            "options": len(scene.fell),
            "without anything [%]": 100.0 * scene.truth[0].estimate,
            "runs": count_of_runs,
            **{f"{of} [%]": percent(of, [scene]) for of in AIMS},
        }
        for scene, count_of_runs in zip(chosen, runs, strict=True)
    ]
    table = pd.DataFrame(rows)
    figure, (axes,) = panels(1, width=7.0, height=0.8 + 0.28 * len(chosen))
    for number, (of, colour, mark) in enumerate(zip(AIMS, COLOURS, "os^D", strict=False)):
        place = np.arange(len(chosen)) + 0.2 * (number - 1.5)  # many are at 100 %
        axes.plot(table[f"{of} [%]"], place, mark, color=colour, markersize=5, label=of)
    axes.set(xlabel="right [%]", xlim=(60.0, 101.0), yticks=range(len(chosen)))
    axes.set_yticklabels([scene.name for scene in chosen])
    axes.invert_yaxis()
    axes.legend(loc="lower left", fontsize="small")
    late = [scene for scene in chosen if not scene.seen]
    of_scene = {of: ("scene", table[f"{of} [%]"], {"units": "%"}) for of in AIMS}
    return Study(
        name="races",
        title="Races of options, beside 800 runs of each",
        quantities={
            "scenes": Quantity("Scenes", float(len(chosen)), form=".0f"),
            "runs": Quantity("Runs of a race", float(np.mean(runs)), form=".0f"),
            "intervals": Quantity("Intervals that hold [%]", percent("intervals", chosen), "93 to 98", ".1f"),
            "late": Quantity(
                "Of scenes looked at only at the end [%]", percent("intervals", late), form=".1f"
            ),
            "best": Quantity("Best within 5 points of the best [%]", percent("best", chosen), "≥ 95", ".1f"),
            "clear": Quantity("Clearly better, and better [%]", percent("clear", chosen), "≥ 97.5", ".1f"),
            "curves": Quantity("Curves at ± 0.75 that hold [%]", percent("curves", chosen), "≥ 93", ".1f"),
        },
        data=xr.Dataset(of_scene, {"scene": [scene.name for scene in chosen]}),
        figure=figure,
        tables={"Scenes": table.round(1)},
    )
