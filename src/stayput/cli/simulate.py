"""``stayput simulate``: one body under one motion."""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from stayput.catalogue import LANGUAGES, say
from stayput.cli.completion import measures, words
from stayput.cli.flags import (
    SCENE,
    SHAKING,
    FlagValues,
    QuietOption,
    changed,
    chosen_measures,
    motion_files,
    scenario_data,
    scenario_of,
    takes,
)
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import compiling, folded, print_json, tell_written
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from stayput.catalogue import Phrase
    from stayput.report.animation import Progress
    from stayput.scenario.shaking import ShakingTable
    from stayput.simulation.run import Run
    from stayput.simulation.space_run import SpaceRun


@takes({**SCENE, **SHAKING})
def simulate(
    scenario: Annotated[
        Path | None,
        typer.Argument(metavar="[SCENARIO.toml]", help="cli_help.example_scenario", show_default=False),
    ] = None,
    *,
    said: FlagValues,
    measure: Annotated[
        list[str] | None,
        typer.Option(metavar="TYPE|NAME", help="cli_help.measure_in_place", autocompletion=words(measures)),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.plot_run")] = None,
    animate: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.animate")] = None,
    speed: Annotated[float, typer.Option(help="cli_help.speed")] = 1.0,
    fps: Annotated[float, typer.Option(help="cli_help.fps")] = 20.0,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput simulate``."""
    from stayput.files import check_apart
    from stayput.report.summary import piece_name
    from stayput.scenario import Scenario
    from stayput.simulation.run import Run

    _check_targets(plot, animate)
    given = scenario_data(scenario, "body" in said)
    if isinstance(given.get("furniture"), list):
        for flag, wanted in (("--body", "body" in said), ("--measure", measure)):
            if wanted:
                raise InputError("scenario.flag_of_one", flag, flag=flag)
    data = changed(given, said, scenario)
    read = [] if scenario is None else [scenario]
    check_apart((plot, animate), [*read, *motion_files(given, scenario), *motion_files(data, scenario)])
    checked = scenario_of(data, given, scenario)
    wanted = _Wanted(("", ""), checked.shaking, checked.title, plot, animate, speed, fps, lang, json)
    if not isinstance(checked, Scenario):
        from stayput.rooms.words import names_in

        with compiling():
            found = checked.run()
        _show_in_space(found, checked.names if json else names_in(checked, lang), wanted)
        return
    with checked.naming_file(), compiling():
        run = checked.case(chosen_measures(checked, measure or [])).run()
    piece = checked.furniture
    wanted = wanted._replace(name=(piece.title, piece_name(piece.preset, piece.name)[1]))
    if isinstance(run, Run):
        _show_in_the_plane(run, wanted)
    else:
        _show_in_space(run, (wanted.called,), wanted)


class _Wanted(NamedTuple):
    """What is shown of a run, and where it is written."""

    name: Phrase
    shaking: ShakingTable
    title: str | None
    plot: Path | None
    animate: Path | None
    speed: float
    fps: float
    lang: str
    json: bool

    @property
    def called(self) -> str:
        """What the piece is called in the language."""
        return self.name[LANGUAGES.index(self.lang)]

    def tell_written(self) -> None:
        """Say which files were written, beside results that are no JSON."""
        if not self.json:
            tell_written(self.lang, self.plot, self.animate)


def _show_in_the_plane(run: Run, wanted: _Wanted) -> None:
    from stayput.report.summary import rows, sentences, summary

    if wanted.plot is not None:
        from stayput.report.plot import plot_run

        title = say(sentences(run, (wanted.called, wanted.called)), wanted.lang)
        plot_run(run, wanted.plot, title=title, language=wanted.lang)
    if wanted.animate is not None:
        from stayput.report.animation import animate_run

        with _progress() as progress:
            animate_run(
                run,
                wanted.animate,
                fps=wanted.fps,
                speed=wanted.speed,
                names=[wanted.called],
                language=wanted.lang,
                progress=progress,
            )
    if wanted.json:
        print_json(summary(run))
    else:
        _print_table(sentences(run, wanted.name), rows(run, wanted.lang), wanted)
    wanted.tell_written()


def _show_in_space(run: SpaceRun, names: tuple[str, ...], wanted: _Wanted) -> None:
    from stayput.report.space.summary import became, space_rows, space_summary

    if wanted.plot is not None:
        from stayput.report.space.plot import plot_space_run

        title = say(became(run, names), wanted.lang)
        plot_space_run(run, wanted.plot, names=names, title=title, language=wanted.lang)
    if wanted.animate is not None:
        from stayput.report.animation import animate_run

        with _progress() as progress:
            animate_run(
                run,
                wanted.animate,
                names=names,
                fps=wanted.fps,
                speed=wanted.speed,
                language=wanted.lang,
                progress=progress,
            )
    if wanted.json:
        print_json(space_summary(run, names))
    else:
        _print_table(became(run, names), space_rows(run, names, wanted.lang), wanted)
    wanted.tell_written()


def _check_targets(plot: Path | None, animate: Path | None) -> None:
    if plot is not None:
        from stayput.files import PLOT_SUFFIXES, check_target

        check_target(plot, PLOT_SUFFIXES)
    if animate is not None:
        from stayput.files import check_animation

        check_animation(animate)


@contextmanager
def _progress() -> Generator[Progress | None]:
    """Yield a function that advances a bar of frames, or None where none is drawn."""
    from stayput.progress import bar, is_drawn

    if not is_drawn():
        yield None
        return
    with ExitStack() as stack:
        advance: list[Callable[[int], None]] = []

        def drawn(done: int, total: int) -> None:
            if not advance:  # the first frame: only now it is known how many there are
                advance.append(stack.enter_context(bar(total, "progress.drawing", unit="progress.frames")))
            advance[0](1)

        yield drawn


def _print_table(said: Phrase, rows: list[tuple[str, str]], wanted: _Wanted) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(highlight=False, markup=False)
    if wanted.title is not None:
        console.print(wanted.title, style="bold")
    sentence = said[LANGUAGES.index(wanted.lang)]
    console.print(folded(sentence, console.width) if wanted.lang == "ja" else sentence)
    table = Table(show_header=False, box=None, padding=(0, 2, 0, 0))
    for label, value in rows:
        table.add_row(label, value)
    if wanted.shaking.strength is not None:
        table.add_row(say("cli.strength", wanted.lang), say(wanted.shaking.strength.about, wanted.lang))
    if wanted.shaking.remove_mean:
        table.add_row(say("cli.baseline", wanted.lang), say("cli.mean_removed", wanted.lang))
    console.print(table)
