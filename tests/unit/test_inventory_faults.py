"""Assessments that are killed, that meet a full disk, or whose files are broken: same bytes in the end."""

from __future__ import annotations

import contextlib
import errno
import os
import random
import shutil
import signal
import sqlite3
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from forks import start
from inventories import city, digests, pieces, table

import stayput as sp
from long_cases import long
from stayput.execution import Pool
from stayput.inventory import assess
from stayput.inventory.folder import OWN, Workspace, entries
from stayput.inventory.store import Store
from stayput.inventory.work import Work

pytestmark = pytest.mark.skipif(os.name != "posix", reason="kill -9 is of POSIX")

PIECES, DIFFERENT = 60, 30


def slowly(inventory: Path, scenario: Path, out: Path) -> None:
    """Assess in many small steps, each of which leaves files."""
    from stayput.inventory import plan, work

    plan.ROWS_PER_PART, work.SECONDS, work.SAVE_AFTER = 20, 0.01, 0.0
    assess(inventory, scenario, out, threads=2, progress=False)


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("inputs")
    return table(folder, pieces(PIECES, DIFFERENT)), city(folder)


@pytest.fixture(scope="module")
def seconds(inputs, tmp_path_factory):
    """How long a child takes that nobody kills."""
    child = start(slowly, *inputs, tmp_path_factory.mktemp("whole") / "out")
    began = time.monotonic()
    child.join()
    assert child.exitcode == 0
    return time.monotonic() - began


def in_small_parts(patch):
    patch.setattr("stayput.inventory.plan.ROWS_PER_PART", 20)
    patch.setattr("stayput.inventory.work.SECONDS", 0.05)
    patch.setattr("stayput.inventory.work.SAVE_AFTER", 0.0)


@pytest.fixture
def small_parts(monkeypatch):
    in_small_parts(monkeypatch)


@pytest.fixture(scope="module")
def finished(inputs, tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        in_small_parts(patch)
        return assess(*inputs, tmp_path_factory.mktemp("finished") / "out", progress=False)


@pytest.fixture(scope="module")
def expected(finished):
    return digests(finished.folder)


@pytest.fixture
def done(finished, small_parts, tmp_path):
    """A copy of the folder of an assessment that is complete."""
    return shutil.copytree(finished.folder, tmp_path / "out")


def check(out: Path, expected: dict[str, str]) -> None:
    """None lost, none twice, all bytes the same, nothing else in the folder."""
    assert digests(out) == expected
    rows = [
        row for part in sorted((out / "pieces").iterdir()) for row in pq.read_table(part)["row"].to_pylist()
    ]
    assert rows == list(range(2, PIECES + 2))
    assert not list((out / "work" / "drafts").iterdir())
    assert all(OWN.fullmatch(entry) for entry in entries(out))


@pytest.mark.processes
@pytest.mark.parametrize("seed", [0, *long(*range(1, 10))])
def test_a_killed_command_goes_on(inputs, seconds, expected, small_parts, tmp_path, seed):
    """Killed at any time; one that happens to be done by then is no harm."""
    rng = random.Random(seed)
    out = tmp_path / "out"
    for _ in range(2):
        child = start(slowly, *inputs, out)
        child.join(rng.uniform(0.05, 0.9) * seconds)
        with contextlib.suppress(ProcessLookupError):
            os.kill(child.pid, rng.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGINT]))
        child.join()
    assess(*inputs, out, progress=False)
    check(out, expected)


class Full:
    """A disk that takes so many bytes."""

    def __init__(self, room: int) -> None:
        self.room = room

    def wrap(self, file):
        disk, write = self, file.write

        class Limited:
            def __getattr__(self, name):
                return getattr(file, name)

            def write(self, content):
                disk.room -= len(content)
                if disk.room < 0:
                    write(content[: len(content) // 2])
                    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
                return write(content)

        return Limited()


@pytest.mark.parametrize("room", [9000, *long(0, 500, 3000, 20_000, 40_000)])
def test_a_full_disk_is_said_and_gone_on_from(inputs, expected, small_parts, tmp_path, monkeypatch, room):
    disk, real = Full(room), Workspace.durable

    @contextlib.contextmanager
    def limited(self, path):
        with real(self, path) as file:
            yield disk.wrap(file)

    with monkeypatch.context() as patch:
        patch.setattr(Workspace, "durable", limited)
        with pytest.raises(sp.InputError, match="no space left"):
            assess(*inputs, tmp_path / "out", progress=False)
    assess(*inputs, tmp_path / "out", progress=False)
    check(tmp_path / "out", expected)


def _cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-100])


