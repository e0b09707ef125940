"""Races of options in scenes whose truth is known from 800 runs of each option.

The runs of a scene are of 400 motions with two draws of each. A race meets 40 of the motions, drawn anew for
each race, with the same two draws, at the same levels as a verification; so many races of a scene tell how
often its intervals hold what all of the runs say, how often the option that is told to be the best is nearly
the best, and how often what is called clearly better is. Half of the scenes were not looked at before the
race was as it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.fragility.trials import Trials
from stayput.mechanics.columns import RESULT
from stayput.montecarlo.counting import OFFSETS, SLIDE_LIMIT, Members
from stayput.montecarlo.runs import Runs
from stayput.verification.race import Race

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

KEPT = Path(__file__).with_name("races.npz")
"""What became of the runs of all scenes: written by `studies.race_scenes`."""

MOTIONS, DRAWS = 40, 2
"""Of a race; a verification has 60 runs of an option at most, 1.5 of each of the usual 40 motions."""

BESIDE = (-0.75, 0.75)
"""Where curves are looked at: JMA's intensity less that which is stated."""

NEARLY = 0.05
"""By how much an option that is nearly the best happens more often than the best."""


@dataclass(frozen=True, eq=False)
class Scene:
    """What became of the runs of a scene.

    Parameters
    ----------
    name : str
        The scene.
    seen : bool
        Whether it was looked at while the race was made.
    options : list of str
        The options, that without anything first.
    fell, slid : ndarray of bool, shape (options, motions, draws)
        Whether a counted piece overturned, and whether one slid too far.
    energy : ndarray, shape (options, motions, draws, places)
        Energy with which a falling piece hits the place of each person, 0 where none does [J].
    beside : ndarray, shape (2, options)
        Share that overturns at `BESIDE`, of the options that were run there; NaN of others.
    """

    name: str
    seen: bool
    options: list[str]
    fell: NDArray[np.bool_]
    slid: NDArray[np.bool_]
    energy: NDArray[np.float64]
    beside: NDArray[np.float64]

    @property
    def level(self) -> NDArray[np.intp]:
        """The number of the level of each run, shape (motions, draws)."""
        motions, draws = self.fell.shape[1:]
        return (
            Members.in_turn(motions, motions * draws, beside=not self.energy.size).level.reshape(draws, -1).T
        )

    @property
    def read(self) -> NDArray[np.bool_]:
        """What people read first: whether somebody is hit in a room, else whether something overturned."""
        return (self.energy > 0.0).any(axis=-1) if self.energy.size else self.fell

    @property
    def truth(self) -> NDArray[np.float64]:
        """Share of the runs at the stated shaking in which what people read happens, shape (options,)."""
        return self.read[:, self.level == 0].mean(axis=1)


