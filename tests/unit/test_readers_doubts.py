"""What is read with a warning: a channel that had to be chosen, an upper floor, another unit."""

import warnings

import numpy as np
import pytest
from test_readers_japan import jma
from test_readers_peer import at2
from test_readers_world import WAVE, cosmos, csmip_channel, esm

import stayput as sp
from stayput.errors import InputError, InputWarning, warnings_to
from stayput.motion.floors import upper_floor
from stayput.motion.readers import read_shaking, read_vertical


@pytest.fixture
def read(tmp_path):
    """Read a file; return the motion and what was told of it."""

    def reader(text, name="record.txt", **kwargs):
        file = tmp_path / name
        file.write_text(text)
        told: list[str] = []
        with warnings_to(lambda warning: told.append(str(warning))):
            motion = sp.read_motion(file, **kwargs)
        assert all(sentence.startswith(f"{name} (") and sentence.endswith(".") for sentence in told)
        return motion, told

    return reader


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
    ("text", "what"),
    [
        (jma(), "horizontal channels NS, EW and none of them was chosen; NS is taken as x"),
        ("# t, NS, EW, UD\n0 1 2 3\n0.01 4 5 6\n", "NS is taken as x"),
        (at2(title="Q, S, UP"), "a vertical channel alone, 'UP'"),
        (cosmos(label="1: Up"), "a vertical channel alone, 'Up'"),
        (esm(STREAM="HNZ"), "a vertical channel alone, 'HNZ'"),
    ],
)
def test_a_choice_that_nobody_made_is_told(read, text, what):
    _, told = read(text, unit=None if "# t" not in text else "gal")
    assert len(told) == 1
    assert what in told[0]


@pytest.mark.parametrize(
    ("text", "given"),
    [
        (jma(), {"component": "EW"}),
        ("0 1 2 3\n0.01 4 5 6\n", {"unit": "gal"}),
        ("t,x,y,z\n0,1,2,3\n0.01,4,5,6\n", {"unit": "gal"}),
        (at2(), {}),
        (esm(), {}),
        ("# acc_gal\n0 1\n0.01 2\n", {"unit": "cm/s2"}),
        ("# seismogram of a large gallery\n0 1\n0.01 2\n", {"unit": "m/s2"}),
    ],
)
def test_what_is_clear_is_read_without_a_word(read, text, given):
    assert read(text, **given)[1] == []


def test_what_stayput_writes_is_read_without_a_word(read, tmp_path):
    file = tmp_path / "record.csv"
    sp.near_fault().write(file)
    assert read(file.read_text(), name="record.csv")[1] == []


@pytest.mark.parametrize(
    "header", ["# acc_gal (band-passed), time_s", "# acceleration [cm/s²]", "# no,acc(gal)"]
)
def test_a_unit_that_the_header_does_not_mention_is_told(read, header):
    _, told = read(f"{header}\n0 0.1\n0.01 -0.2\n", unit="g")
    assert len(told) == 1
    assert "The unit is given as 'g' and the file's header mentions" in told[0]
    with pytest.raises(InputError, match="without saying that it is the unit of the acceleration"):
        read(f"{header}\n0 0.1\n0.01 -0.2\n")


def test_a_unit_that_the_header_states_is_compared_whole(read):
    for unit in ("UNITS: GAL", "UNITS = GAL", "IN UNITS OF GAL"):
        with pytest.raises(InputError, match=r"must be the one that the file states, 'GAL'"):
            read(at2(unit=unit), unit="g")
    with pytest.raises(InputError, match="'G/10'"):
        read(csmip_channel(1, "90 DEG", WAVE, unit="  (UNITS: G/10)"))


def test_a_peak_above_5_g_is_told(read):
    rows = "".join(f"{0.01 * i:.2f} {a:.3f}\n" for i, a in enumerate(WAVE))
    assert read(rows, unit="gal")[1] == []
    _, told = read(rows, unit="g")
    assert len(told) == 1
    assert f"is {np.abs(WAVE).max():.4g} g; above 5 g check the unit" in told[0]


