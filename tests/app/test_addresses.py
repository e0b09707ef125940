"""A server that other machines can reach says so, and where."""

from __future__ import annotations

import re
import socket
import subprocess
import sys

from stayput.app.server import bind, own_addresses, warning_of

START = "from stayput.cli import main; main()"


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


def test_the_command_warns_on_its_error_output() -> None:
    command = [sys.executable, "-c", START, "app", "--host", "0.0.0.0", "--port", "0", "--no-browser"]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True) as started:
        try:
            assert started.stdout is not None
            assert started.stderr is not None
            port = re.search(r"127\.0\.0\.1:(\d+)/", started.stdout.readline())
            assert port
            told = started.stderr.readline()
        finally:
            started.kill()
    assert told.startswith("Warning: other machines can reach stayput")
    assert port[1] in told
