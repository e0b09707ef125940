"""``stayput fragility``: fragility curves of a scenario's measures, in the forms that loss tools read."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import say
from stayput.cli.completion import intensity_measures, measures, words
from stayput.cli.flags import (
    EveryRunOption,
    QuietOption,
    ThreadsOption,
    chosen_measures,
    parsed,
    scenario_data,
)
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import compiling, note, tell_written

if TYPE_CHECKING:
    from stayput.fragility import FragilityCurve
    from stayput.scenario import Scenario


def fragility(
    scenario: Annotated[Path, typer.Argument(metavar="SCENARIO.toml", help="cli_help.scenario")],
    out: Annotated[Path, typer.Option(metavar="DIR", help="cli_help.curves_out")],
    im: Annotated[
        str,
        typer.Option(
            metavar="JMA|MMI|PGA|PGV|SA(T)|PFA|PFV",
            help="cli_help.im",
            autocompletion=words(intensity_measures),
        ),
    ] = "JMA",
    measure: Annotated[
        list[str] | None,
        typer.Option(
            metavar="TYPE|NAME",
            help="cli_help.only_measure",
            autocompletion=words(measures),
        ),
    ] = None,
    lang: LanguageOption = OF_LOCALE,
    every_run: EveryRunOption = False,
    threads: ThreadsOption = None,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput fragility``."""
    from stayput.errors import InputError
    from stayput.fragility import MMI, intensity_measure

    wanted = intensity_measure(im, "--im")
    if out.exists() and not out.is_dir():
        raise InputError("cli.folder_is_file", "--out", folder=repr(str(out)))
    if not out.parent.is_dir():
        raise InputError("cli.no_parent", "--out", folder=repr(str(out)))

    from stayput.scenario import Scenario

    given = scenario_data(scenario, None)
    selected = _only(parsed(Scenario, given, given, scenario, None), measure)

    from stayput.report.verdict.exports import write_curves
    from stayput.verification import verify
    from stayput.verification.words import title

    with compiling():
        verdict = verify(selected, intensity_measures=[wanted], every_run=every_run, threads=threads)
    files, left_out = write_curves(verdict, wanted, out, lang)
    for result in verdict.options:
        curve: FragilityCurve = result.curves[wanted]
        name = title(result.option, verdict, lang) if lang == "ja" else curve.name
        typer.echo(say("cli.curve", lang, name=name, told=curve.texts))
        if curve.lognormal is not None:
            typer.echo(f"  {say(curve.lognormal.texts, lang)}")
    if wanted == MMI:
        typer.echo(say("fragility.mmi_scatter", lang))
    for sentence in left_out:
        note(sentence)
    tell_written(lang, *files)


def _only(scenario: Scenario, names: list[str] | None) -> Scenario:
    """Return the scenario with only these of its measures, or with these types of measure.

    Raises
    ------
    InputError
        A name that is neither.
    """
    if not names:
        return scenario
    from stayput.scenario import Scenario

    chosen_measures(scenario, names)  # refuses unknown names
    tables = scenario.model_dump(by_alias=True, exclude_unset=True)
    stated_names = (measure_set.name for measure_set in scenario.measures)
    stated = dict(zip(stated_names, tables.get("measures") or (), strict=True))
    tables["measures"] = [stated.get(name, {"type": name}) for name in dict.fromkeys(names)]
    return Scenario.parse(tables, scenario.folder)
