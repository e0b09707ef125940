"""What a case costs as WebAssembly, in wasmtime and in Chromium, beside the machine code: `make wasm`.

The mixed cases of `workload`, on one core; all three give the same bytes.
"""

from __future__ import annotations

import base64
import sys
import time
from pathlib import Path

import numpy as np
import wasmtime
from playwright.sync_api import sync_playwright
from rich.console import Console
from rich.table import Table

import workload
from stayput.mechanics.engine import run_batch
from stayput.mechanics.runner import BatchArguments, arguments, shaking

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "app"))
import browsing
from webassembly_calls import PLACE, Image

import prerequisites

COUNT, REPEATS = 1000, 5
TIMED = """
async ([module, content, given, repeats]) => {
  PLACE
  let best = Infinity;
  for (let n = 0; n < repeats; n++) {
    const start = performance.now();
    instance.exports.run_bare(...numbers);
    best = Math.min(best, (performance.now() - start) / 1000);
  }
  return best;
}
""".replace("PLACE", PLACE)


def in_wasmtime(file: Path, batch: BatchArguments) -> tuple[float, int]:
    """Return the best time in wasmtime [s], and where its free memory begins."""
    store = wasmtime.Store()
    exports = wasmtime.Instance(store, wasmtime.Module(store.engine, file.read_bytes()), []).exports(store)
    base, memory = exports["__heap_base"].value(store), exports["memory"]
    image = Image(base)
    numbers = [number for _, number in image.call(batch)]
    memory.grow(store, image.size // 65536 + 1)
    memory.write(store, image.content(), base)
    best = np.inf
    for _ in range(REPEATS):
        start = time.perf_counter()
        exports["run_bare"](store, *numbers)
        best = min(best, time.perf_counter() - start)
    return float(best), base


def in_chromium(file: Path, batch: BatchArguments, base: int) -> float:
    """Return the best time in Chromium [s]."""
    image = Image(base)
    given = [(kind, None if number == np.inf else number) for kind, number in image.call(batch)]
    module, content = (base64.b64encode(part).decode() for part in (file.read_bytes(), image.content()))
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(
            executable_path=prerequisites.find_chromium(), args=browsing.FLAGS
        )
        best: float = started.new_page().evaluate(TIMED, [module, content, given, REPEATS])
        started.close()
    return best


def main() -> None:
    """Print the table."""
    file, motion = Path(sys.argv[1]), workload.record()
    floor = shaking(motion.x, None, motion.dt, 0)
    batch = arguments(workload.columns(workload.mixed(COUNT)), None, floor)
    run_batch(*batch)
    native = np.inf
    for _ in range(REPEATS):
        start = time.perf_counter()
        run_batch(*batch)
        native = min(native, time.perf_counter() - start)
    there, base = in_wasmtime(file, batch)
    table = Table(title=f"{COUNT} mixed cases, one core; {file.stat().st_size / 1024:.0f} KiB")
    for column in ("", "µs a case", "× machine code"):
        table.add_column(column, justify="right" if column else "left")
    times = {"machine code": native, "wasmtime": there, "Chromium": in_chromium(file, batch, base)}
    for name, seconds in times.items():
        table.add_row(name, f"{1e6 * seconds / COUNT:.1f}", f"{seconds / native:.2f}")
    Console().print(table)


if __name__ == "__main__":
    main()
