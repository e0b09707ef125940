"""Output that all commands share: warnings and errors in one sentence, exit codes, and JSON."""

from __future__ import annotations

import errno
import io
import json
import locale
import os
import re
import sys
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import typer
from typer.core import TyperGroup

from stayput.catalogue import Language, Phrase, phrase, say
from stayput.cli.interrupts import INTERRUPTED
from stayput.cli.streams import closed_output, is_stream, standard_input
from stayput.errors import InputError, InputWarning, quoted, reason_of, warnings_to
from stayput.progress import is_drawn, is_quiet, keep_quiet, language_of_bars, told_in

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

Told = TypeVar("Told", InputError, InputWarning)

REFUSED = 2
"""Exit code for input that is refused."""

UNREAD = 141
"""Exit code where the reader of the output has gone, as of programs that the signal SIGPIPE ends."""


_USAGE: Any = typer.BadParameter.__base__
"""What Typer raises where it cannot read the command line; that class has no public name."""


def of_locale() -> Language:
    """Return the language that the environment asks for: Japanese where it does, else English."""
    variables = (os.environ.get(name) for name in ("LC_ALL", "LC_MESSAGES", "LANG"))
    asked = next(filter(None, variables), None) or locale.getlocale()[0] or ""
    return "ja" if asked.lower().startswith("ja") else "en"


def of_arguments(args: Sequence[str]) -> Language:
    """Return the language of a command line, in which it is refused too."""
    flags = " ".join(args)
    for language in ("ja", "en"):
        if f"--lang {language}" in flags or f"--lang={language}" in flags:
            return language
    return of_locale()


class CommandGroup(TyperGroup):
    """A group of commands that reports an error of the input or the output in one sentence."""

    _language: Language = "en"

    def main(self, args: Sequence[str] | None = None, *rest: Any, **kwargs: Any) -> Any:
        """Run the command line, and flush standard output."""
        self._language = of_arguments(sys.argv[1:] if args is None else args)
        if sys.stdout is None:  # pyright: ignore[reportUnnecessaryComparison] - where it is closed
            sys.stdout = closed_output()
        if isinstance(sys.stdout, io.TextIOWrapper) and sys.stdout.errors in ("strict", "surrogateescape"):
            # letters that the terminal lacks are written out, as Python does on standard error
            sys.stdout.reconfigure(errors="backslashreplace")
        try:
            try:
                with told_in(self._language):
                    return super().main(args, *rest, **kwargs)
            finally:
                keep_quiet(False)
                sys.stdout.flush()
        except OSError as error:
            sys.exit(_unwritten(error, self._language))
        except SystemExit as end:
            if isinstance(end.__context__, BrokenPipeError):
                # Rich and Typer end so where the reader has gone
                sys.exit(_unwritten(end.__context__, self._language))
            raise

    def make_context(self, *args: Any, **kwargs: Any) -> Any:
        """Read what stands before the name of the command."""
        with self._refusing():
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: Any) -> Any:
        """Run the command; refused input ends it with `REFUSED`, Ctrl-C with `INTERRUPTED`.

        Each warning is printed once, when it arises.
        """
        printed: set[str] = set()

        def of_flags(notice: Told) -> Told:
            """Return a refusal or a warning with flags in the place of the arguments that it names."""
            flags = _flags_of(self.get_command(ctx, ctx.invoked_subcommand or ""))
            named = {
                key: _flag(value, flags)
                for key in _ARGUMENTS
                if isinstance(value := notice.values.get(key), str)
            }
            values = notice.values | {key: flag for key, flag in named.items() if flag is not None}
            return type(notice)(notice.code, notice.field, context=notice.context, **values)

        def warn(warning: InputWarning) -> None:
            sentence = of_flags(warning).told(self._language)
            if sentence not in printed:
                printed.add(sentence)
                note(say("cli.warning", self._language, sentence=sentence))

        with self._refusing(of_flags), warnings_to(warn), standard_input():
            return super().invoke(ctx)

    @contextmanager
    def _refusing(self, called: Callable[[InputError], InputError] = lambda error: error) -> Generator[None]:
        """End the program where its input is refused, its output cannot be written, or on Ctrl-C."""
        try:
            try:
                yield
            except _USAGE as error:
                raise _misused(error) from None
            except OSError as error:
                if error.errno != errno.ENAMETOOLONG:
                    raise typer.Exit(_unwritten(error, self._language)) from None
                raise InputError("cli.long_name", file=quoted(str(error.filename))) from None
        except InputError as error:
            _print_aside(called(error).told(self._language))
            raise typer.Exit(REFUSED) from None
        except KeyboardInterrupt:
            _print_aside(say("cli.interrupted", self._language))
            raise typer.Exit(INTERRUPTED) from None


def _misused(error: Any) -> InputError:
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
        name = _as_on_the_line(error.param)
        return InputError("cli.missing", name, command=command)
    if kind == "BadParameter" and error.param is not None and hasattr(error.__cause__, "errors"):
        (wrong, *_) = error.__cause__.errors()  # of pydantic, by which Typer reads numbers
        name, value = _as_on_the_line(error.param), quoted(str(wrong["input"]))
        allowed = _allowed(wrong["type"], error.param)
        return InputError("common.not_allowed", name, value=value, hint="", allowed=allowed)
    said = re.sub(r"\. Did you mean (.+)\?$", r" (did you mean \1?)", str(error.message))
    return InputError("cli.misused", said=said.rstrip("."), command=command)


