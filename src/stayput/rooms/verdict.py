"""The verdict on a room: who is hit by what, which door stays shut, and what changes that most."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, NamedTuple

from stayput.saved import InJson

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import numpy as np
    from numpy.typing import NDArray

    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.model.floor_plan import Door, FloorPlan, PersonPlace
    from stayput.montecarlo.counting import Quantiles
    from stayput.rooms.changes import Change
    from stayput.scenario import Scenario

DAY_HOURS = 16.0
"""Hours of the day, those of the night being the rest of 24."""

FALLS = 0.05
"""Chance of overturning from which on a piece is to be held, even where it hits nobody and blocks no way."""


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
    """

    piece: str
    mass: float
    probability: Probability
    speed: Quantiles
    energy: Quantiles


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
        The pieces that hit it in some run, the most frequent first.
    shut_in : Probability
        That no way leads out from there.
    """

    place: PersonPlace
    hit: Probability
    by: tuple[HitVerdict, ...]
    shut_in: Probability

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


@dataclass(frozen=True, slots=True, eq=False)
class RoomPiece:
    """What becomes of a piece of a room.

    Parameters
    ----------
    name : str
        The piece.
    in_plane : bool
        Whether it ran in the plane across its length; in space if not.
    probabilities : mapping of str to Probability
        Of each of `stayput.montecarlo.counting.EVENTS`.
    slide : Quantiles
        Peak slide [m].
    fell, stood : ndarray, shape (nx, ny)
        Shares of the runs in which it ends on each cell of the floor having overturned, and without; see
        `stayput.rooms.events.Ways`.
    outline : ndarray, shape (n, 2)
        Its outline in plan as it stands [m].
    risk : float
        Chance that it hits a person, weighted by how long somebody is at each place.
    """

    name: str
    in_plane: bool
    probabilities: Mapping[str, Probability]
    slide: Quantiles
    fell: NDArray[np.float64]
    stood: NDArray[np.float64]
    outline: NDArray[np.float64]
    risk: float

    @property
    def falls(self) -> bool:
        """Whether it overturns so often that it is to be held, even where it hits nobody."""
        return self.probabilities["overturned"].estimate >= FALLS

    @property
    def covers(self) -> NDArray[np.float64]:
        """Share of the runs in which it ends on each cell of the floor, shape (nx, ny)."""
        return self.fell + self.stood


@dataclass(frozen=True, slots=True)
class RoomEffect:
    """What happens in a room with changes, beside the room as it is, run by run.

    Parameters
    ----------
    hit, shut_in, blocked : Probability
        That anybody who is there is hit; that anybody is shut in; that any door is blocked.
    hit_change, shut_in_change, blocked_change : Difference
        Those less the same as the room is.
    risk : float
        Chance that a person is hit, weighted by how long somebody is at each place.
    overturned : tuple of Probability
        That each piece overturns, in the order of the file.
    overturned_change : tuple of Difference
        Those less the same as the room is.
    """

    hit: Probability
    hit_change: Difference
    shut_in: Probability
    shut_in_change: Difference
    blocked: Probability
    blocked_change: Difference
    risk: float
    overturned: tuple[Probability, ...]
    overturned_change: tuple[Difference, ...]

    @property
    def better(self) -> tuple[str, ...]:
        """What happens clearly less often: some of "hit", "shut_in", "blocked" and "overturned"."""
        return self._clear(-1.0)

    @property
    def worse(self) -> tuple[str, ...]:
        """What happens clearly more often."""
        return self._clear(1.0)

    @property
    def helps(self) -> bool:
        """Whether something is clearly for the better, nothing clearly for the worse, and no more are hit."""
        return bool(self.better) and not self.worse and self.hit_change.estimate <= 0.0

    @property
    def fallen(self) -> float:
        """How many pieces overturn, on average."""
        return sum(chance.estimate for chance in self.overturned)

    def _clear(self, sign: float) -> tuple[str, ...]:
        """Return what changes clearly in one direction, each once."""
        falls = (("overturned", change) for change in self.overturned_change)
        others = ("hit", self.hit_change), ("shut_in", self.shut_in_change), ("blocked", self.blocked_change)
        clear = (name for name, diff in (*others, *falls) if diff.clear and sign * diff.estimate > 0.0)
        return tuple(dict.fromkeys(clear))


@dataclass(frozen=True, slots=True)
class ChangeVerdict(RoomEffect):
    """What a single change of the room brings.

    Parameters
    ----------
    change : Change
        The change.
    """

    change: Change

    @classmethod
    def of(cls, change: Change, effect: RoomEffect) -> ChangeVerdict:
        """Return what a change brings."""
        return cls(**{field.name: getattr(effect, field.name) for field in fields(effect)}, change=change)


class TypicalRun(NamedTuple):
    """A run in which what happens most often happens: hit or not, shut in or not.

    Parameters
    ----------
    member : int
        Which of the motions, from 1 on.
    direction : float
        Where the motion's x points in plan, from x towards y [rad].
    """

    member: int
    direction: float


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class RoomVerdict(InJson):
    """Result of `stayput.verify_room`.

    Parameters
    ----------
    scenario : Scenario
        What was verified.
    plan : FloorPlan
        Its plan.
    intensity : float
        Median JMA intensity of the ground.
    hit : Probability
        That anybody who is there is hit.
    shut_in, blocked : Probability
        That anybody is shut in; that any door is blocked.
    risk : float
        Chance that a person is hit, weighted by how long somebody is at each place.
    places : tuple of PlaceVerdict
        In the order of the file.
    doors : tuple of DoorVerdict
        In the order of the file.
    pieces : tuple of RoomPiece
        Those that contribute most to the risk first.
    collisions : mapping of pairs of str to Probability
        Pieces that meet; what they do afterwards is not followed.
    changes : tuple of ChangeVerdict
        Single changes, the best first; none where they were not asked for.
    typical : TypicalRun or None
        A run to look at; None where none was finished.
    complete : bool
        Whether it is final; else runs and changes are still to come.
    motions, samples, runs : int
        Motions, samples of each, and runs of pieces that were made.
    slide_limit : float
        Slide that counts as too far [m].
    seed : int
        Seed of the draws.
    seconds : float
        What it took.

    Examples
    --------
    >>> import stayput as sp
    >>> room = sp.read_scenario("examples/bedroom.toml")
    >>> verdict = sp.verify_room(room, changes=False, progress=False)
    >>> [piece.name for piece in verdict.pieces]
    ['bookcase', 'chest', 'wardrobe']
    """

    scenario: Scenario
    plan: FloorPlan
    intensity: float
    hit: Probability
    shut_in: Probability
    blocked: Probability
    risk: float
    places: tuple[PlaceVerdict, ...]
    doors: tuple[DoorVerdict, ...]
    pieces: tuple[RoomPiece, ...]
    collisions: Mapping[tuple[str, str], Probability]
    typical: TypicalRun | None
    motions: int
    samples: int
    slide_limit: float
    seed: int
    floor: str = ""
    changes: tuple[ChangeVerdict, ...] = ()
    complete: bool = False
    runs: int = 0
    seconds: float = 0.0

    def __repr__(self) -> str:
        chances = f"hit {self.hit.text}; shut in {self.shut_in.text}"
        numbers = f"{len(self.pieces)} pieces, {len(self.changes)} changes"
        return f"RoomVerdict(JMA {self.intensity:.2f}; {chances}; {numbers})"

    @property
    def best(self) -> ChangeVerdict | None:
        """The best single change, or None where none makes anything better."""
        return next((change for change in self.changes if change.helps), None)

    @property
    def shut_at_rest(self) -> bool:
        """Whether every way out is blocked as the furniture stands."""
        ways = [door.at_rest for door in self.doors if door.door.way_out]
        return bool(ways) and all(ways)

    def piece_changed(self, change: ChangeVerdict) -> tuple[Probability, Difference] | None:
        """Return how often the piece of a change overturns with it, and the difference; None of a place."""
        names = self.scenario.names
        if change.change.what not in names:
            return None
        number = names.index(change.change.what)
        return change.overturned[number], change.overturned_change[number]

    def label(self, change: ChangeVerdict, language: str = "en") -> str:
        """Return what a change consists of, in "en" or "ja": "Belts on the bookcase"."""
        from stayput.rooms.words import change_label

        return change_label(change.change, self, language)

    def sentence(self, language: str = "en") -> str:
        """Return the verdict in one sentence, in "en" or "ja"."""
        from stayput.rooms.words import sentence_of_room

        return sentence_of_room(self, language)

    def to_json(self) -> str:
        """Return the verdict as JSON; keys carry their units."""
        from stayput.report.room.data import room_data
        from stayput.report.verdict.data import json_text

        return json_text(room_data(self))

    def to_markdown(self, language: str = "en") -> str:
        """Return the verdict as Markdown, in "en" or "ja"."""
        from stayput.report.room.report import room_markdown

        return room_markdown(self, language)

    def to_csv(self) -> str:
        """Return the probabilities as CSV."""
        from stayput.report.room.data import room_csv

        return room_csv(self)

    def report(self, path: str | Path, language: str = "en") -> Path:
        """Write the report, one HTML file with everything in it; see `stayput.report.room`."""
        from stayput.report.room.report import write_room_report

        return write_room_report(self, path, language)


def presence(place: PersonPlace) -> float:
    """Return in what share of the 24 hours somebody is at a place."""
    return (DAY_HOURS * place.day + (24.0 - DAY_HOURS) * place.night) / 24.0
