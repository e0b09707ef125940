"""``stayput motion suite``: many motions at once, made or read, scaled, and written."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import say
from stayput.cli.flags import GROUND, FlagValues, LanguageOption, numbers, tables_of_motion, takes, words
from stayput.cli.messages import note
from stayput.errors import InputError, not_allowed, unknown
from stayput.files import CSV_ENCODING, csv_text, folder_draft, name_part
from stayput.progress import bar
from stayput.wording import counted

if TYPE_CHECKING:
    from stayput.motion.suites.suite import Suite
    from stayput.motion.suites.target import TargetSpectrum

FITS = ("scale", "match", "together")


@takes(GROUND)
def suite(
    out: Annotated[Path, typer.Option(metavar="DIR", help="cli_help.suite_out")],
    family: Annotated[
        str, typer.Option(help="cli_help.family", autocompletion=words("catalogue.names:FAMILIES"))
    ] = "mixed",
    count: Annotated[int, typer.Option(help="cli_help.count")] = 40,
    seed: Annotated[int, typer.Option(help="cli_help.seed")] = 1,
    records: Annotated[Path | None, typer.Option(metavar="DIR", help="cli_help.records")] = None,
    *,
    said: FlagValues,
    target: Annotated[str | None, typer.Option(help="cli_help.target")] = None,
    band: Annotated[str, typer.Option(metavar="T1,T2", help="cli_help.band")] = "0.1,5",
    fit: Annotated[str, typer.Option(help="cli_help.fit", autocompletion=words("cli.suite:FITS"))] = "scale",
    select: Annotated[int | None, typer.Option(metavar="N", help="cli_help.select")] = None,
    lang: LanguageOption = "",
) -> None:
    """Run ``stayput motion suite``."""
    if out.exists() and not out.is_dir():
        raise InputError("common.folder_is_file", "--out", folder=out, path=out)
    if fit not in FITS:
        raise unknown("--fit", fit, FITS, "--fit")
    if target is not None and "intensity" in said:
        raise InputError("scenario.only_one", "--target", other="--intensity")
    for flag, asked in (("--select", select is not None), ("--fit", fit != "scale")):
        if target is None and asked:
            raise InputError("scenario.needs_both", "--target", name=flag, other="--target")
    wanted = None if target is None else _target_of(target)
    first, last = numbers("--band", band, band.split(","), (2,), "0.1,5")
    periods = first, last

    from stayput.scenario import Scenario

    made = {"family": family, "count": count, "seed": seed}
    tables = tables_of_motion(None, said, suite=made if records is None else str(records))
    motions = Scenario.parse(tables).shaking.motions(Path())
    if wanted is not None:
        if select is not None:
            motions = motions.selected(wanted, select, periods)
        scaled = motions.to_spectrum(wanted, periods)
        motions = scaled if fit == "scale" else scaled.matched(wanted, periods, together=fit == "together")
    _write(motions, out, wanted, lang)
    _print_end(motions, wanted, periods, out, lang)


def _target_of(text: str) -> TargetSpectrum:
    """Return the target spectrum of ``japan[:LEVEL[,SOIL]]``, ``asce7:SDS,SD1[,TL]`` or a table's file.

    Raises
    ------
    InputError
        A text or a file that cannot be read.
    """
    from stayput.motion.suites.target import asce7, japanese_design, read_target

    kind, _, rest = text.partition(":")
    if kind == "asce7":
        return asce7(*numbers("--target", text, rest.split(","), (2, 3), "asce7:1.0,0.6,8"))
    if kind == "japan":
        level, _, soil = (rest or "very-rare,2").partition(",")
        number = numbers("--target", text, [soil or "2"], (1,), "japan:very-rare,2")[0]
        return japanese_design(level.replace("-", " "), round(number))
    if not Path(text).exists():
        raise not_allowed("--target", repr(text), "cli.targets", "--target")
    return read_target(text)


def _write(motions: Suite, out: Path, target: TargetSpectrum | None, lang: str) -> None:
    from stayput.report.spectra import plot_suite, suite_title
    from stayput.report.summary import attributes

    rows: list[dict[str, object]] = []
    with (
        folder_draft(out) as unfinished,
        bar(len(motions), "progress.writing", unit="progress.motions") as advance,
    ):
        folder = unfinished / "motions"
        folder.mkdir()
        for i, motion in enumerate(motions, start=1):
            file = f"{i:0{len(str(len(motions)))}d}-{name_part(motion.name, 'motion')}.csv"
            motion.write(folder / file)
            about: dict[str, object] = {
                "file": file,
                **attributes(motion, "name", "synthetic", "dt_s", "duration_s"),
                "jma_intensity": motion.intensity,
                **attributes(motion, "pga_m_s2", "pgv_m_s"),
                "d5_95_s": motion.significant_duration,
                **attributes(motion, "floor", "source"),
            }
            rows.append(about)
            advance(1)
        (unfinished / "suite.csv").write_text(
            csv_text(list(rows[0]), (row.values() for row in rows), "\n"), encoding=CSV_ENCODING
        )
        title = suite_title(motions, lang)
        plot_suite(motions, unfinished / "suite.png", target, title=title, language=lang)


def _print_end(
    motions: Suite, target: TargetSpectrum | None, periods: tuple[float, float], out: Path, lang: str
) -> None:
    from stayput.motion.intensity import published_intensity
    from stayput.report.names import given_name

    number, kind = len(motions), "synthetic motion" if motions.synthetic else "motion"
    japanese = f"{'模擬' if motions.synthetic else ''}地震動{number}本"
    count, at = (counted(number, kind), japanese), [published_intensity(i) for i in motions.intensities]
    typer.echo(say("cli.suite", lang, count=count, low=min(at), high=max(at)))
    if target is not None:
        off = motions.deviation(target, periods)
        said = say(
            "cli.suite_off",
            lang,
            target=given_name(target.name, lang),
            first=periods[0],
            last=periods[1],
            mean=100.0 * off.mean,
            worst=100.0 * off.worst,
            at=off.worst_period,
        )
        typer.echo(said)
    note(say("cli.wrote_suite", lang, folder=out), aside=False)
