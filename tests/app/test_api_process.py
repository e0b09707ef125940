"""`stayput app` as a process of its own: its address, its memory, its end; and the files of its page."""

from __future__ import annotations

import json
import re
import signal
import socket
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urljoin

import httpx
import pytest
from serving import COMPILING, SCENE

from long_cases import long
from stayput.app.server import address_of, bind, own_addresses, warning_of, words
from stayput.catalogue import LANGUAGES
from stayput.errors import InputError
from waiting import PATIENCE, wait_until

if TYPE_CHECKING:
    from collections.abc import Generator


APP = Path(__file__).parents[2] / "src/stayput/app"
PAGE = APP / "page"
RECORD = "1\n-1\n0\n2\n" * 500
GIVEN = {"unit": "gal", "dt": "0.01"}
STATUS = Path("/proc/self/status")
START = "from stayput.cli import main; main()"


@contextmanager
def process(*options: str) -> Generator[tuple[str, subprocess.Popen[str]]]:
    """Start the server as a process; give its address and it."""
    command_line = [sys.executable, "-c", START, "app", "--port", "0", "--no-browser", *options]
    pipe = subprocess.PIPE
    with subprocess.Popen(command_line, stdout=pipe, stderr=pipe, text=True) as started:
        try:
            assert started.stdout is not None
            found = re.search(r"http://127\.0\.0\.1:\d+", started.stdout.readline())
            assert found
            yield found[0], started
        finally:
            started.kill()


def client_at(address: str) -> httpx.Client:
    return httpx.Client(base_url=address, trust_env=False, timeout=COMPILING)


def memory(pid: int) -> float:
    """Resident memory of a process [MiB]."""
    text = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    found = re.search(r"VmRSS:\s+(\d+) kB", text)
    assert found
    return int(found[1]) / 1024


def test_it_prints_its_address_warns_and_ends_quietly_on_an_interrupt() -> None:
    scene = {**SCENE, "uncertainty": {"samples": 2000}}
    with process("--host", "0.0.0.0") as (address, started):
        with client_at(address) as client:
            place = client.post("/api/v1/verify", json={"scene": scene}).headers["location"]
            wait_until(lambda: client.get(place).json()["done"] > 0)
        started.send_signal(signal.SIGINT)
        _, told = started.communicate(timeout=PATIENCE)
    assert started.returncode in (0, -signal.SIGINT)
    (warning,) = told.splitlines()
    assert warning.startswith("Warning: other machines can reach stayput")
    assert address.rpartition(":")[2] in warning


@pytest.mark.parametrize("by_llvm", [False, *long(True)])  # for which Numba takes half a minute before
def test_it_ends_quietly_while_it_compiles(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, by_llvm: bool
) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    with process() as (address, started):
        with client_at(address) as client:
            assert client.get("/api/v1/ping").json()["ready"] is False
        if by_llvm:
            wait_until(lambda: any(tmp_path.rglob("*.code")))  # of the first function; the others follow
        started.send_signal(signal.SIGINT)
        _, told = started.communicate(timeout=PATIENCE)
    assert (started.returncode, told) == (0, "")


@pytest.mark.long
@pytest.mark.skipif(not STATUS.exists(), reason="this system does not tell memory in /proc")
def test_memory_stays_flat() -> None:
    """Over hundreds of requests of all kinds, from four clients at once; it may grow by 20 kB for each."""
    with (
        process() as (address, started),
        httpx.Client(base_url=address, trust_env=False, timeout=COMPILING) as client,
    ):
        wait_until(lambda: client.get("/api/v1/ping").json()["ready"], every=0.1)

        def ask(number: int) -> None:
            shaking = {"builtin": "near-fault", "scale": 0.3 + 0.0001 * number}
            body = {"scene": {**SCENE, "shaking": shaking}, "measures": [{"type": "belt"}]}
            match number % 10:
                case 0 if number % 50 == 0:  # each takes a process
                    answer = client.post("/api/v1/motions", files={"file": ("a", RECORD)}, data=GIVEN)
                case 1:
                    answer = client.post("/api/v1/scenario/toml", json=body)
                case 2:
                    answer = client.get("/api/v1/presets")
                case 3:
                    answer = client.post("/api/v1/simulate", json={"scene": {}})
                case 4 | 5 | 6 | 7:
                    answer = client.get("/main.js")
                case _:
                    answer = client.post("/api/v1/simulate", json=body)
            assert answer.status_code in ((422,) if number % 10 == 3 else (200, 201, 429))

        def some(numbers: range) -> float:
            with ThreadPoolExecutor(4) as pool:
                list(pool.map(ask, numbers))
            return memory(started.pid)

        before = some(range(100))
        after = some(range(100, 600))  # a thousand would say no more, and take 3 s longer
    assert after - before < 10.0


