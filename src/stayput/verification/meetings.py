"""What running pieces by themselves leaves out: those that strike each other, and copies that differ."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.catalogue import Phrase, phrase
from stayput.catalogue.names import PIECES_OF_RUNS
from stayput.montecarlo.counting import OVERTURNED
from stayput.simulation.groups import meet
from stayput.wording import joined, name_within

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.montecarlo.runs import Runs
    from stayput.scenario.measures import Option
    from stayput.verification.option_runner import OptionRunner
    from stayput.verification.verdict import Verdict


class Meeting(NamedTuple):
    """Two pieces that run by themselves and come together in some runs.

    Parameters
    ----------
    first, second : str
        The pieces.
    chance : Probability
        That they do; what they then do to each other is not followed.
    """

    first: str
    second: str
    chance: Probability


def meetings_of(runner: OptionRunner, option: Option, runs: Runs) -> tuple[Meeting, ...]:
    """Return which pieces come together that run by themselves, the likeliest first.

    Parameters
    ----------
    runner : OptionRunner
        Under whose motions and draws they ran.
    option : Option
        What is in place.
    runs : Runs
        The runs, with their tracks.
    """
    if not runs.tracks.size:
        return ()
    names, meetings = runner.scenario.names, list[Meeting]()
    groups = [standing.group for standing in runner.scene_runner.standings(runner.scene(option))]
    for group, further in combinations(groups, 2):
        for a in group:
            for b in further:
                together = np.array([meet(row[a], row[b]) for row in runs.tracks.tolist()])
                if together.any():
                    meetings.append(Meeting(names[a], names[b], runs.probability(together)))
    return tuple(sorted(meetings, key=lambda meeting: -meeting.chance.estimate))


LISTED = 3
"""Most meetings that a note names."""


def notes_of_rooms(verdict: Verdict) -> Iterator[Phrase]:
    """Yield what is said of pieces that strike each other, and of copies that are computed as one."""

    def called(name: str) -> Phrase:
        return name_within(name, PIECES_OF_RUNS)

    for first, second, chance in verdict.meetings[:LISTED]:
        counts = {"fell": chance.fell, "runs": chance.runs}
        yield phrase("verification.meets", first=called(first), second=called(second), **counts)
    alike = Counter(verdict.kinds)
    for kind, count in alike.items():
        if count > 1:
            numbers = [number for number, of in enumerate(verdict.kinds) if of == kind]
            chance = verdict.without.pieces[numbers[0]].probabilities[OVERTURNED].estimate
            least, most = (f"{100.0 * share:.0f}" for share in (chance, 1.0 - (1.0 - chance) ** count))
            if least != most:
                pieces = joined([called(verdict.scenario.names[number]) for number in numbers])
                yield phrase("verification.alike", pieces=pieces, least=least, most=most)
