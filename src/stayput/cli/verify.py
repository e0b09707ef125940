"""``stayput verify``: which measure keeps a piece of furniture standing, and how likely that is."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.cli.flags import (
    EveryRunOption,
    FlagValues,
    QuietOption,
    ThreadsOption,
    inputs_of,
    parsed,
    reads_records,
    scenario_data,
)
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import compiling, folded, tell_written
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
from stayput.cli.streams import called, check_output, is_stream, to_output, write_text
from stayput.cli.verify_room import print_room
from stayput.cli.verify_several import print_several

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console
    from rich.table import Table

    from stayput.rooms.verdict import RoomVerdict
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.verification import AssemblyVerdict, Verdict


@reads_records
@scales_motions
def verify(
    scenario: Annotated[Path, typer.Argument(metavar="SCENARIO.toml", help="cli_help.scenario")],
    report: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="cli_help.report"),
    ] = None,
    lang: LanguageOption = OF_LOCALE,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    markdown: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.markdown")] = None,
    csv: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.csv")] = None,
    plan: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="cli_help.plan"),
    ] = None,
    no_drilling: Annotated[bool, typer.Option("--no-drilling", help="cli_help.no_drilling")] = False,
    tatami: Annotated[bool, typer.Option("--tatami", help="cli_help.tatami")] = False,
    plasterboard: Annotated[bool, typer.Option("--plasterboard", help="cli_help.plasterboard")] = False,
    dropped_ceiling: Annotated[
        bool, typer.Option("--dropped-ceiling", help="cli_help.dropped_ceiling")
    ] = False,
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
    slide_limit: Annotated[float | None, typer.Option(help="cli_help.slide_limit")] = None,
    every_run: EveryRunOption = False,
    threads: ThreadsOption = None,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput verify``."""
    from stayput.errors import InputError, within
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
    given = scenario_data(scenario, None)
    check_apart((report, markdown, csv, plan), inputs_of(given, scenario, (motion, x, y, z)))
    if plan is not None and "plan" not in given:
        raise InputError("cli.plan_of_a_room", "--plan").at(called(scenario))
    data = shaken(
        given,
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
    checked = parsed(_kind(data), data, given, scenario, motion or x)
    tell_of_y(y, checked)
    verdict = _verified(checked, slide_limit, every_run, threads)
    from stayput.rooms.verdict import RoomVerdict

    if json:
        typer.echo(verdict.to_json(), nl=False)
    elif not instead:
        _tell(verdict, lang)
    written = _write(verdict, report, markdown, csv, lang)  # what was found is told even if this fails
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


def _kind(data: dict[str, Any]) -> type[Scenario | AssemblyScenario]:
    """Return what a file's tables describe."""
    from stayput.scenario import AssemblyScenario, RoomScenario, Scenario

    if "plan" in data:
        return RoomScenario
    return AssemblyScenario if isinstance(data.get("furniture"), list) else Scenario


def _verified(
    scenario: Scenario | AssemblyScenario, slide_limit: float | None, every_run: bool, threads: int | None
) -> Verdict | AssemblyVerdict | RoomVerdict:
    from stayput.scenario import RoomScenario
    from stayput.verification import SLIDE_LIMIT

    limit = SLIDE_LIMIT if slide_limit is None else slide_limit
    with scenario.naming_file(), compiling():
        if isinstance(scenario, RoomScenario):
            from stayput.rooms.verify import verify_room

            return verify_room(scenario, slide_limit=limit, threads=threads)

        from stayput.verification import verify as compare

        return compare(scenario, slide_limit=limit, every_run=every_run, threads=threads)


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


def _tell(verdict: Verdict | AssemblyVerdict | RoomVerdict, lang: str) -> None:
    from stayput.rooms.verdict import RoomVerdict
    from stayput.verification import AssemblyVerdict

    if isinstance(verdict, RoomVerdict):
        print_room(verdict, lang)
    elif isinstance(verdict, AssemblyVerdict):
        print_several(verdict, lang)
    else:
        _print(verdict, lang)


def _print(verdict: Verdict, lang: str) -> None:
    from rich.console import Console

    from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY
    from stayput.montecarlo.counting import OVERTURNED
    from stayput.report.verdict import numbers
    from stayput.report.verdict.tables import SHARES, grades_text, impossible_rows, ranking, simulations
    from stayput.report.verdict.words import word
    from stayput.verification import EVENTS
    from stayput.verification.words import headline, title
    from stayput.wording import with_aside

    text = partial(word, language=lang)
    console = Console(highlight=False, markup=False)

    def paragraph(sentences: str) -> None:
        console.print(folded(sentences, console.width) if lang == "ja" else sentences)

    if verdict.scenario.title is not None:
        console.print(verdict.scenario.title, style="bold")
    paragraph(headline(verdict, lang))
    limit = numbers.length(verdict.slide_limit, lang)
    events = (text(f"brief_{event}", limit=limit) for event in EVENTS)
    capacities = (text("brief_capacity", share=f"{100.0 * share:g}") for share in SHARES)
    inside = (text("brief_contents_out"),) if verdict.without.contents is not None else ()
    headings = (*events, *inside, text("brief_slide"), *capacities)
    rows, lines = ranking(verdict, lang), list[tuple[str, ...]]()
    for row in rows:
        falls, *others = (
            numbers.NO_NUMBER if chance is None else numbers.probability(chance, lang)
            for _, chance in row.shares
        )
        result = row.option
        reached = (numbers.capacity(result.capacities.get(share), lang, brief=True) for share in SHARES)
        slide = text("brief_falls") if math.isinf(result.slide.median) else row.slide[0]
        share = f"{falls} ({row.grade})"  # the grade of its inputs stands beside the number itself
        out = () if row.contents is None else (numbers.probability(row.contents, lang),)
        lines.append((str(result.rank), row.name or row.label, share, *others, *out, slide, *reached))
    impossible = impossible_rows(verdict, lang)
    for (label, _), rejected in zip(impossible, verdict.impossible, strict=True):
        name = rejected.option.name if rejected.option.own_name else label
        lines.append((numbers.NO_NUMBER, name, text("brief_not_possible")))
    console.print(_fitting(text("measure"), headings, lines, len(SHARES), console))
    intensity = FLOOR_JMA if verdict.floor else JMA_INTENSITY
    paragraph(text("brief_text", intensity=intensity.names))
    paragraph(grades_text(lang))
    colon = text("colon")
    for row in rows:
        ends = numbers.interval(row.option.probabilities[OVERTURNED], lang)
        label = title(row.option.option, verdict, lang)
        label = with_aside(label, ends, lang) if ends else label
        console.print(f"{row.option.rank}. {label}{colon}{row.reason}", soft_wrap=True)
    for label, why in impossible:
        console.print(
            f"{numbers.NO_NUMBER}  {label}{colon}{text('not_possible')}{colon}{why}", soft_wrap=True
        )
    for note in verdict.notes(lang):
        console.print(note, soft_wrap=True)
    if verdict.motions == 1:
        paragraph(text("one_motion"))
    if not verdict.precise:
        paragraph(text("not_precise"))
    paragraph(simulations(verdict, lang))


def _fitting(
    label: str, headings: tuple[str, ...], lines: Sequence[tuple[str, ...]], last: int, console: Console
) -> Table:
    """Return the table of a ranking, without its last columns where it is wider than the terminal."""
    from rich.cells import cell_len
    from rich.table import Table

    narrow = 12  # of the labels, which are folded
    folds = max(max(cell_len(line[1]) for line in lines) - narrow, 0)
    for shown in (headings, headings[:-last]):
        table = Table(box=None, padding=(0, 1, 0, 0))
        table.add_column("", justify="right")
        table.add_column(label, min_width=narrow, overflow="fold")
        for heading in shown:
            table.add_column(heading, justify="right", no_wrap=True, overflow="fold")
        for line in lines:
            table.add_row(*line[: len(shown) + 2])
        if (
            console.measure(table, options=console.options.update(max_width=10_000)).maximum - folds
            <= console.width
        ):
            break
    return table
