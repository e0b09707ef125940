"""The race of the options of a verification: which of them runs how often.

All run a few times, then what is without anything and those that look best some more, and then those of which
what people read is not known well enough: without anything and the best to within a half-width, those that
may still be as good to within a wider one, and what clearly cannot win any more to within a still wider one.
All have the same motions and draws in the same order, so that any two are compared pair by pair.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.montecarlo.runs import Runs
from stayput.verification.people import events_of, hardest, harm_of

if TYPE_CHECKING:
    from stayput.scenario.measures import Option
    from stayput.verification.option_runner import OptionRunner

FIRST_LOOK, STEP, STEP_IN_ROOM = 4, 8, 4
"""Runs of all options at the first look, which is the first answer, and more of an option in a later one.

In a room a look is cheap: most runs of an option are those of others, and no curve is fitted."""

GROWTH = 8
"""By how much more runs there are at the next look where all runs are asked for: few looks are fast."""

LEADERS = 3
"""Options that run on beside that without anything after the first look; others of a room cannot win then."""

HALF_WIDTHS = {2: 0.10, 3: 0.16}
"""Half-width that is enough of what is without anything and of the best, by dimensions.

A run in the plane takes a tenth of the time of one in space."""

HELPS, CONTENDS, CONTENDER = 0.04, 0.15, 0.6
"""How much less often the best overturns than without anything, and than what may be as good; its factor.

