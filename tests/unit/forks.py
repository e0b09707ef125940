"""Processes that have the package and its solvers loaded: children of a server that forks them.

A new process of Python takes a second or two to load them; a child takes a hundredth of that. Where a system
cannot fork, new processes are started.
"""

from __future__ import annotations

import multiprocessing
import os
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Callable
    from multiprocessing.context import BaseContext
    from multiprocessing.process import BaseProcess

METHOD = "forkserver" if os.name == "posix" else "spawn"

FOLDERS = [Path(__file__).parent, Path(__file__).parents[1]]
"""Where the server finds `loaded` and what that imports; what it does not find it silently leaves out."""


def context() -> BaseContext:
    """Return what makes such processes, with the server running."""
    made = multiprocessing.get_context(METHOD)
    if METHOD == "forkserver":
        from multiprocessing import forkserver

        made.set_forkserver_preload(["loaded"])
        with pytest.MonkeyPatch.context() as patch:
            for folder in FOLDERS:
                patch.setenv("PYTHONPATH", str(folder), prepend=os.pathsep)
            forkserver.ensure_running()
    return made


def start(function: Callable[..., object], *arguments: object, **named: object) -> BaseProcess:
    """Start a function of one of the modules of this folder in a process of its own."""
    process = context().Process(target=function, args=arguments, kwargs=named)
    process.start()
    return process
