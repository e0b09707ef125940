"""Processor time of a start: of programs as they are called, and of what is compiled, by phase.

A cold start finds no machine code on disk and compiles; a warm one loads it. All is processor time, which is
much the same on a machine that does other things too.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.compiled import kind_of
from stayput.mechanics import engine
from stayput.mechanics.columns import CASE
from stayput.mechanics.devices.columns import ELEMENT
from stayput.mechanics.devices.runner import devices_of
from stayput.mechanics.runner import arguments, shaking

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from stayput.machine_code import MachineCode

SCENARIO = Path(__file__).parents[1] / "examples" / "bookcase.toml"
PROGRAMS = {
    "stayput simulate": ["-m", "stayput", "simulate", "--motion", "sine:1,1,1", "--json"],
    "stayput verify": ["-m", "stayput", "verify", str(SCENARIO), "--threads", "1", "--json"],
}


def program_seconds(arguments: list[str], folder: str) -> float:
    """Run the interpreter with its machine code in a folder; return its processor time [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, *arguments]
    environment = {**os.environ, "NUMBA_CACHE_DIR": folder}
    subprocess.run(command, env=environment, capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Phases:
    """Processor time of each phase [s], without that of the phases within it."""

    def __init__(self) -> None:
        self.seconds: Counter[str] = Counter()
        self._open = ["else"]
        self._last = time.process_time()

    @contextmanager
    def phase(self, name: str) -> Generator[None]:
        """Count what is done meanwhile."""
        self._turn()
        self._open.append(name)
        try:
            yield
        finally:
            self._turn()
            self._open.pop()

    def _turn(self) -> None:
        now = time.process_time()
        self.seconds[self._open[-1]] += now - self._last
        self._last = now

    def watch(self, owner: Any, method: str, name: str) -> None:
        """Count each call of a method as a phase."""
        original: Callable[..., Any] = getattr(owner, method)

        def watched(*args: Any, **kwargs: Any) -> Any:
            with self.phase(name):
                return original(*args, **kwargs)

        setattr(owner, method, watched)


def compiled_in_phases() -> None:
    """Compile the solver for bodies without devices, then with them, and print where the time goes."""
    phases = Phases()
    with phases.phase("import Numba"):
        from numba.core import typed_passes, untyped_passes

        from stayput import intermediate_code, machine_code
    for owner, method, name in (
        (untyped_passes.TranslateByteCode, "run_pass", "byte code to Numba's"),
        (untyped_passes.ReconstructSSA, "run_pass", "single assignment"),
        (typed_passes.NopythonTypeInference, "run_pass", "types"),
        (typed_passes.NativeLowering, "run_pass", "to LLVM's code"),
        (intermediate_code.LinkableCode, "linked", "linking"),
        (machine_code, "_optimize", "optimizing"),
        (type(machine_code._machine()), "emit_object", "machine code"),
    ):
        phases.watch(owner, method, name)
    values = np.zeros(2)
    cases, motion = np.zeros(1, CASE), shaking(values, None, 0.01, 0)
    held = devices_of(np.zeros((1, 1), ELEMENT), motion)
    table: list[Counter[str]] = []
    for devices in (None, held):
        kinds = tuple(map(kind_of, arguments(cases, devices, motion)))
        entry: Any = engine.run_batch
        code: MachineCode = entry._machine_code(kinds)
        begun: list[object] = []
        code.add(entry._compile(kinds, begun.append))
        phases.seconds["(functions)"] = len(begun)
        phases._turn()
        table.append(phases.seconds)
        phases.seconds = Counter()
    print(f"\n{'phase':22} {'without devices':>16} {'then with them':>16}")
    for name in sorted(table[0], key=lambda name: -table[0][name]):
        if name != "(functions)":
            print(f"{name:22} {table[0][name]:16.2f} {table[1][name]:16.2f}")
    for name, numbers in (
        ("sum", [sum(column.values()) - column["(functions)"] for column in table]),
        ("functions", [column["(functions)"] for column in table]),
    ):
        print(f"{name:22} " + " ".join(f"{number:16.5g}" for number in numbers))


def main() -> None:
    print(f"{'processor time [s]':22} {'cold':>16} {'warm':>16}")
    for name, program in PROGRAMS.items():
        with tempfile.TemporaryDirectory() as folder:
            cold, warm = program_seconds(program, folder), program_seconds(program, folder)
        print(f"{name:22} {cold:16.2f} {warm:16.2f}")
    with tempfile.TemporaryDirectory() as folder:
        os.environ["NUMBA_CACHE_DIR"] = folder
        compiled_in_phases()


if __name__ == "__main__":
    main()
