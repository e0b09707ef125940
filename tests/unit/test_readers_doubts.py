"""What is read with a warning: a channel that had to be chosen, an upper floor, another unit."""

import warnings

import numpy as np
import pytest

import stayput as sp
from record_files import WAVE, at2, cosmos, csmip_channel, esm, jma
from stayput.errors import InputError, InputWarning, warnings_to
from stayput.motion.floors import upper_floor
from stayput.motion.readers import read_shaking


def codes(warned):
    return [warning.code.removeprefix("motion.") for warning in warned]


def test_a_warning_is_one_of_python_and_names_the_line_that_called(tmp_path):
    file = tmp_path / "up.at2"
    file.write_text(at2(title="Q, S, UP"))
    with pytest.warns(InputWarning, match="vertical channel alone, 'UP'") as told:
        sp.read_motion(file)
    assert told[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error", InputWarning)
        with pytest.raises(InputWarning, match=r"^up\.at2 \(PEER AT2\): "):
            sp.read_motion(file)
        assert sp.read_motion(file, component="UP").pga > 0.0  # it was meant


def test_a_long_sentence_is_cut_in_its_middle():
    told = str(InputError(f"The name is {'x' * 5000}; it must be short."))
    assert len(told) == 600
    assert told.startswith("The name is xxx")
    assert told.endswith("; it must be short.")


@pytest.mark.parametrize(
    ("text", "given", "expected"),
    [
        (jma(), {}, ["x_chosen"]),
        ("# t, NS, EW, UD\n0 1 2 3\n0.01 4 5 6\n", {"unit": "gal"}, ["x_chosen"]),
        (cosmos(label="1: Up"), {}, ["vertical_alone"]),
        (esm(STREAM="HNZ"), {}, ["vertical_alone"]),
        ("# acc_gal (band-passed)\n0 0.1\n0.01 -0.2\n", {"unit": "g"}, ["unit_mentioned"]),
        ("# acceleration [cm/s²]\n0 0.1\n0.01 -0.2\n", {"unit": "g"}, ["unit_mentioned"]),
        ("# no,acc(gal)\n0 0.1\n0.01 -0.2\n", {"unit": "g"}, ["unit_mentioned"]),
        ("0 1\n0.01 6\n", {"unit": "g"}, ["large_peak"]),
        (jma(), {"component": "EW"}, []),
        ("t,x,y,z\n0,1,2,3\n0.01,4,5,6\n", {"unit": "gal"}, []),
        (at2(), {}, []),
        (esm(), {}, []),
        ("# acc_gal\n0 1\n0.01 2\n", {"unit": "cm/s2"}, []),
        (sp.near_fault().text(), {}, []),
    ],
)
def test_a_choice_that_nobody_made_is_told_and_nothing_else(read, text, given, expected):
    warned = read(text, **given)[1]
    assert codes(warned) == expected
    fields = {"unit_mentioned": "unit", "large_peak": "unit"}
    assert all(warning.field == fields.get(codes([warning])[0], "component") for warning in warned)


@pytest.mark.parametrize(
    ("text", "floor"),
    [
        ("market575_1989_floor42_gal_dt0.01", "floor 42"),
        ("575 Market St, 42nd Floor", "floor 42"),
        ("Sta Chan 14: 360 Deg Location: 2nd Fl: East", "floor 2"),
        ("Bldg FOURTH FLOOR", "floor 4"),
        ("Bldg LEVEL 4", "floor 4"),
        ("Bldg 3/F", "floor 3"),
        ("Bldg Fl. 3", "floor 3"),
        ("Bldg top floor", "upper floor"),
        ("LOS ANGELES - 52-STORY BLDG, ROOF", "roof"),
        ("abc_roof_ns", "roof"),
        ("本庁舎12階", "floor 12"),
        ("本庁舎 屋上", "roof"),
        ("本庁舎 地下2階", ""),
        ("12階建 1階", ""),
        ("52-story office building, 1st floor", ""),
        ("10th Street, Rooftown, basement floor", ""),
        ("ground floor", ""),
        ("Sea level", ""),
        ("basement level 2", ""),
        ("level 2 earthquake", ""),
    ],
)
def test_upper_floors_by_their_names(text, floor):
    assert upper_floor([text]) == floor


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("# unit: gal\n0 1\n0.01 2\n", "bldg_floor42.csv"),
        ("# unit: gal, 42nd floor\n0 1\n0.01 2\n", "a.csv"),
        (cosmos().replace("Location:", "Location: 42nd Floor: East"), "a.v2c"),
        (csmip_channel(1, "90 DEG").replace("FAULT ZONE 14", "BLDG 3, 42ND FLOOR"), "a.v2"),
    ],
)
def test_an_upper_floor_is_known_and_told(read, text, name):
    motion, warned = read(text, name)
    assert motion.floor == "floor 42"
    assert "recorded on floor 42" in motion.source
    assert codes(warned) == ["upper_floor"]
    assert motion.scaled(2.0).floor == sp.Motion.combine(motion).floor == "floor 42"


def test_vertical_components_are_read_as_such(tmp_path):
    file = tmp_path / "record"
    told: list[InputWarning] = []
    with warnings_to(told.append):
        for text, unit, first in (
            (jma(), None, 0.0125),
            (at2(title="Q, S, DOWN"), None, -0.1 * 9.80665),
            ("1\n2\n", "gal", 0.01),
        ):
            file.write_text(text, encoding="utf-8")
            assert read_shaking(file, unit=unit, dt=0.01, vertical=True).x[0] == pytest.approx(first)
        file.write_text(at2(title="Q, S, 090"))
        with pytest.raises(InputError, match="The channels are 090; exactly one must be vertical"):
            read_shaking(file, vertical=True)
    assert told == []


def test_a_vertical_channel_beside_horizontal_ones_is_told_or_refused(read, tmp_path):
    motion, warned = read(jma(), component="UD")
    assert list(motion.components) == ["x"]
    assert codes(warned) == ["vertical_as_x"]
    assert "horizontal channels NS (channel 1), EW (channel 2)" in str(warned[0])
    file = tmp_path / "record"
    for component in ("UD", "up", "channel 3"):
        with pytest.raises(
            InputError, match="is a vertical channel; it must be a horizontal one: NS"
        ) as caught:
            read_shaking(file, component)
        assert caught.value.field == "component"
    with pytest.raises(InputError, match=r"^record \(JMA CSV\): .* vertical channel"):
        sp.read_suite([file], "UD")
    assert read_shaking(file, "EW").z is not None
    file.write_text(at2(title="Q, S, UP"))
    assert read_shaking(file, "UP").pga > 0.0  # the file has no other


def test_a_peak_above_5_g_is_told_with_its_size(read):
    wave = 0.2 * WAVE
    rows = "".join(f"{0.01 * i:.2f} {a:.3f}\n" for i, a in enumerate(wave))
    (warning,) = read(rows, unit="g")[1]
    assert f"is {np.abs(wave).max():.4g} g; above 5 g check the unit" in str(warning)
