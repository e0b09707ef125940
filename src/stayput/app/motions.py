"""Uploaded motions: kept for a while in the server's own folder, under names that nobody can guess."""

from __future__ import annotations

import re
import secrets
import shutil
import threading
import time
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app.japanese import wording_of
from stayput.app.refusals import RefusedError
from stayput.app.replies import MotionReply, PreviewReply
from stayput.app.running import class_of, intensity_of
from stayput.errors import InputError
from stayput.motion import read_motion

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.app.limits import Limits
    from stayput.app.uploads import Upload
    from stayput.motion import Motion

PREVIEW = 1000
"""Most pieces of a preview."""

_SEPARATORS = np.zeros(256, np.bool_)
_SEPARATORS[list(b" \t\n\r\v\f,;")] = True
_UNSAFE = re.compile(r"[^\w .,()+-]", re.ASCII)


@dataclass(slots=True)
class Kept:
    """A motion that is kept."""

    motion: Motion
    asked: dict[str, Any]
    size: int
    used: float = field(default_factory=time.monotonic)


def safe_label(name: str | None) -> str:
    """Return what a user's file may be called in texts: its last part, plain characters only."""
    last = re.split(r"[\\/]", name or "")[-1]
    plain = _UNSAFE.sub("_", last).strip(" .")[:60]
    return plain or "record"


class Motions:
    """The motions that were uploaded.

    Parameters
    ----------
    folder : Path
        The server's own folder.
    limits : Limits
        How many, how large, how long.
    """

    def __init__(self, folder: Path, limits: Limits) -> None:
        self.folder = folder
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

    def add(self, sent: Upload) -> MotionReply:
        """Read a file's content and keep it.

        Raises
        ------
        RefusedError
            It is no record in a known format, or it is too long.
        """
        data, label = sent.data, safe_label(sent.name)
        self._check_numbers(data)
        name = secrets.token_hex(16)
        path = self.folder / name
        path.write_bytes(data)
        try:
            motion = replace(read_motion(path, sent.component, sent.unit, dt=sent.dt), name=label)
            self._check_length(motion)
        except InputError as error:
            path.unlink(missing_ok=True)
            told = self._without_path(str(error), path, label)
            raise RefusedError(422, told, wording_of(told)[1] or "file") from None
        except BaseException:
            path.unlink(missing_ok=True)
            raise
        given: dict[str, Any] = {"unit": sent.unit, "dt": sent.dt, "component": sent.component}
        asked = {"record": name} | {key: value for key, value in given.items() if value is not None}
        with self._lock:
            self._kept[name] = Kept(motion, asked, len(data))
        self.expire()
        return self.about(name)

    def about(self, name: str) -> MotionReply:
        """Return what is known of a motion.

        Raises
        ------
        RefusedError
            There is none of this name.
        """
        kept = self._of(name)
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
            pga_m_s2=motion.pga,
            pgv_m_s=motion.pgv,
            intensity=intensity,
            intensity_class=class_of(intensity),
            expires_in_s=max(0.0, self._limits.keep - (time.monotonic() - kept.used)),
            shaking=kept.asked,
        )

    def preview(self, name: str) -> PreviewReply:
        """Return the outline of a motion's x.

        Raises
        ------
        RefusedError
            There is none of this name.
        """
        motion = self._of(name).motion
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

    def remove(self, name: str) -> None:
        """Forget a motion.

        Raises
        ------
        RefusedError
            There is none of this name.
        """
        self._of(name)
        with self._lock:
            self._drop(name)

    def expire(self) -> None:
        """Forget motions that were not used for long, and the oldest where there are too many."""
        limits, now = self._limits, time.monotonic()
        with self._lock:
            oldest = sorted(self._kept, key=lambda name: self._kept[name].used)
            size = sum(kept.size for kept in self._kept.values())
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
                raise RefusedError(
                    404, "There is no such motion; it may have expired and must be uploaded again."
                )
            kept.used = time.monotonic()
            return kept

    def _drop(self, name: str) -> None:
        del self._kept[name]
        (self.folder / name).unlink(missing_ok=True)

    def _check_numbers(self, data: bytes) -> None:
        """Refuse more numbers than any record needs before a list is made of them."""
        between = _SEPARATORS[np.frombuffer(data, np.uint8)]
        count = int(np.count_nonzero(between[1:] & ~between[:-1])) + 1
        if count > self._limits.numbers:
            told = f"The file has about {count} numbers; this server reads {self._limits.numbers}."
            raise RefusedError(422, told, "file")

    def _check_length(self, motion: Motion) -> None:
        limits = self._limits
        if motion.duration > limits.duration:
            told = f"The motion lasts {motion.duration:.0f} s; this server allows {limits.duration:g} s."
            raise RefusedError(422, told, "file")
        if len(motion) > limits.samples_of_motion:
            told = f"The motion has {len(motion)} samples; this server allows {limits.samples_of_motion}."
            raise RefusedError(422, told, "file")

    @staticmethod
    def _without_path(sentence: str, path: Path, label: str) -> str:
        """Return a reader's sentence with the user's name for the file, not the server's."""
        for known in (repr(str(path)), str(path), path.name):
            sentence = sentence.replace(known, label)
        return sentence
