"""A progress bar for long work, drawn on a terminal only."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import Language, say

if TYPE_CHECKING:
    from rich.progress import Progress, Task
    from rich.text import Text

_language: ContextVar[Language] = ContextVar("_language", default="en")

_drawn: list[Progress] = []
"""What is drawn at present, of one item at most: a terminal has room for no second one."""

_quiet: list[bool] = []
"""What was asked of this process, of one item at most: whether it keeps quiet."""


def keep_quiet(wanted: bool) -> None:
    """Draw no bar where nobody says so, and print no note beside the results; or do so again."""
    _quiet[:] = [wanted]


def is_quiet() -> bool:
    """Whether nothing but results and refusals is wanted."""
    return any(_quiet)


@contextmanager
def told_in(language: Language) -> Generator[None]:
    """Let the bars of this thread speak a language meanwhile."""
    token = _language.set(language)
    try:
        yield
    finally:
        _language.reset(token)


def language_of_bars() -> Language:
    """Return the language that bars speak."""
    return _language.get()


@contextmanager
def bar(
    total: int | None, what: str, shown: bool | None = None, unit: str = "progress.cases"
) -> Generator[Callable[[int], None]]:
    """Yield a callback that advances a progress bar on standard error, with the rate and the time left.

    Where another bar is drawn already, this one stands below it.

    Parameters
    ----------
    total : int or None
        Number of items; None where it is not known, and the bar but moves.
    what : str
        Label of the bar: the id of a text.
    shown : bool, optional
        Whether to draw it; by default only if standard error is a terminal, and not in a process that another
        one has started for its work.
    unit : str
        What the items are called, in the plural: the id of a text.
    """
    if not (is_drawn() if shown is None else shown):
        yield lambda count: None
        return
    with _progress() as progress:
        text = say(what, _language.get())
        task = progress.add_task(text, total=total, unit=say(unit, _language.get()))
        try:
            yield lambda count: progress.advance(task, count)
        finally:
            progress.remove_task(task)


@dataclass
class Tally:
    """How much work is done: each call with a number adds to it, moves a bar, and is told on."""

    total: int
    advance: Callable[[int], None]
    on_progress: Callable[[int, int], None] | None
    done: int = 0

    def __call__(self, count: int) -> None:
        """Add work that was just done."""
        self.done += count
        self.advance(count)
        if self.on_progress is not None:
            self.on_progress(self.done, max(self.total, self.done))


@contextmanager
def tally(
    total: int | None, what: str, shown: bool | None, on_progress: Callable[[int, int], None] | None = None
) -> Generator[Tally]:
    """Yield a tally of work beside a progress bar; see `bar`.

    Parameters
    ----------
    total, what, shown
        As of `bar`.
    on_progress : callable, optional
        Called with what is done and all that is to do, as far as it is known; an exception that it raises
        stops the work.
    """
    with bar(total, what, shown) as advance:
        yield Tally(total or 0, advance, on_progress)


def is_drawn() -> bool:
    """Whether bars are drawn where nobody says so."""
    if is_quiet():
        return False
    from rich.console import Console

    return Console(stderr=True).is_terminal and multiprocessing.parent_process() is None


@contextmanager
def _progress() -> Generator[Progress]:
    """Yield the bars that are drawn at present, or a place for them that is cleared at the end."""
    if _drawn:
        yield _drawn[0]
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, ProgressColumn, TimeRemainingColumn
    from rich.text import Text

    language = _language.get()  # which the thread that draws does not know

    class Rate(ProgressColumn):
        def render(self, task: Task) -> Text:
            return Text("" if task.speed is None else f"{task.speed:,.0f} {task.fields['unit']}/s")

    class Remaining(TimeRemainingColumn):
        def render(self, task: Task) -> Text:
            time = super().render(task)
            known = task.time_remaining is not None
            return Text(say("progress.left", language, time=time.plain), time.style) if known else time

    columns = "{task.description}", BarColumn(), MofNCompleteColumn(), Rate(), Remaining()
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        _drawn.append(progress)
        try:
            yield progress
        finally:
            _drawn.remove(progress)
