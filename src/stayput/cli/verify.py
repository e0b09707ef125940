"""``stayput verify``: which measure keeps a piece of furniture standing, and how likely that is."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import say
from stayput.cli.completion import intensity_measures, measures, words
from stayput.cli.flags import (
    SHAKING,
    FlagValues,
    QuietOption,
    ThreadsOption,
    changed,
    chosen_measures,
    motion_files,
    scenario_data,
    scenario_of,
    takes,
)
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import compiling, note, tell_written
from stayput.cli.streams import called, check_output, is_stream, to_output, write_text
from stayput.cli.verdicts import print_verdict
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.fragility import IntensityMeasure
    from stayput.rooms.verdict import RoomVerdict
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.verification import AssemblyVerdict, Verdict


@takes(SHAKING)
def verify(
    scenario: Annotated[Path, typer.Argument(metavar="SCENARIO.toml", help="cli_help.scenario")],
    *,
    said: FlagValues,
    measure: Annotated[
        list[str] | None,
        typer.Option(metavar="TYPE|NAME", help="cli_help.only_measure", autocompletion=words(measures)),
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
            autocompletion=words(intensity_measures),
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
    from stayput.files import check_apart, check_target

    for page in (report, plan):
        if page is not None:
            check_target(page, (".html",))
    check_output(markdown, (".md",))
    check_output(csv, (".csv",))
    instead = to_output({"--markdown": markdown, "--csv": csv}, json)
    if report is not None and plan is not None and report.resolve() == plan.resolve():
        value = repr(str(plan))
        raise InputError("cli.same_file", "--plan", flag="--report", other="--plan", value=value)
    if slide_limit is not None:
        within("--slide-limit", slide_limit, 0.0, 100.0, "m")
    home = (no_drilling, tatami, plasterboard, dropped_ceiling)
    if plan is None and any(home):
        raise InputError("cli.home_without_plan")
    over = _over(curves, im)
    given = scenario_data(scenario)
    if plan is not None and "plan" not in given:
        raise InputError("cli.plan_of_a_room", "--plan").at(called(scenario))
    data = changed(given, said, scenario)
    read = [*motion_files(given, scenario), *motion_files(data, scenario)]
    check_apart((report, markdown, csv, plan), [scenario, *read])
    checked = _only(scenario_of(data, given, scenario), measure, curves)
    verdict = _verified(checked, over, slide_limit, every_run, threads)
    if json:
        typer.echo(verdict.to_json(), nl=False)
    elif not instead:
        print_verdict(verdict, lang)
    written = _write(verdict, report, markdown, csv, lang)  # what was found is told even if this fails
    from stayput.rooms.verdict import RoomVerdict
    from stayput.verification import Verdict

    if curves is not None and isinstance(verdict, Verdict):
        written += _write_curves(verdict, over[0], curves, lang, aside=instead or json)
    if plan is not None and isinstance(verdict, RoomVerdict):
        from stayput.rooms.planning import action_plan

        made = action_plan(
            verdict,
            no_drilling=no_drilling,
            tatami=tatami,
            plasterboard=plasterboard,
            dropped_ceiling=dropped_ceiling,
            threads=threads,
        )
        written.append(made.report(plan, lang))
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
            raise InputError("cli.im_without_curves", "--im", value=repr(im))
        return []
    if curves.exists() and not curves.is_dir():
        raise InputError("cli.folder_is_file", "--curves", folder=repr(str(curves)))
    if not curves.parent.is_dir():
        raise InputError("cli.no_parent", "--curves", folder=repr(str(curves)))
    return [intensity_measure(im or "JMA", "--im")]


def _only(
    scenario: Scenario | AssemblyScenario, names: list[str] | None, curves: Path | None
) -> Scenario | AssemblyScenario:
    """Return the scenario with only these of its measures, or with these types of measure.

    Raises
    ------
    InputError
        A name that is neither; flags of one piece beside several.
    """
    from stayput.scenario import Scenario

    if not isinstance(scenario, Scenario):
        for flag, wanted in (("--measure", names), ("--curves", curves)):
            if wanted:
                raise InputError("scenario.flag_of_one", flag, flag=flag)
        return scenario
    if not names:
        return scenario
    chosen_measures(scenario, names)  # refuses unknown names
    tables = scenario.model_dump(by_alias=True, exclude_unset=True)
    stated_names = (measure_set.name for measure_set in scenario.measures)
    stated = dict(zip(stated_names, tables.get("measures") or (), strict=True))
    tables["measures"] = [stated.get(name, {"type": name}) for name in dict.fromkeys(names)]
    return Scenario.parse(tables, scenario.folder)


def _verified(
    scenario: Scenario | AssemblyScenario,
    over: list[IntensityMeasure],
    slide_limit: float | None,
    every_run: bool,
    threads: int | None,
) -> Verdict | AssemblyVerdict | RoomVerdict:
    from stayput.scenario import RoomScenario
    from stayput.verification import SLIDE_LIMIT

    limit = SLIDE_LIMIT if slide_limit is None else slide_limit
    with scenario.naming_file(), compiling():
        if isinstance(scenario, RoomScenario):
            from stayput.rooms.verify import verify_room

            return verify_room(scenario, slide_limit=limit, threads=threads)

        from stayput.verification import verify as compare

        options: dict[str, Any] = {"intensity_measures": over} if over else {}
        return compare(scenario, slide_limit=limit, every_run=every_run, threads=threads, **options)


def _write(
    verdict: Verdict | AssemblyVerdict | RoomVerdict,
    report: Path | None,
    markdown: Path | None,
    csv: Path | None,
    lang: str,
) -> list[Path]:
    if report is not None:
        verdict.report(report, lang)
    if markdown is not None:
        write_text(markdown, verdict.to_markdown(lang))
    if csv is not None:
        from stayput.spreadsheets import CSV_ENCODING

        write_text(csv, verdict.to_csv(), CSV_ENCODING)
    return [path for path in (report, markdown, csv) if path is not None and not is_stream(path)]


def _write_curves(
    verdict: Verdict, measure: IntensityMeasure, folder: Path, lang: str, *, aside: bool
) -> Sequence[Path]:
    """Write the fragility curves of all options, and tell of each beside the verdict unless that is aside."""
    from stayput.fragility import MMI
    from stayput.report.verdict.exports import write_curves
    from stayput.verification.words import title

    files, left_out = write_curves(verdict, measure, folder, lang)
    told: list[str] = []
    for result in verdict.options:
        curve = result.curves[measure]
        name = title(result.option, verdict, lang) if lang == "ja" else curve.name
        told.append(say("cli.curve", lang, name=name, told=curve.texts))
        if curve.lognormal is not None:
            told.append(f"  {say(curve.lognormal.texts, lang)}")
    if measure == MMI:
        told.append(say("fragility.mmi_scatter", lang))
    for sentence in () if aside else told:
        typer.echo(sentence)
    for sentence in left_out:
        note(sentence)
    return files
