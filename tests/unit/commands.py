"""The command line, run in this process."""

from __future__ import annotations

from typing import Any

from typer.testing import CliRunner

from stayput.cli import app


def cli(*words: object, given: str | None = None, **environment: str) -> Any:
    """What a command ends with: its exit code, and what it printed."""
    return CliRunner(env=environment).invoke(app, [str(word) for word in words], input=given)
