"""Files that are no record, the choice of a component, units, and what no reader may let pass."""

import io
import os
import re
import zipfile
from importlib.resources import files

import numpy as np
import pytest

from stayput.errors import InputError
from stayput.motion.channels import Channel, is_direction, is_vertical, motion_fields, plain_label
from stayput.motion.readers import read_motion
from stayput.motion.record import Motion
from stayput.motion.units import ACCELERATION_UNITS, unit_factor

WAVE = np.sin(np.arange(40) * 0.3)


def channel(label, size=1.0, **fields):
    return Channel(label, size * WAVE, fields.pop("dt", 0.01), **fields)


def motion_of_channels(*args):
    return Motion(**motion_fields(*args))


def test_missing_file_and_directory(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_motion(tmp_path / "no.at2")
    with pytest.raises(InputError, match="is a directory"):
        read_motion(tmp_path)
    with pytest.raises(InputError, match=r"path is 3\.5; it must be of type str"):
        read_motion(3.5)
    if hasattr(os, "mkfifo"):  # it would be waited for without end
        os.mkfifo(tmp_path / "pipe")
        with pytest.raises(InputError, match="device or a pipe"):
            read_motion(tmp_path / "pipe")
    with pytest.raises(InputError, match=r"cannot be read|no such file"):
        read_motion("a\0b")


@pytest.mark.skipif(getattr(os, "geteuid", lambda: 0)() == 0, reason="root may read every file")
def test_unreadable_file(tmp_path):
    file = tmp_path / "locked.txt"
    file.write_text("1\n2\n")
    file.chmod(0)
    with pytest.raises(InputError, match="cannot be read"):
        read_motion(file, unit="gal", dt=0.01)


def archive(name) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as file:
        file.writestr(name, "x")
    return data.getvalue()


ACCELEROGRAM = "UNCORRECTED ACCELEROGRAM DATA\n" + "a text\n" * 6


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "empty"),
        (" \r\n\t\n", "empty"),
        (b"\x00\x01\x02\x03 1 2 3", r"binary \(other formats"),
        ("1\n2\n".encode("utf-16-le"), "binary"),
        (archive("a.txt"), "archive, which is to be unpacked"),
        (b"\x1f\x8b\x08\x00\x00", "archive, which is to be unpacked"),
        (archive("xl/workbook.xml"), "sheet can be saved as CSV"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\x00", "sheet can be saved as CSV"),
        ("1 " * 6000, "A line of .* has 12,000 characters"),
        ("Dear Sir,\nplease find no numbers here.\n", "no known format"),
        ("<html><body>404</body></html>", "in the format HTML, which is not read"),
        ("2 CORRECTED ACCELEROGRAM\n*\n" + "a text\n" * 9 + "         1         2\n" * 20, "format USGS SMC"),
        (f"{ACCELEROGRAM}UNIVERSIDAD DE CHILE - RENADIC\n1 2 3\n", "format RENADIC"),
        (f"{ACCELEROGRAM}1 2 3\n1 2 3\n", "format CSMIP V1"),
        ("Uncorrected accelerogram 1 GNS Science\n1 2 3\n", "format GeoNet V1A/V2A"),
        ("1993/01/15 20:06:08   3 100 15700 X: Y\n063-GL 1 2\n1 2 3\n", "format BRI .ac"),
        ("1\n2\nx\n", r"^record \(columns of numbers\): .*'x'"),
    ],
)
def test_files_that_are_no_record(refusal, content, message):
    assert re.search(message, str(refusal(content, unit="gal", dt=0.01)))


@pytest.mark.parametrize(
    ("unit", "size"),
    [
        ("m/s²", 1.0),
        ("M/S^2", 1.0),
        ("cm/s/s", 0.01),
        ("CM/SEC/SEC", 0.01),
        ("cm/sec2", 0.01),
        ("Gals", 0.01),
        ("gal(cm/s/s)", 0.01),
        ("mm/s²", 0.001),
        (" G. ", 9.80665),
    ],
)
def test_units(unit, size):
    assert unit_factor(unit) == size


@pytest.mark.parametrize(
    "unit", ["", "counts", "m/s", "cm", "ft/s", "mgal", "g/10", "0.01 g", "G (X 1000)", "kip", 5, None]
)
def test_unknown_units(unit):
    with pytest.raises(InputError, match="must be one of m/s²"):
        unit_factor(unit)


def test_the_page_offers_every_unit():
    script = files("stayput").joinpath("app", "page", "upload.js").read_text("utf-8")
    offered = re.findall('"([^"]+)"', script[script.index("UNITS = [") :].split("]")[0])
    assert offered == list(ACCELERATION_UNITS)


def test_an_unknown_unit_or_step_is_refused_before_the_file_is_looked_at():
    with pytest.raises(InputError, match="unit of acceleration"):
        read_motion("nowhere", unit="furlong")
    with pytest.raises(InputError, match="dt is nan"):
        read_motion("nowhere", dt=float("nan"))