def _flip(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)


def _empty(path: Path) -> None:
    path.write_bytes(b"")


def _of_another(path: Path) -> None:
    shutil.copy(sorted(path.parent.iterdir())[-1], path)


@pytest.mark.parametrize("breaks", [_cut, _flip, _empty, _of_another, Path.unlink])
def test_a_broken_part_is_made_again(inputs, expected, done, breaks):
    breaks(done / "pieces" / "part-000001.parquet")
    assert assess(*inputs, done, progress=False).runs == 0
    check(done, expected)


def _garble(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[4096:8192] = random.Random(1).randbytes(4096)
    path.write_bytes(content)


def _rename_columns(path: Path) -> None:
    path.unlink()
    with contextlib.closing(sqlite3.connect(path)) as base, base:
        base.execute("CREATE TABLE outcomes (place INTEGER PRIMARY KEY, record BLOB)")


def _shorten_records(path: Path) -> None:
    with contextlib.closing(sqlite3.connect(path)) as base, base:
        base.execute("UPDATE outcomes SET record = substr(record, 2) WHERE number = 3")


def _damage_a_record(path: Path) -> None:
    """As where the end of the file is cut off: SQLite reads zeros there."""
    with contextlib.closing(sqlite3.connect(path)) as base, base:
        base.execute("UPDATE outcomes SET record = zeroblob(length(record)) WHERE number = 3")


@pytest.mark.parametrize(
    "breaks", [_cut, _empty, Path.unlink, _garble, _rename_columns, _shorten_records, _damage_a_record]
)
def test_outcomes_that_are_lost_are_simulated_again(inputs, expected, finished, done, breaks):
    breaks(done / "work" / "outcomes.sqlite")
    shutil.rmtree(done / "pieces")
    runs = assess(*inputs, done, progress=False).runs
    assert runs == finished.runs or breaks is _cut  # of what was cut off nothing may have been needed
    check(done, expected)


def test_the_rest_of_a_unit_is_simulated(inputs, expected, done):
    with contextlib.closing(sqlite3.connect(done / "work" / "outcomes.sqlite")) as base, base:
        base.execute("DELETE FROM outcomes WHERE number % 2 = 1")
        base.execute("DELETE FROM parts")
    assess(*inputs, done, progress=False)
    check(done, expected)


@pytest.mark.parametrize("breaks", [_cut, _empty, Path.unlink])
def test_a_broken_plan_is_made_again(inputs, expected, done, breaks):
    breaks(done / "work" / "plan.sqlite")
    assert assess(*inputs, done, progress=False).runs == 0
    check(done, expected)


def test_two_commands_are_not_in_one_folder(inputs, done):
    import fcntl

    with (done / ".lock").open("ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        with pytest.raises(sp.InputError, match="Another command"):
            assess(*inputs, done, progress=False)


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError])
@pytest.mark.parametrize(("kind", "place"), [(Work, "_store_outcome"), (Pool, "_wait"), (Pool, "_hand_in")])
def test_what_reads_the_plan_is_closed_before_it(tmp_path, monkeypatch, error, kind, place):
    """However the work ends, and while its traceback still holds all that it was doing."""
    order: list[str] = []
    units_at, close = Store.units_at, Store.close

    def watched(self, site):
        order.append("reading")
        try:
            yield from units_at(self, site)
        finally:
            order.append("read")

    def failing(self, *arguments):
        if "reading" in order:
            raise error
        return original(self, *arguments)

    original = getattr(kind, place)
    monkeypatch.setattr(Store, "units_at", watched)
    monkeypatch.setattr(Store, "close", lambda self: (order.append("closed"), close(self))[1])
    monkeypatch.setattr(kind, place, failing)
    monkeypatch.setattr("stayput.inventory.work.SECONDS", 0.0)  # a task for each unit
    file = table(tmp_path, [f"p{n},,0.{n},1.8,50" for n in range(30, 70)], "id,preset,width,height,mass")
    order.clear()
    with pytest.raises(error) as held:
        assess(file, city(tmp_path), tmp_path / "out", threads=1, progress=False)
    assert order[-3:] == ["reading", "read", "closed"]
    assert held.tb is not None
