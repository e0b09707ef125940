"""What happens to the people of a room with an option: who is hit by what and how hard, and who gets out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.fragility.paired import Difference, difference
from stayput.fragility.probabilities import Probability, probability
from stayput.mechanics.columns import OVERTURNED_OUTCOME
from stayput.montecarlo.counting import RANKING_RESOLUTION, Member, Quantiles

if TYPE_CHECKING:
    from stayput.model.floor_plan import Door, FloorPlan, PersonPlace
    from stayput.montecarlo.runs import Runs

DAY_HOURS = 16.0
"""Hours of the day, those of the night being the rest of 24."""

HARM_STEPS = 20.0
"""Steps of a decade of energy in the ranking: harm that differs by less, by about a tenth, is alike."""

SPEED, ENERGY = 1, 2
"""Columns of `stayput.montecarlo.scenes.Seen.hits`."""


@dataclass(frozen=True, slots=True)
class HitVerdict:
    """How a piece hits the place of a person.

    Parameters
    ----------
    piece : str
        The piece.
    mass : float
        Its mass [kg].
    probability : Probability
        That it touches the person who is there.
    speed : Quantiles
        Largest speed of the part that is within the place, of the runs in which it hits [m/s].
    energy : Quantiles
        Its largest kinetic energy while it touches, of the same runs [J].
    falls : float
        Share of these runs in which it overturns.
    """

    piece: str
    mass: float
    probability: Probability
    speed: Quantiles
    energy: Quantiles
    falls: float

    @property
    def by_falling(self) -> bool:
        """Whether it mostly falls on the place, and does not slide against it."""
        return self.falls >= 0.5

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
    hit : Probability
        That somebody who is there is hit by any piece.
    by : tuple of HitVerdict
        The pieces that hit it in some run, that which does most harm first.
    shut_in : Probability
        That no way leads out from there.
    shut_in_at_rest : bool
        Whether none does as the furniture stands.
    """

    place: PersonPlace
    hit: Probability
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


class Outlook(NamedTuple):
    """How often something happens, and that less how often without the option; None of that itself."""

    chance: Probability
    change: Difference | None


@dataclass(frozen=True, slots=True)
class People:
    """What happens to people.

    Parameters
    ----------
    hit, shut_in, blocked : Outlook
        That anybody who is there is hit; that anybody is shut in; that any door is blocked.
    risk : float
        Chance that a person is hit, weighted by how long somebody is at each place.
    harm : float
        Energy with which persons are hit, on average over all runs and weighted in the same way [J].
    places : tuple of PlaceVerdict
        In the order of the file.
    doors : tuple of DoorVerdict
        In the order of the file.
    """

    hit: Outlook
    shut_in: Outlook
    blocked: Outlook
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


def hits_in(runs: Runs) -> NDArray[np.bool_]:
    """Return which places are hit by which pieces, shape (motions, samples, places, pieces)."""
    assert runs.hits is not None
    return ~np.isnan(runs.hits[..., 0])


def risk_of(hit: NDArray[np.bool_], places: Sequence[PersonPlace], missing: NDArray[np.bool_]) -> float:
    """Return the chance that a person is hit, weighted by how long somebody is at each place.

    Parameters
    ----------
    hit : ndarray of bool, shape (motions, samples, places)
        Which places are hit.
    places : sequence of PersonPlace
        The places.
    missing : ndarray of bool, shape (motions, samples)
        Which runs were given up.
    """
    present = np.array([presence(place) for place in places])
    spared = np.prod(1.0 - present * hit[~missing], axis=-1)
    return float(1.0 - spared.mean()) if len(spared) else math.nan


def harm_of(energy: NDArray[np.float64], places: Sequence[PersonPlace], missing: NDArray[np.bool_]) -> float:
    """Return the energy with which persons are hit, on average and weighted in the same way [J].

    Parameters
    ----------
    energy : ndarray, shape (motions, samples, places)
        Of what hits each place hardest, 0 where nothing does [J].
    places, missing
        As for `risk_of`.
    """
    present = np.array([presence(place) for place in places])
    known = (energy[~missing] * present).sum(axis=-1)
    return float(known.mean()) if len(known) else math.nan


