"""The page in Chromium: reload, back, forward and shared links keep everything, or say what they lack."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
from browsing import opened

import stayput as sp
from stayput.app.messages import RefusedError
from waiting import wait_until

if TYPE_CHECKING:
    from pathlib import Path

    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

    from stayput.app.motions import Motions

LOST = ("status of 404", "status of 422")


def small_record(folder: Path, seconds: float = 20.0) -> Path:
    """Return a record of a small sensor: 20 s in steps of 20 ms, with two digits."""
    motion = sp.near_fault()
    time = np.arange(0.0, seconds, 0.02)
    values = np.interp(time, motion.time, motion.x)
    path = folder / "my town.csv"
    lines = "\n".join(f"{one:.2f}" for one in values)
    path.write_text(f"{lines}\n", encoding="utf-8")
    return path


def small_vertical(folder: Path, seconds: float = 6.0) -> Path:
    """Return the vertical record of such a sensor, whose file says what it holds."""
    motion = sp.near_fault()
    time = np.arange(0.0, seconds, 0.02)
    values = 0.5 * np.interp(time, motion.time, motion.x)
    path = folder / "up.csv"
    rows = "\n".join(f"{t:.2f},{one:.1f}" for t, one in zip(time, values, strict=True))
    path.write_text(f"# acceleration, unit: m/s²\nt,UD\n{rows}\n", encoding="utf-8")
    return path


def take_vertical(it: Opened, path: Path) -> None:
    """Drop a vertical record beside the one that is in use, and take it as its vertical component."""
    it.page.set_input_files("#file", path)
    it.simulated(it.page.get_by_role("button", name="Take it as vertical").click)
    it.kept("verticalName=up.csv")


def sent(it: Opened, path: Path) -> None:
    """Drop a record whose file does not say its unit and its time step, and say them."""
    it.page.set_input_files("#file", path)
    it.page.fill("#step", "0.02")
    it.simulated(lambda: it.page.get_by_role("button", name="Send again").click())


def forget(server: Running) -> None:
    """Let the server forget all records, once no verification needs one."""
    motions: Motions = server.app.state.service.motions

    def all_gone() -> bool:
        for name in list(motions._stored):
            with suppress(RefusedError):  # of a page that has just been closed
                motions.remove(name)
        return not motions._stored

    wait_until(all_gone)


def test_a_small_vertical_record_travels_with_the_horizontal_one(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    with opened(browser, server, "#piece=chest&inSpace=0", allowed=LOST) as it:
        sent(it, small_record(tmp_path, 6.0))
        take_vertical(it, small_vertical(tmp_path))
        it.wait("() => location.hash.includes('verticalWave=')")
        summary = it.text("#says-without"), it.text("#summary")
        address = it.page.input_value("#address")
        assert it.page.locator("#link-record").is_hidden()
    assert len(address) < 5500
    forget(server)
    with opened(browser, server, address.removeprefix(f"{server.address}/"), allowed=LOST) as it:
        assert (it.text("#says-without"), it.text("#summary")) == summary
        assert "Vertical component: up.csv." in it.text("#uploaded")
        assert it.page.locator("#notices").is_hidden()
        forget(server)  # while the page is open: both are sent again
        it.page.get_by_label("Height (cm)").fill("140")
        it.wait("() => document.getElementById('uploaded').textContent.includes('up.csv')")
        it.settle()
        assert it.page.locator("#notices").is_hidden()
        assert "Vertical component: up.csv." in it.text("#uploaded")


def test_a_vertical_record_that_does_not_fit_is_said_to_be_missing(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    with opened(browser, server, "#piece=chest&inSpace=0", allowed=LOST) as it:
        sent(it, small_record(tmp_path))
        take_vertical(it, small_vertical(tmp_path, 20.0))
        it.go("keep")
        assert "“up.csv” is too large for the link" in it.text("#link-record")
        address = it.page.input_value("#address")
        assert "verticalWave=" not in address
    forget(server)
    with opened(browser, server, address.removeprefix(f"{server.address}/"), allowed=LOST) as it:
        said = it.text("#notices")
        assert "“up.csv” is no longer on the server" in said
        assert said.count("without this component") == 1
        assert "my town.csv" in it.text("#uploaded")
        assert "Vertical component" not in it.text("#uploaded")


def test_back_and_forward_bring_records_and_screens_back(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    with opened(browser, server, "#piece=chest&inSpace=0", allowed=LOST) as it:
        sent(it, small_record(tmp_path))
        it.kept("dt=0.02")
        it.simulated(lambda: it.page.click("text=Without this record"))
        it.wait("() => !location.hash.includes('record=')")
        forget(server)
        it.page.go_back()
        it.page.locator("#summary", has_text="my town.csv").wait_for()
        it.settle()
        it.simulated(lambda: it.page.go_forward())
        assert "my town.csv" not in it.text("#summary")
