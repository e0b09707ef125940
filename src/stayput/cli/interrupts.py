"""Ctrl-C ends the program with its own exit code and no traceback, whatever it is doing.

This module is loaded before all others of the command line, and loads nothing that takes long.
"""

from __future__ import annotations

import os
import sys
from _thread import interrupt_main

TYPE_CHECKING = False  # as in typing, which takes longer to load than all else here
if not TYPE_CHECKING:
    import _signal as signal  # what signal takes its functions from, after it has loaded enum and collections
else:
    import signal
    from collections.abc import Callable
    from types import FrameType
    from typing import Any

    Handler = Callable[[int, FrameType | None], None]

INTERRUPTED = 130
"""Exit code after Ctrl-C."""

_AGAIN = 0.02
"""Time after which an interrupt that could not be raised is tried again [s]."""


def end_at_once(_signal: int, _frame: FrameType | None) -> None:
    """End the process: there is nothing to tidy up yet, or no longer."""
    os._exit(INTERRUPTED)


def raise_after_imports(_signal: int, frame: FrameType | None) -> None:
    """Raise KeyboardInterrupt; later where a module is being loaded, which might turn it into any error."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            _raise_later()
            return
        frame = frame.f_back
    sys.unraisablehook, sys.excepthook = _raise_where_it_counts, _print_unless_interrupted
    raise KeyboardInterrupt


def _raise_later() -> None:
    from threading import Timer

    Timer(_AGAIN, interrupt_main).start()


def _raise_where_it_counts(ignored: sys.UnraisableHookArgs) -> None:
    """Raise an interrupt again that met a finaliser or a callback, whose exceptions Python ignores."""
    if isinstance(ignored.exc_value, KeyboardInterrupt):
        _raise_later()
    else:
        sys.__unraisablehook__(ignored)


def _print_unless_interrupted(kind: type[BaseException], *error: Any) -> None:
    """Print an exception as Python does; extensions written in Cython also print those that they ignore."""
    if not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, *error)


class HandledBy:
    """Context in which a function handles Ctrl-C, where Python's own does: a shell may have it ignored.

    Parameters
    ----------
    handler, afterwards : callable
        What handles it meanwhile and afterwards.
    """

    def __init__(self, handler: Handler, afterwards: Handler = signal.default_int_handler) -> None:
        self.handler, self.afterwards = handler, afterwards

    def __enter__(self) -> None:
        _exchange(signal.default_int_handler, self.handler)

    def __exit__(self, *_: object) -> None:
        _exchange(self.handler, self.afterwards)


def _exchange(before: Handler, after: Handler) -> None:
    try:
        if signal.getsignal(signal.SIGINT) is before:
            signal.signal(signal.SIGINT, after)
    except ValueError:  # another thread than the main one loads the command line
        pass
