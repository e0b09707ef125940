"""Components of two records are not put together: other stations, events, directions, or one file twice."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import stayput as sp
from record_files import cosmos, esm, jma

N = 100
WAVE = np.random.default_rng(3).normal(size=N)


def at2(title: str, wave=WAVE) -> str:
    rows = "".join(f"{a:.8f}\n" for a in wave)
    return f"PEER\n{title}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {len(wave)}, DT= .01 SEC\n{rows}"


@pytest.fixture
def read(tmp_path):
    def reader(text, name="record", **options):
        file = tmp_path / name
        file.write_text(text, encoding="utf-8")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return sp.read_motion(file, **options)

    return reader


def refused(*parts, **more):
    with pytest.raises(sp.InputError) as caught:
        sp.Motion.combine(*parts, **more)
    return caught.value


@pytest.mark.parametrize("other", ["QUAKE 1/2/99, SOUTH, 000", "QUAKE 3/4/99, NORTH, 000"])
def test_another_station_or_event_is_refused_by_both_names(read, other):
    x, y = read(at2("QUAKE 1/2/99, NORTH, 090")), read(at2(other, 2 * WAVE))
    error = refused(x, y)
    assert "x component is of 'QUAKE 1/2/99, NORTH' and the y component of" in str(error)
    assert f"'{other[:-5]}'" in str(error)
    assert error.field == "y"
    assert "x成分は「QUAKE 1/2/99, NORTH」、y成分は" in error.told("ja")


def test_each_format_states_where_and_when(read):
    files = {
        "jma": (jma(), jma().replace("INITIAL TIME = 20", "INITIAL TIME = 19")),
        "esm": (esm(), esm(STATION_CODE="OTHER")),
        "cosmos": (cosmos(), cosmos().replace("Hypocenter: ...", "Statn No: 7", 1)),
    }
    for name, (text, changed) in files.items():
        assert text != changed, name
        first, second = read(text), read(changed)
        assert first.listing.origin
        assert first.listing.origin != second.listing.origin, name


@pytest.mark.parametrize(
    ("first", "second"),
    [("000", "360"), ("NS", "N"), ("090", "270"), ("NS", "180"), ("N", "S"), ("EAST", "270"), ("H1", "H1")],
)
def test_two_of_one_direction_are_refused(read, first, second):
    parts = [read(at2(f"QUAKE, PLACE, {d}", k * WAVE)) for k, d in enumerate((first, second), 1)]
    error = refused(*parts)
    told = f"The x component points to '{first}' and the y component to '{second}'; they must be at right"
    assert str(error).startswith(told)
    assert "互いに直交" in error.told("ja")


@pytest.mark.parametrize(("first", "second"), [("000", "090"), ("NS", "EW"), ("233", "323"), ("", "090")])
def test_two_directions_of_one_record_are_not(read, first, second, recwarn):
    titles = (f"QUAKE, PLACE, {d}".removesuffix(", ") for d in (first, second))
    x, y = (read(at2(title, k * WAVE)) for k, title in enumerate(titles, 1))
    assert sp.Motion.combine(x, y).y is not None
    assert not recwarn.list


@pytest.mark.parametrize(
    ("place", "direction", "wanted", "japanese"),
    [
        ("y", "UP", "horizontal", "水平動"),
        ("z", "090", "vertical", "上下動"),
        ("z", "E", "vertical", "上下動"),
    ],
)
def test_each_component_has_its_axis(read, place, direction, wanted, japanese):
    x, other = read(at2("QUAKE, PLACE, 000")), read(at2(f"QUAKE, PLACE, {direction}", 2 * WAVE))
    error = refused(x, **{place: other})
    assert str(error) == f"The {place} component is '{direction}'; it must be {wanted}."
    assert japanese in error.told("ja")


@pytest.mark.parametrize("place", ["y", "z"])
def test_one_file_twice_is_refused(read, place):
    motion = read("".join(f"{0.01 * i:.2f} {a}\n" for i, a in enumerate(WAVE)), unit="gal")
    error = refused(motion, **{place: motion})
    assert f"x and {place} components are the same record, 'record'" in str(error)
    assert "同じ記録" in error.told("ja")
    assert sp.Motion.combine(sp.near_fault(), sp.near_fault()).y is not None  # computed, and meant


def test_files_that_do_not_say_are_warned_of(read):
    columns = [
        read("".join(f"{0.01 * i:.2f} {k * a}\n" for i, a in enumerate(WAVE)), unit="gal") for k in (1, 2)
    ]
    untold = read(at2("QUAKE, PLACE-EAST", 3 * WAVE))
    told = read(at2("QUAKE, PLACE, 000"))
    for x, y in (columns, (told, columns[1]), (told, untold)):
        with pytest.warns(sp.InputWarning, match="do not both say of which record they are") as heard:
            sp.Motion.combine(x, y)
        assert "同じ記録かどうか" in heard[0].message.told("ja")


def test_a_part_of_a_file_is_no_other_record(read, recwarn):
    station = read(jma())
    up = station.component("z")
    joined = sp.Motion.combine(station, station.component("y"), up)
    assert list(joined.components) == ["x", "y", "z"]
    assert not recwarn.list


@pytest.mark.parametrize("change", ["digits", "zeros", "unit"])
def test_one_record_in_another_writing_is_refused(read, change):
    x = read(at2("QUAKE, PLACE, 000"))
    text = {
        "digits": at2("QUAKE, PLACE, 090", np.round(WAVE, 3)),
        "zeros": at2("QUAKE, PLACE, 090", np.append(WAVE, 0.0)),
        "unit": "".join(f"{0.01 * i:.2f} {980.665 * a:.1f}\n" for i, a in enumerate(WAVE)),
    }[change]
    error = refused(x, read(text, unit="gal" if change == "unit" else None))
    assert error.code == "motion.one_record"
    assert "同じ記録" in error.told("ja")


def test_components_of_files_keep_what_they_are(read):
    heading = "t [s],N-S [gal],E-W [gal],U-D [gal]"
    files = [
        read(
            "\n".join([heading, *(f"{0.01 * i:.2f},{k * a},{a * a},{a**3}" for i, a in enumerate(WAVE))])
            + "\n"
        )
        for k in (1, 2)
    ]
    east = files[0].component("y")
    assert refused(east, files[1].component("y").scaled(3.0)).code == "motion.one_direction"
    assert refused(files[0], z=files[1].component("y")).field == "z"
    joined = sp.Motion.combine(files[0].component("x"), east, files[0].component("z"))
    assert joined.component("z").listing.labels["x"] == "U-D"
    turned = joined.rotated(0.5)
    assert turned.listing.labels == {"x": "", "z": "U-D"}
    assert turned.component("y").listing.labels == {"x": ""}


def test_the_station_is_named_before_the_time_step(read):
    other = at2("QUAKE, OTHER, 090", 2 * WAVE).replace("DT= .01", "DT= .02")
    assert refused(read(at2("QUAKE, PLACE, 000")), read(other)).code == "motion.two_records"


@pytest.mark.parametrize("title", ["KOBE,KJM,UP", "Kobe,  KJM, UP", "KOBE, KJM , UP"])
def test_blanks_and_marks_make_no_other_station(read, recwarn, title):
    joined = sp.Motion.combine(read(at2("KOBE, KJM, 000")), z=read(at2(title, 2 * WAVE)))
    assert joined.z is not None
    assert not recwarn.list


def test_the_sensors_of_a_borehole_are_called_in_each_language():
    from stayput.motion.channels import Listing

    below, above = (
        sp.Motion(
            0.01, k * WAVE, listing=Listing((label,), (False,), 0, {"x": label}, f"TST001, {place}, 2006")
        )
        for k, (label, place) in enumerate((("NS1", "borehole"), ("EW2", "surface")), 1)
    )
    error = refused(below, above)
    assert "'TST001, borehole, 2006'" in str(error)
    assert "「TST001, 地中, 2006」" in error.told("ja")
    assert "「TST001, 地表, 2006」" in error.told("ja")


def test_ground_and_floor_are_not_put_together():
    ground, floor = sp.Motion(0.01, WAVE, name="a"), sp.Motion(0.01, WAVE[::-1], name="b", floor="floor 5")
    for pair in ((ground, floor), (floor, ground)):
        error = refused(*pair)
        assert "they must be of one place" in str(error)
        assert "同じ場所の記録" in error.told("ja")
