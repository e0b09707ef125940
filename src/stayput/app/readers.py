"""Uploads are read in a process of their own, one at a time: it is ended when it takes too long.

It is a plain child process with pipes, which all systems have; Ctrl-C does not reach it, and it ends with the
server.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from typing import TYPE_CHECKING

from stayput.app import reader
from stayput.app.turns import Workers
from stayput.errors import InputError

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.app.limits import Limits
    from stayput.errors import InputWarning
    from stayput.motion import Motion

START = "import sys; sys.path[:] = sys.argv[1:]; from stayput.app.reader import main; main()"
"""What the process runs; it finds the package where this one does."""

OF_WINDOWS = ("CREATE_NEW_PROCESS_GROUP", "CREATE_NO_WINDOW")
"""How Windows starts it."""


class Readers:
    """Processes that run `stayput.app.reader`, one after the other.

    Parameters
    ----------
    limits : Limits
        How many uploads may wait, and what one may take.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._workers = Workers(1, limits.reading_waiting)
        self._process: subprocess.Popen[bytes] | None = None

    async def read(
        self,
        path: Path,
        component: str | None = None,
        unit: str | None = None,
        dt: float | None = None,
        *,
        remove_mean: bool = False,
    ) -> tuple[Motion, tuple[InputWarning, ...]]:
        """Read a record; see `read_shaking`. Return it with the warnings about it.

        Raises
        ------
        InputError
            It is no record, or takes too much.
        RefusedError
            Too many are waiting.
        """
        task = reader.ReadingTask(str(path), component, unit, dt, remove_mean, self._limits)
        result = await self._workers.run(self._read, task)
        if result.motion is None:
            raise result.refusal or InputError("app.reading_died")
        return result.motion, result.warnings

    def close(self) -> None:
        """End the process."""
        self._workers.close()
        if self._process is not None:
            self._process.kill()

    def _read(self, task: reader.ReadingTask) -> reader.ReadingResult:
        with subprocess.Popen(
            [sys.executable, "-c", START, *map(str, sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            # a group of its own: the terminal's Ctrl-C is for the server, which ends it
            creationflags=sum(getattr(subprocess, name, 0) for name in OF_WINDOWS),
            start_new_session=os.name == "posix",
        ) as process:
            self._process = process
            try:
                told, _ = process.communicate(pickle.dumps(task), task.limits.reading_seconds)
            except subprocess.TimeoutExpired:
                process.kill()
                error = InputError("app.reading_slow", seconds=task.limits.reading_seconds)
                return reader.ReadingResult(None, error)
        try:
            return pickle.loads(told)
        except (EOFError, pickle.UnpicklingError):  # it ended without its whole answer
            return reader.ReadingResult(None, None)
