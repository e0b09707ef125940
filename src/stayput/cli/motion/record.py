"""``stayput motion info``, ``plot``, ``spectrum`` and ``convert``: commands on one motion."""

from __future__ import annotations

import math
from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import say
from stayput.cli.flags import (
    GROUND,
    FlagValues,
    MotionArgument,
    QuietOption,
    motion_of,
    numbers,
    tables_of_motion,
    takes,
)
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import folded, note, print_json, tell_written
from stayput.cli.motion.floors import print_floors, respond
from stayput.cli.streams import check_output, is_stream, to_output, write_text
from stayput.errors import InputError, InputWarning, unknown, warn

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from stayput.motion import Motion, Peaks
    from stayput.motion.measures import DisplacementPeak, Intensities, SpectralMeasures
    from stayput.motion.spectrum import ResponseSpectrum

TABLE_PERIODS = (0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)
"""Periods of the table that is printed [s]."""


@takes(GROUND)
def info(
    motion: MotionArgument,
    *,
    said: FlagValues,
    lang: LanguageOption = OF_LOCALE,
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput motion info``."""
    from stayput.motion.measures import Intensities, SpectralMeasures

    tables = tables_of_motion(motion, said)
    if (response := respond(tables)) is not None:
        print_floors(response, lang, json=json)
        return
    record = motion_of(tables)
    intensities = Intensities.of(record)
    rows = {name: (peaks, SpectralMeasures.of(record, name)) for name, peaks in record.peaks().items()}
    if json:
        print_json(_info_record(record, intensities, rows))
    else:
        _print_info(record, intensities, rows, lang)


def _number(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _info_record(
    motion: Motion, intensities: Intensities, rows: dict[str, tuple[Peaks, SpectralMeasures]]
) -> dict[str, Any]:
    moved = _displacements(motion)
    return {
        "name": motion.name,
        "source": motion.source,
        "synthetic": motion.synthetic,
        "dt_s": motion.dt,
        "samples": len(motion),
        "duration_s": motion.duration,
        "jma_intensity": _number(intensities.intensity),
        "jma_class": None if motion.floor else intensities.intensity_class,
        "long_period_sva_m_s": intensities.long_period_response,
        "long_period_class": None if motion.floor else intensities.long_period_class,
        "modified_mercalli": _number(intensities.mercalli),
        "floor": motion.floor or None,
        "components": {
            name: {
                "pga_m_s2": peaks.pga,
                "pgv_m_s": peaks.pgv,
                "pgd_m": peaks.pgd,
                "pgd_baseline_corrected_m": moved[name].corrected,
                "displacement_drifts": moved[name].drifts,
                "arias_m_s": peaks.arias,
                "cav_m_s": peaks.cav,
                "significant_duration_s": peaks.significant_duration,
                "housner_intensity_m": spectral.housner_intensity,
                "spectrum_intensity_m_s": spectral.spectrum_intensity,
                "predominant_period_s": _number(spectral.predominant_period),
                "mean_period_s": _number(spectral.mean_period),
            }
            for name, (peaks, spectral) in rows.items()
        },
    }


def _print_info(
    motion: Motion, intensities: Intensities, rows: dict[str, tuple[Peaks, SpectralMeasures]], lang: str
) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.catalogue.names import INTENSITIES
    from stayput.motion.floors import floor_phrase
    from stayput.report.names import given_name, motion_label

    console = Console(highlight=False, markup=False)
    console.print(motion_label(motion, lang), style="bold")
    console.print(given_name(motion.source, lang))
    console.print(say("cli.samples", lang, count=len(motion), dt=motion.dt, duration=motion.duration))
    strong = say(
        "cli.intensities_of_floor" if motion.floor else "cli.intensities",
        lang,
        intensity=intensities.published,
        name=floor_phrase(motion.floor) if motion.floor else INTENSITIES[intensities.intensity_class],
        long_period=intensities.long_period_class,
        sva=100.0 * intensities.long_period_response,
        mmi=intensities.mercalli,
    )
    console.print(folded(strong, console.width) if lang == "ja" else strong)
    moved = _displacements(motion)
    names = {"x": "cli.along", "y": "cli.across", "z": "cli.up"}
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("")
    for name in rows:
        table.add_column(say(names[name], lang), justify="right")
    lines = (
        ("cli.pga", [peaks.pga for peaks, _ in rows.values()]),
        ("cli.pgv", [100.0 * peaks.pgv for peaks, _ in rows.values()]),
        ("cli.pgd", [math.nan if one.drifts else 100.0 * one.pgd for one in moved.values()]),
        ("cli.arias", [peaks.arias for peaks, _ in rows.values()]),
        ("cli.cav", [peaks.cav for peaks, _ in rows.values()]),
        ("cli.d5_95", [peaks.significant_duration for peaks, _ in rows.values()]),
        ("cli.housner", [spectral.housner_intensity for _, spectral in rows.values()]),
        ("cli.si", [100.0 * spectral.spectrum_intensity for _, spectral in rows.values()]),
        ("cli.largest_sa", [spectral.predominant_period for _, spectral in rows.values()]),
        ("cli.mean_period", [spectral.mean_period for _, spectral in rows.values()]),
    )
    for label, values in lines:
        told = (f"{value:.3g}" if math.isfinite(value) else "–" for value in values)
        table.add_row(say(label, lang), *told)
    console.print(table)
    _warn_of_drift(motion)


def _displacements(motion: Motion) -> dict[str, DisplacementPeak]:
    from stayput.motion.measures import DisplacementPeak

    return {name: DisplacementPeak.of(motion, name) for name in motion.components}


def _warn_of_drift(motion: Motion) -> None:
    """Warn of displacements that are those of the record's baseline and not of the ground."""
    for name, peak in _displacements(motion).items():
        if peak.drifts:
            pgd, corrected = 100.0 * peak.pgd, 100.0 * peak.corrected
            warn(InputWarning("motion.drifts", "motion", component=name, pgd=pgd, corrected=corrected))


@takes(GROUND)
def plot(
    motion: MotionArgument,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="cli_help.picture")],
    *,
    said: FlagValues,
    spectra: Annotated[str | None, typer.Option(metavar="STOREY,…", help="cli_help.floor_spectra")] = None,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput motion plot``."""
    from stayput.files import PLOT_SUFFIXES, check_target

    check_target(out, PLOT_SUFFIXES)
    tables = tables_of_motion(motion, said, out)
    if (response := respond(tables)) is not None:
        from stayput.report.building import building_title, plot_building

        parts = [] if spectra is None else spectra.split(",")
        storeys = [round(one) for one in numbers("--spectra", spectra or "", parts, range(99), "3,8")]
        for storey in storeys:
            response.model.place(storey)
        plot_building(response, out, storeys or None, title=building_title(response, lang), language=lang)
    elif spectra is not None:
        raise InputError("cli.spectra_of_floors", "--spectra", value=repr(spectra))
    else:
        from stayput.report.names import motion_label
        from stayput.report.plot import plot_motion  # Matplotlib takes its time to load

        record = motion_of(tables)
        plot_motion(record, out, title=motion_label(record, lang), language=lang)
        _warn_of_drift(record)
    tell_written(lang, out)


@takes(GROUND)
def spectrum(
    motion: MotionArgument,
    *,
    said: FlagValues,
    damping: Annotated[float, typer.Option(help="cli_help.oscillator_damping")] = 0.05,
    out: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.spectra_out")] = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.plot_spectra")] = None,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput motion spectrum``."""
    from stayput.files import PLOT_SUFFIXES, check_target
    from stayput.motion.spectrum import PERIODS, response_spectrum

    check_output(out, (".csv",))
    if plot is not None:
        check_target(plot, PLOT_SUFFIXES)
    record = motion_of(tables_of_motion(motion, said, out, plot))
    instead = to_output({"--out": out})

    def spectra(periods: ArrayLike) -> dict[str, ResponseSpectrum]:
        return {name: response_spectrum(record, periods, damping, name) for name in record.components}

    if not instead:
        _print_spectra(record, spectra(TABLE_PERIODS), lang)
    if out is not None:
        write_text(out, _spectra_csv(spectra(PERIODS)))
    if plot is not None:
        from stayput.catalogue import say
        from stayput.report.names import motion_label
        from stayput.report.spectra import plot_spectra

        title = say("plots.spectra", lang, name=motion_label(record, lang), damping=100.0 * damping)
        plot_spectra(record, plot, damping, title=title, language=lang)
    tell_written(lang, out, plot, aside=instead)


