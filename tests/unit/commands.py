"""The command line, run in this process, and scenarios for it."""

from __future__ import annotations

from typing import Any

from typer.testing import CliRunner

from stayput.cli import app

SLENDER = """
[furniture]
width = 0.3
height = 1.5
mass = 60.0
[room]
left_wall = { gap = 0.02 }
[shaking]
builtin = "near-fault"
[uncertainty]
samples = 4
[[measures]]
type = "belt"
"""
BOOKCASE = """
[furniture]
preset = "bookcase"
[room]
left_wall = { gap = 0.02 }
[shaking]
intensity = "6-lower"
suite = { family = "near-fault", count = 2 }
[uncertainty]
samples = 4
"""
BEDROOM = """
[plan]
width = 3.6
length = 2.7
[[furniture]]
name = "bookcase"
preset = "bookcase"
against = "left_wall"
along = 1.35
[[places]]
kind = "bed"
at = [1.6, 1.35]
[shaking]
builtin = "near-fault"
[uncertainty]
samples = 2
"""


def cli(*words: object, given: str | None = None, **environment: str) -> Any:
    """What a command ends with: its exit code, and what it printed."""
    return CliRunner(env=environment).invoke(app, [str(word) for word in words], input=given)
