"""Uploaded motions: kept for a while in the server's own folder, under names that nobody can guess."""

from __future__ import annotations

import asyncio
import os
import re
import secrets
import shutil
import threading
import time
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app.refusals import RefusedError, problem, refused
from stayput.app.replies import ChannelReply, DoubtReply, MotionReply, PreviewReply
from stayput.errors import InputError
from stayput.motion.channels import upper_floor, upper_floor_warning
from stayput.motion.intensity import EXCEEDED, intensity_class
from stayput.report.summary import number

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from pathlib import Path

    from stayput.app.limits import Limits
    from stayput.app.readers import Readers
    from stayput.app.uploads import Upload
    from stayput.errors import InputWarning
    from stayput.motion import Motion

PREVIEW = 1000
"""Most pieces of a preview."""

_NAME = re.compile(r"\b[0-9a-f]{32}\b")
_UNSAFE = re.compile(r"[^\w .,()+-]", re.ASCII)


@dataclass(slots=True)
class Kept:
    """A motion that is kept."""

    motion: Motion
    asked: dict[str, Any]
    size: int
    doubts: tuple[InputWarning, ...] = ()
    called: str = ""  # by the user, in any script
    used: float = field(default_factory=time.monotonic)


def safe_label(name: str | None) -> str:
    """Return what a user's file may be called in texts: its last part, plain characters only."""
    last = re.split(r"[\\/]", name or "")[-1]
    plain = _UNSAFE.sub("_", last).strip(" .")[:60]
    return plain or "record"


def intensity_of(motion: Motion) -> float | None:
    """Return the JMA intensity of a motion, if it has one: it is long enough and not still."""
    return number(motion.intensity) if motion.duration > 2.0 * EXCEEDED else None


