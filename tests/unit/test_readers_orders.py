"""Orders of columns and units with factors that are not understood are refused, never guessed."""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp

TIME = 0.02 * np.arange(200)
WAVE = np.sin(6.0 * TIME)


def four(path, above):
    rows = (f"{t:.2f},{10 * a:.3f},{300 * a:.3f},{200 * a:.3f}" for t, a in zip(TIME, WAVE, strict=True))
    path.write_text("\n".join([*above, *rows]) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "above",
    [
        ["# 列：時間、上下、南北、東西"],
        ["# Order: Z N E"],
        ["# channel order: V, L, T"],
        ["# component order: UD / NS / EW"],
        ["# 1列目：時間、2列目：上下、3列目：南北、4列目：東西"],
        ["# 1: time (s) 2: UD (gal) 3: NS (gal) 4: EW (gal)"],
        ["# 1) time", "# 2) UD", "# 3) NS", "# 4) EW"],
        ["# time -> UD -> NS -> EW"],
        ["Station ABC  Channels V NS EW"],
    ],
)
def test_a_vertical_that_is_named_is_read_or_refused(tmp_path, above):
    file = four(tmp_path / "it.csv", above)
    try:
        motion = sp.read_motion(file, unit="gal")
    except sp.InputError as error:
        refusal = error
    else:
        assert np.abs(motion.z).max() == pytest.approx(0.1, rel=1e-3)
        return
    assert "columns" in str(refusal)
    assert "列" in refusal.told("ja")


@pytest.mark.parametrize(
    "above", [["# Lat 35.1 N, Lon 139.2 E, Version V2"], ["# x, y and z in gal"], ["# a title"]]
)
def test_other_comments_say_nothing_of_the_order(tmp_path, above):
    assert sp.read_motion(four(tmp_path / "it.csv", above), unit="gal").pga == pytest.approx(0.1, rel=1e-3)


@pytest.mark.parametrize(
    ("headings", "vertical"),
    [
        ("時間[s],鉛直方向[gal],水平1[gal],水平2[gal]", True),
        ("時間[s],垂直[gal],NS[gal],EW[gal]", True),
        ("時間[s],縦揺れ[gal],横揺れ1[gal],横揺れ2[gal]", True),
        ("时间[s],垂直[gal],南北[gal],东西[gal]", True),
        ("time[s],αβγ[gal],δεζ[gal],ηθι[gal]", False),
    ],
)
def test_headings_in_other_scripts_are_known_or_refused(tmp_path, headings, vertical):
    file = four(tmp_path / "it.csv", [headings])
    if vertical:
        assert np.abs(sp.read_motion(file).z).max() == pytest.approx(0.1, rel=1e-3)
    else:
        with pytest.raises(sp.InputError, match="must be named once"):
            sp.read_motion(file)


@pytest.mark.parametrize(
    "heading",
    [
        "加速度(0.1gal)",
        "acc (0.1 gal)",
        "acc (100 gal)",
        "acc [10 gal]",
        "acc [g x1000]",
        "acc [10-3 g]",
        "acc (10^-2 m/s2)",
        "acc (x10^-2 m/s2)",
        "acc [G (X 1000)]",
    ],
)
@pytest.mark.parametrize("unit", [None, "g"])
def test_a_unit_with_a_factor_is_refused(tmp_path, heading, unit):
    file = tmp_path / "it.csv"
    rows = (f"{t:.2f},{a:.4f}" for t, a in zip(TIME, WAVE, strict=True))
    file.write_text("\n".join([f"time (s),{heading}", *rows]) + "\n", encoding="utf-8")
    with pytest.raises(sp.InputError, match="without one") as refused:
        sp.read_motion(file, unit=unit)
    assert "倍率" in refused.value.told("ja")


@pytest.mark.parametrize(
    "heading", ["acc (m/s2)", "acc [cm s-2]", "acc (ch 1) [gal]", "Sensor 2 acc (gal)", "acc (cm/s^2)"]
)
def test_figures_of_a_unit_or_a_sensor_are_no_factor(tmp_path, heading):
    file = tmp_path / "it.csv"
    rows = (f"{t:.2f},{a:.4f}" for t, a in zip(TIME, WAVE, strict=True))
    file.write_text("\n".join([f"time (s),{heading}", *rows]) + "\n", encoding="utf-8")
    assert sp.read_motion(file).pga in (pytest.approx(1.0, rel=1e-3), pytest.approx(0.01, rel=1e-3))


def test_ground_and_floor_are_not_put_together():
    ground = sp.Motion(0.01, np.sin(TIME), name="a")
    floor = sp.Motion(0.01, np.cos(TIME), name="b", floor="floor 5")
    for pair in ((ground, floor), (floor, ground)):
        with pytest.raises(sp.InputError, match="must be of the same place") as refused:
            sp.Motion.combine(*pair)
        assert "同じ場所の記録" in refused.value.told("ja")


def test_a_vertical_record_alone_is_no_motion_of_a_suite(tmp_path):
    for name, heading, factor in (("a", "UD", 1.0), ("b", "NS", 2.0)):
        rows = "".join(f"{t:.2f},{factor * a:.3f}\n" for t, a in zip(TIME, WAVE, strict=True))
        (tmp_path / f"{name}.csv").write_text(f"t,{heading} (gal)\n{rows}")
    with pytest.warns(sp.InputWarning, match=r"a\.csv \(vertical alone\)"):
        assert [motion.name for motion in sp.read_suite(tmp_path)] == ["b"]
