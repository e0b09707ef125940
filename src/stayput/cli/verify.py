"""``stayput verify``: which measure keeps a piece of furniture standing, and how likely that is."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import say
from stayput.cli.flags import (
    OF_LOCALE,
    SHAKING,
    FlagValues,
    LanguageOption,
    QuietOption,
    ThreadsOption,
    chosen_measures,
    opened,
    takes,
    words,
)
from stayput.cli.messages import compiling, note, tell_written
from stayput.cli.streams import called, check_output, is_stream, to_output, write_text
from stayput.cli.verdicts import print_verdict
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.fragility import IntensityMeasure
    from stayput.rooms.verdict import RoomVerdict
    from stayput.scenario import Scenario
    from stayput.verification import Verdict


@takes(SHAKING)
def verify(
    scenario: Annotated[Path, typer.Argument(metavar="SCENARIO.toml", help="cli_help.scenario")],
    *,
    said: FlagValues,
    measure: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TYPE|NAME", help="cli_help.only_measure", autocompletion=words("measures:MEASURES")
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
            autocompletion=words("fragility:INTENSITY_MEASURES"),
        ),
    ] = None,
    plan: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.plan")] = None,
    no_drilling: Annotated[bool, typer.Option("--no-drilling", help="cli_help.no_drilling")] = False,
    tatami: Annotated[bool, typer.Option("--tatami", help="cli_help.tatami")] = False,
    plasterboard: Annotated[bool, typer.Option("--plasterboard", help="cli_help.plasterboard")] = False,
    dropped_ceiling: Annotated[
        bool, typer.Option("--dropped-ceiling", help="cli_help.dropped_ceiling")
    ] = False,
    slide_limit: Annotated[float | None, typer.Option(help="cli_help.slide_limit")] = None,
    every_run: Annotated[bool, typer.Option("--every-run", help="cli_help.every_run")] = False,
    threads: ThreadsOption = None,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput verify``."""
    from stayput.errors import within
    from stayput.files import check_target
    from stayput.montecarlo.counting import SLIDE_LIMIT
    from stayput.rooms.verdict import RoomVerdict
    from stayput.verification import Verdict

    for page in (report, plan):
        if page is not None:
            check_target(page, (".html",))
    check_output(markdown, (".md",))
    check_output(csv, (".csv",))
    instead = to_output({"--markdown": markdown, "--csv": csv}, json)
    if report is not None and plan is not None and report.resolve() == plan.resolve():
        value = repr(str(plan))
        raise InputError("cli.same_file", "--plan", flag="--report", other="--plan", value=value)
    limit = SLIDE_LIMIT if slide_limit is None else within("--slide-limit", slide_limit, 0.0, 100.0, "m")
    home: dict[str, Any] = {
        "no_drilling": no_drilling,
        "tatami": tatami,
        "plasterboard": plasterboard,
        "dropped_ceiling": dropped_ceiling,
    }
    if plan is None and any(home.values()):
        flags = ", ".join(f"--{name}".replace("_", "-") for name, wanted in home.items() if wanted)
        raise InputError("cli.flag_without", "--plan", flag=flags, other="--plan")
    over = _over(curves, im)
    of_one = {"--measure": measure, "--curves": curves}
    checked = opened(scenario, said, (report, markdown, csv, plan), of_one=of_one)
    if plan is not None and checked.plan is None:
        raise InputError("cli.plan_of_a_room", "--plan").at(called(scenario))
    if measure:
        checked = _only(checked, measure)
    verdict = _verified(checked, over, limit, every_run, threads)
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
        from stayput.spreadsheets import CSV_ENCODING

        write_text(csv, verdict.to_csv(), CSV_ENCODING)
    if curves is not None and isinstance(verdict, Verdict):
        written += _write_curves(verdict, over[0], curves, lang, aside=instead or json)
    if plan is not None and isinstance(verdict, RoomVerdict):
        from stayput.rooms.planning import action_plan

        written.append(action_plan(verdict, **home, threads=threads).report(plan, lang))
    if not json:
        tell_written(lang, *written, aside=instead)


def _over(curves: Path | None, im: str | None) -> list[IntensityMeasure]:
    """Return what the curves are over; nothing where none are asked for.

    Raises
    ------
    InputError
        A measure that there is not, or without curves; a folder that cannot be one.
    """
    from stayput.fragility import intensity_measure

    if curves is None:
        if im is not None:
            raise InputError("cli.flag_without", "--im", flag="--im", other="--curves")
        return []
    if curves.exists() and not curves.is_dir():
        raise InputError(
            "common.folder_is_file", "--curves", folder=repr(str(curves)), path=repr(str(curves))
        )
    return [intensity_measure(im or "JMA", "--im")]


def _only(scenario: Scenario, names: list[str]) -> Scenario:
    """Return the scenario with only these of its measures, or with these types of measure.

    Raises
    ------
    InputError
        A name that is neither.
    """
    chosen_measures(scenario, names)  # refuses unknown names
    tables = scenario.model_dump(by_alias=True, exclude_unset=True)
    stated_names = (measure_set.name for measure_set in scenario.options)
    stated = dict(zip(stated_names, tables.get("measures") or (), strict=True))
    tables["measures"] = [stated.get(name, {"type": name}) for name in dict.fromkeys(names)]
    return type(scenario).parse(tables, scenario.folder)


def _verified(
    scenario: Scenario,
    over: list[IntensityMeasure],
    slide_limit: float,
    every_run: bool,
    threads: int | None,
) -> Verdict | RoomVerdict:
    from stayput.rooms.verify import verify_room
    from stayput.verification import verify as compare

    with scenario.naming_file(), compiling():
        if scenario.plan is not None:
            return verify_room(scenario, slide_limit=slide_limit, threads=threads)
        options: dict[str, Any] = {"intensity_measures": over} if over else {}
        return compare(scenario, slide_limit=slide_limit, every_run=every_run, threads=threads, **options)


def _write_curves(
    verdict: Verdict, measure: IntensityMeasure, folder: Path, lang: str, *, aside: bool
) -> Sequence[Path]:
    """Write the fragility curves of all options, and tell of each beside the verdict unless that is aside."""
    from stayput.fragility import MMI
    from stayput.report.verdict.exports import write_curves
    from stayput.verification.words import title

    files, left_out = write_curves(verdict, measure, folder, lang)
    sentences: list[str] = []
    for result in verdict.options:
        curve = result.curves[measure]
        name = title(result.option, verdict, lang) if lang == "ja" else curve.name
        sentences.append(say("cli.curve", lang, name=name, told=curve.texts))
        if curve.lognormal is not None:
            sentences.append(f"  {say(curve.lognormal.texts, lang)}")
    if measure == MMI:
        sentences.append(say("fragility.mmi_scatter", lang))
    for sentence in () if aside else sentences:
        typer.echo(sentence)
    for sentence in left_out:
        note(sentence)
    return files