def _as_on_the_line(param: Any) -> str:
    """Return a flag as it is typed, or an argument as the help calls it."""
    flag = next((name for name in param.opts if name.startswith("--")), None)
    return flag or str(param.metavar or param.name).strip("[]")


def _allowed(kind: str, param: Any) -> Phrase:
    if param.min is not None and param.max is not None:
        return phrase("scenario.whole_number", low=param.min, high=param.max, unit="")
    return phrase("common.whole_number" if kind.startswith("int") else "common.number")


_ARGUMENTS = ("option", "other_option")
"""Values of sentences that name an argument, which is a flag of the command line."""

_OF_RECORDS = ("unit", "dt", "component", "columns", "skip_lines", "decimal_comma", "location", "remove_mean")
"""What is said of how a record is read, in sentences about it."""


def _flag(option: str, flags: set[str]) -> str | None:
    """Return the flag for an argument of Python; None where there is none."""
    flag = f"--{option}".replace("_", "-")
    if flag in flags:
        return flag
    return f"--set shaking.{option}" if "--set" in flags and option in _OF_RECORDS else None


def _flags_of(command: Any) -> set[str]:
    """Return the flags of a command, or of all in a group; of none where there is no such command."""
    flags = {flag for parameter in getattr(command, "params", ()) for flag in parameter.opts}
    return flags.union(*map(_flags_of, getattr(command, "commands", {}).values()))


def _unwritten(error: OSError, language: Language) -> int:
    """Report a failure of standard output, unless its reader has closed it; return the exit code.

    An error that names a file is none of the output's.
    """
    if error.filename is not None:
        raise error
    if not isinstance(error, BrokenPipeError):
        reason = phrase("cli.closed") if error.errno == errno.EBADF else reason_of(error)
        _print_aside(say("cli.unwritten", language, reason=reason))
    with suppress(OSError):
        # what still waits would fail again when the program ends
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return UNREAD if isinstance(error, BrokenPipeError) else REFUSED


_UNBROKEN = re.compile(
    r"[（「]*(?:[!-~²…]+ ?|\S| )[、。，：）」～％・ーぁぃぅぇぉっゃゅょァィゥェォッャュョ]*"
)
"""What stays on one line of a Japanese text: a word in Latin letters or a character, with its marks."""


def folded(text: str, width: int) -> str:
    """Return a Japanese text, which has no spaces to break at, in lines that fit a width [cells].

    No line begins with a mark that ends a clause or closes a bracket.

    Examples
    --------
    >>> folded("順位は、転倒の少なさ。", 8).splitlines()
    ['順位は、', '転倒の少', 'なさ。']
    """
    from rich.cells import cell_len

    lines = [""]
    for part in _UNBROKEN.findall(text):
        if lines[-1] and cell_len(lines[-1] + part) > width:
            lines.append("")
            part = part.lstrip()
        lines[-1] += part
    return "\n".join(lines)


def terminal(lang: str, title: str | None = None) -> tuple[Console, Callable[[str], None]]:
    """Print a title; return the terminal, and what prints a paragraph on it."""
    from rich.console import Console

    console = Console(highlight=False, markup=False)
    if title is not None:
        console.print(title, style="bold")
    return console, lambda text: console.print(folded(text, console.width) if lang == "ja" else text)


def plain_table(
    headings: Sequence[str], rows: Iterable[Sequence[str]], *, gap: int = 2, **numbers: Any
) -> Table:
    """Return a table without lines, whose cells fold.

    Besides labels it takes what Rich's ``add_column`` takes for the other columns.
    """
    from rich.table import Table

    table = Table(box=None, padding=(0, gap, 0, 0), show_header=any(headings))
    for place, heading in enumerate(headings):
        table.add_column(heading, overflow="fold", **(numbers if place else {}))
    for row in rows:
        table.add_row(*row)
    return table


def note(text: str, *, aside: bool = True) -> None:
    """Print a line beside the results, unless quiet is wanted.

    Parameters
    ----------
    text : str
        The line.
    aside : bool
        Whether it goes to standard error, and not to standard output with the results.
    """
    if is_quiet():
        return
    if aside:
        _print_aside(text)
    else:
        typer.echo(text)


def _print_aside(text: str) -> None:
    """Print a line on standard error; where that cannot be written, results and the exit code must do."""
    with suppress(OSError):
        typer.echo(text, err=True)


def tell_written(lang: str, *files: Path | None, aside: bool = False) -> None:
    """Say which files were written, unless quiet is wanted.

    Parameters
    ----------
    lang : str
        "en" or "ja".
    files : Path or None
        The files; standard output, and None where one was not asked for, are passed over.
    aside : bool
        Whether standard output is for something else.
    """
    for file in files:
        if file is not None and not is_stream(file):
            note(say("cli.wrote", lang, file=file), aside=aside)


def print_json(values: object) -> None:
    """Print values as one JSON object."""
    typer.echo(json.dumps(values, allow_nan=False))


@contextmanager
def compiling() -> Generator[None]:
    """Announce on standard error that the mechanics are being compiled, where no bar shows it."""
    from stayput.compiling import on_compilation

    language = language_of_bars()  # which the threads that compile do not know

    def announce() -> None:
        if not is_drawn():
            note(say("cli.compiling", language))

    with on_compilation(announce):
        yield
