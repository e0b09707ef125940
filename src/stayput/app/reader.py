"""The program of a reading process: it reads uploaded records, so that a crash does not end the server.

Messages go as pickles over its standard input and output. It ends when its input does, which is so when the
server ends in any way, and when a record takes too long.
"""

from __future__ import annotations

import contextlib
import faulthandler
import os
import pickle
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, BinaryIO, TypeVar

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, warnings_to
from stayput.motion.readers import read_shaking
from stayput.motion.readers.chosen import OPTIONS

if TYPE_CHECKING:
    from stayput.motion import Motion

T = TypeVar("T", InputError, InputWarning)

_CONTROLS = {"dt": "page.file_dt", "remove_mean": "page.file_remove_mean"}
"""The labels of the page's controls for options of reading that have one."""

_SEPARATORS = np.zeros(256, np.bool_)
_SEPARATORS[list(b" \t\n\r\v\f,;")] = True


@dataclass(frozen=True, slots=True)
class ReadingTask:
    """A record to read.

    Parameters
    ----------
    path : str
        The file.
    component, unit, dt, remove_mean
        As `read_shaking` takes them.
    numbers, samples : int
        Most numbers in the file, most samples of the motion.
    duration, seconds : float
        Longest motion, longest time to read it [s].
    """

    path: str
    component: str | None
    unit: str | None
    dt: float | None
    remove_mean: bool
    numbers: int
    samples: int
    duration: float
    seconds: float


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
        return ReadingResult(None, InputError("app.reading_memory"))
    return ReadingResult(motion, None, tuple(map(_on_page, warnings)))


def _on_page(told: T) -> T:
    """Return what is told of a record, with an option called by its control on the page or by its flag."""
    option = told.values.get("option")
    if option not in OPTIONS:
        return told
    if option in _CONTROLS:
        way, field = phrase(_CONTROLS[option]), told.field
    else:
        way, field = phrase("app.flag", flag=f"--{option.replace('_', '-')}"), None
    return type(told)(told.code, field, context=told.context, **told.values | {"option": way})


def _read(task: ReadingTask) -> Motion:
    with open(task.path, "rb") as file:  # noqa: PTH123 - a plain path is all that came
        _check_numbers(file.read(), task.numbers)
    motion = read_shaking(task.path, task.component, task.unit, dt=task.dt, remove_mean=task.remove_mean)
    if motion.duration > task.duration:
        raise InputError("app.long_motion", value=motion.duration, most=task.duration)
    if len(motion) > task.samples:
        raise InputError("app.many_samples", value=len(motion), most=task.samples)
    return motion


def _check_numbers(data: bytes, most: int) -> None:
    """Refuse more numbers than any record needs before a list is made of them."""
    between = _SEPARATORS[np.frombuffer(data, np.uint8)]
    count = int(np.count_nonzero(between[1:] & ~between[:-1])) + 1
    if count > most:
        raise InputError("app.many_numbers", value=count, most=most)


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


def main(memory: int) -> None:
    """Read records until the input ends.

    Parameters
    ----------
    memory : int
        How much memory it may take for them [bytes].
    """
    requests, replies = sys.stdin.buffer, os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())  # nothing that prints gets between the answers
    faulthandler.disable()
    limit_memory(memory)
    send(replies, None)
    while (task := receive(requests)) is not None:
        # The server ends a process that is too slow; where it is gone, the process ends itself.
        faulthandler.dump_traceback_later(2.0 * task.seconds + 5.0, exit=True, file=nowhere)
        result = read(task)
        faulthandler.cancel_dump_traceback_later()
        send(replies, result)


def send(stream: BinaryIO, value: object) -> None:
    """Write a message."""
    pickle.dump(value, stream, pickle.HIGHEST_PROTOCOL)
    stream.flush()


def receive(stream: BinaryIO) -> ReadingTask | None:
    """Read a task, or None at the end."""
    try:
        return pickle.load(stream)
    except EOFError:
        return None
