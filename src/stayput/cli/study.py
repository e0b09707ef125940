"""``stayput study``: the paper's studies and their kin."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import say
from stayput.cli.completion import words
from stayput.cli.flags import ComponentOption, QuietOption, TimeStepOption, UnitOption, motion_of
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import note, tell_written
from stayput.cli.shaking import XOption, YOption, ZOption, along

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.studies import Study

STUDIES = {
    "friction": "peak slide over static and kinetic friction (§4.2 of the paper)",
    "critical-ratio": "critical amplitude of a sine over b/h and frequency (§4.3, Eq. 4.1)",
    "wall-gap": "overturning over width and distance to a wall, under a sine (§4.4)",
    "wall-gap-record": "the same under a record (§4.5, Table 4.3)",
    "spectrum": "overturning and rocking spectra of pulses and of a record",
    "tokyo": "devices alone and together, as in Tokyo's product test of 2015",
    "baseline": "what the ideal block leaves out and is worth, and where bare furniture lies in the field",
    "tip-over": "what tips common pieces over without an earthquake",
    "tombstones": "gravestones that fall against intensity, beside surveys",
    "consumer-centre": "the Japanese consumer centre's shake table of 2018, as far as published",
    "ac156": "does a piece that passes AC156 survive the floors of buildings?",
    "contents": "what comes out of shelves and cupboards, beside tests and reports",
    "capacity": "median overturning capacity beside Kaneko and Hayashi's formula",
    "three-dimensions": "how often, and for which shapes, the plane's verdict differs from that of space",
}
"""Names of the studies, and what they are about."""

OF_A_RECORD = ("wall-gap-record", "spectrum", "tokyo", "contents")
"""Studies that take a motion."""


def study(
    name: Annotated[
        str,
        typer.Argument(
            help="; ".join(f"{k}: {v}" for k, v in STUDIES.items()) + ".",
            autocompletion=words(lambda: STUDIES),
        ),
    ],
    out: Annotated[Path, typer.Option(metavar="DIR", help="Folder for data, figures and text; it is made.")],
    motion: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help=f"A record's file, or -, for {', '.join(OF_A_RECORD)}. Default: near-fault.",
        ),
    ] = None,
    x: XOption = None,
    y: YOption = None,
    z: ZOption = None,
    component: ComponentOption = None,
    unit: UnitOption = None,
    dt: TimeStepOption = None,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run a study and write its data (NetCDF, CSV), figures, key numbers and tables."""
    from stayput.errors import InputError, unknown

    if name not in STUDIES:
        raise unknown("studies.name", name, STUDIES, "name")
    motion = along(motion, x)
    if motion is not None and name not in OF_A_RECORD:
        raise InputError("studies.no_motion", "motion", name=name, names=", ".join(OF_A_RECORD))
    if out.exists() and not out.is_dir():
        raise InputError("cli.folder_is_file", "out", folder=repr(str(out)))

    import stayput.studies as studies

    run: Callable[..., Study] = getattr(studies, name.replace("-", "_"))
    motions = ()
    if any(value is not None for value in (motion, y, z, component, unit, dt)):
        ground = motion or "near-fault"
        motions = (motion_of(ground, "--motion", y=y, z=z, component=component, unit=unit, dt=dt),)
    result = run(*motions)
    typer.echo(result.markdown())
    if lang == "ja":
        note(say("cli.study_in_english", lang))
    tell_written(lang, *result.write(out))
