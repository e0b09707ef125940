"""``stayput motion plot``: acceleration, velocity, displacement."""

from __future__ import annotations

from pathlib import Path  # noqa: TC003 - Typer reads the annotations
from typing import Annotated

import typer

from stayput.cli.options import Component, MotionText, TimeStep, Unit  # noqa: TC001 - Typer reads them


def plot(
    motion: MotionText,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="Picture to write: .png, .svg or .pdf.")],
    component: Component = None,
    unit: Unit = None,
    dt: TimeStep = None,
) -> None:
    """Plot acceleration, velocity and displacement of every component."""
    from stayput.cli.flags import motion_of
    from stayput.files import PLOT_SUFFIXES, check_target

    check_target(out, PLOT_SUFFIXES)
    read = motion_of(motion, component=component, unit=unit, dt=dt)
    from stayput.report.plot import plot_motion

    plot_motion(read, out)
    typer.echo(f"Wrote {out}")
