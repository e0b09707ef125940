"""Uploaded motions: read in a process of their own, kept for a while under names that nobody can guess.

The process is a plain child with pipes, which all systems have; it is ended when it takes too long. Ctrl-C
does not reach it, and it ends with the server.
"""

from __future__ import annotations

import asyncio
import os
import pickle
import re
import secrets
import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import Field

from stayput.app.jobs import CLIENT, Client, Workers, first_to_go
from stayput.app.messages import ID, Problem, RefusedError, Reply, Upload, problem, refused
from stayput.app.reader import ReadingResult, ReadingTask
from stayput.errors import InputError, InputWarning, warnings_to
from stayput.motion.floors import upper_floor
from stayput.motion.intensity import EXCEEDED, intensity_class
from stayput.motion.record import Motion
from stayput.motion.suites.suite import record_key
from stayput.report.summary import number

if TYPE_CHECKING:
    from stayput.app.limits import Limits

MOST_INTERVALS = 1000
"""Most intervals of a preview, each with its lowest and highest value."""

START = "import sys; sys.path[:] = sys.argv[1:]; from stayput.app.reader import main; main()"
"""What the process runs; it finds the package where this one does."""

OF_WINDOWS = ("CREATE_NEW_PROCESS_GROUP", "CREATE_NO_WINDOW")
"""How Windows starts it."""

_NAME = re.compile(rf"\b{ID}\b")
_UNSAFE = re.compile(r"[^\w .,()+-]", re.ASCII)


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

    async def read(self, path: Path, **options: Any) -> tuple[Motion, tuple[InputWarning, ...]]:
        """Read a record; see `read_shaking`. Return it with the warnings about it.

        Raises
        ------
        InputError
            It is no record, or takes too much.
        RefusedError
            Too many are waiting.
        """
        task = ReadingTask(str(path), options, self._limits)
        result = await self._workers.run(self._read, task)
        if result.motion is None:
            raise result.refusal or InputError("app.reading_died")
        return result.motion, result.warnings

    def close(self) -> None:
        """End the process."""
        self._workers.close()
        if self._process is not None:
            self._process.kill()

    def _read(self, task: ReadingTask) -> ReadingResult:
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
                answer, _ = process.communicate(pickle.dumps(task), task.limits.reading_seconds)
            except subprocess.TimeoutExpired:
                process.kill()
                error = InputError("app.reading_slow", seconds=task.limits.reading_seconds)
                return ReadingResult(None, error)
        try:
            return pickle.loads(answer)
        except (EOFError, pickle.UnpicklingError):  # it ended without its whole answer
            return ReadingResult(None, None)


@dataclass(slots=True)
class StoredMotion:
    """An uploaded motion, and how a scene's shaking names it."""

    motion: Motion
    shaking: dict[str, Any]
    size: int
    warnings: tuple[InputWarning, ...] = ()
    client: Client = field(default_factory=CLIENT.get)
    last_used: float = field(default_factory=time.monotonic)


def safe_label(name: str | None) -> str:
    """Return a label for a user's file: the last part of its name, plain characters only."""
    last = re.split(r"[\\/]", name or "")[-1]
    plain = _UNSAFE.sub("_", last).strip(" .")[:60]
    return plain or "record"


def intensity_of(motion: Motion) -> float | None:
    """Return the JMA intensity of a motion, if it has one: it is long enough and not still."""
    return number(motion.intensity) if motion.duration > 2.0 * EXCEEDED else None


def class_of(intensity: float | None) -> str | None:
    """Return the class of an intensity, if it has one."""
    return None if intensity is None else intensity_class(intensity)


class ChannelReply(Reply):
    """A channel of an uploaded file."""

    name: str = Field(description="What chooses it.")
    vertical: bool
    used: bool = Field(description="Whether it is the one along the shaking, x.")