@pytest.mark.parametrize(
    ("text", "floor"),
    [
        ("market575_1989_floor42_gal_dt0.01", "floor 42"),
        ("575 Market St, 42nd Floor", "floor 42"),
        ("Sta Chan 14: 360 Deg Location: 2nd Fl: East", "floor 2"),
        ("LOS ANGELES - 52-STORY BLDG, ROOF", "roof"),
        ("abc_roof_ns", "roof"),
        ("本庁舎12階", "floor 12"),
        ("本庁舎 屋上", "roof"),
        ("本庁舎 地下2階", ""),
        ("12階建 1階", ""),
        ("market575_1989_ground", ""),
        ("52-story office building, 1st floor", ""),
        ("10th Street, Rooftown, basement floor", ""),
        ("42nd street", ""),
    ],
)
def test_upper_floors_by_their_names(text, floor):
    assert upper_floor([text]) == floor


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("# acc_gal\n0 1\n0.01 2\n", "bldg_floor42.csv"),
        ("# acc_gal, 42nd floor\n0 1\n0.01 2\n", "a.csv"),
        (cosmos().replace("Location:", "Location: 42nd Floor: East"), "a.v2c"),
        (csmip_channel(1, "90 DEG", WAVE).replace("FAULT ZONE 14", "BLDG 3, 42ND FLOOR"), "a.v2"),
        (at2(title="QUAKE 1/2/99, 42ND FLOOR, 090"), "a.at2"),
    ],
)
def test_an_upper_floor_is_known_and_told(read, text, name):
    motion, told = read(text, name=name, unit="gal" if "acc_gal" in text else None)
    assert motion.floor == "floor 42"
    assert "recorded on floor 42" in motion.source
    assert sum("not a motion of the ground" in sentence for sentence in told) == 1
    assert motion.scaled(2.0).floor == "floor 42"
    assert sp.Motion.combine(motion).floor == "floor 42"


def test_a_floor_that_goes_through_a_building_is_refused():
    building = sp.Building(5)
    ground = sp.sine(2.0, 1.0, duration=2.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error", InputWarning)
        floor = building.floor_motion(ground, 4)
    assert (ground.floor, floor.floor) == ("", "storey 4")
    calls = (
        lambda: building.floor_motion(floor, 3),
        lambda: list(building.floor_motions([ground, floor], [3])),
        lambda: building.floor_peaks([floor]),
        lambda: building.respond(floor),
    )
    for call in calls:
        with pytest.raises(
            sp.InputError, match=r"is of storey 4, not of the ground; a building stands on the ground"
        ):
            call()


def test_vertical_components_are_read_as_such(tmp_path):
    file = tmp_path / "record"
    told: list[str] = []
    with warnings_to(lambda warning: told.append(str(warning))):
        file.write_text(jma())
        assert read_vertical(file).x[0] == pytest.approx(0.0125)
        file.write_text(at2(title="Q, S, DOWN"))
        assert read_vertical(file).x[0] == pytest.approx(-0.1 * 9.80665)
        file.write_text("1\n2\n")
        assert read_vertical(file, "gal", dt=0.01).x[1] == pytest.approx(0.02)
        file.write_text(at2(title="Q, S, 090"))
        with pytest.raises(InputError, match="The channels are 090; exactly one must be vertical"):
            read_vertical(file)
    assert told == []


def test_a_vertical_channel_beside_horizontal_ones_is_told_or_refused(read, tmp_path):
    motion, told = read(jma(), component="UD")
    assert list(motion.components) == ["x"]
    assert len(told) == 1
    assert "'UD' is a vertical channel and is taken as x" in told[0]
    assert "horizontal channels NS (channel 1), EW (channel 2)" in told[0]
    file = tmp_path / "record.txt"
    for component in ("UD", "up", "channel 3"):
        with pytest.raises(
            InputError, match=r"is a vertical channel; it must be a horizontal one: NS"
        ) as caught:
            read_shaking(file, component)
        assert caught.value.field == "component"
    with pytest.raises(InputError, match=r"^record\.txt \(JMA CSV\): .* vertical channel"):
        sp.read_suite([file], "UD")
    assert read_shaking(file, "EW").z is not None
    file.write_text(at2(title="Q, S, UP"))
    with warnings.catch_warnings():
        warnings.simplefilter("error", InputWarning)
        assert read_shaking(file, "UP").pga > 0.0  # the file has no other


def test_a_channel_is_asked_for_among_the_horizontal_ones(tmp_path):
    file = tmp_path / "array.v2"
    labels = ("90 DEG", "UP", "360 DEG", "90 DEG")
    file.write_text("".join(csmip_channel(i, label, WAVE) for i, label in enumerate(labels, start=1)))
    with pytest.raises(InputError) as caught:
        sp.read_motion(file)
    assert "one of 90 DEG (channel 1), 360 DEG (channel 3), 90 DEG (channel 4)." in str(caught.value)