class Replayed:
    """A runner whose runs were made before; see `stayput.verification.option_runner.Replayed`.

    Parameters
    ----------
    scene : Scene
        The runs.
    motions : ndarray of int
        Which of the motions it meets, in their order.
    """

    in_plane = False

    def __init__(self, scene: Scene, motions: NDArray[np.intp]) -> None:
        self.fell, self.slid, self.energy = (
            each[:, motions] for each in (scene.fell, scene.slid, scene.energy)
        )
        room = scene.energy.shape[-1] > 0
        self.members = Members.in_turn(MOTIONS, 3 * MOTIONS // 2, beside=not room)
        places = [SimpleNamespace(day=1.0, night=1.0)] * scene.energy.shape[-1]
        self._plan = SimpleNamespace(places=places)
        self.scenario = SimpleNamespace(plan=self._plan if room else None, alone=not room)
        self.settings = SimpleNamespace(precision=None, slide_limit=SLIDE_LIMIT)

    def plan(self, option: Any) -> Any:
        """Return the plan of the room."""
        return self._plan

    def run(self, options: Iterable[Any], members: Members, *, keep: bool) -> list[Runs]:
        """Return runs of options."""
        return [self._runs(option.number, members) for option in options]

    def _runs(self, number: int, members: Members) -> Runs:
        at, n = (number, members.motion, members.sample), len(members)
        no, zero, none = np.zeros(n, np.bool_), np.zeros(n), np.zeros((n, 0))
        energy = self.energy[at][:, :, np.newaxis]
        hits = np.stack([0.0 * energy, 0.0 * energy, energy, np.ones_like(energy)], axis=-1)
        hits[energy == 0.0] = np.nan
        outcomes = members, self.fell[at], no, no, no, self.slid[at] * 2.0 * SLIDE_LIMIT, zero
        doors, tracks = none.astype(np.bool_), none.astype(object)
        return Runs(*outcomes, none, none, zero, np.zeros((n, 1), RESULT), hits, doors, doors, tracks)


def scenes(kept: Path = KEPT) -> list[Scene]:
    """Return the scenes whose runs are kept in a file."""
    with np.load(kept) as file:
        names = [str(name) for name in file["names"]]
        return [
            Scene(
                name,
                bool(file[f"{name}/seen"]),
                [str(option) for option in file[f"{name}/options"]],
                *(_unpacked(file[f"{name}/{of}"], file[f"{name}/shape"]) for of in ("fell", "slid")),
                file[f"{name}/energy"].astype(np.float64),
                file[f"{name}/beside"],
            )
            for name in names
        ]


def _unpacked(bits: NDArray[np.uint8], shape: NDArray[np.intp]) -> NDArray[np.bool_]:
    return np.unpackbits(bits, count=int(np.prod(shape))).astype(np.bool_).reshape(shape)


def race_of(scene: Scene, number: int) -> dict[str, Any]:
    """Return what a race of a scene told, and whether it holds; motions are drawn by its number."""
    count = scene.fell.shape[1]
    # each motion keeps the level that it ran at: those of one place in the turn of levels are exchanged
    turns = np.arange(count).reshape(-1, 5)
    rng = np.random.default_rng([number, len(scene.name)])
    chosen = np.stack(
        [rng.permutation(turns[:, place])[: MOTIONS // 5] for place in range(5)], axis=1
    ).ravel()
    runner: Any = Replayed(scene, chosen)
    options: Any = [SimpleNamespace(number=n, count=n) for n in range(len(scene.fell))]
    race = Race(runner, options)
    for _ in race.looks():
        pass
    runs, truth = race.runs, scene.truth
    reads = [
        (each.hits[:, :, :, 3] == 1.0).any(axis=(1, 2)) if scene.energy.size else each.overturned
        for each in runs
    ]
    chances = [each.probability(read) for each, read in zip(runs, reads, strict=True)]
    changes = [
        each.difference(read, runs[0], reads[0], len(runs) - 1)
        for each, read in zip(runs[1:], reads[1:], strict=True)
    ]
    best = 1 + min(range(len(changes)), key=lambda n: (changes[n].estimate, n))
    holds = [bool(chance.low <= p <= chance.high) for chance, p in zip(chances, truth, strict=True)]
    clear = [
        truth[n] < truth[0] for n, change in enumerate(changes, 1) if change.clear and change.estimate < 0.0
    ]
    curves = list[bool]()
    for n in np.flatnonzero(np.isfinite(scene.beside[0])) if not scene.energy.size else ():
        im = np.array(OFFSETS)[runs[n].members.level]
        trials = Trials.of_runs(
            JMA_INTENSITY, im, runs[n].overturned, runs[n].missing, runs[n].members.motion, len(OFFSETS)
        )
        low, high = FragilityCurve("", trials).band(np.array(BESIDE))
        curves += ((low <= scene.beside[:, n]) & (scene.beside[:, n] <= high)).tolist()
    return {
        "runs": sum(len(each.members) for each in runs),
        "holds": holds,
        "leaders": [holds[0], holds[best]],
        "best": bool(truth[best] <= truth[1:].min() + NEARLY or truth.min() >= truth[0] - NEARLY),
        "clear": clear,
        "curves": curves,
        "half_width": chances[0].half_width,
    }
