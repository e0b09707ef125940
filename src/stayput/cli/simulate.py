"""``stayput simulate``: what stands, under one motion."""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import say
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
    from stayput.report.animation import animate_run
    from stayput.report.plot import plot_run
    from stayput.report.summary import rows, sentences, summary

    _check_targets(plot, animate)
    checked = opened(scenario, said, (plot, animate), of_one={"--measure": measure})
    with compiling():
        run = checked.run(chosen_measures(checked, measure or []))
    sentence = say(sentences(run), lang)
    if plot is not None:
        plot_run(run, plot, title=sentence, language=lang)
    if animate is not None:
        with _progress() as progress:
            animate_run(run, animate, fps=fps, speed=speed, language=lang, progress=progress)
    if json:
        print_json(summary(run))
        return
    console, paragraph = terminal(lang, checked.title)
    paragraph(sentence)
    listed = rows(run, lang)
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
