"""``stayput simulate``: one body under one motion."""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from stayput.catalogue import LANGUAGES, say
from stayput.cli.completion import measures, surfaces, words
from stayput.cli.flags import (
    FlagValues,
    QuietOption,
    chosen_measures,
    inputs_of,
    overlaid,
    parsed,
    reads_records,
    scenario_data,
)
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import compiling, folded, print_json, tell_written
from stayput.cli.shaking import (
    BuildingOption,
    MotionOption,
    ScaleOption,
    StoreyOption,
    VerticalOption,
    XOption,
    YOption,
    ZOption,
    scales_motions,
    shaken,
    tell_of_y,
)
from stayput.errors import InputError, InputWarning, warn

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from stayput.catalogue import Phrase
    from stayput.report.animation import Progress
    from stayput.scenario.shaking import ShakingTable
    from stayput.simulation.run import Run
    from stayput.simulation.space_run import SpaceRun


@reads_records
@scales_motions
def simulate(
    scenario: Annotated[
        Path | None,
        typer.Argument(
            metavar="[SCENARIO.toml]",
            help="cli_help.example_scenario",
            show_default=False,
        ),
    ] = None,
    body: Annotated[
        str | None,
        typer.Option(metavar="WxHxM", help="cli_help.body"),
    ] = None,
    motion: MotionOption = None,
    x: XOption = None,
    y: YOption = None,
    z: ZOption = None,
    *,
    reading: FlagValues,
    scale: ScaleOption = None,
    strength: FlagValues,
    building: BuildingOption = None,
    storey: StoreyOption = None,
    vertical: VerticalOption = None,
    floor: Annotated[
        str | None,
        typer.Option(metavar="SURFACE", help="cli_help.floor", autocompletion=words(surfaces)),
    ] = None,
    friction: Annotated[
        str | None, typer.Option(metavar="STATIC[,KINETIC]", help="cli_help.friction")
    ] = None,
    wall: Annotated[float | None, typer.Option("--wall", "--left-wall", help="cli_help.wall")] = None,
    right_wall: Annotated[float | None, typer.Option(help="cli_help.right_wall")] = None,
    near_side_wall: Annotated[float | None, typer.Option(help="cli_help.near_side_wall")] = None,
    far_side_wall: Annotated[float | None, typer.Option(help="cli_help.far_side_wall")] = None,
    length: Annotated[float | None, typer.Option(help="cli_help.length")] = None,
    heading: Annotated[float | None, typer.Option(help="cli_help.heading")] = None,
    dimensions: Annotated[int | None, typer.Option(metavar="2|3", help="cli_help.dimensions")] = None,
    measure: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TYPE|NAME",
            help="cli_help.measure_in_place",
            autocompletion=words(measures),
        ),
    ] = None,
    lang: LanguageOption = OF_LOCALE,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.plot_run")] = None,
    animate: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.animate")] = None,
    speed: Annotated[float, typer.Option(help="cli_help.speed")] = 1.0,
    fps: Annotated[float, typer.Option(help="cli_help.fps")] = 20.0,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput simulate``."""
    from stayput.files import check_apart
    from stayput.report.summary import piece_name
    from stayput.scenario import Scenario
    from stayput.simulation.run import Run

    _check_targets(plot, animate)
    given = scenario_data(scenario, body)
    check_apart((plot, animate), inputs_of(given, scenario, (motion, x, y, z)))
    several = scenario is not None and isinstance(given.get("furniture"), list)
    of_one = {
        "--body": body,
        "--length": length,
        "--heading": heading,
        "--measure": measure or None,
    }
    if several and (flags := [flag for flag, value in of_one.items() if value is not None]):
        raise InputError("scenario.flag_of_one", flags[0], flag=flags[0])
    data = overlaid(
        given,
        body=body,
        floor=floor,
        friction=friction,
        walls={
            "left_wall": wall,
            "right_wall": right_wall,
            "near_side_wall": near_side_wall,
            "far_side_wall": far_side_wall,
        },
        dimensions=dimensions,
        piece={"length": length, "heading": heading},
    )
    data = shaken(
        data,
        scenario,
        motion=motion,
        x=x,
        y=y,
        z=z,
        reading=reading,
        scale=scale,
        strength=strength,
        building=building,
        storey=storey,
        vertical=vertical,
    )
    if several:
        from stayput.scenario import AssemblyScenario, RoomScenario

        pieces = parsed(
            RoomScenario if "plan" in given else AssemblyScenario, data, given, scenario, motion or x
        )
        with compiling():
            found = pieces.run()
        from stayput.rooms.words import names_in

        _show_in_space(
            found,
            pieces.names if json else names_in(pieces, lang),
            _Wanted(("", ""), pieces.shaking, pieces.title, plot, animate, speed, fps, lang, json),
        )
        return
    checked = parsed(Scenario, data, given, scenario, motion or x)
    if length is not None and checked.dimensions == 2:
        warn(InputWarning("cli.length_in_the_plane", "--length", value=length))
    tell_of_y(y, checked)
    with checked.naming_file(), compiling():
        run = checked.case(chosen_measures(checked, measure or [])).run()
    piece = checked.furniture
    called = piece.title, piece_name(piece.preset, piece.name)[1]
    wanted = _Wanted(called, checked.shaking, checked.title, plot, animate, speed, fps, lang, json)
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
                name=wanted.called,
                language=wanted.lang,
                progress=progress,
            )
    if wanted.json:
        print_json(summary(run))
    else:
        _print_table(sentences(run, wanted.name), rows(run, wanted.lang), wanted)
    wanted.tell_written()


def _show_in_space(run: SpaceRun, names: tuple[str, ...], wanted: _Wanted) -> None:
    from stayput.report.space.said import became
    from stayput.report.space.summary import space_rows, space_summary

    if wanted.plot is not None:
        from stayput.report.space.plot import plot_space_run

        title = say(became(run, names), wanted.lang)
        plot_space_run(run, wanted.plot, names=names, title=title, language=wanted.lang)
    if wanted.animate is not None:
        from stayput.report.space.animation import animate_space_run

        with _progress() as progress:
            animate_space_run(
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
