"""The process that reads uploaded records: started ahead of need, ended and replaced when it takes too long.

It is a plain child process with pipes, which all systems have; Ctrl-C does not reach it, and it ends with the
server, however that ends.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import threading
from typing import TYPE_CHECKING, BinaryIO, cast

from stayput.app import reader
from stayput.app.refusals import refused
from stayput.app.turns import Workers
from stayput.errors import InputError

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.app.limits import Limits
    from stayput.errors import InputWarning
    from stayput.motion import Motion

START = "import sys; sys.path[:] = sys.argv[2:]; from stayput.app.reader import main; main(int(sys.argv[1]))"
"""What the process runs; it finds the package where this one does."""

STARTING = 60.0
"""How long it may take to be ready, on a slow machine [s]."""


class Reader:
    """A process that runs `stayput.app.reader`, one record after the other.

    Parameters
    ----------
    limits : Limits
        How many may wait, and what it may take for one.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._workers = Workers(1, limits.reading_waiting)
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._ready = self._closed = False

    def start(self) -> subprocess.Popen[bytes]:
        """Have the process started, and return it."""
        with self._lock:
            if self._closed:
                raise refused(503, "app.ends")
            if self._process is None:
                # a group of its own: the terminal's Ctrl-C is for the server, which ends it
                windows = ("CREATE_NEW_PROCESS_GROUP", "CREATE_NO_WINDOW")
                self._process = subprocess.Popen(
                    [sys.executable, "-c", START, str(self._limits.reading_memory), *map(str, sys.path)],
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.DEVNULL,
                    env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONIOENCODING": "utf-8"},
                    creationflags=sum(getattr(subprocess, name, 0) for name in windows),
                    start_new_session=os.name == "posix",
                )
                self._ready = False
            return self._process

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
        with self._lock:
            self._closed = True
        self._end()
        self._workers.close()

    def _read(self, task: reader.ReadingTask) -> reader.ReadingResult:
        seconds = task.limits.reading_seconds
        for _ in range(2):  # it may have died while it waited, which is not the file's fault
            process = self.start()
            try:
                if not self._ready:
                    self._answer(process, STARTING)
                    self._ready = True
                reader.send(cast("BinaryIO", process.stdin), task)
                return cast("reader.ReadingResult", self._answer(process, seconds))
            except TimeoutError:
                self._end()
                return reader.ReadingResult(None, InputError("app.reading_slow", seconds=seconds))
            except (
                EOFError,
                OSError,
                ValueError,
                pickle.UnpicklingError,
            ):  # it ended, half an answer or none
                self._end()
        return reader.ReadingResult(None, InputError("app.reading_died"))

    @staticmethod
    def _answer(process: subprocess.Popen[bytes], seconds: float) -> object:
        late = threading.Event()

        def end() -> None:
            late.set()
            process.kill()

        timer = threading.Timer(seconds, end)
        timer.daemon = True
        timer.start()
        try:
            return pickle.load(cast("BinaryIO", process.stdout))
        finally:
            timer.cancel()
            if late.is_set():
                raise TimeoutError

    def _end(self) -> None:
        with self._lock:
            process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.wait()
