"""``stayput simulate`` and ``stayput verify``: what stands under one motion, and which measure holds it."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import phrase, say
from stayput.cli import flags as flag
from stayput.cli.messages import compiling, note, plain_table, print_json, tell_written, terminal
from stayput.cli.streams import called, check_output, is_stream, to_output, write_text
from stayput.errors import InputError, within
from stayput.execution import thread_count
from stayput.files import CSV_ENCODING, PLOT_SUFFIXES, check_animation, check_writable
from stayput.progress import bar, is_drawn

if TYPE_CHECKING:
    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.report.animation import Progress
    from stayput.scenario import Scenario
    from stayput.verification import Verdict


@flag.takes({**flag.SCENE, **flag.SHAKING})
def simulate(
    scenario: Annotated[
        Path | None,
        typer.Argument(metavar="[SCENARIO.toml]", help="cli_help.example_scenario", show_default=False),
    ] = None,
    *,
    said: flag.FlagValues,
    measure: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TYPE|NAME",
            help="cli_help.measure_in_place",
            autocompletion=flag.words("measures:MEASURES"),
        ),
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.plot_run")] = None,
    animate: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.animate")] = None,
    speed: Annotated[float, typer.Option(help="cli_help.speed")] = 1.0,
    fps: Annotated[float, typer.Option(help="cli_help.fps")] = 20.0,
    lang: flag.LanguageOption = "",
) -> None:
    """Run ``stayput simulate``."""
    from stayput.report.summary import rows, sentences, summary

    check_output(plot, PLOT_SUFFIXES, stream=False)
    if animate is not None:
        check_animation(animate)
    checked = flag.opened(scenario, said, (plot, animate), of_one={"--measure": measure})
    with compiling():
        run = checked.run(flag.chosen_measures(checked, measure) if measure else None)
    sentence = say(sentences(run), lang)
    if plot is not None:
        from stayput.report.plot import plot_run  # loading it takes longer than a run

        plot_run(run, plot, title=sentence, language=lang)
    if animate is not None:
        from stayput.report.animation import animate_run  # this one too

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


@contextmanager
def _progress() -> Generator[Progress | None]:
    """Yield a function that advances a bar of frames, or None where none is drawn."""
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


@flag.takes(flag.SHAKING)
def verify(
    scenario: Annotated[Path, typer.Argument(metavar="SCENARIO.toml", help="cli_help.scenario")],
    *,
    said: flag.FlagValues,
    measure: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TYPE|NAME", help="cli_help.only_measure", autocompletion=flag.words("measures:MEASURES")
        ),
    ] = None,
    report: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.report")] = None,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    markdown: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.markdown")] = None,
    csv: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.csv")] = None,
    curves: Annotated[Path | None, typer.Option(metavar="DIR", help="cli_help.curves")] = None,
    im: Annotated[
        str | None,
        typer.Option(
            metavar="JMA|MMI|PGA|PGV|SA(T)|PFA|PFV",
            help="cli_help.im",
            autocompletion=flag.words("fragility.intensity_measures:INTENSITY_MEASURES"),
        ),
    ] = None,
    card: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.card")] = None,
    no_drilling: Annotated[bool, typer.Option("--no-drilling", help="cli_help.no_drilling")] = False,
    tatami: Annotated[bool, typer.Option("--tatami", help="cli_help.tatami")] = False,
    plasterboard: Annotated[bool, typer.Option("--plasterboard", help="cli_help.plasterboard")] = False,
    dropped_ceiling: Annotated[
        bool, typer.Option("--dropped-ceiling", help="cli_help.dropped_ceiling")
    ] = False,
    slide_limit: Annotated[float | None, typer.Option(help="cli_help.slide_limit")] = None,
    threads: flag.ThreadsOption = None,
    lang: flag.LanguageOption = "",
) -> None:
    """Run ``stayput verify``."""
    from stayput.cli.verdicts import print_verdict
    from stayput.montecarlo.counting import SLIDE_LIMIT
    from stayput.rooms.steps import Home
    from stayput.verification import verify as compare

    check_output(report, (".html",), stream=False)
    check_output(card, (".html",), stream=False)
    check_output(markdown, (".md",))
    check_output(csv, (".csv",))
    instead = to_output({"--markdown": markdown, "--csv": csv}, json)
    if report is not None and card is not None and report.resolve() == card.resolve():
        raise InputError("cli.same_file", "--card", flag="--report", other="--card", value=card)
    limit = SLIDE_LIMIT if slide_limit is None else within("--slide-limit", slide_limit, 0.0, 100.0, "m")
    home = Home(no_drilling, tatami, plasterboard, dropped_ceiling)
    if card is None and home != Home():
        flags = ", ".join(f"--{name}".replace("_", "-") for name, said in asdict(home).items() if said)
        raise InputError("scenario.needs_both", "--card", name=flags, other="--card")
    over = _over(curves, im)
    of_one = {"--measure": measure}
    checked = flag.opened(scenario, said, (report, markdown, csv, card), of_one=of_one)
    if card is not None and checked.plan is None:
        where = phrase("rooms.against_without_plan")
        raise InputError("common.left_out", "--card", where=where).at(called(scenario))
    if measure:
        checked = _only(checked, measure)
    with checked.naming_file():
        checked = home.of(checked)  # the verdict, too, is of the room as it is said to be
    thread_count(threads)  # refused as what it is, not as the file's
    options: dict[str, Any] = {} if over is None else {"intensity_measures": [over]}
    with checked.naming_file(), compiling():
        verdict = compare(checked, slide_limit=limit, threads=threads, **options)
    if json:
        typer.echo(verdict.to_json(), nl=False)
    elif not instead:
        print_verdict(verdict, lang)
    written = [path for path in (report, markdown, csv) if path is not None and not is_stream(path)]
    if report is not None:
        verdict.report(report, lang)
    if markdown is not None:
        write_text(markdown, verdict.to_markdown(lang))
    if csv is not None:
        write_text(csv, verdict.to_csv(), CSV_ENCODING)
    if curves is not None and over is not None:
        written += _write_curves(verdict, over, curves, lang, aside=instead or json)
    if card is not None:
        from stayput.rooms.planning import action_plan

        written.append(action_plan(verdict, **asdict(home), threads=threads).report(card, lang))
    if not json:
        tell_written(lang, *written, aside=instead)


def _over(curves: Path | None, im: str | None) -> IntensityMeasure | None:
    """Return what the curves are over; none where no curves are asked for.

    Raises
    ------
    InputError
        A measure that there is not, or without curves; a folder that cannot be one.
    """
    from stayput.fragility.intensity_measures import intensity_measure

    if curves is None:
        if im is not None:
            raise InputError("scenario.needs_both", "--im", other="--curves")
        return None
    if curves.exists() and not curves.is_dir():
        raise InputError("common.folder_is_file", "--curves", folder=curves, path=curves)
    check_writable(curves / "curves.csv")
    return intensity_measure(im or "JMA", "--im")


def _only(scenario: Scenario, names: list[str]) -> Scenario:
    """Return the scenario with only these of its measures, or with these types of measure.

    Raises
    ------
    InputError
        A name that is neither.
    """
    flag.chosen_measures(scenario, names)  # refuses unknown names
    tables = scenario.model_dump(by_alias=True, exclude_unset=True)
    stated_names = (measure_set.name for measure_set in scenario.options)
    stated = dict(zip(stated_names, tables.get("measures") or (), strict=True))
    tables["measures"] = [stated.get(name, {"type": name}) for name in dict.fromkeys(names)]
    return type(scenario).parse(tables, scenario.folder)


def _write_curves(
    verdict: Verdict, measure: IntensityMeasure, folder: Path, lang: str, *, aside: bool
) -> Sequence[Path]:
    """Write the fragility curves of all options, and tell of each beside the verdict unless that is aside."""
    from stayput.fragility.intensity_measures import MMI
    from stayput.report.verdict.exports import write_curves

    files, left_out = write_curves(verdict, measure, folder, lang)
    sentences: list[str] = []
    for result in verdict.options:
        curve = result.curves[measure]
        name = verdict.label(result, lang) if lang == "ja" else curve.name
        sentences.append(say("cli.curve", lang, name=name, told=curve.texts))
        if curve.lognormal is not None:
            sentences.append(f"  {say(curve.lognormal_texts, lang)}")
    if measure == MMI:
        sentences.append(say("fragility.mmi_scatter", lang))
    for sentence in () if aside else sentences:
        typer.echo(sentence)
    for sentence in left_out:
        note(sentence)
    return files