def _spectra_csv(spectra: dict[str, ResponseSpectrum]) -> str:
    columns = {"period_s": next(iter(spectra.values())).periods.tolist()}
    for name, spectrum in spectra.items():
        columns[f"sa_{name}_m_s2"] = spectrum.sa.tolist()
        columns[f"psv_{name}_m_s"] = spectrum.psv.tolist()
        columns[f"sva_{name}_m_s"] = spectrum.sva.tolist()
        columns[f"sd_{name}_m"] = spectrum.sd.tolist()
    rows = [",".join(map(repr, row)) for row in zip(*columns.values(), strict=True)]
    return "\n".join([",".join(columns), *rows, ""])


def _print_spectra(motion: Motion, spectra: dict[str, ResponseSpectrum], lang: str) -> None:
    from rich.console import Console
    from rich.table import Table

    from stayput.report.names import motion_label

    console = Console(highlight=False, markup=False)
    damping = 100.0 * next(iter(spectra.values())).damping
    heading = say("cli.spectra", lang, motion=motion_label(motion, lang), damping=damping)
    console.print(heading, style="bold")
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column(say("cli.period", lang), justify="right")
    for name in spectra:
        for label in (f"Sa {name} [m/s²]", f"ω·Sd {name} [cm/s]"):
            table.add_column(label, justify="right")
    for i, period in enumerate(TABLE_PERIODS):
        values = [v for s in spectra.values() for v in (s.sa[i], 100.0 * s.psv[i])]
        table.add_row(f"{period:g}", *(f"{value:.3g}" for value in values))
    console.print(table)