def class_of(intensity: float | None) -> str | None:
    """Return the class of an intensity, if it has one."""
    return None if intensity is None else intensity_class(intensity)


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
        self._kept: dict[str, Kept] = {}
        self._lock = threading.Lock()

    def knows(self, name: str) -> bool:
        """Return whether there is such a motion."""
        self.expire()
        with self._lock:
            return name in self._kept

    def touch(self, name: str) -> None:
        """Note that a motion is used."""
        with self._lock:
            if name in self._kept:
                self._kept[name].used = time.monotonic()

    async def add(self, sent: Upload) -> str:
        """Read a file's content in a process of its own and keep it; return its name here.

        Raises
        ------
        RefusedError
            It is no record in a known format, or it is too long.
        """
        label, size, name = safe_label(sent.name), len(sent.data), secrets.token_hex(16)
        path = self.folder / name
        given: dict[str, Any] = {"unit": sent.unit, "dt": sent.dt, "component": sent.component}
        asked = {"record": name} | {key: value for key, value in given.items() if value is not None}
        try:
            await asyncio.to_thread(path.write_bytes, sent.data)
            kept = await self._read(asked, label, size, sent.name or label, "file")
        except BaseException:
            path.unlink(missing_ok=True)
            raise
        with self._lock:
            self._kept[name] = kept
        self.expire()
        return name

    async def with_component(self, name: str, component: str | None) -> Kept:
        """Return a motion, read anew where another channel than the one it was uploaded with is to be x.

        Raises
        ------
        RefusedError
            There is none of this name, or it has no such channel.
        """
        kept = self._of(name)
        if component is None or component == kept.asked.get("component"):
            return kept
        asked = {**kept.asked, "component": component}
        return await self._read(asked, kept.motion.name, kept.size, kept.called, "component")

    async def _read(self, asked: dict[str, Any], label: str, size: int, called: str, about: str) -> Kept:
        """Read a file of the folder in a process of its own, as a scene's shaking asks for it."""
        name = asked["record"]
        options = (asked.get(key) for key in ("component", "unit", "dt"))

        def plainly(text: str) -> str:
            return self.told(text, {name: label})

        try:
            motion, doubts = await self._readers.read(self.folder / name, *options)
        except InputError as error:
            known = error.rewritten(plainly)
            raise RefusedError(422, known.about(known.field or about)) from None
        motion = replace(motion, name=label)
        if not motion.floor and (floor := upper_floor([called])):  # the reader knows no user's names
            motion = replace(motion, floor=floor)
            doubts = (*doubts, upper_floor_warning(floor).at(label))
        known = tuple(doubt.rewritten(plainly) for doubt in doubts)
        return Kept(motion, asked, size, known, called)

    def about(self, name: str, kept: Kept | None = None) -> MotionReply:
        """Return what is known of a motion.

        Parameters
        ----------
        name : str
            Its id.
        kept : Kept, optional
            The motion with another component, from `with_component`.

        Raises
        ------
        RefusedError
            There is none of this name.
        """
        kept = self._of(name) if kept is None else kept
        motion = kept.motion
        intensity = intensity_of(motion)
        return MotionReply(
            id=name,
            name=motion.name,
            source=motion.source,
            synthetic=motion.synthetic,
            duration_s=motion.duration,
            dt_s=motion.dt,
            samples=len(motion),
            components=list(motion.components),
            channels=_channels(motion),
            pga_m_s2=motion.pga,
            pgv_m_s=motion.pgv,
            intensity=intensity,
            intensity_class=class_of(intensity),
            expires_in_s=max(0.0, self._limits.keep - (time.monotonic() - kept.used)),
            floor=motion.floor,
            warnings=[DoubtReply(**problem(doubt).model_dump()) for doubt in kept.doubts],
            shaking=kept.asked,
        )

    @staticmethod
    def preview(motion: Motion) -> PreviewReply:
        """Return the outline of a motion's x."""
        starts = np.unique(np.linspace(0, len(motion), PREVIEW, endpoint=False).astype(np.intp))
        return PreviewReply(
            time_s=np.round(motion.time[starts], 4).tolist(),
            low_m_s2=np.round(np.minimum.reduceat(motion.x, starts), 4).tolist(),
            high_m_s2=np.round(np.maximum.reduceat(motion.x, starts), 4).tolist(),
        )

    def label(self, name: str) -> str:
        """Return what a motion's file is called."""
        return self._of(name).motion.name

    def named(self, text: str) -> str:
        """Return a text with the motions' own names in place of their ids."""
        with self._lock:
            for name, kept in self._kept.items():
                text = text.replace(name, kept.motion.name)
        return text

    def told(self, sentence: str, new: Mapping[str, str] | None = None) -> str:
        """Return a sentence with the users' names for their files, not the server's.

        Parameters
        ----------
        sentence : str
            What was said of a file.
        new : mapping, optional
            Names of files that are not kept yet.
        """
        with self._lock:
            names = {name: kept.motion.name for name, kept in self._kept.items()}
        names |= new or {}
        inside = f"{self.folder}{os.sep}"
        for known in (repr(inside)[1:-1], inside):  # sentences quote paths by repr, which doubles backslashes
            sentence = sentence.replace(known, "")
        return _NAME.sub(lambda found: names.get(found[0], "record"), sentence)

    def remove(self, name: str) -> None:
        """Forget a motion.

        Raises
        ------
        RefusedError
            There is none of this name, or a verification still needs it.
        """
        self._of(name)
        if name in self._in_use():
            raise refused(409, "app.motion_needed")
        with self._lock:
            self._drop(name)

    def expire(self) -> None:
        """Forget motions that were not used for long, and the oldest where there are too many.

        Those in use neither go nor count.
        """
        limits, now, in_use = self._limits, time.monotonic(), self._in_use()
        with self._lock:
            free = [name for name in self._kept if name not in in_use]
            oldest = sorted(free, key=lambda name: self._kept[name].used)
            size = sum(self._kept[name].size for name in free)
            count = len(oldest)
            for name in oldest:
                kept = self._kept[name]
                if count > limits.motions or size > limits.motion_bytes or now - kept.used > limits.keep:
                    count, size = count - 1, size - kept.size
                    self._drop(name)

    def close(self) -> None:
        """Forget all motions, and remove the folder."""
        with self._lock:
            self._kept.clear()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _of(self, name: str) -> Kept:
        self.expire()
        with self._lock:
            kept = self._kept.get(name)
            if kept is None:
                raise refused(404, "app.no_such_motion")
            kept.used = time.monotonic()
            return kept

    def _drop(self, name: str) -> None:
        del self._kept[name]
        (self.folder / name).unlink(missing_ok=True)


def _channels(motion: Motion) -> list[ChannelReply]:
    listing = motion.listing
    if listing is None:
        return []
    return [
        ChannelReply(name=name, vertical=vertical, used=i == listing.used)
        for i, (name, vertical) in enumerate(zip(listing.names, listing.vertical, strict=True))
    ]
