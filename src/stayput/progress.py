"""A progress bar for long work, drawn on a terminal only."""

from __future__ import annotations

import multiprocessing
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from rich.progress import Progress, Task
    from rich.text import Text


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
def bar(
    total: int | None, what: str, shown: bool | None = None, unit: str = "cases"
) -> Generator[Callable[[int], None]]:
    """Yield a callback that advances a progress bar on standard error, with the rate and the time left.

    Where another bar is drawn already, this one stands below it.

    Parameters
    ----------
    total : int or None
        Number of items; None where it is not known, and the bar but moves.
    what : str
        Label of the bar.
    shown : bool, optional
        Whether to draw it; by default only if standard error is a terminal, and not in a process that another
        one has started for its work.
    unit : str
        What the items are called, in the plural.
    """
    if not (is_drawn() if shown is None else shown):
        yield lambda count: None
        return
    with _progress() as progress:
        task = progress.add_task(what, total=total, unit=unit)
        try:
            yield lambda count: progress.advance(task, count)
        finally:
            progress.remove_task(task)


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

    class Rate(ProgressColumn):
        def render(self, task: Task) -> Text:
            return Text("" if task.speed is None else f"{task.speed:,.0f} {task.fields['unit']}/s")

    class Remaining(TimeRemainingColumn):
        def render(self, task: Task) -> Text:
            time = super().render(task)
            return time if task.time_remaining is None else time.append(" left")

    columns = "{task.description}", BarColumn(), MofNCompleteColumn(), Rate(), Remaining()
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        _drawn.append(progress)
        try:
            yield progress
        finally:
            _drawn.remove(progress)