@pytest.mark.parametrize(
    ("label", "plain"),
    [("N-S", "NS"), ("090", "90"), (" 360 deg", "360"), ("Up", "UP"), ("000", "0"), ("HNE", "HNE")],
)
def test_labels_in_one_spelling(label, plain):
    assert plain_label(label) == plain


@pytest.mark.parametrize(
    ("labels", "vertical", "horizontal"),
    [
        (("UD", "U-D", "UD1", "Up", "V", "U", "z", "Vert.", "vertical", "DN", "UP DEG"), True, False),
        (("HNZ", "BHZ00", "HNZ.10", "00.HNZ", "acc_z", "accZ", "az", "z-axis", "acc_z_g"), True, False),
        (("Linear Acceleration z", "Acceleration Up", "Vertical component"), True, False),
        (("NS", "EW", "360", "x", "N", "HNE10", "ax", "acc_y", "L", "T", "H1", "East"), False, True),
        (("acc", "S14E1 rotated", "20 Hz", "60 deg", "a 1", "channel 2", "UNKNOWN", ""), False, False),
    ],
)
def test_names_of_directions(labels, vertical, horizontal):
    for label in labels:
        assert is_vertical(label) is vertical, label
        assert is_direction(label) is (vertical or horizontal), label


THREE = [channel("UD", 3.0), channel("EW", 2.0), channel("NS", 1.0)]


@pytest.mark.parametrize(
    ("component", "sizes"),
    [
        (None, {"x": 2.0, "y": 1.0, "z": 3.0}),
        ("EW", {"x": 2.0, "y": 1.0, "z": 3.0}),
        ("NS", {"x": 1.0, "y": 2.0, "z": 3.0}),
        ("360", {"x": 1.0, "y": 2.0, "z": 3.0}),
        (360, {"x": 1.0, "y": 2.0, "z": 3.0}),
        ("90", {"x": 2.0, "y": 1.0, "z": 3.0}),
        ("channel 3", {"x": 1.0, "y": 2.0, "z": 3.0}),
        ("UD", {"x": 3.0}),
    ],
)
def test_component_chooses_x_and_the_rest_follows(component, sizes):
    motion = motion_of_channels(THREE, component, "test")
    assert list(motion.components) == list(sizes)
    for name, size in sizes.items():
        assert motion.components[name] == pytest.approx(size * WAVE)


@pytest.mark.parametrize("component", ["45", "channel 4", "channel 0", "SN", "180", "", "NS2"])
def test_no_such_component(component):
    with pytest.raises(InputError, match=r"The component is .*; it must be one of EW \(channel 2\), NS"):
        motion_of_channels(THREE, component, "test")


def test_a_building_array_must_be_told_its_channel_and_gives_only_that():
    floors = [channel("360", 1.0), channel("90", 2.0), channel("360", 3.0), channel("UP", 4.0)]
    with pytest.raises(InputError, match="component must name one of"):
        motion_of_channels(floors, None, "test")
    with pytest.raises(InputError, match="is '360'; it must be one of 360"):
        motion_of_channels(floors, "360", "test")
    motion = motion_of_channels(floors, "channel 3", "test")
    assert motion.x == pytest.approx(3.0 * WAVE)
    assert list(motion.components) == ["x"]


def test_a_channel_that_points_down_is_turned_up():
    motion = motion_of_channels([channel("360"), channel("DOWN")], None, "test")
    assert motion.z == pytest.approx(-WAVE)
    assert "sign changed to up" in motion.source
    assert motion_of_channels([channel("DWN")], None, "test").x == pytest.approx(-WAVE)


def test_channels_that_differ_are_cut_or_refused():
    short = Channel("EW", np.ones(199), 0.01)
    motion = motion_of_channels([Channel("NS", np.ones(200), 0.01), short], None, "test")
    assert len(motion) == 199
    assert "cut to 199 samples: x from 200" in motion.source
    with pytest.raises(InputError, match="within 1 %"):
        motion_of_channels([Channel("NS", np.ones(250), 0.01), short], None, "test")
    with pytest.raises(InputError, match="must be that of x"):
        motion_of_channels([channel("NS"), channel("EW", dt=0.02)], None, "test")


def test_a_header_peak_that_the_samples_contradict_is_refused():
    peak = float(np.abs(WAVE).max())
    assert motion_of_channels([channel("NS", peak=-1.005 * peak)], None, "test").pga == pytest.approx(peak)
    with pytest.raises(InputError, match="peak acceleration"):
        motion_of_channels([channel("NS", peak=1.02 * peak)], None, "test")
    with pytest.raises(InputError, match="peak acceleration"):  # also of a channel that is not x
        motion_of_channels([channel("NS"), channel("EW", peak=2.0 * peak)], "NS", "test")


def test_name_is_the_files_own_or_its_stem():
    assert motion_of_channels([channel("NS", name="AKT013")], None, "test", "stem").name == "AKT013, NS"
    assert motion_of_channels([channel("x")], None, "test", "stem").name == "stem"
