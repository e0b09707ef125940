"""The app's server under load: pings beside heavy work, memory over many requests, times of single answers.

The server is a process of its own on two cores, the clients are on the others; twenty clients ask at once.
`python benchmarks/app.py [--seconds 10] [--cores 2]`
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from typing import TYPE_CHECKING, Any

import httpx
import numpy as np
from rich.console import Console
from rich.table import Table

if TYPE_CHECKING:
    from collections.abc import Generator

CLIENTS = 20
PAUSE = 0.2
"""Between two pings of one client [s]; twenty clients of Python would else wait for each other."""

START = "from stayput.app.server import serve; serve(port=0, browser=False)"
SCENE: dict[str, Any] = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"intensity": "6-upper", "member": 3},
}
HELD = [{"type": "l_bracket"}]
UPSTAIRS = {**SCENE, "shaking": {**SCENE["shaking"], "building": {"storeys": 20}, "storey": 20}}


@contextmanager
def served(cores: set[int]) -> Generator[tuple[str, int]]:
    """Give the address and the process number of a warm server on some of the cores."""
    own = os.sched_getaffinity(0)
    os.sched_setaffinity(0, cores)  # a process begins on the cores of its parent
    command = [sys.executable, "-c", START]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as started:
        os.sched_setaffinity(0, own - cores or own)
        try:
            assert started.stdout is not None
            found = re.search(r"http://127\.0\.0\.1:\d+", started.stdout.readline())
            assert found
            with client_of(found[0]) as client:
                while not client.get("/api/v1/ping").json()["ready"]:
                    time.sleep(0.1)
            yield found[0], started.pid
        finally:
            started.terminate()
            os.sched_setaffinity(0, own)


def client_of(address: str) -> httpx.Client:
    return httpx.Client(base_url=address, timeout=120.0, trust_env=False)


def memory(pid: int) -> float:
    """Resident memory of a process [MiB]."""
    text = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    return int(re.findall(r"VmRSS:\s+(\d+) kB", text)[0]) / 1024


def pings(address: str, seconds: float) -> np.ndarray:
    """Return the times of all pings of twenty clients [s]."""
    times: list[float] = []
    end = time.perf_counter() + seconds

    def ask() -> None:
        mine: list[float] = []
        connection = HTTPConnection(address.removeprefix("http://"), timeout=60.0)
        connection.connect()
        while time.perf_counter() < end:
            start = time.perf_counter()
            connection.request("GET", "/api/v1/ping")
            answer = connection.getresponse()
            answer.read()
            mine.append(time.perf_counter() - start)
            assert answer.status == 200
            time.sleep(PAUSE)
        connection.close()
        times.extend(mine)

    threads = [threading.Thread(target=ask) for _ in range(CLIENTS)]
    for one in threads:
        one.start()
    for one in threads:
        one.join()
    return np.array(times)


@contextmanager
def heavy(address: str) -> Generator[None]:
    """Keep two verifications and two clients that simulate at work."""
    stop = threading.Event()
    scene = {**SCENE, "uncertainty": {"samples": 2000}}
    with client_of(address) as client:
        jobs = [client.post("/api/v1/verify", json={"scene": scene}).json()["id"] for _ in range(2)]

        def simulate() -> None:
            with client_of(address) as own:
                while not stop.is_set():
                    own.post("/api/v1/simulate", json={"scene": UPSTAIRS, "measures": HELD})

        threads = [threading.Thread(target=simulate) for _ in range(2)]
        for one in threads:
            one.start()
        try:
            yield
        finally:
            stop.set()
            for one in threads:
                one.join()
            for job in jobs:
                client.delete(f"/api/v1/jobs/{job}")


def answers(address: str) -> Table:
    """Return the times of single answers of a warm server."""
    table = Table(title="One answer at a time", title_justify="left")
    for heading in ("what", "median [ms]", "largest [ms]", "size [kB]"):
        table.add_column(heading, justify="right")
    asked: list[tuple[str, str, dict[str, Any] | None]] = [
        ("the page", "/", None),
        ("presets", "/api/v1/presets", None),
        ("simulate, without and with", "/api/v1/simulate", {"scene": SCENE, "measures": HELD}),
        ("the same on the 20th floor", "/api/v1/simulate", {"scene": UPSTAIRS, "measures": HELD}),
    ]
    with client_of(address) as client:
        for name, path, body in asked:
            times = []
            for _ in range(10):
                start = time.perf_counter()
                answer = client.get(path) if body is None else client.post(path, json=body)
                times.append(1e3 * (time.perf_counter() - start))
                answer.raise_for_status()
            size = len(answer.content) / 1e3
            table.add_row(name, f"{np.median(times):.1f}", f"{max(times):.1f}", f"{size:.0f}")
    return table


def under_load(address: str, seconds: float) -> Table:
    """Return how long pings take, on an idle server and beside heavy work."""
    table = Table(title=f"Pings of {CLIENTS} clients", title_justify="left")
    for heading in ("server", "pings", "median [ms]", "99 % [ms]", "largest [ms]"):
        table.add_column(heading, justify="right")

    def row(name: str, times: np.ndarray) -> None:
        ms = 1e3 * times
        middle, most = np.quantile(ms, [0.5, 0.99])
        table.add_row(name, f"{len(ms):,}", f"{middle:.1f}", f"{most:.1f}", f"{ms.max():.1f}")

    row("idle", pings(address, seconds))
    with heavy(address):
        row("2 verifications, 2 simulating", pings(address, seconds))
    return table


def over_requests(address: str, pid: int, count: int) -> Table:
    """Return the server's memory over many requests."""
    table = Table(title="Memory of the server", title_justify="left")
    for heading in ("requests", "memory [MiB]"):
        table.add_column(heading, justify="right")
    with client_of(address) as client:
        for number in range(count + 1):
            if number % (count // 5) == 0:
                table.add_row(f"{number:,}", f"{memory(pid):.1f}")
            scene = {**SCENE, "shaking": {"intensity": 4.0 + 0.003 * number, "member": 3}}
            client.post("/api/v1/simulate", json={"scene": scene, "measures": HELD}).raise_for_status()
    return table


def main() -> None:
    """Run everything."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0, help="how long pings are sent")
    parser.add_argument("--cores", type=int, default=2, help="on how many cores the server is")
    given = parser.parse_args()
    console = Console(width=100)
    with served(set(sorted(os.sched_getaffinity(0))[: given.cores])) as (address, pid):
        console.print(answers(address))
        console.print(under_load(address, given.seconds))
        console.print(over_requests(address, pid, 1000))


if __name__ == "__main__":
    main()
