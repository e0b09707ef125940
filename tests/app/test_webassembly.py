"""Mechanics and floors of buildings as WebAssembly: the same bytes as natively, also in a browser."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from browsing import browser  # noqa: F401
from webassembly_calls import PLACE, Image

import stayput as sp
from stayput.building import histories
from stayput.measures import MEASURES
from stayput.measures.measure import element_rows, hold
from stayput.mechanics.columns import EVENT
from stayput.mechanics.devices.runner import devices_of, no_elements
from stayput.mechanics.engine import run_batch
from stayput.mechanics.flat import BLOCK, block_extremes
from stayput.mechanics.runner import arguments, shaking
from stayput.model.state import State
from stayput.simulation.flat_fields import case_columns
from stayput.webassembly import build, find_linker

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from playwright.sync_api import Browser

    from stayput.compiled import Entry

wasmtime = pytest.importorskip("wasmtime")
pytestmark = pytest.mark.skipif(find_linker() is None, reason="wasm-ld is not installed")

CASES = 500


@pytest.fixture(scope="module")
def kernel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("kernel") / "kernel.wasm"
    build(file)
    return file


class Runtime:
    """The module in wasmtime."""

    def __init__(self, file: Path) -> None:
        self.store = wasmtime.Store()
        module = wasmtime.Module(self.store.engine, file.read_bytes())
        assert not module.imports
        self.exports = wasmtime.Instance(self.store, module, []).exports(self.store)

    def __call__(self, name: str, *given: Any) -> None:
        base = self.exports["__heap_base"].value(self.store)
        memory, image = self.exports["memory"], Image(base)
        numbers = [number for _, number in image.call(given)]
        missing = base + image.size - memory.data_len(self.store)
        if missing > 0:
            memory.grow(self.store, -(-missing // 65536))
        memory.write(self.store, image.content(), base)
        assert self.exports[name](self.store, *numbers) == 0
        image.read_back(bytes(memory.read(self.store, base, base + image.size)))


@pytest.fixture(scope="module")
def runtime(kernel: Path) -> Runtime:
    return Runtime(kernel)


def drawn(count: int, seed: int) -> np.ndarray:
    """Return bodies of all kinds beside walls and under ceilings, or free."""
    rng = np.random.default_rng(seed)
    rows = []
    for _ in range(count):
        b, h, mu, gap, tilt = rng.uniform((0.2, 0.4, 0.1, 0.0, -0.1), (0.8, 2.0, 1.0, 0.2, 0.1))
        wall = sp.Wall(gap + 0.3, rng.uniform(), rng.uniform()) if rng.random() < 0.5 else None
        ceiling = sp.Ceiling(2.4) if rng.random() < 0.2 else None
        floor = sp.Floor(mu, 0.8 * mu, normal_restitution=rng.choice([0.0, 0.3]))
        offset = rng.uniform(-0.1, 0.1) * b, rng.uniform(-0.1, 0.1) * h
        body = sp.Body(b, h, 100.0, cg_offset=offset, base_heights=(0.0, rng.choice([0.0, -0.003])))
        start = State(tilt=tilt) if rng.random() < 0.5 else State()
        rows.append(case_columns(body, sp.Room(floor, right_wall=wall, ceiling=ceiling), start, 9.80665))
    cases = np.concatenate(rows)
    cases["scale"] = rng.uniform(0.02, 1.2, count)
    return cases


def held_cases() -> tuple[np.ndarray, np.ndarray]:
    """Return a bookcase with each measure that has devices."""
    room = sp.Room(left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
    cases, elements = [], []
    for measure in MEASURES.values():
        held = hold(sp.Body(0.4, 1.8, 120.0), room, (measure(),))
        rows = element_rows(held)
        if len(rows):
            elements.append(rows)
            cases.append(case_columns(held.body, held.room, State(), 9.80665))
    most = max(map(len, elements))
    padded = no_elements(most, len(elements))
    for row, given in zip(padded, elements, strict=True):
        row[: len(given)] = given
    return np.concatenate(cases), padded


def test_load_extremes_are_the_same_bytes(runtime: Runtime) -> None:
    values = sp.near_fault().x.copy()
    blocks = -(-(len(values) - 1) // BLOCK)
    native, there = np.zeros((2, blocks)), np.zeros((2, blocks))
    block_extremes(values, *native)
    low, high = there[0].copy(), there[1].copy()
    runtime("block_extremes", values, low, high)
    assert low.tobytes() + high.tobytes() == native.tobytes()


@pytest.mark.parametrize("law", [0, 1], ids=["coulomb", "paper"])
def test_bare_bodies_have_the_same_bytes(runtime: Runtime, law: int) -> None:
    motion, cases = sp.near_fault(), drawn(CASES, 1)
    floor = shaking(motion.x, motion.z, motion.dt, law)
    native, there = (arguments(cases, None, floor, max_events=20_000) for _ in range(2))
    run_batch(*native)
    runtime("run_bare", *there)
    assert len(np.unique(native.results["outcome"])) >= 4
    assert there.results.tobytes() == native.results.tobytes()


def test_held_bodies_have_the_same_bytes(runtime: Runtime) -> None:
    motion = sp.near_fault()
    floor, (cases, elements) = shaking(motion.x, motion.z, motion.dt, 0), held_cases()
    assert len(cases) >= 5
    batches = [arguments(cases, devices_of(elements, floor), floor) for _ in range(2)]
    native, there = batches
    run_batch(*native)
    runtime("run_held", *there)
    assert there.results.tobytes() == native.results.tobytes()
    assert there.held is not None
    assert native.held is not None
    assert there.held.devices.tobytes() == native.held.devices.tobytes()


def test_a_history_has_the_same_bytes(runtime: Runtime) -> None:
    floor = shaking(sp.near_fault().x, None, sp.near_fault().dt, 0)
    native, there = (arguments(drawn(1, 3), None, floor, records=True) for _ in range(2))
    few = np.zeros((2, 1000, EVENT))  # room for a million events would have to be copied
    native = native._replace(output=native.output._replace(events=few[0]))
    there = there._replace(output=there.output._replace(events=few[1]))
    run_batch(*native)
    runtime("run_bare", *there)
    for name in ("history", "events"):
        assert getattr(there.output, name).tobytes() == getattr(native.output, name).tobytes()
    assert native.output.history.any()


@pytest.mark.parametrize("yields", [False, True], ids=["linear", "yielding"])
def test_floors_of_a_building_have_the_same_bytes(
    runtime: Runtime, monkeypatch: pytest.MonkeyPatch, yields: bool
) -> None:
    called: list[str] = []

    def twice(entry: Entry) -> Callable[..., None]:
        def call(*given: Any) -> None:
            there = [part.copy() if isinstance(part, np.ndarray) else part for part in given]
            entry(*given)
            runtime(entry.__name__, *there)
            for part, other in zip(given, there, strict=True):
                if isinstance(part, np.ndarray):
                    assert part.tobytes() == other.tobytes()
            called.append(entry.__name__)

        return call

    for name in ("fill_step", "linear_histories", "yielding_histories"):
        monkeypatch.setattr(histories, name, twice(getattr(histories, name)))
    sp.Building(8, nonlinear=yields).respond(sp.near_fault().component("x"))
    assert called == ["fill_step", "yielding_histories" if yields else "linear_histories"]


CALL = """
async ([module, content, name, given]) => {
  PLACE
  const status = instance.exports[name](...numbers);
  const after = new Uint8Array(memory.buffer, base.value, image.length);
  let text = "";
  for (const byte of after) text += String.fromCharCode(byte);
  return [status, btoa(text)];
}
""".replace("PLACE", PLACE)


@pytest.mark.parametrize("held", [False, True], ids=["bare", "held"])
def test_a_browser_gives_the_same_bytes(
    kernel: Path,
    runtime: Runtime,
    browser: Browser,  # noqa: F811
    held: bool,
) -> None:
    motion = sp.near_fault()
    floor = shaking(motion.x, None, motion.dt, 0)
    cases, elements = held_cases() if held else (drawn(20, 2), None)
    native, there = (
        arguments(cases, None if elements is None else devices_of(elements, floor), floor) for _ in range(2)
    )
    run_batch(*native)
    image = Image(runtime.exports["__heap_base"].value(runtime.store))
    given = [(kind, None if number == np.inf else number) for kind, number in image.call(there)]
    module, content = (base64.b64encode(part).decode() for part in (kernel.read_bytes(), image.content()))
    page = browser.new_page()
    status, memory = page.evaluate(CALL, [module, content, "run_held" if held else "run_bare", given])
    page.close()
    assert status == 0
    image.read_back(base64.b64decode(memory))
    assert there.results.tobytes() == native.results.tobytes()
