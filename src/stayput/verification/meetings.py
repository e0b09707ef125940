"""What running pieces by themselves leaves out: those that strike each other, and copies that differ."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

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
    from stayput.verification.verdict import OptionVerdict, Verdict


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


def with_meetings(runner: OptionRunner, verdict: OptionVerdict) -> OptionVerdict:
    """Return the verdict on an option with the pieces that come together in its runs."""
    members = runner.members.chosen(slice(verdict.runs))
    (runs,) = runner.run([verdict.option], members, keep=True)
    return replace(verdict, meetings=meetings_of(runner, verdict.option, runs))


LISTED = 3
"""Most meetings that a note names."""


def more_meetings(after: OptionVerdict, before: OptionVerdict) -> list[Meeting]:
    """Return the likeliest meetings that an option brings about, or makes likelier."""
    known = {meeting[:2]: meeting.chance.estimate for meeting in before.meetings}
    return [each for each in after.meetings if each.chance.estimate > known.get(each[:2], 0.0)][:LISTED]


def notes_of_rooms(verdict: Verdict) -> Iterator[Phrase]:
    """Yield what is said of pieces that strike each other, and of copies that are computed as one."""

    def called(name: str) -> Phrase:
        return name_within(name, PIECES_OF_RUNS)

    def counts(meeting: Meeting) -> dict[str, Any]:
        names = {"first": called(meeting.first), "second": called(meeting.second)}
        return {**names, "fell": meeting.chance.fell, "runs": meeting.chance.runs}

    for meeting in verdict.without.meetings[:LISTED]:
        yield phrase("verification.meets", **counts(meeting))
    if (best := verdict.helping) is not None:
        label = verdict.label(best, "en"), verdict.label(best, "ja")
        for meeting in more_meetings(best, verdict.without):
            yield phrase("verification.meets_with", option=label, **counts(meeting))
    alike = Counter(verdict.kinds)
    for kind, count in alike.items():
        if count > 1:
            numbers = [number for number, of in enumerate(verdict.kinds) if of == kind]
            chance = verdict.without.pieces[numbers[0]].probabilities[OVERTURNED].estimate
            least, most = (f"{100.0 * share:.0f}" for share in (chance, 1.0 - (1.0 - chance) ** count))
            if least != most:
                pieces = joined([called(verdict.scenario.names[number]) for number in numbers])
                yield phrase("verification.alike", pieces=pieces, least=least, most=most)
