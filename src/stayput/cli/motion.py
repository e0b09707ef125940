"""``stayput motion``: look at a motion, or at the floors of a building under it, or write it anew."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stayput.catalogue import phrase, say
from stayput.cli import flags
from stayput.cli.help import HelpfulCommand, HelpfulGroup
from stayput.cli.messages import note, plain_table, print_json, tell_written, terminal
from stayput.cli.streams import check_output, is_stream, to_output, write_text
from stayput.cli.suite import suite
from stayput.errors import InputError, InputWarning, not_allowed, unknown, warn
from stayput.files import PLOT_SUFFIXES, check_target, csv_text

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from stayput.building.response import FloorResponse
    from stayput.motion.record import Motion
    from stayput.motion.response import ResponseSpectrum

app = typer.Typer(cls=HelpfulGroup, help="cli_help.motion", no_args_is_help=True, rich_markup_mode=None)

TABLE_PERIODS = (0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0)
"""Periods of the table that is printed [s]."""


@flags.takes(flags.GROUND)
def info(
    motion: flags.MotionArgument,
    *,
    said: flags.FlagValues,
    lang: flags.LanguageOption = "",
    json: Annotated[bool, typer.Option("--json", help="cli_help.json")] = False,
) -> None:
    """Run ``stayput motion info``."""
    tables = flags.tables_of_motion(motion, said)
    if (response := respond(tables)) is not None:
        if json:
            print_json(_floors_record(response))
        else:
            _print_floors(response, lang)
        return
    record = flags.motion_of(tables)
    if json:
        print_json(_measures(record))
    else:
        _print_info(record, lang)


def _measures(motion: Motion) -> dict[str, Any]:
    """Return how strong a motion is, as one JSON object."""
    from stayput.motion.ground_shaking import mercalli_of
    from stayput.motion.intensity import (
        SpectralMeasures,
        intensity_class,
        long_period_class,
        long_period_response,
    )
    from stayput.report.summary import attributes, number

    intensity = motion.intensity
    response = long_period_response(motion.x, motion.y, motion.dt)
    parts = {name: (peaks, SpectralMeasures.of(motion, name)) for name, peaks in motion.peaks().items()}
    return {
        **attributes(motion, "name", "source", "synthetic", "dt_s"),
        "samples": len(motion),
        "duration_s": motion.duration,
        "jma_intensity": number(intensity),
        "jma_class": None if motion.floor else intensity_class(intensity),
        "long_period_sva_m_s": response,
        "long_period_class": None if motion.floor else long_period_class(response),
        "modified_mercalli": number(mercalli_of(motion)),
        "floor": motion.floor or None,
        "components": {
            name: {
                **attributes(peaks, "pga_m_s2", "pgv_m_s", "pgd_m", "pgd_baseline_corrected_m"),
                "displacement_drifts": peaks.displacement_drifts,
                **attributes(peaks, "arias_m_s", "cav_m_s", "significant_duration_s"),
                **attributes(spectral, "housner_intensity_m", "spectrum_intensity_m_s"),
                **attributes(spectral, "predominant_period_s", "mean_period_s"),
            }
            for name, (peaks, spectral) in parts.items()
        },
    }


LINES = {
    "cli.pga": ("pga_m_s2", 1.0),
    "cli.pgv": ("pgv_m_s", 100.0),
    "cli.pgd": ("pgd_m", 100.0),
    "cli.arias": ("arias_m_s", 1.0),
    "cli.cav": ("cav_m_s", 1.0),
    "cli.d5_95": ("significant_duration_s", 1.0),
    "cli.housner": ("housner_intensity_m", 1.0),
    "cli.si": ("spectrum_intensity_m_s", 100.0),
    "cli.largest_sa": ("predominant_period_s", 1.0),
    "cli.mean_period": ("mean_period_s", 1.0),
}
"""Lines of the table of a motion: label, key in JSON, and factor from there to the unit of the table."""


def _print_info(motion: Motion, lang: str) -> None:
    from stayput.catalogue.names import INTENSITIES
    from stayput.motion.floors import floor_phrase
    from stayput.motion.intensity import published_intensity
    from stayput.report.names import given_name, motion_label

    console, paragraph = terminal(lang, motion_label(motion, lang))
    console.print(given_name(motion.source, lang))
    console.print(say("cli.samples", lang, count=len(motion), dt=motion.dt, duration=motion.duration))
    about = _measures(motion)
    strong = say(
        "cli.intensities_of_floor" if motion.floor else "cli.intensities",
        lang,
        intensity=published_intensity(motion.intensity),
        name=floor_phrase(motion.floor) if motion.floor else INTENSITIES[about["jma_class"]],
        long_period=about["long_period_class"],
        sva=100.0 * about["long_period_sva_m_s"],
        mmi=about["modified_mercalli"],
    )
    paragraph(strong)
    parts = about["components"]
    rows: list[list[str]] = []
    for label, (key, factor) in LINES.items():
        values = (
            None if key == "pgd_m" and part["displacement_drifts"] else part[key] for part in parts.values()
        )
        cells = ("–" if value is None else f"{factor * value:.3g}" for value in values)
        rows.append([say(label, lang), *cells])
    names = {"x": "cli.along", "y": "cli.across", "z": "cli.up"}
    headings = ["", *(say(names[part], lang) for part in parts)]
    console.print(plain_table(headings, rows, justify="right"))
    _warn_of_drift(motion)


def _warn_of_drift(motion: Motion) -> None:
    """Warn of displacements that are those of the record's baseline and not of the ground."""
    for name, peaks in motion.peaks().items():
        if peaks.displacement_drifts:
            pgd, corrected = 100.0 * peaks.pgd, 100.0 * peaks.pgd_baseline_corrected
            warn(InputWarning("motion.drifts", "motion", component=name, pgd=pgd, corrected=corrected))