def hardest(runs: Runs, pieces: Sequence[int] | None = None) -> NDArray[np.float64]:
    """Return the energy of what hits each place hardest, of some or all pieces; 0 where nothing does [J]."""
    assert runs.hits is not None
    energy = np.nan_to_num(runs.hits[..., ENERGY])
    chosen = energy if pieces is None else energy[..., list(pieces)]
    return chosen.max(axis=-1, initial=0.0)


def people_of(
    runs: Runs,
    bare: Runs | None,
    plan: FloorPlan,
    pieces: Sequence[tuple[str, float]],
    at_rest: tuple[Sequence[bool], Sequence[bool]],
) -> People | None:
    """Return what happens to people with an option; None where nobody looked.

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
    if runs.hits is None or runs.blocked is None or runs.shut_in is None:
        return None
    hit, missing = hits_in(runs), runs.missing
    then = hit.any(axis=(2, 3)), runs.shut_in.any(axis=2), runs.blocked.any(axis=2)
    hits, shut_in, blocked = (Outlook(probability(flags, missing), None) for flags in then)
    if bare is not None and bare.blocked is not None and bare.shut_in is not None:
        now = hits_in(bare).any(axis=(2, 3)), bare.shut_in.any(axis=2), bare.blocked.any(axis=2)
        both = missing | bare.missing
        hits, shut_in, blocked = (
            Outlook(outlook.chance, difference(with_it, without, both))
            for outlook, with_it, without in zip((hits, shut_in, blocked), then, now, strict=True)
        )
    places = tuple(
        PlaceVerdict(
            place,
            probability(hit[:, :, n].any(axis=2), missing),
            _by(runs, n, pieces),
            probability(runs.shut_in[:, :, n], missing),
            bool(at_rest[1][n]),
        )
        for n, place in enumerate(plan.places)
    )
    doors = tuple(
        DoorVerdict(door, probability(runs.blocked[:, :, n], missing), bool(at_rest[0][n]))
        for n, door in enumerate(plan.doors)
    )
    risk = risk_of(np.any(hit, axis=3), plan.places, missing)
    return People(hits, shut_in, blocked, risk, harm_of(hardest(runs), plan.places, missing), places, doors)


def _by(runs: Runs, place: int, pieces: Sequence[tuple[str, float]]) -> tuple[HitVerdict, ...]:
    assert runs.hits is not None
    assert runs.results is not None
    verdicts: list[HitVerdict] = []
    for body, (name, mass) in enumerate(pieces):
        contacts = runs.hits[:, :, place, body]
        hit = ~np.isnan(contacts[..., 0])
        if not hit.any():
            continue
        fell = runs.results[..., body]["outcome"][hit] == OVERTURNED_OUTCOME
        of_hits = (
            Quantiles.of(contacts[..., n][hit], np.zeros(len(fell), np.bool_)) for n in (SPEED, ENERGY)
        )
        chance = probability(hit, runs.missing)
        verdicts.append(HitVerdict(name, mass, chance, *of_hits, falls=float(fell.mean())))
    return tuple(sorted(verdicts, key=lambda hit: -hit.harm))


def typical_of(*each: Runs) -> Member:
    """Return the run that differs least from all runs in what falls, hits, blocks and shuts in.

    Each of these counts by the share of the runs that have it otherwise; of equals the one whose largest tilt
    is in the middle. Of several options it is the one draw that differs least with all of them.
    """
    flags: list[NDArray[np.bool_]] = []
    for runs in each:
        of_pieces = None if runs.results is None else runs.results["outcome"] == OVERTURNED_OUTCOME
        flags.append(runs.overturned[..., np.newaxis] if of_pieces is None else of_pieces)
        if runs.hits is not None and runs.blocked is not None and runs.shut_in is not None:
            flags += [hits_in(runs).reshape(*runs.missing.shape, -1), runs.blocked, runs.shut_in]
    happens, missing = np.concatenate(flags, axis=2), np.any([runs.missing for runs in each], axis=0)
    if missing.all():
        return Member(0, 0)
    share = happens[~missing].mean(axis=0)
    otherwise: NDArray[np.float64] = share + happens * (1.0 - 2.0 * share)
    far: NDArray[np.float64] = otherwise.sum(axis=2)
    far[missing] = np.inf
    alike = np.flatnonzero(far.ravel() <= far.min() + 1e-9)
    in_order = alike[np.argsort(each[0].tilt.ravel()[alike], kind="stable")]
    return Member(*divmod(int(in_order[(len(in_order) - 1) // 2]), far.shape[1]))
