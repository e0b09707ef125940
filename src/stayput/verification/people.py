"""What happens to the people of a room with an option: who is hit by what and how hard, and who gets out.

Events nest: who is crushed is hit, and only a piece that falls hits. One that comes to somebody without
falling touches them, which is counted apart.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics.columns import OVERTURNED_OUTCOME
from stayput.montecarlo.counting import RANKING_RESOLUTION, Member, Quantiles
from stayput.montecarlo.scenes import ENERGY, FALLS, SPEED

if TYPE_CHECKING:
    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.model.floor_plan import Door, FloorPlan, PersonPlace
    from stayput.montecarlo.runs import Runs

DAY_HOURS = 16.0
"""Hours of the day, those of the night being the rest of 24."""

HARM_STEPS = 20.0
"""Steps of a decade of energy in the ranking: harm that differs by less, by about a tenth, is alike."""

DECIDING_EVENTS = ("hit", "shut_in", "blocked")
"""What happens to people and doors by which options are compared, the gravest first; fields of `People`."""

CRUSHING_ENERGY = 79.0
"""Energy from which on a falling piece crushes whom it hits [J].

58 ft lbf, from which on explosives safety takes a fragment to be hazardous (US Department of Defense
Explosives Safety Board, Technical Paper 12). Furniture is larger and slower: this tells blows from nudges,
and predicts no injury.
"""


@dataclass(frozen=True, slots=True)
class HitVerdict:
    """How a piece hits the place of a person, or touches it where it does not fall.

    Parameters
    ----------
    piece : str
        The piece.
    mass : float
        Its mass [kg].
    probability : Probability
        That it does so to the person who is there.
    speed : Quantiles
        Largest speed of the part that is within the place, of the runs in which it does [m/s].
    energy : Quantiles
        Its largest kinetic energy while it touches, of the same runs [J].
    by_falling : bool
        Whether it is in falling, in the same runs, that it comes there: else it touches.
    """

    piece: str
    mass: float
    probability: Probability
    speed: Quantiles
    energy: Quantiles
    by_falling: bool

    @property
    def harm(self) -> float:
        """Energy with which it hits, on average over all runs, its median being for each [J]."""
        return self.probability.estimate * self.energy.median


@dataclass(frozen=True, slots=True)
class PlaceVerdict:
    """What happens at the place of a person.

    Parameters
    ----------
    place : PersonPlace
        The place.
    crushed, hit, touched : Probability
        That somebody who is there is hit by a falling piece with `CRUSHING_ENERGY` or more; is hit by a
        falling piece; is touched by one that does not fall.
    by : tuple of HitVerdict
        The pieces that hit it in some run, that which does most harm first, and then those that touch it.
    shut_in : Probability
        That no way leads out from there.
    shut_in_at_rest : bool
        Whether none does as the furniture stands.
    """

    place: PersonPlace
    crushed: Probability
    hit: Probability
    touched: Probability
    by: tuple[HitVerdict, ...]
    shut_in: Probability
    shut_in_at_rest: bool

    @property
    def by_day(self) -> Probability:
        """Chance that somebody is there by day and is hit."""
        return self.hit.scaled(self.place.day)

    @property
    def by_night(self) -> Probability:
        """Chance that somebody is there at night and is hit."""
        return self.hit.scaled(self.place.night)


@dataclass(frozen=True, slots=True)
class DoorVerdict:
    """Whether a door can be used afterwards.

    Parameters
    ----------
    door : Door
        The door.
    blocked : Probability
        That it does not open far enough, or that nobody gets to it.
    at_rest : bool
        Whether it is blocked as the furniture stands.
    """

    door: Door
    blocked: Probability
    at_rest: bool


class PairedEstimate(NamedTuple):
    """How often something happens, and that less how often without the option; None of that itself."""

    chance: Probability
    change: Difference | None


@dataclass(frozen=True, slots=True)
class People:
    """What happens to people.

    Parameters
    ----------
    crushed, hit, touched : PairedEstimate
        That anybody who is there is crushed, is hit, is touched; see `PlaceVerdict`.
    shut_in, blocked : PairedEstimate
        That anybody is shut in; that any door is blocked.
    risk : float
        Chance that a person is hit, weighted by how long somebody is at each place.
    harm : float
        Energy with which persons are hit, on average over all runs and weighted in the same way [J].
    places : tuple of PlaceVerdict
        In the order of the file.
    doors : tuple of DoorVerdict
        In the order of the file.
    """

    crushed: PairedEstimate
    hit: PairedEstimate
    touched: PairedEstimate
    shut_in: PairedEstimate
    blocked: PairedEstimate
    risk: float
    harm: float
    places: tuple[PlaceVerdict, ...]
    doors: tuple[DoorVerdict, ...]

    @property
    def severity(self) -> tuple[float, ...]:
        """The sort key of an option: harm, then how often anybody is shut in, and any door is blocked."""
        chances = self.shut_in.chance.estimate, self.blocked.chance.estimate
        shares = (chance if math.isfinite(chance) else 1.0 for chance in chances)
        return harm_step(self.harm), *(round(share / RANKING_RESOLUTION) for share in shares)


def harm_step(harm: float) -> float:
    """Return harm [J] as it ranks: by steps of its logarithm, below a millijoule as none."""
    return float(round(HARM_STEPS * math.log10(max(harm, 1e-3)))) if math.isfinite(harm) else math.inf


def presence(place: PersonPlace) -> float:
    """Return in what share of the 24 hours somebody is at a place."""
    return (DAY_HOURS * place.day + (24.0 - DAY_HOURS) * place.night) / 24.0


def contacts_in(runs: Runs) -> NDArray[np.bool_]:
    """Return which places which pieces come to, shape (runs, places, pieces)."""
    return ~np.isnan(runs.hits[..., 0])


def hits_in(runs: Runs) -> NDArray[np.bool_]:
    """Return which places are hit by which falling pieces, shape (runs, places, pieces)."""
    fell: NDArray[np.bool_] = runs.results["outcome"] == OVERTURNED_OUTCOME
    return (runs.hits[..., FALLS] == 1.0) & fell[:, np.newaxis]


def events_at_places(runs: Runs) -> dict[str, NDArray[np.bool_]]:
    """Return where somebody is crushed, hit and touched by any piece, each (runs, places)."""
    hit = hits_in(runs)
    return {
        "crushed": np.greater_equal(hardest(runs), CRUSHING_ENERGY),
        "hit": np.any(hit, axis=2),
        "touched": np.any(contacts_in(runs) & ~hit, axis=2),
    }


def events_of(runs: Runs) -> dict[str, NDArray[np.bool_]]:
    """Return whether it happens to anybody, and to any door: each of shape (runs,)."""
    ways = {"shut_in": runs.shut_in, "blocked": runs.blocked}
    return {name: np.any(flags, axis=1) for name, flags in (events_at_places(runs) | ways).items()}


def risk_of(hit: NDArray[np.bool_], places: Sequence[PersonPlace], missing: NDArray[np.bool_]) -> float:
    """Return the chance that a person is hit, weighted by how long somebody is at each place.

    Parameters
    ----------
    hit : ndarray of bool, shape (runs, places)
        Which places are hit.
    places : sequence of PersonPlace
        The places.
    missing : ndarray of bool, shape (runs,)
        Which runs were given up.
    """
    present = np.array([presence(place) for place in places])
    spared = np.prod(1.0 - present * hit[~missing], axis=-1)
    return float(1.0 - spared.mean()) if len(spared) else math.nan


def harm_of(energy: NDArray[np.float64], places: Sequence[PersonPlace], missing: NDArray[np.bool_]) -> float:
    """Return the energy with which persons are hit, on average and weighted in the same way [J].

    Parameters
    ----------
    energy : ndarray, shape (runs, places)
        Of what hits each place hardest, 0 where nothing does [J].
    places, missing
        As for `risk_of`.
    """
    present = np.array([presence(place) for place in places])
    known = (energy[~missing] * present).sum(axis=-1)
    return float(known.mean()) if len(known) else math.nan


def hardest(runs: Runs, pieces: Sequence[int] | None = None) -> NDArray[np.float64]:
    """Return the energy of what hits each place hardest, of some or all pieces; 0 where nothing does [J]."""
    energy = np.where(hits_in(runs), runs.hits[..., ENERGY], 0.0)
    chosen = energy if pieces is None else energy[..., list(pieces)]
    return chosen.max(axis=-1, initial=0.0)


def people_of(
    runs: Runs,
    bare: Runs | None,
    plan: FloorPlan,
    pieces: Sequence[tuple[str, float]],
    at_rest: tuple[Sequence[bool], Sequence[bool]],
) -> People:
    """Return what happens to people with an option.

    Parameters
    ----------
    runs, bare : Runs
        With the option, and without; None of what is without.
    plan : FloorPlan
        The room with the option.
    pieces : sequence of (str, float)
        Name and mass [kg] of each.
    at_rest : tuple of sequence of bool
        Which doors are blocked and who is shut in as the furniture stands.
    """
    at_places, happened = events_at_places(runs), events_of(runs)
    changes: dict[str, Difference] = {}
    if bare is not None:
        then = events_of(bare)
        changes = {name: runs.difference(flags, bare, then[name]) for name, flags in happened.items()}
    estimates = {
        name: PairedEstimate(runs.probability(flags), changes.get(name)) for name, flags in happened.items()
    }
    places = tuple(
        PlaceVerdict(
            place=place,
            **{name: runs.probability(flags[:, n]) for name, flags in at_places.items()},
            by=_by(runs, n, pieces),
            shut_in=runs.probability(runs.shut_in[:, n]),
            shut_in_at_rest=bool(at_rest[1][n]),
        )
        for n, place in enumerate(plan.places)
    )
    doors = tuple(
        DoorVerdict(door, runs.probability(runs.blocked[:, n]), bool(at_rest[0][n]))
        for n, door in enumerate(plan.doors)
    )
    risk = risk_of(at_places["hit"], plan.places, runs.missing)
    harm = harm_of(hardest(runs), plan.places, runs.missing)
    return People(**estimates, risk=risk, harm=harm, places=places, doors=doors)


def _by(runs: Runs, place: int, pieces: Sequence[tuple[str, float]]) -> tuple[HitVerdict, ...]:
    hits, contacts, verdicts = hits_in(runs), contacts_in(runs), list[HitVerdict]()
    for body, (name, mass) in enumerate(pieces):
        for by_falling, all_of_them in ((True, hits), (False, contacts & ~hits)):
            chosen = all_of_them[:, place, body]
            if not chosen.any():
                continue
            those = runs.hits[:, place, body][chosen]
            overturned = np.zeros(len(those), np.bool_)  # what falls too counts by how it hits
            speed, energy = (Quantiles.of(those[:, n], overturned) for n in (SPEED, ENERGY))
            chance = runs.probability(chosen)
            verdicts.append(HitVerdict(name, mass, chance, speed, energy, by_falling))
    return tuple(sorted(verdicts, key=lambda hit: (not hit.by_falling, -hit.harm)))


def typical_of(*each: Runs) -> Member:
    """Return the run that differs least from all runs in what falls, hits, blocks and shuts in.

    Each of these counts by the share of the runs that have it otherwise; of equals the one whose largest tilt
    is in the middle. Of several options it is the one draw that differs least with all of them.
    """
    flags: list[NDArray[np.bool_]] = []
    for runs in each:
        hits = hits_in(runs).reshape(len(runs.members), -1)
        flags += [runs.results["outcome"] == OVERTURNED_OUTCOME, hits, runs.blocked, runs.shut_in]
    happens, missing = np.concatenate(flags, axis=1), np.any([runs.missing for runs in each], axis=0)
    if missing.all():
        return Member(0, 0)
    share = happens[~missing].mean(axis=0)
    otherwise: NDArray[np.float64] = share + happens * (1.0 - 2.0 * share)
    far: NDArray[np.float64] = otherwise.sum(axis=1)
    far[missing] = np.inf
    alike = np.flatnonzero(far <= far.min() + 1e-9)
    tilts = np.round(each[0].tilt[alike], 9)  # equal where they are so but for rounding
    in_order = alike[np.argsort(tilts, kind="stable")]
    return each[0].members[int(in_order[(len(in_order) - 1) // 2])]