def respond(tables: Mapping[str, Any]) -> FloorResponse | None:
    """Return what the floors of a building do of which no storey is named; None where there is no such one.

    Parameters
    ----------
    tables : mapping
        Tables of a scenario, whose ``[shaking]`` may have a building.

    Raises
    ------
    InputError
        A value that is not allowed, or a record that cannot be read.
    """
    from stayput.scenario import Scenario

    shaking = flags.table_of(tables, "shaking")
    if "building" not in shaking or "storey" in shaking:
        return None
    table = Scenario.parse({**tables, "shaking": {**shaking, "storey": 1}}).shaking
    assert table.building is not None
    ground = table.model_copy(update={"building": None, "storey": None})
    return table.building.building().respond(ground.motion(Path()))


def _floors_record(response: FloorResponse) -> dict[str, Any]:
    import numpy as np

    model = response.model
    return {
        "building": model.name,
        "periods_s": model.periods.tolist(),
        "damping": np.atleast_1d(model.damping).tolist(),
        "nonlinear": model.yields,
        "motion": {"name": response.motion.name, "synthetic": response.motion.synthetic},
        "dt_s": response.dt,
        "storeys": response.storeys.tolist(),
        "components": {
            name: {
                "peak_floor_acceleration_m_s2": response.peak_acceleration(name).tolist(),
                "peak_floor_velocity_m_s": response.peak_velocity(name).tolist(),
                "peak_drift_m": response.peak_drift(name).tolist(),
            }
            for name in response.acceleration
        },
        "energy": {
            name: {
                "input_j": float(energy.input[-1]),
                "damping_j": float(energy.damping[-1]),
                "plastic_j": float(energy.plastic[-1]),
                "imbalance": energy.imbalance,
            }
            for name, energy in response.energy.items()
        },
    }


def _print_floors(response: FloorResponse, lang: str) -> None:
    """Print the peaks of all floors, and where the energy went."""
    from stayput.report.names import given_name, motion_label

    model = response.model
    kind = say("plots.yielding" if model.yields else "plots.linear", lang)
    name = given_name(model.name, lang)
    heading = say("cli.building", lang, name=name, period=model.periods[0], kind=kind)
    console, paragraph = terminal(lang, heading)
    console.print(say("cli.building_ground", lang, motion=motion_label(response.motion, lang)))
    headings, ground = [say("report.floor", lang)], list[float]()
    columns: list[NDArray[np.float64]] = []
    for name in response.acceleration:
        peaks = response.motion.peaks()[name]
        headings += [f"PFA {name} [m/s²]", f"PFV {name} [cm/s]"]
        ground += [peaks.pga, 100.0 * peaks.pgv]
        columns += [response.peak_acceleration(name), 100.0 * response.peak_velocity(name)]
    floors = [(model.place(s), [column[s - 1] for column in columns]) for s in response.storeys.tolist()]
    rows = [
        [given_name(label, lang), *(f"{value:.3g}" for value in values)]
        for label, values in (*reversed(floors), ("ground", ground))
    ]
    console.print(plain_table(headings, rows, justify="right"))
    for name, energy in response.energy.items():
        if not energy.input[-1] > 0.0:
            console.print(say("cli.building_no_energy", lang, component=name))
            continue
        share = 100.0 * energy.plastic[-1] / energy.input[-1]
        paragraph(say("cli.building_energy", lang, component=name, share=share, imbalance=energy.imbalance))


