"""Options that several commands share: which motion, and how a record's file is to be read."""

from __future__ import annotations

from typing import Annotated, TypeAlias

import typer

MotionText: TypeAlias = Annotated[
    str, typer.Argument(metavar="MOTION", help="A record's file; or near-fault, or sine:A,F[,T].")
]
Component: TypeAlias = Annotated[
    str | None, typer.Option("--component", help="The record's channel along the shaking.")
]
Unit: TypeAlias = Annotated[
    str | None, typer.Option("--unit", help="The record's unit, where its file does not state it.")
]
TimeStep: TypeAlias = Annotated[
    float | None, typer.Option("--dt", help="The record's time step [s], where its file does not state it.")
]
Threads: TypeAlias = Annotated[
    int | None, typer.Option("--threads", min=1, help="Threads; as many as there are cores by default.")
]
