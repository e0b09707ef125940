"""Memory that long work has freed goes back to the system.

A verification allocates and frees hundreds of megabytes on a thread of its own. The C library of GNU keeps
what was freed for later, thread by thread, so that the process stays as large as all its threads ever were.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any


@cache
def _trim() -> Any:
    """Return what gives freed memory back, of the C library of GNU; None elsewhere."""
    try:
        return ctypes.CDLL(None).malloc_trim
    except (AttributeError, OSError, TypeError):
        return None


def give_freed_back() -> None:
    """Give memory back to the system that was freed; it takes some milliseconds."""
    trim = _trim()
    if trim is not None:
        trim(0)
