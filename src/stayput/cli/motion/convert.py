"""``stayput motion convert``: another format, component, time step or strength."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import Annotated

import typer

from stayput.cli.options import Component, MotionText, TimeStep, Unit  # noqa: TC001 - Typer reads them


def convert(
    motion: MotionText,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="File to write: .csv or .at2 (PEER).")],
    component: Component = None,
    unit: Unit = None,
    dt: TimeStep = None,
    only: Annotated[
        str | None, typer.Option(metavar="x|y|z", help="Keep this component alone, as x; for .at2.")
    ] = None,
    step: Annotated[
        float | None, typer.Option(help="New time step [s], a whole part or multiple of the record's.")
    ] = None,
    scale: Annotated[float | None, typer.Option(help="Factor on the motion.")] = None,
    intensity: Annotated[
        str | None, typer.Option(help="JMA intensity to scale to: a number, or a class such as 6-upper.")
    ] = None,
) -> None:
    """Write a motion in another format, or changed."""
    from stayput.cli.flags import intensity_value, motion_of, one_of_two
    from stayput.files import check_target
    from stayput.motion.writers import FORMATS

    check_target(out, tuple(FORMATS))
    if scale is not None and intensity is not None:
        raise one_of_two("--scale", f"{scale:g}", "--intensity", repr(intensity))
    read = motion_of(motion, component=component, unit=unit, dt=dt)
    if intensity is not None:
        read = read.to_intensity(intensity_value(intensity))
    if scale is not None:
        read = read.scaled(scale)
    if step is not None:
        read = read.resampled(step)
    if only is not None:
        read = read.component(only)
    read.write(out)
    typer.echo(f"Wrote {out}: {len(read)} samples every {read.dt:g} s, {', '.join(read.components)}")
