"""The solvers are compiled once for all tests, and tests that depend on the machine are tried twice.

Compiling takes a minute or two, which no test with a time limit, and no example with a deadline, should pay.
Run as a program, this file compiles.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import prerequisites
from stayput.execution import cores

if TYPE_CHECKING:
    from collections.abc import Generator

os.environ["LC_ALL"] = "C.UTF-8"  # commands speak the language of the locale

APP = Path(__file__).parent / "app"

compiling = pytest.StashKey[subprocess.Popen[bytes]]()
"""The process that compiles, of a run whose tests are run by others (pytest-xdist)."""


def load_solvers() -> None:
    """Run each compiled entry point of the mechanics once: from the cache on disk, or compiled into it."""
    import numpy as np

    from stayput import Body, Motion, Room, State, simulate
    from stayput.mechanics.runner import no_elements, shaking, trace
    from stayput.model.flat_fields import case_columns

    (case,) = case_columns(Body(0.4, 1.6, 100.0), Room(), State(), 9.81)
    motion = shaking(np.zeros(2), None, 0.01, 0)
    trace(case, motion)
    trace(case, motion, no_elements(1))
    simulate(Body(0.4, 1.6, 100.0, length=0.8), Room(), Motion(dt=0.01, x=np.zeros(2)), dimensions=3)


@pytest.fixture(scope="session", autouse=True)
def solvers() -> None:
    """Load the solvers before the first test of each process."""
    load_solvers()


@pytest.fixture
def japanese_font() -> None:
    """Require a font with Japanese letters: where there is none, pictures show an ellipsis instead."""
    if not prerequisites.has_japanese_font():
        prerequisites.do_without(prerequisites.FONT)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Give all skips for want of one prerequisite the same place: the summary has one line for them."""
    report = yield
    if report.skipped and isinstance(report.longrepr, tuple):
        reason = report.longrepr[2].removeprefix("Skipped: ")
        if reason in prerequisites.ABSENT.values():
            report.longrepr = (prerequisites.__file__, 1, reason)
    return report


def pytest_sessionstart(session: pytest.Session) -> None:
    """Compile while pytest-xdist's workers import the tests, which takes them about half as long.

    One process compiles all: the solver with devices contains the one without, so a second process would
    compile that again and save no time.
    """
    config = session.config
    if config.pluginmanager.hasplugin("dsession") and not config.option.collectonly:
        config.stash[compiling] = subprocess.Popen([sys.executable, __file__])


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """Start one worker more than there are cores: tests of pages wait for Chromium much of the time."""
    del config
    return cores() + 1


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_node_collection_finished(node: Any) -> None:
    """Send no tests to the workers before everything is compiled; they load it from the disk."""
    node.config.stash[compiling].wait()


def pytest_sessionfinish(session: pytest.Session) -> None:
    if compiling in session.config.stash:  # and still at work, where the run ends early
        session.config.stash[compiling].kill()
        session.config.stash[compiling].wait()


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Try a test of the app, or one that starts clusters or ends processes, a second time when it fails.

    They have servers, browsers and clusters beside them, whose start and answers depend on what else the
    machine does; what is wrong fails twice. No other test is tried again: numbers are right the first time.
    The summary lists every second attempt, with the failure of the first.
    """
    if config.option.usepdb:  # which is to stop at the first failure
        return
    for item in items:
        if item.path.is_relative_to(APP) or item.get_closest_marker("processes"):
            item.add_marker(pytest.mark.flaky(reruns=1))


if __name__ == "__main__":
    load_solvers()
