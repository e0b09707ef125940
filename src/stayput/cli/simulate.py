"""``stayput simulate``: one body under one motion."""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import LANGUAGES, say
from stayput.cli.flags import (
    OF_LOCALE,
    SCENE,
    SHAKING,
    FlagValues,
    LanguageOption,
    QuietOption,
    chosen_measures,
    opened,
    takes,
    words,
)
from stayput.cli.messages import compiling, plain_table, print_json, tell_written, terminal

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from stayput.report.animation import Progress


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
        typer.Option(
            metavar="TYPE|NAME", help="cli_help.measure_in_place", autocompletion=words("measures:MEASURES")
        ),
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
    from stayput.report.summary import piece_name, rows, sentences, summary
    from stayput.simulation.run import Run

    _check_targets(plot, animate)
    checked = opened(scenario, said, (plot, animate), of_one={"--measure": measure})
    with compiling():
        run = checked.run(chosen_measures(checked, measure or []))
    if checked.alone:
        piece = checked.piece
        name = (piece.title, piece_name(piece.preset, piece.name)[1])
        names = (name[LANGUAGES.index(lang)],)
    else:
        from stayput.rooms.words import names_in

        name, names = ("", ""), checked.names if json else names_in(checked, lang)
    from stayput.report.animation import animate_run

    if isinstance(run, Run):
        from stayput.report.plot import plot_run

        told, values, listed = sentences(run, name), summary(run), rows(run, lang)
        plotted = partial(plot_run, run)
    else:
        from stayput.report.space.plot import plot_space_run
        from stayput.report.space.summary import became, space_rows, space_summary

        told, values, listed = became(run, names), space_summary(run, names), space_rows(run, names, lang)
        plotted = partial(plot_space_run, run, names=names)
    if plot is not None:
        plotted(plot, title=say(told, lang), language=lang)
    if animate is not None:
        with _progress() as progress:
            animate_run(run, animate, names=names, fps=fps, speed=speed, language=lang, progress=progress)
    if json:
        print_json(values)
        return
    console, paragraph = terminal(lang, checked.title)
    paragraph(say(told, lang))
    shaking = checked.shaking
    if shaking.strength is not None:
        listed.append((say("cli.strength", lang), say(shaking.strength.about, lang)))
    if shaking.remove_mean:
        listed.append((say("cli.baseline", lang), say("cli.mean_removed", lang)))
    console.print(plain_table(("", ""), listed))
    tell_written(lang, plot, animate)


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
