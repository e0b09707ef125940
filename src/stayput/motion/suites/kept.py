"""Synthetic motions that are kept in memory for the next call, up to so many bytes."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from stayput.motion.suites.synthesis import synthetic_motion

if TYPE_CHECKING:
    from stayput.motion.record import Motion

MOST_BYTES = 128 * 1024 * 1024
"""Bytes of samples that are kept: 40 motions of the mixed suite have 9 MB, 100 of the longest kind 60 MB."""


class KeptMotions:
    """Motions by family, place and seed; those that were not used for longest go first.

    Parameters
    ----------
    most : int
        Most bytes of samples.
    """

    def __init__(self, most: int = MOST_BYTES) -> None:
        self._most = most
        self._kept: dict[tuple[str, int, int], Motion] = {}
        self._lock = threading.Lock()
        self.size = 0

    def get(self, family: str, place: int, seed: int) -> Motion:
        """Return a motion, made anew where it is not kept; see `synthetic_motion`."""
        key = (family, place, seed)
        with self._lock:
            motion = self._kept.pop(key, None)
            if motion is not None:
                self._kept[key] = motion  # a dict keeps its order: the last one is the newest
                return motion
        motion = synthetic_motion(family, place, seed)
        with self._lock:
            if key not in self._kept:
                self._kept[key] = motion
                self.size += _size(motion)
            while self.size > self._most:
                self.size -= _size(self._kept.pop(next(iter(self._kept))))
        return motion


def _size(motion: Motion) -> int:
    return sum(samples.nbytes for samples in motion.components.values())
