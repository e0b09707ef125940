"""A progress bar for long work, drawn on a terminal only."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from rich.progress import Task
    from rich.text import Text


@contextmanager
def bar(
    total: int, what: str, shown: bool | None = None, unit: str = "cases"
) -> Generator[Callable[[int], None]]:
    """Yield a callback that advances a progress bar on standard error, with the rate and the time left.

    Parameters
    ----------
    total : int
        Number of items.
    what : str
        Label of the bar.
    shown : bool, optional
        Whether to draw it; by default only if standard error is a terminal.
    unit : str
        What the items are called, in the plural.
    """
    from rich.console import Console

    console = Console(stderr=True)
    if not (console.is_terminal if shown is None else shown):
        yield lambda count: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, ProgressColumn, TimeRemainingColumn
    from rich.text import Text

    class Rate(ProgressColumn):
        def render(self, task: Task) -> Text:
            return Text("" if task.speed is None else f"{task.speed:,.0f} {unit}/s")

    columns = "{task.description}", BarColumn(), MofNCompleteColumn(), Rate(), TimeRemainingColumn()
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task(what, total=total)
        yield lambda count: progress.advance(task, count)
