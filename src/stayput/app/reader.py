"""The program of a reading process: it reads an uploaded record, so that a crash does not end the server.

Messages go as pickles over its standard input and output.
"""

from __future__ import annotations

import contextlib
import faulthandler
import os
import pickle
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, warnings_to
from stayput.motion.readers import read_shaking
from stayput.motion.readers.columns import OPTIONS

if TYPE_CHECKING:
    from stayput.app.limits import Limits
    from stayput.motion.record import Motion

T = TypeVar("T", InputError, InputWarning)

_CONTROLS = {"unit": "page.file_unit", "dt": "page.file_dt", "remove_mean": "page.file_remove_mean"}
"""The labels of the page's controls for options of reading that have one."""


@dataclass(frozen=True, slots=True)
class ReadingTask:
    """A record to read.

    Parameters
    ----------
    path : str
        The file.
    options : dict
        Further arguments of `read_shaking`.
    limits : Limits
        What is accepted.
    """

    path: str
    options: dict[str, Any]
    limits: Limits


@dataclass(frozen=True, slots=True)
class ReadingResult:
    """The motion that was read, or its refusal; and warnings about it."""

    motion: Motion | None
    refusal: InputError | None
    warnings: tuple[InputWarning, ...] = ()


def read(task: ReadingTask) -> ReadingResult:
    """Read a record within the limits."""
    warnings: list[InputWarning] = []
    try:
        with warnings_to(warnings.append):
            motion = _read(task)
    except InputError as error:
        return ReadingResult(None, _on_page(error))
    except (MemoryError, RecursionError):
        return ReadingResult(None, InputError("app.reading_died"))
    return ReadingResult(motion, None, tuple(map(_on_page, warnings)))


def _on_page(note: T) -> T:
    """Return what is told of a record, with options called by the page's controls or by their flags."""
    ways, field = dict[str, object](), note.field
    for key in ("option", "other_option"):
        option = note.values.get(key)
        if option in _CONTROLS:
            ways[key] = phrase("app.control", label=phrase(_CONTROLS[option]))
        elif option in OPTIONS:
            flag = "--columns" if option == "columns" else f"--set shaking.{option}"
            ways[key], field = phrase("app.flag", flag=flag), None
    return type(note)(note.code, field, context=note.context, **note.values | ways) if ways else note


def _read(task: ReadingTask) -> Motion:
    limits = task.limits
    motion = read_shaking(task.path, **task.options)
    if motion.duration > limits.duration:
        raise InputError(
            "app.many", name=phrase("app.duration"), value=round(motion.duration), most=limits.duration
        )
    if len(motion) > limits.samples_of_motion:
        most = limits.samples_of_motion
        raise InputError("app.many", name=phrase("app.samples"), value=len(motion), most=most)
    return motion


def limit_memory(more: int) -> None:
    """Limit this process to its present memory and so much more [bytes], where the system can."""
    try:
        import resource
    except ModuleNotFoundError:  # Windows
        return
    taken = 0
    with contextlib.suppress(OSError), open("/proc/self/statm", "rb") as file:  # noqa: PTH123
        taken = int(file.read().split()[0]) * resource.getpagesize()
    with contextlib.suppress(OSError, ValueError):  # macOS knows the limit and refuses it
        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        wanted = taken + more
        resource.setrlimit(resource.RLIMIT_AS, (wanted if hard < 0 else min(wanted, hard), hard))


def main() -> None:
    """Read the record that the standard input asks for, and answer on the standard output."""
    replies = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # nothing that prints gets into the answer
    task: ReadingTask = pickle.load(sys.stdin.buffer)
    # the server ends a process that is too slow; where it is gone, the process ends itself
    faulthandler.dump_traceback_later(2.0 * task.limits.reading_seconds, exit=True)
    limit_memory(task.limits.reading_memory)
    with replies:
        pickle.dump(read(task), replies, pickle.HIGHEST_PROTOCOL)
