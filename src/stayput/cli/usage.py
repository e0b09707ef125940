"""Refusals of a command line that names no command, or gives a flag what it cannot take."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import typer

from stayput.catalogue import phrase
from stayput.errors import InputError, quoted

if TYPE_CHECKING:
    from stayput.catalogue import Phrase

USAGE: Any = typer.BadParameter.__base__
"""What Typer raises where it cannot read the command line; that class has no public name."""


def misused(error: Any) -> InputError:
    """Return the refusal, in one sentence, of a command line that Typer does not take.

    Parameters
    ----------
    error : UsageError
        What Typer raised. Help that is shown where nothing was asked for is none, and raised again.
    """
    kind = type(error).__name__
    if kind == "NoArgsIsHelpError":
        raise error
    command = getattr(error.ctx, "command_path", "stayput")
    if kind == "NoSuchOption":
        flag = str(error.option_name)
        return InputError("cli.no_such_flag", flag, flag=repr(flag), command=command)
    if kind == "MissingParameter":
        name = as_on_the_line(error.param)
        return InputError("cli.missing", name, name=name, command=command)
    if kind == "BadParameter" and error.param is not None and hasattr(error.__cause__, "errors"):
        (wrong, *_) = error.__cause__.errors()  # of pydantic, by which Typer reads numbers
        name, value = as_on_the_line(error.param), quoted(str(wrong["input"]))
        allowed = _allowed(wrong["type"], error.param)
        return InputError("cli.wrong_value", name, name=name, value=value, allowed=allowed)
    said = re.sub(r"\. Did you mean (.+)\?$", r" (did you mean \1?)", str(error.message))
    return InputError("cli.misused", said=said.rstrip("."), command=command)


def as_on_the_line(param: Any) -> str:
    """Return a flag as it is typed, or an argument as the help calls it."""
    flag = next((name for name in param.opts if name.startswith("--")), None)
    return flag or str(param.metavar or param.name).strip("[]")


def _allowed(kind: str, param: Any) -> Phrase:
    if param.min is not None and param.max is not None:
        return phrase("cli.whole_number_within", low=param.min, high=param.max)
    return phrase("cli.whole_number" if kind.startswith("int") else "cli.number")