@takes(GROUND)
def convert(
    motion: MotionArgument,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="cli_help.converted")],
    *,
    said: FlagValues,
    only: Annotated[str | None, typer.Option(metavar="x|y|z", help="cli_help.only")] = None,
    step: Annotated[float | None, typer.Option(help="cli_help.step")] = None,
    form: Annotated[str | None, typer.Option("--format", metavar="csv|at2", help="cli_help.format")] = None,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput motion convert``."""
    from stayput.motion.writers import FORMATS

    check_output(out, tuple(FORMATS))
    tables = tables_of_motion(motion, said, out)
    ending = _ending(out, form)
    record = motion_of(tables)
    if step is not None:
        record = record.resampled(step)
    if only is not None:
        record = record.component(only)
    write_text(out, record.text(ending))
    if not is_stream(out):
        parts = ", ".join(record.components)
        told = say("cli.wrote_motion", lang, file=out, count=len(record), dt=record.dt, components=parts)
        note(told, aside=False)


def _ending(out: Path, form: str | None) -> str:
    """Return the ending that says the format: the file's own, or ``--format`` of what is printed."""
    from stayput.motion.writers import FORMATS

    known = [ending.removeprefix(".") for ending in FORMATS]
    if form is not None and form not in known:
        raise unknown("--format", form, known, "--format")
    if is_stream(out):
        return f".{form or known[0]}"
    if form is not None and f".{form}" != out.suffix.lower():
        raise InputError("cli.other_format", "--format", value=repr(form), out=repr(str(out)))
    return out.suffix.lower()