Where something helps, the options between which it is open are known better than others: else what is told as
the best is more than 5 points worse than the best in one of sixteen races."""

UNSURE = 0.4
"""Factor on the half-width of what is without anything and of the best, while the best only seems to help."""

RUNNER_UP, BEATEN = 1.25, 1.9
"""Factors on the half-width for other options: those that may still be the best, and those that cannot be."""


class Race:
    """Options with the runs that they have so far.

    Parameters
    ----------
    runner : OptionRunner
        The motions and draws.
    options : sequence of Option
        The options; the first has nothing in place.

    Attributes
    ----------
    runner : OptionRunner
        The same; after a look another may take its place that has these motions first, and more.
    runs : list of Runs
        Those of each option, in the order of the members of the runner.
    precise : bool
        Whether all that was to be known well enough is.
    """

    def __init__(self, runner: OptionRunner, options: Sequence[Option]) -> None:
        self.runner, self.options = runner, [*options]
        self._tracked = 0 if runner.scenario.alone else len(options)
        self.runs: list[Runs] = []
        self.precise = False

    def add(self, options: Sequence[Option]) -> None:
        """Let more options take part, whose tracks are not kept."""
        self.options += options

    def looks(self) -> Iterator[None]:
        """Run the race, and yield after each look; all runs of all options, where so many are asked for."""
        return self._all_runs() if self.runner.settings.all_runs else self._race()

    def _all_runs(self) -> Iterator[None]:
        most, count = len(self.runner.members), STEP
        while True:
            self._run_to(dict.fromkeys(range(len(self.options)), count))
            yield
            if count >= most:
                return
            count *= GROWTH

    def _race(self) -> Iterator[None]:
        everyone = range(len(self.options))
        for count in (STEP,) if self.runs else (FIRST_LOOK, STEP):
            self._run_to(dict.fromkeys(everyone, count))
            yield
        self._run_to(dict.fromkeys([0, *self._in_order()[:LEADERS]], 2 * STEP))
        yield
        step = STEP_IN_ROOM if self._in_room else STEP
        while unknown := self._unknown():
            done = {number: len(self.runs[number].members) for number in unknown}
            most = len(self.runner.members)
            going = {number: count + step for number, count in done.items() if count < most}
            if not going:
                break
            if not self.runner.scenario.alone:
                # what all are compared with has all runs of each: most of them are there already
                going[0] = max(len(self.runs[0].members), *going.values())
            self._run_to(going)
            yield
        self.precise = not unknown

    @property
    def _in_room(self) -> bool:
        return self.runner.scenario.plan is not None

    def _run_to(self, counts: dict[int, int]) -> None:
        """Run options until they have so many runs, as far as there are members."""
        most = len(self.runner.members)
        self.runs += [None] * (len(self.options) - len(self.runs))  # type: ignore[list-item]
        spans = dict[tuple[int, int, bool], list[int]]()
        for number, asked in counts.items():
            count = min(asked, most)
            done = len(self.runs[number].members) if self.runs[number] else 0
            if done < count:
                spans.setdefault((done, count, number < self._tracked), []).append(number)
        for (done, count, keep), numbers in spans.items():
            members = self.runner.members.chosen(slice(done, count))
            more = self.runner.run([self.options[number] for number in numbers], members, keep=keep)
            for number, runs in zip(numbers, more, strict=True):
                self.runs[number] = Runs.joined([self.runs[number], runs]) if done else runs

    def _in_order(self) -> list[int]:
        """Return the other options, that first which looks best beside what is without anything."""
        return sorted(range(1, len(self.options)), key=self._gain)

    def _gain(self, number: int) -> tuple[float, ...]:
        """Return by how much harm, what people read and sliding exceed those without anything, run by run."""
        option, bare = paired(self.runs[number], self.runs[0])
        known, limit = ~(option.missing | bare.missing), self.runner.settings.slide_limit
        if not known.any():
            return (np.inf,)
        sliding = float(option.moved(limit)[known].mean() - bare.moved(limit)[known].mean())
        less = self._more(number), sliding, self.options[number].count
        if not self._in_room:
            return less
        harm, before = (
            harm_of(hardest(each), self.runner.plan(self.options[number]).places, ~known)
            for each in (option, bare)
        )
        return harm - before, *less

    def _more(self, number: int) -> float:
        """Return by how much more often what people read happens than without anything, run by run."""
        option, bare = paired(self.runs[number], self.runs[0])
        known = ~(option.missing | bare.missing)
        more = self._read(option)[known].mean() - self._read(bare)[known].mean() if known.any() else np.inf
        return float(more)

    def _unknown(self) -> list[int]:
        """Return the options of which what people read is not known well enough."""
        precision, order = self.runner.settings.precision, self._in_order()
        enough = HALF_WIDTHS[2 if self.runner.in_plane else 3] if precision is None else precision
        best, *others = order or [0]
        targets = dict.fromkeys((0, best), enough)
        for place, number in enumerate(others, 1):
            may_win = not self._beaten(number, best) and (place < LEADERS or not self._in_room)
            targets[number] = enough * (RUNNER_UP if may_win else BEATEN)
        targets |= dict.fromkeys(self._contenders(order), enough * CONTENDER)
        unknown = [number for number in targets if not self._half_width(number) <= targets[number]]
        if precision is None and self._seems_to_help(order):
            counts = {number: len(self.runs[number].members) for number in (0, best)}
            # whether it does is told by pairs: of what has fewer runs those that make up pairs come first
            behind = {number for number in counts if counts[number] < max(counts.values())}
            wide = [number for number in counts if not self._half_width(number) <= enough * UNSURE]
            unknown += behind or wide
        return sorted({*unknown})

    def _half_width(self, number: int) -> float:
        runs = self.runs[number]
        return runs.probability(self._read(runs)).half_width

    def _contenders(self, order: list[int]) -> list[int]:
        """Return the options of which it is open which is the best, where they help; else none."""
        # of a room several changes often take away the same harm: which of them is best does not matter
        if not order or self._in_room or (least := self._more(order[0])) > -HELPS:
            return []
        near = [n for n in order[: LEADERS + 1] if self._more(n) <= least + CONTENDS]
        unbeaten = [number for number in near if number == order[0] or not self._beaten(number, order[0])]
        return unbeaten if len(unbeaten) > 1 else []

    def _seems_to_help(self, order: list[int]) -> bool:
        """Return whether the best helps in these runs, and it is not clear beyond chance that it does."""
        if not order or self._in_room or self._more(order[0]) > -HELPS:
            return False
        # as it is told: by intervals that hold for all options together
        return not self._beaten(0, order[0], len(self.options) - 1)

    def _read(self, runs: Runs) -> NDArray[np.bool_]:
        """Return what people read first: whether somebody is hit, or whether a counted piece overturns."""
        hit_is_read = self._in_room and len(self.runner.plan(self.options[0]).places) > 0
        return events_of(runs)["hit"] if hit_is_read else runs.overturned

    def _beaten(self, number: int, best: int, comparisons: int = 1) -> bool:
        option, first = self.runs[number], self.runs[best]
        more = option.difference(self._read(option), first, self._read(first), comparisons)
        return more.clear and more.estimate > 0.0


def paired(first: Runs, second: Runs) -> tuple[Runs, Runs]:
    """Return the runs that two options both have."""
    both = slice(min(len(first.members), len(second.members)))
    return first.chosen(both), second.chosen(both)