class MotionReply(Reply):
    """An uploaded motion."""

    id: str
    name: str
    source: str
    synthetic: bool
    duration_s: float
    dt_s: float
    samples: int
    components: list[str]
    channels: list[ChannelReply]
    record: str | None = Field(description="Of a file of one channel: the same in all files of its record.")
    pga_m_s2: float
    pgv_m_s: float
    intensity: float | None
    intensity_class: str | None
    expires_in_s: float
    floor: str = Field(description="Upper floor of a building that it was recorded on; empty otherwise.")
    warnings: list[Problem] = Field(description="What is doubtful about the file.")
    shaking: dict[str, Any] = Field(description="What a scene's shaking says to use it.")


class PreviewReply(Reply):
    """A motion's outline: extremes of the acceleration in each piece of time."""

    time_s: list[float]
    low_m_s2: list[float]
    high_m_s2: list[float]


class Motions:
    """The motions that were uploaded.

    Parameters
    ----------
    folder : Path
        The server's own folder.
    limits : Limits
        How many, how large, how long.
    readers : Readers
        What reads them.
    in_use : callable
        Returns the names of the motions that must stay, whatever their age.
    """

    def __init__(
        self, folder: Path, limits: Limits, readers: Readers, in_use: Callable[[], set[str]]
    ) -> None:
        self.folder = folder
        self._readers = readers
        self._in_use = in_use
        self._limits = limits
        self._stored: dict[str, StoredMotion] = {}
        self._lock = threading.Lock()

    def used(self, name: str) -> StoredMotion | None:
        """Return a motion, if there is one of this name, and note that it is used."""
        self.expire()
        with self._lock:
            stored = self._stored.get(name)
            if stored is not None:
                stored.last_used = time.monotonic()
            return stored

    async def add(self, upload: Upload) -> StoredMotion:
        """Read a file's content in a process of its own and keep it.

        Raises
        ------
        RefusedError
            It is no record in a known format, or it is too long.
        """
        data, file_name, name = await upload.file.read(), upload.file.filename, secrets.token_hex(16)
        if not data:
            raise refused(422, "app.empty_file", "file")
        if floor := upper_floor([file_name or ""]):
            name += f"_{floor.replace(' ', '_')}"
        label, path = safe_label(file_name), self.folder / name
        shaking = {"record": name, **upload.model_dump(exclude={"file"}, exclude_defaults=True)}
        try:
            await asyncio.to_thread(path.write_bytes, data)
            stored = await self._read(shaking, label, len(data), "file")
        except BaseException:
            path.unlink(missing_ok=True)
            raise
        with self._lock:
            self._stored[name] = stored
        self.expire()
        return stored

    async def with_component(self, name: str, component: str | None) -> StoredMotion:
        """Return a motion, read anew where another channel than the one it was uploaded with is to be x.

        Raises
        ------
        RefusedError
            There is none of this name, or it has no such channel.
        """
        stored = self._get(name)
        if component is None or component == stored.shaking.get("component"):
            return stored
        shaking = {**stored.shaking, "component": component}
        return await self._read(shaking, stored.motion.name, stored.size, "component")

    async def _read(self, shaking: dict[str, Any], label: str, size: int, about: str) -> StoredMotion:
        """Read a file of the folder in a process of its own, as a scene's shaking asks for it."""
        name = shaking["record"]

        def rewrite(text: str) -> str:
            return self.with_file_names(text, {name: label})

        try:
            options = {key: value for key, value in shaking.items() if key != "record"}
            motion, warnings = await self._readers.read(self.folder / name, **options)
        except InputError as error:
            known = error.rewritten(rewrite)
            raise RefusedError(422, known.about(known.field or about)) from None
        motion = replace(motion, name=label)
        known = tuple(warning.rewritten(rewrite) for warning in warnings)
        return StoredMotion(motion, shaking, size, known)

    def joined(self, stored: StoredMotion, **files: str | None) -> StoredMotion:
        """Return a motion with the components that files of their own hold.

        Parameters
        ----------
        stored : StoredMotion
            The motion.
        **files : str
            Names of the motions whose x is ``across`` and ``vertical``.

        Raises
        ------
        RefusedError
            There is none of these names, or they are not of one record.
        """
        others = {key: name for key, name in files.items() if name is not None}
        if not others:
            return stored
        motion, warnings = stored.motion, [*stored.warnings]
        parts = {axis: motion.component(axis) for axis in motion.components if axis != "x"}
        parts |= {"y" if key == "across" else "z": self._get(name).motion for key, name in others.items()}
        try:
            with warnings_to(warnings.append):
                whole = Motion.combine(motion, parts.get("y"), parts.get("z"))
        except InputError as error:
            raise RefusedError(422, error.about("file")) from None
        return replace(stored, motion=whole, shaking={**stored.shaking, **others}, warnings=tuple(warnings))

    def about(self, stored: StoredMotion) -> MotionReply:
        """Return the facts about a motion."""
        motion = stored.motion
        intensity = intensity_of(motion)
        return MotionReply.from_attributes(
            motion,
            id=stored.shaking["record"],
            samples=len(motion),
            components=list(motion.components),
            channels=_channels(motion),
            record=_record_of(motion),
            intensity=intensity,
            intensity_class=None if motion.floor else class_of(intensity),
            expires_in_s=max(0.0, self._limits.keep - (time.monotonic() - stored.last_used)),
            warnings=[problem(warning) for warning in stored.warnings],
            shaking=stored.shaking,
        )

    @staticmethod
    def preview(motion: Motion) -> PreviewReply:
        """Return the outline of a motion's x."""
        starts = np.unique(np.linspace(0, len(motion), MOST_INTERVALS, endpoint=False).astype(np.intp))
        return PreviewReply(
            time_s=np.round(motion.time[starts], 4).tolist(),
            low_m_s2=np.round(np.minimum.reduceat(motion.x, starts), 4).tolist(),
            high_m_s2=np.round(np.maximum.reduceat(motion.x, starts), 4).tolist(),
        )

    def with_file_names(self, text: str, new: Mapping[str, str] | None = None) -> str:
        """Return a text with the users' names for their files in place of the server's.

        Parameters
        ----------
        text : str
            A sentence about a file, or a report.
        new : mapping, optional
            Names of files that are not kept yet.
        """
        with self._lock:
            names = {name: stored.motion.name for name, stored in self._stored.items()}
        names |= new or {}
        inside = f"{self.folder}{os.sep}"
        for known in (repr(inside)[1:-1], inside):  # sentences quote paths by repr, which doubles backslashes
            text = text.replace(known, "")
        return _NAME.sub(lambda match: names.get(match[0], "record"), text)

    def remove(self, name: str) -> None:
        """Forget a motion.

        Raises
        ------
        RefusedError
            There is none of this name, or a verification still needs it.
        """
        self._get(name)
        if name in self._in_use():
            raise refused(409, "app.motion_needed")
        with self._lock:
            self._drop(name)

    def expire(self) -> None:
        """Forget motions unused for too long, and of too many those of the client that has most.

        Those in use neither go nor count.
        """
        limits, now, in_use = self._limits, time.monotonic(), self._in_use()
        with self._lock:
            free = {name: motion for name, motion in self._stored.items() if name not in in_use}
            for name in [name for name, motion in free.items() if now - motion.last_used > limits.keep]:
                self._drop(name)
                del free[name]
            while len(free) > limits.motions or sum(m.size for m in free.values()) > limits.motion_bytes:
                name = first_to_go(free.values()).shaking["record"]
                self._drop(name)
                del free[name]

    def close(self) -> None:
        """Forget all motions, and remove the folder."""
        with self._lock:
            self._stored.clear()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _get(self, name: str) -> StoredMotion:
        stored = self.used(name)
        if stored is None:
            raise refused(404, "app.no_such_id")
        return stored

    def _drop(self, name: str) -> None:
        del self._stored[name]
        (self.folder / name).unlink(missing_ok=True)


def _record_of(motion: Motion) -> str | None:
    listing = motion.listing
    if listing is None or len(listing.names) > 1:
        return None
    return record_key(motion.name, listing.origin, listing.labels["x"])


def _channels(motion: Motion) -> list[ChannelReply]:
    listing = motion.listing
    if listing is None:
        return []
    return [
        ChannelReply(name=name, vertical=vertical, used=i == listing.used)
        for i, (name, vertical) in enumerate(zip(listing.names, listing.vertical, strict=True))
    ]
