"""A pool of processes that read uploaded records: started ahead of need, ended when one takes too long.

They are plain child processes with pipes, which all systems have; Ctrl-C does not reach them, and they end
with the server, however that ends.
"""

from __future__ import annotations

import asyncio
import os
import pickle
import queue
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import TYPE_CHECKING, BinaryIO, cast

from stayput.app import reader
from stayput.app.refusals import refused
from stayput.errors import InputError

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.app.limits import Limits
    from stayput.errors import InputWarning
    from stayput.motion import Motion

START = "import sys; sys.path[:] = sys.argv[2:]; from stayput.app.reader import main; main(int(sys.argv[1]))"
"""What a process runs; it finds the package where this one does."""

STARTING = 60.0
"""How long a process may take to be ready, on a slow machine [s]."""


class ReaderProcess:
    """A process that runs `stayput.app.reader`.

    Parameters
    ----------
    memory : int
        How much memory it may take for a record [bytes].
    """

    def __init__(self, memory: int) -> None:
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONIOENCODING": "utf-8"}
        # a group of its own: the terminal's Ctrl-C is for the server, which ends it
        windows = ("CREATE_NEW_PROCESS_GROUP", "CREATE_NO_WINDOW")
        self._process = subprocess.Popen(
            [sys.executable, "-c", START, str(memory), *map(str, sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=environment,
            creationflags=sum(getattr(subprocess, name, 0) for name in windows),
            start_new_session=os.name == "posix",
        )
        self._ready = False

    def read(self, task: reader.ReadingTask) -> reader.ReadingResult:
        """Have a record read.

        Raises
        ------
        TimeoutError
            It took too long; the process is ended.
        EOFError
            The process came to its end.
        """
        if not self._ready:
            self._answer(STARTING)
            self._ready = True
        try:
            reader.send(cast("BinaryIO", self._process.stdin), task)
        except OSError:
            raise EOFError from None
        return cast("reader.ReadingResult", self._answer(task.seconds))

    def _answer(self, seconds: float) -> object:
        answers = cast("BinaryIO", self._process.stdout)
        late = threading.Event()

        def end() -> None:
            late.set()
            self._process.kill()

        timer = threading.Timer(seconds, end)
        timer.daemon = True
        timer.start()
        try:
            return pickle.load(answers)
        except (EOFError, OSError, ValueError, pickle.UnpicklingError):  # half an answer, or a closed pipe
            if late.is_set():
                raise TimeoutError from None
            raise EOFError from None
        finally:
            timer.cancel()

    @property
    def alive(self) -> bool:
        """Whether the process is running."""
        return self._process.poll() is None

    def end(self) -> None:
        """End it now."""
        self._process.kill()
        self._process.wait()


class ReaderPool:
    """All processes that read: an idle one, and more while it is busy.

    Parameters
    ----------
    limits : Limits
        How many, and what they may take.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._pool = ThreadPoolExecutor(limits.readers, "stayput-reader")
        self._idle: queue.SimpleQueue[ReaderProcess] = queue.SimpleQueue()
        self._all: set[ReaderProcess] = set()
        self._lock = threading.Lock()
        self._closed = False
        self._busy = 0

    def start(self) -> None:
        """Have a process made ready."""
        with suppress(OSError):  # the system allows none now; an upload tries again
            self._idle.put(self._new())

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
        limits = self._limits
        if self._busy >= limits.readers + limits.reading_waiting:
            raise refused(503, "app.many_files", retry_after=2)
        most = limits.numbers, limits.samples_of_motion, limits.duration, limits.reading_seconds
        task = reader.ReadingTask(str(path), component, unit, dt, remove_mean, *most)
        self._busy += 1
        try:
            result = await asyncio.get_running_loop().run_in_executor(self._pool, self._read, task)
        finally:
            self._busy -= 1
        if result.motion is None:
            raise result.refusal or InputError("app.reading_died")
        return result.motion, result.warnings

    def close(self) -> None:
        """End all processes."""
        with self._lock:
            self._closed = True
            ending, self._all = self._all, set()
        for process in ending:
            process.end()
        self._pool.shutdown(wait=False, cancel_futures=True)

    def _read(self, task: reader.ReadingTask) -> reader.ReadingResult:
        process = self._taken()
        try:
            try:
                result = process.read(task)
            except EOFError:  # it may have died while it waited, which is not the file's fault
                self._forget(process)
                process = self._new()
                result = process.read(task)
        except TimeoutError:
            result = reader.ReadingResult(None, InputError("app.reading_slow", seconds=task.seconds))
        except EOFError:
            result = reader.ReadingResult(None, InputError("app.reading_died"))
        else:
            self._idle.put(process)
            return result
        self._forget(process)
        if self._idle.empty() and not self._closed:
            self.start()
        return result

    def _taken(self) -> ReaderProcess:
        while True:
            try:
                process = self._idle.get_nowait()
            except queue.Empty:
                return self._new()
            if process.alive:
                return process
            self._forget(process)

    def _new(self) -> ReaderProcess:
        with self._lock:
            if self._closed:
                raise refused(503, "app.ends")
            process = ReaderProcess(self._limits.reading_memory)
            self._all.add(process)
            return process

    def _forget(self, process: ReaderProcess) -> None:
        with self._lock:
            self._all.discard(process)
        process.end()
