"""Processor time of a start of programs as they are called.

A cold start finds no machine code on disk and compiles; a warm one loads it. All is processor time, which is
much the same on a machine that does other things too.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

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


def main() -> None:
    print(f"{'processor time [s]':22} {'cold':>16} {'warm':>16}")
    for name, program in PROGRAMS.items():
        with tempfile.TemporaryDirectory() as folder:
            cold, warm = program_seconds(program, folder), program_seconds(program, folder)
        print(f"{name:22} {cold:16.2f} {warm:16.2f}")


if __name__ == "__main__":
    main()
