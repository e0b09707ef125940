"""The page in Chromium: how strong the earthquake is by what people know of it, and records of their own."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import PHONE, opened

import stayput as sp
from real_records import MOTIONS, recorded

if TYPE_CHECKING:
    from pathlib import Path

    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

AMOUNTS = "() => /intensity \\d/.test(document.querySelector('#entry .amounts').textContent)"
"""Whether the page says what the entry amounts to."""


def test_an_earthquake_by_magnitude_and_distance(it: Opened) -> None:
    way = it.page.get_by_label("What do you know of it?")
    assert it.page.locator("#strength").is_visible()
    asked, answer = it.simulated(lambda: way.select_option("earthquake"))
    shaking = asked["scene"]["shaking"]
    assert "intensity" not in shaking
    assert shaking["earthquake"] == {
        "magnitude": 7,
        "distance": 20,
        "depth": 10,
        "kind": "crustal",
        "vs30": 300,
    }
    it.wait(AMOUNTS)
    weak = it.text("#entry .amounts")
    assert "About JMA intensity" in weak
    assert "±" in weak
    assert "Si and Midorikawa (1999)" in it.text("#entry")
    assert "not the seismic hazard at your site" in it.text("#entry")
    assert not it.page.locator("#strength").is_visible()  # another way to say it, at one time
    assert not it.page.locator("#meaning").is_visible()
    field = it.page.get_by_label("Shortest distance to the fault (km)")
    asked, nearer = it.simulated(lambda: field.fill("5"))
    assert asked["scene"]["shaking"]["earthquake"]["distance"] == 5
    assert nearer["motion"]["ground_intensity"] > answer["motion"]["ground_intensity"]
    it.wait("before => document.querySelector('#entry .amounts').textContent !== before", weak)
    it.wait(AMOUNTS)
    asked, _ = it.simulated(lambda: it.page.get_by_label("Ground", exact=True).select_option("180"))
    assert asked["scene"]["shaking"]["earthquake"]["vs30"] == 180
    field.fill("1000")
    assert "From 3 to 300 km." in it.text("#entry")  # as far as the model goes
    it.kept("entry=earthquake%3A7%3B300%3B10%3Bcrustal%3B180")
    it.page.reload()
    it.settle()
    assert field.input_value() == "300"
    asked, _ = it.simulated(lambda: way.select_option("intensity"))
    assert asked["scene"]["shaking"]["intensity"] == 6.25
    assert it.page.locator("#strength").is_visible()


def test_other_ways_to_say_it_in_japanese_on_a_phone(browser: Browser, server: Running) -> None:
    with opened(browser, server, language="ja", size=PHONE) as it:
        it.go("scene")
        way = it.page.get_by_label("揺れの強さを何で決めますか")
        asked, _ = it.simulated(lambda: way.select_option("mmi"))
        assert asked["scene"]["shaking"]["mmi"] == 8
        it.wait("() => document.querySelector('#entry .amounts').textContent.includes('震度5')")
        assert "地震危険度を示すものではありません" in it.text("#entry")
        asked, _ = it.simulated(
            lambda: it.page.get_by_label("改正メルカリ震度", exact=True).select_option("9")
        )
        assert asked["scene"]["shaking"]["mmi"] == 9
        asked, _ = it.simulated(lambda: way.select_option("pga"))
        assert asked["scene"]["shaking"]["pga"] == 4
        asked, _ = it.simulated(lambda: it.page.get_by_label("地面の最大加速度 (gal)").fill("800"))
        assert asked["scene"]["shaking"]["pga"] == 8
        asked, _ = it.simulated(lambda: way.select_option("pgv"))
        assert asked["scene"]["shaking"]["pgv"] == 0.4
        it.kept("entry=pgv%3A0.4")
        asked, _ = it.simulated(lambda: way.select_option("sa"))
        assert asked["scene"]["shaking"]["sa"] == {"period": 0.3, "value": 8}
        asked, _ = it.simulated(lambda: it.page.get_by_label("加速度応答（減衰5%） (gal)").fill("1200"))
        assert asked["scene"]["shaking"]["sa"] == {"period": 0.3, "value": 12}
        it.kept("entry=sa%3A0.3%3B12")
        it.page.reload()
        it.settle()
        assert it.page.get_by_label("加速度応答（減衰5%） (gal)").input_value() == "1200"
        wide = it.page.evaluate("() => document.documentElement.scrollWidth")
        assert wide <= PHONE["width"]


def test_a_wrong_entry_of_a_link_is_an_intensity(browser: Browser, server: Running) -> None:
    read = """async (entries) => {
      const [{ fromText }, { presets }] = await Promise.all([import("/earthquake.js"), import("/api.js")]);
      const known = await presets();
      return entries.map((entry) => fromText(entry, known));
    }"""
    wrong = ["earthquake:7", "mmi:much", "quake:3", "earthquake:7;20;10;volcanic;300"]
    with opened(browser, server, f"#piece=bookcase&entry={wrong[0]}") as it:
        assert it.page.get_by_label("What do you know of it?").input_value() == "intensity"
        assert it.page.evaluate(read, wrong) == [None] * len(wrong)
        it.simulated(lambda: it.page.get_by_label("Kind of earthquake").select_option("near-fault"))
        told = it.text("#family-about")
        assert told.startswith("Computed motions, no recordings")
        assert "in the manner of Kobe in 1995" in told


def test_a_record_is_asked_where_it_was_measured(browser: Browser, server: Running, tmp_path: Path) -> None:
    file = tmp_path / "mine.csv"
    sp.near_fault().write(file)
    with opened(browser, server) as it:
        it.simulated(lambda: it.page.get_by_label("In a building").check())
        asked, _ = it.simulated(lambda: it.page.set_input_files("#file", file))
        assert asked["scene"]["shaking"]["building"]["storeys"] == 10
        assert "Where was it measured?" in it.text("#uploaded")
        asked, _ = it.simulated(lambda: it.page.get_by_label("A floor of a building").check())
        assert "building" not in asked["scene"]["shaking"]
        assert "with no building between" in it.text("#uploaded")
        assert it.text("#summary").startswith("On the floor where it was recorded, JMA intensity")
        it.kept("onFloor=1")
        it.page.reload()
        it.settle()
        assert it.page.get_by_label("A floor of a building").is_checked()


def test_a_vertical_record_is_taken_as_one(browser: Browser, server: Running, tmp_path: Path) -> None:
    level, up = tmp_path / "level.csv", tmp_path / "up.csv"
    motion = sp.near_fault()
    motion.write(level)
    rows = "\n".join(f"{t:.4f},{a:.6g}" for t, a in zip(motion.time, 0.5 * motion.x, strict=True))
    up.write_text(f"# acceleration, unit: m/s²\nt,UD\n{rows}\n", encoding="utf-8")
    with opened(browser, server) as it:
        it.settle()
        it.page.set_input_files("#file", up)
        it.page.wait_for_selector("#uploaded [role=alert]")
        assert "holds a vertical component alone" in it.text("#uploaded")
        asked, _ = it.simulated(lambda: it.page.set_input_files("#file", level))
        assert asked["scene"]["shaking"].get("vertical") is None
        it.page.set_input_files("#file", up)
        take = it.page.get_by_role("button", name="Take it as vertical")
        asked, _ = it.simulated(take.click)
        shaking = asked["scene"]["shaking"]
        assert shaking["vertical"] != shaking["record"]
        assert "Vertical component: up.csv." in it.text("#uploaded")
        it.kept("verticalName=up.csv")
        it.page.reload()
        it.settle()
        assert "Vertical component: up.csv." in it.text("#uploaded")


def test_the_unit_that_is_asked_for_starts_at_what_the_file_mentions(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    file = tmp_path / "own.csv"
    rows = "\n".join(f"{0.01 * i:.2f},{100 * (i % 7 - 3)}" for i in range(1500))
    file.write_text(f"# accelerations in gal\n{rows}", encoding="utf-8")
    with opened(browser, server, allowed=("422",)) as it:
        it.page.set_input_files("#file", file)
        it.page.wait_for_selector("#unit")
        assert it.page.input_value("#unit") == "gal"
        assert it.page.locator("#step").count() == 0  # there is a column of times
        _, answer = it.simulated(lambda: it.page.click("text=Send again"))
        assert abs(answer["motion"]["pga_m_s2"] - 3.0) < 1e-6


@recorded
def test_files_of_one_record_are_its_components_together_and_one_after_another(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    ns, ew, up = (MOTIONS / f"jma_kobe_1995_{axis}.AT2" for axis in ("ns", "ew", "ud"))
    with opened(browser, server) as it:
        asked, answer = it.simulated(lambda: it.page.set_input_files("#file", [up, ns, ew]))
        shaking = asked["scene"]["shaking"]
        assert len({shaking[key] for key in ("record", "across", "vertical")}) == 3
        assert answer["engine"] == "space"
        assert "Component across it: jma_kobe_1995_ns.AT2." in it.text("#uploaded")
        assert "Vertical component: jma_kobe_1995_ud.AT2." in it.text("#uploaded")
        assert "JMA intensity 6.4" in it.text("#uploaded")  # of all three
        it.kept("acrossName=jma_kobe_1995_ns.AT2", "verticalName=jma_kobe_1995_ud.AT2")
        it.page.reload()
        it.settle()
        assert "Component across it: jma_kobe_1995_ns.AT2." in it.text("#uploaded")
        it.simulated(lambda: it.page.get_by_role("button", name="Without this record").click())
        for file in (ns, up, ew):
            asked, one_by_one = it.simulated(lambda file=file: it.page.set_input_files("#file", file))
        assert {"record", "across", "vertical"} <= asked["scene"]["shaking"].keys()
        for file in (ns, ew, up):
            (tmp_path / file.name).write_bytes(file.read_bytes())
        (suite,) = sp.read_suite(tmp_path)
        for run in (answer, one_by_one):
            assert run["motion"]["pga_m_s2"] == pytest.approx(suite.pga, rel=1e-3)
        for part in (
            "Component across it: jma_kobe_1995_ns.AT2.",
            "Vertical component: jma_kobe_1995_ud.AT2.",
        ):
            assert part in it.text("#uploaded")
        other = MOTIONS / "elcentro_1940_180.AT2"
        asked, _ = it.simulated(lambda: it.page.set_input_files("#file", other))
        assert not {"across", "vertical"} & asked["scene"]["shaking"].keys()  # another record
        it.simulated(lambda: it.page.set_input_files("#file", [ns, up, other]))
        assert "left out: jma_kobe" in it.text("#uploaded")