@flags.takes(flags.GROUND)
def plot(
    motion: flags.MotionArgument,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="cli_help.picture")],
    *,
    said: flags.FlagValues,
    spectra: Annotated[str | None, typer.Option(metavar="STOREY,…", help="cli_help.floor_spectra")] = None,
    lang: flags.LanguageOption = "",
) -> None:
    """Run ``stayput motion plot``."""
    check_target(out, PLOT_SUFFIXES)
    tables = flags.tables_of_motion(motion, said, out)
    if (response := respond(tables)) is not None:
        from stayput.report.building import building_title, plot_building

        parts = [] if spectra is None else spectra.split(",")
        storeys = [
            round(storey) for storey in flags.numbers("--spectra", spectra or "", parts, range(99), "3,8")
        ]
        for storey in storeys:
            response.model.place(storey)
        plot_building(response, out, storeys or None, title=building_title(response, lang), language=lang)
    elif spectra is not None:
        raise InputError("common.left_out", "--spectra", where=phrase("cli.one_storey"))
    else:
        from stayput.report.names import motion_label
        from stayput.report.plot import plot_motion  # Matplotlib takes its time to load

        record = flags.motion_of(tables)
        plot_motion(record, out, title=motion_label(record, lang), language=lang)
        _warn_of_drift(record)
    tell_written(lang, out)


@flags.takes(flags.GROUND)
def spectrum(
    motion: flags.MotionArgument,
    *,
    said: flags.FlagValues,
    damping: Annotated[float, typer.Option(help="cli_help.oscillator_damping")] = 0.05,
    out: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.spectra_out")] = None,
    plot: Annotated[Path | None, typer.Option(metavar="FILE", help="cli_help.plot_spectra")] = None,
    lang: flags.LanguageOption = "",
) -> None:
    """Run ``stayput motion spectrum``."""
    from stayput.motion.response import PERIODS

    check_output(out, (".csv",))
    check_output(plot, PLOT_SUFFIXES, stream=False)
    record = flags.motion_of(flags.tables_of_motion(motion, said, out, plot))
    instead = to_output({"--out": out})

    def spectra(periods: ArrayLike) -> dict[str, ResponseSpectrum]:
        return {name: record.spectrum(periods, damping, name) for name in record.components}

    if not instead:
        _print_spectra(record, spectra(TABLE_PERIODS), lang)
    if out is not None:
        write_text(out, _spectra_csv(spectra(PERIODS)))
    if plot is not None:
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
    return csv_text(list(columns), zip(*columns.values(), strict=True), "\n")


def _print_spectra(motion: Motion, spectra: dict[str, ResponseSpectrum], lang: str) -> None:
    from stayput.report.names import motion_label

    damping = 100.0 * next(iter(spectra.values())).damping
    console, _ = terminal(lang, say("cli.spectra", lang, motion=motion_label(motion, lang), damping=damping))
    headings = [say("plots.period", lang)]
    for name in spectra:
        headings += [f"Sa {name} [m/s²]", f"ω·Sd {name} [cm/s]"]
    rows = [
        [f"{period:g}", *(f"{v:.3g}" for s in spectra.values() for v in (s.sa[i], 100.0 * s.psv[i]))]
        for i, period in enumerate(TABLE_PERIODS)
    ]
    console.print(plain_table(headings, rows, justify="right"))


@flags.takes(flags.GROUND)
def convert(
    motion: flags.MotionArgument,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="cli_help.converted")],
    *,
    said: flags.FlagValues,
    only: Annotated[str | None, typer.Option(metavar="x|y|z", help="cli_help.only")] = None,
    step: Annotated[float | None, typer.Option(help="cli_help.step")] = None,
    form: Annotated[str | None, typer.Option("--format", metavar="csv|at2", help="cli_help.format")] = None,
    lang: flags.LanguageOption = "",
) -> None:
    """Run ``stayput motion convert``."""
    from stayput.motion.writers import FORMATS

    check_output(out, tuple(FORMATS))
    tables = flags.tables_of_motion(motion, said, out)
    ending = _ending(out, form)
    record = flags.motion_of(tables)
    if step is not None:
        record = record.resampled(step)
    if only is not None:
        record = record.component(only)
    write_text(out, record.text(ending))
    if not is_stream(out):
        parts = ", ".join(record.components)
        written = say("cli.wrote_motion", lang, file=out, count=len(record), dt=record.dt, components=parts)
        note(written, aside=False)


def _ending(out: Path, form: str | None) -> str:
    """Return the ending that says the format: the file's own, or ``--format`` of what is printed."""
    from stayput.motion.writers import FORMATS

    known = [ending.removeprefix(".") for ending in FORMATS]
    if form is not None and form not in known:
        raise unknown("--format", form, known, "--format")
    if is_stream(out):
        return f".{form or known[0]}"
    if form is not None and f".{form}" != out.suffix.lower():
        raise not_allowed("--format", repr(form), phrase("cli.other_format", out=repr(str(out))), "--format")
    return out.suffix.lower()


for run in (info, plot, spectrum, convert, suite):
    app.command(run.__name__, cls=HelpfulCommand, help=f"cli_help.{run.__name__}")(run)


@app.callback()
def _options(lang: flags.LanguageOption = "") -> None:  # pyright: ignore[reportUnusedFunction] - Typer calls it
    """Take the flags that stand before a command."""
