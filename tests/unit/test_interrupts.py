"""Ctrl-C while modules are loaded: exit code 130, and no traceback."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import types
from functools import partial

import pytest
from interrupts import hears_interrupts

from long_cases import long
from stayput.cli.interrupts import HandledBy, end_at_once, raise_after_imports

INTERRUPTING = """
import runpy, signal, sys
class Interrupting:
    def find_spec(self, name, path=None, target=None):
        if name == WANTED:
            sys.meta_path.remove(self)
            print("met", file=sys.stderr)
            signal.raise_signal(signal.SIGINT)
WANTED = sys.argv.pop(1)
sys.meta_path.insert(0, Interrupting())
"""
STARTS = {
    "python -m stayput": "sys.argv[0] = 'stayput'; runpy.run_module('stayput', None, '__main__', True)",
    "stayput": "from stayput.cli import main; sys.exit(main())",
}
ON_POSIX = pytest.mark.skipif(os.name != "posix", reason="POSIX signals")


@pytest.mark.processes
@ON_POSIX
@pytest.mark.parametrize(
    ("start", "module", "said"),
    [
        ("python -m stayput", "typer", ""),
        ("stayput", "stayput.simulation.run", "Interrupted.\n"),
        *long(
            ("stayput", "stayput.errors", ""),
            ("python -m stayput", "stayput.compiling.machine_code", "Interrupted.\n"),
            ("stayput", "matplotlib.figure", "Interrupted.\n"),
        ),
    ],
)
def test_ctrl_c_while_a_module_is_loaded(tmp_path, start, module, said):
    command = ["simulate", "--plot", "a.png"]
    done = subprocess.run(
        [sys.executable, "-c", INTERRUPTING + STARTS[start], module, *command],
        capture_output=True, text=True, check=False, cwd=tmp_path, preexec_fn=hears_interrupts,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (130, f"met\n{said}")
    assert not list(tmp_path.iterdir())


@pytest.mark.processes
@ON_POSIX
def test_ctrl_c_in_a_finaliser_is_not_lost():
    """Python ignores what is raised there."""
    finaliser = """
from stayput.cli import interrupts
import signal, time
class Finalised:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)
with interrupts.HandledBy(interrupts.raise_after_imports):
    try:
        Finalised()
        for _ in range(1000):  # what is sent again does not wake a sleeper
            time.sleep(0.02)
    except KeyboardInterrupt:
        print("raised")
"""
    done = subprocess.run(
        [sys.executable, "-c", finaliser],
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=hears_interrupts,
    )
    assert (done.stdout, done.stderr) == ("raised\n", "")


def test_an_interrupt_is_raised_at_once_where_no_module_is_loaded(request):
    for name in ("unraisablehook", "excepthook"):
        request.addfinalizer(partial(setattr, sys, name, getattr(sys, name)))
    with pytest.raises(KeyboardInterrupt):
        raise_after_imports(
            signal.SIGINT, types.SimpleNamespace(f_code=raise_after_imports.__code__, f_back=None)
        )


def test_what_else_handles_interrupts_goes_on_to():
    """A shell lets programs in its background ignore them, and another thread may load the command line."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with HandledBy(end_at_once):
            assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
        signal.signal(signal.SIGINT, signal.default_int_handler)
        with HandledBy(raise_after_imports, afterwards=end_at_once):
            assert signal.getsignal(signal.SIGINT) is raise_after_imports
        assert signal.getsignal(signal.SIGINT) is end_at_once
        signal.signal(signal.SIGINT, signal.default_int_handler)
        thread = threading.Thread(target=HandledBy(end_at_once).__enter__)
        thread.start()
        thread.join()
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
