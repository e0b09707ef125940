"""``stayput study``: the paper's studies and their kin."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import TYPE_CHECKING, Annotated

import typer

from stayput.catalogue import say
from stayput.catalogue.studies import STUDIES
from stayput.cli.completion import words
from stayput.cli.flags import FlagValues, QuietOption, motion_of, reads_records
from stayput.cli.language import OF_LOCALE, LanguageOption
from stayput.cli.messages import note, tell_written
from stayput.cli.shaking import XOption, YOption, ZOption, along

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.studies import Study

OF_A_RECORD = ("wall-gap-record", "spectrum", "tokyo", "contents")
"""Studies that take a motion."""


@reads_records
def study(
    name: Annotated[
        str,
        typer.Argument(
            help="cli_help.study_name",
            autocompletion=words(lambda: STUDIES),
        ),
    ],
    out: Annotated[Path, typer.Option(metavar="DIR", help="cli_help.study_out")],
    motion: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="cli_help.study_motion",
        ),
    ] = None,
    x: XOption = None,
    y: YOption = None,
    z: ZOption = None,
    *,
    reading: FlagValues,
    lang: LanguageOption = OF_LOCALE,
    quiet: QuietOption = False,
) -> None:
    """Run ``stayput study``."""
    from stayput.errors import InputError, unknown

    if name not in STUDIES:
        raise unknown("studies.name", name, STUDIES, "name")
    motion, named = along(motion, x)
    if motion is not None and name not in OF_A_RECORD:
        raise InputError("studies.no_motion", "motion", name=name, names=", ".join(OF_A_RECORD))
    if out.exists() and not out.is_dir():
        raise InputError("cli.folder_is_file", "out", folder=repr(str(out)))

    import stayput.studies as studies

    run: Callable[..., Study] = getattr(studies, name.replace("-", "_"))
    motions = ()
    if reading or any(value is not None for value in (motion, y, z)):
        ground = motion or "near-fault"
        motions = (motion_of(ground, named, y=y, z=z, reading=reading),)
    result = run(*motions)
    typer.echo(result.markdown())
    if lang == "ja":
        note(say("cli.study_in_english", lang))
    tell_written(lang, *result.write(out))
