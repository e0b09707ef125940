"""Compiled code on disk: used again, dropped with the source it came from, announced when made."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from numba import njit

import stayput.compiled as compiled

CALLER = """
from small.callee import part
from small.compiled import entry, told_of_compilation

@entry
def whole(x):
    return part(x) + 1.0

with told_of_compilation(lambda: print("compiling", end=" ")):
    whole(1.0), whole(2)
print(whole(1.0))
"""


def callee(factor):
    return f"from small.compiled import inner\n\n@inner\ndef part(x):\n    return {factor} * x\n"


@pytest.fixture
def run(tmp_path):
    package = tmp_path / "small"
    package.mkdir()
    shutil.copy(Path(compiled.__file__), package / "compiled.py")
    (package / "caller.py").write_text(CALLER)
    (package / "callee.py").write_text(callee(2.0))

    def run():
        done = subprocess.run(
            [sys.executable, "-m", "small.caller"],
            cwd=tmp_path,
            env=os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "code")},
            capture_output=True,
            text=True,
            check=True,
        )
        return done.stdout.strip()

    return run


def test_code_on_disk_is_used_until_any_source_changes(run, tmp_path):
    assert run() == "compiling 3.0"
    assert run() == "3.0"
    (tmp_path / "small" / "callee.py").write_text(callee(5.0))  # the entry's own file stays as it was
    assert run() == "compiling 6.0"
    assert run() == "6.0"


def test_code_that_cannot_be_dropped_is_no_failure(run, tmp_path, monkeypatch):
    run()
    index = next((tmp_path / "code").rglob("*.nbi"))
    os.utime(index, (0, 0))

    def refuse(self, missing_ok=False):
        raise PermissionError(13, "Permission denied", str(self))

    monkeypatch.setattr(Path, "unlink", refuse)
    compiled._forget_outdated(index.parent, [tmp_path / "small"])
    assert index.exists()


def test_constants_do_not_compile_a_function_anew():
    @compiled.inner
    def raised(x, power):
        return x**power

    @njit
    def both(x):
        return raised(x, 2) + raised(x, 3) + raised(x, int(x))

    assert both(2.0) == 16.0
    assert len(raised.signatures) == 1