def test_an_address_that_is_taken_is_refused() -> None:
    with bind("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        assert address_of(taken) == f"http://127.0.0.1:{port}/"
        with pytest.raises(InputError, match=f"port {port}"):
            bind("127.0.0.1", port)
    with pytest.raises(InputError, match="cannot be served"):
        bind("no such host", 0)


def test_the_loopback_needs_no_warning() -> None:
    with bind("127.0.0.1", 0) as bound:
        assert warning_of(bound) is None


def test_all_addresses_are_named_each_once() -> None:
    with bind("0.0.0.0", 0) as bound:
        port = bound.getsockname()[1]
        told = warning_of(bound)
    assert told is not None
    own = own_addresses(socket.AF_INET)
    assert len(set(own)) == len(own)
    assert not [one for one in own if one.startswith(("127.", "0."))]
    assert all(f"http://{one}:{port}/" in told for one in own)
    assert str(port) in told
    assert "password" in told


def test_one_address_is_named_as_it_is() -> None:
    """An address in a network, which the machine of the tests need not have."""

    class Bound:
        family = socket.AF_INET

        def getsockname(self) -> tuple[str, int]:
            return "192.0.2.7", 8000

    told = warning_of(Bound())  # pyright: ignore[reportArgumentType]
    assert told is not None
    assert told.count("http://") == 1
    assert "http://192.0.2.7:8000/" in told


def test_an_address_of_version_6_is_in_brackets() -> None:
    if not socket.has_ipv6:
        pytest.skip("this machine has no IPv6")
    try:
        with bind("::1", 0) as bound:
            assert address_of(bound).startswith("http://[::1]:")
    except InputError:
        pytest.skip("this machine has no IPv6 loopback")


def test_the_page_s_files_are_served_with_their_kinds(client: httpx.Client) -> None:
    kinds = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml"}
    contents = {f"/{file.name}": file.read_bytes() for file in PAGE.iterdir()}
    contents |= {f"/room/{file.name}": file.read_bytes() for file in (APP / "room_page").iterdir()}
    assert {"/index.html", "/room/index.html"} <= contents.keys()
    for path, content in contents.items():
        answer = client.get(path)
        assert answer.status_code == 200
        if path.endswith(".html"):  # with what both pages have put into it
            assert answer.text.startswith("<!DOCTYPE html>")
            assert answer.text.endswith("</html>\n")
            assert 'id="theme"' in answer.text
            assert not set("{}") & set(answer.text)
            modules = re.findall(r'<link rel="modulepreload" href="([^"]+)">', answer.text)
            assert len(modules) > 40
            assert all(client.get(urljoin(path, module)).status_code == 200 for module in modules)
            continue
        assert answer.content == content
        assert answer.headers["content-type"].startswith(kinds.get(Path(path).suffix, ""))
        assert answer.headers["cache-control"] == "no-cache"
        again = client.get(path, headers={"if-none-match": answer.headers["etag"]})
        assert again.status_code == 304
        assert again.content == b""


def test_the_words_come_in_both_languages(client: httpx.Client) -> None:
    answer = client.get("/words_table.js")
    assert answer.headers["content-type"].startswith("text/javascript")
    assert answer.headers["cache-control"] == "no-cache"
    tables = json.loads(answer.text.removeprefix("export const TABLES = ").removesuffix(";\n"))
    assert tables == {language: words(language) for language in LANGUAGES}


@pytest.mark.parametrize(
    "path",
    [
        "/../server.py",
        "/..%2fserver.py",
        "/%2e%2e/server.py",
        "/page/../../server.py",
        "//etc/passwd",
        "/__init__.py",
    ],
)
def test_no_other_file_is_served(client: httpx.Client, path: str) -> None:
    request = client.build_request("GET", "/")
    request.url = request.url.copy_with(raw_path=path.encode())
    assert client.send(request).status_code == 404
