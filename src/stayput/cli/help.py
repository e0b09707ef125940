"""``--help`` in the language of the command line: what Typer writes in English, in Japanese too."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, cast

from typer.core import TyperCommand, TyperGroup

from stayput.catalogue import TEXTS, Language, say
from stayput.cli.messages import CommandGroup, folded

_BETWEEN = 2
"""Cells between a name and its text."""

_Base: Any = object  # whose methods a command and a group of Typer have


class _Translated(_Base):
    """A command or a group whose texts are ids of the catalogue until `translate` is called."""

    language: Language = "en"

    def get_help_option(self, ctx: Any) -> Any:
        """Return ``--help``, which Typer adds, with its text in the language."""
        option = cast("Any", super().get_help_option(ctx))
        if option is not None:
            option.help = say("cli_help.help", self.language)
        return option

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """Write the help: Typer's layout in English, `japanese_help` in Japanese."""
        if self.language == "ja":
            formatter.write(japanese_help(self, ctx, formatter.width))
        else:
            super().format_help(ctx, formatter)


class HelpfulCommand(_Translated, TyperCommand):
    """A command with its help in both languages."""


class HelpfulGroup(_Translated, TyperGroup):
    """A group of commands with its help in both languages."""


class RootGroup(_Translated, CommandGroup):
    """``stayput`` itself: all texts are in the language of the arguments or of the locale."""

    def make_context(self, *args: Any, **kwargs: Any) -> Any:
        """Choose the language, which a shell that completes a command needs as well."""
        if self.help in TEXTS:
            translate(self, self._language)
        return cast("Any", super().make_context(*args, **kwargs))


def translate(command: Any, language: Language) -> None:
    """Put the sentences in the place of their ids, in a command and in all that it groups.

    Typer makes new commands whenever the program is called, so that each call speaks its own language.

    Parameters
    ----------
    command : Command
        The command, as Typer made it.
    language : Language
        "en" or "ja".
    """
    command.language = language
    command.help = say(command.help, language)
    if language == "ja":  # which Typer cannot shorten by words
        command.short_help = command.help.partition("\n")[0]
    for param in command.params:
        ours = param.help in TEXTS  # others are Typer's flags of completion
        param.help = say(param.help if ours else f"cli_help.{param.name}", language)
        if isinstance(param.show_default, str):
            param.show_default = say(param.show_default, language)
    for each in getattr(command, "commands", {}).values():
        translate(each, language)


def japanese_help(command: Any, ctx: Any, width: int) -> str:
    """Return the help of a command in Japanese.

    Parameters
    ----------
    command : Command
        The command, after `translate`.
    ctx : Context
        Its context.
    width : int
        Cells of a line.
    """
    rows: dict[str, list[tuple[str, str, str]]] = {"arguments": [], "options": [], "commands": []}
    for param in command.get_params(ctx):
        if (record := param.get_help_record(ctx)) is not None:
            rows[f"{param.param_type_name}s"].append((record[0], param.help, _facts(param)))
    rows["commands"] = [
        (name, sub.short_help, "") for name, sub in getattr(command, "commands", {}).items() if not sub.hidden
    ]
    usage = f"{say('cli_help.usage', 'ja')}：{ctx.command_path} {' '.join(command.collect_usage_pieces(ctx))}"
    about = (_indented(folded(part, width - 2).splitlines()) for part in command.help.split("\n\n"))
    lists = (
        f"{say(f'cli_help.{heading}', 'ja')}：\n{_listed(each, width - 2)}"
        for heading, each in rows.items()
        if each
    )
    return "\n\n".join((folded(usage, width), *about, *lists)) + "\n"


def _facts(param: Any) -> str:
    """Return in brackets the default of a parameter, its limits, and whether it must be given."""
    shown = param.default if param.show_default is True else param.show_default
    if isinstance(shown, bool):  # a flag: the one of two that holds
        shown = max(param.opts, key=len) if shown else None
    limits = getattr(param, "type", param)  # older releases of Typer have a type of numbers in a range
    low, high = (getattr(limits, end, None) for end in ("min", "max"))
    facts = [
        None if shown in (None, "") else say("cli_help.default", "ja", value=shown),
        None if low is None else say("cli_help.range", "ja", low=low, high=high),
        say("cli_help.required", "ja") if param.required else None,
    ]
    brackets = say("common.listed", "ja").join(fact for fact in facts if fact is not None)
    return f"[{brackets}]" if brackets else ""


def _listed(rows: Sequence[tuple[str, str, str]], width: int) -> str:
    """Return names with their texts beside them, or below a name that is wider than most."""
    from rich.cells import cell_len

    widest = max((cell_len(name) for name, _, _ in rows if cell_len(name) <= width // 3), default=0)
    column = widest + _BETWEEN
    lines: list[str] = []
    for name, text, facts in rows:
        block = [line for part in text.split("\n") for line in folded(part, width - column).splitlines()]
        if facts and "\n" not in text and cell_len(block[-1] + facts) + _BETWEEN <= width - column:
            block[-1] += " " * _BETWEEN + facts
        elif facts:
            block.append(facts)
        beside = cell_len(name) <= widest
        first = block.pop(0) if beside else ""
        lines.append(name + " " * (column - cell_len(name)) + first)
        lines += [" " * column + line for line in block]
    return _indented(lines)


def _indented(lines: Iterable[str]) -> str:
    return "\n".join(f"  {line}".rstrip() for line in lines)
