"""The order of options and their ranks: what clearly differs decides, and ties share a rank.

What clearly helps stands before what does not, and that before what clearly makes something worse. Among the
former and the latter a rank ends where its first option is clearly better than the next: in the first of the
events that differ clearly, the gravest first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from stayput.montecarlo.counting import severity
from stayput.verification.contents import less_out
from stayput.verification.people import DECIDING_EVENTS, events_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from stayput.fragility.paired import Difference
    from stayput.montecarlo.runs import Runs
    from stayput.verification.verdict import OptionVerdict


def in_order(verdicts: Sequence[OptionVerdict]) -> list[int]:
    """Return the places of options, the best first; that without anything is the first of the arguments.

    It stands before those that do not clearly differ from it. Options that stand alike are in the order of
    harm to people, and of `stayput.montecarlo.counting.severity`.
    """

    def key(i: int) -> tuple[float, ...]:
        verdict = verdicts[i]
        harm = () if verdict.people is None else verdict.people.severity
        events = severity(verdict.probabilities, verdict.option.count)
        return verdict.standing, verdict.standing == 0 and i > 0, *harm, *events, i

    return sorted(range(len(verdicts)), key=key)


def ranks_of(verdicts: Sequence[OptionVerdict], outcomes: Sequence[Runs], limit: float) -> list[int]:
    """Return the ranks of options, given in their order: equal where none is clearly better, as in 1, 1, 3.

    Parameters
    ----------
    verdicts : sequence of OptionVerdict
        The options.
    outcomes : sequence of Runs
        Their runs.
    limit : float
        Slide that counts as too far [m].
    """
    others = len(verdicts) - 1

    def changes(first: int, second: int) -> Iterator[Difference]:
        now, then = outcomes[first], outcomes[second]

        def change(happened: NDArray[np.bool_], before: NDArray[np.bool_]) -> Difference:
            return now.difference(happened, then, before, others)

        if verdicts[first].people is not None:
            events = events_of(now), events_of(then)
            yield from (change(*(each[name] for each in events)) for name in DECIDING_EVENTS)
        yield change(now.overturned, then.overturned)
        contents = verdicts[first].contents, verdicts[second].contents
        if contents[0] is not None and contents[1] is not None:
            yield less_out(contents[0], contents[1], others)
        yield change(now.moved(limit), then.moved(limit))

    def better(first: int, second: int) -> bool:
        clear = (change.estimate for change in changes(first, second) if change.clear)
        return next(clear, 0.0) < 0.0

    ranks, first = [1], 0
    for place in range(1, len(verdicts)):
        standing = verdicts[place].standing
        if standing != verdicts[first].standing or (standing and better(first, place)):
            first = place
        ranks.append(first + 1)
    return ranks
