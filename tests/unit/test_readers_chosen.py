"""Which columns of a file are a motion, lines that are passed over, decimal commas: as the caller says it."""

from __future__ import annotations

import pytest

import stayput as sp
from stayput.motion import read_motion
from stayput.motion.readers import read_vertical
from stayput.motion.readers.columns import chosen_columns

PHONE = (
    ("timestamp", "Time (ms)", "Acc X (gal)", "Acc Y (gal)", "Acc Z (gal)", "Absolute acceleration"),
    *((f"12:00:0{i}", f"{10 * i}", f"{i}.5", f"{2 * i}.5", f"{3 * i}.5", "n/a") for i in range(5)),
)
"""What an app of a phone may export: a column of words, and one that is no component."""


@pytest.fixture
def read(tmp_path):
    def reader(rows, mark=",", **options):
        file = tmp_path / "record.csv"
        text = rows if isinstance(rows, str) else "".join(f"{mark.join(row)}\n" for row in rows)
        file.write_text(text, encoding="utf-8")
        return read_motion(file, **options)

    return reader


@pytest.mark.parametrize("mark", [",", ";", "\t"])
@pytest.mark.parametrize(
    "columns",
    [
        "t=2,x=3,y=4,z=5",
        "t=Time (ms),x=Acc X (gal),y=Acc Y (gal),z=Acc Z (gal)",
        " z = acc z , y=ACC Y,x=acc  x,t=time",
        {"t": 2, "x": "3", "y": "acc y", "z": 5},
    ],
)
def test_columns_are_chosen_by_headings_or_places(read, mark, columns):
    motion = read(PHONE, mark, columns=columns)
    assert motion.dt == 0.01
    assert [values[2] for values in motion.components.values()] == pytest.approx([0.025, 0.045, 0.065])
    assert "x = Acc X, column 3, y = Acc Y, column 4, z = Acc Z, column 5" in motion.source


def test_what_is_said_of_a_column_holds_against_its_heading(read):
    motion = read(PHONE, columns="t=2,x=acc z,z=acc x")  # the phone stood upright
    assert {name: values[1] for name, values in motion.components.items()} == pytest.approx(
        {"x": 0.035, "z": 0.015}
    )


def test_without_a_column_of_time_the_step_is_given(read):
    motion = read(PHONE, columns={"x": "acc y", "y": "acc x"}, dt=0.005)
    assert motion.dt == 0.005
    assert [motion.x[1], motion.y[1]] == pytest.approx([0.025, 0.015])
    with pytest.raises(sp.InputError, match=r"dt must be given"):
        read(PHONE, columns={"x": 3})
    bare = [row[2:5] for row in PHONE[1:]]
    assert read(bare, unit="m/s²", columns={"x": 2}, dt=0.01).x[1] == 2.5


@pytest.mark.parametrize("mark", [";", "\t", " "])
def test_numbers_may_have_a_decimal_comma(read, mark):
    rows = [[f"{0.01 * i:.2f}".replace(".", ","), f"{i},5"] for i in range(4)]
    motion = read(rows, mark, unit="m/s²", decimal_comma=True)
    assert motion.dt == 0.01
    assert motion.x.tolist() == [0.5, 1.5, 2.5, 3.5]
    if mark == ";":
        with pytest.raises(sp.InputError, match=r"'0,00'; .* unless decimal_comma says") as refused:
            read(rows, mark, unit="m/s²")
        assert "decimal_commaで指定" in refused.value.told("ja")


@pytest.mark.parametrize("above", ["1;2;3\n\nstarted 12:00;;\n", "3 lines\n2 lines\n1 line\n"])
def test_lines_at_the_beginning_are_passed_over(read, above):
    text = f"{above}time;acc [g]\n0.00;0.1\n0.01;0.2\n"
    assert read(text, skip_lines=3).x == pytest.approx([0.980665, 1.96133])
    with pytest.raises(sp.InputError):
        read(text)
    synthetic = text.replace(above.split("\n")[0], "synthetic")
    assert read(synthetic, skip_lines=3).synthetic
    for count in (6, 7, 100):
        with pytest.raises(sp.InputError, match=f"skip_lines is {count}; the file must have more"):
            read(text, skip_lines=count)


@pytest.mark.parametrize(
    ("columns", "english", "japanese"),
    [
        ("x", "columns has 'x'; it must be such as", "columnsに「x」があります"),
        ("t=1", "columns has 't=1'", "columnsに「t=1」があります"),
        ("t=1,x=", "columns has 'x='", "columnsに「x=」があります"),
        ("t=1,x=1", "columns has 't=1,x=1'", "columnsに「t=1,x=1」があります"),
        ("x=1,x=2", "columns has 'x=1,x=2'", "columnsに「x=1,x=2」があります"),
        ({}, "columns has {}", "columnsに{}があります"),
        ({"x": 2.5}, "columns has {'x': 2.5}", "columnsに{'x': 2.5}があります"),
        (3, "columns has 3", "columnsに3があります"),
        ("x=1,w=2", "columns is 'w'; it must be one of 't', 'x', 'y', 'z'", "columnsが'w'になっています"),
        ("t=2,x=0", "say x='0'; each must be a column of the file", "x=「0」に当たる列"),
        ("t=2,x=7", "say x='7'", "x=「7」に当たる列"),
        ("t=2,x=Acc", "say x='Acc'", "x=「Acc」に当たる列"),
        (
            "t=2,x=acc x,y=3",
            "say y='3'; each must be a column of the file, and another one",
            "y=「3」に当たる列",
        ),
        ("t=1,x=3", "first column is headed 'timestamp'|'12:00:00'", "「12:00:00」になっていて"),
        ("t=2,x=6", "'n/a'", "「n/a」になっていて"),
    ],
)
def test_columns_that_are_refused(read, columns, english, japanese):
    with pytest.raises(sp.InputError, match=english.replace("{}", r"\{\}").replace("{'", r"\{'")) as refused:
        read(PHONE, columns=columns, unit="gal")
    assert japanese in refused.value.told("ja")


def test_a_velocity_that_is_chosen_is_refused(read):
    with pytest.raises(sp.InputError, match="is of velocity"):
        read("t;NS [cm/s];EW [gal]\n0;1;2\n0.01;3;4\n", columns="t=1,x=2")


def test_a_component_beside_columns_is_refused(read):
    with pytest.raises(sp.InputError, match="component is 'NS' beside columns") as refused:
        read(PHONE, columns="t=2,x=3", component="NS")
    assert "どちらか一方" in refused.value.told("ja")


def test_the_file_of_a_vertical_component_may_have_chosen_columns(tmp_path):
    file = tmp_path / "up.csv"
    file.write_text("".join(f"{','.join(row)}\n" for row in PHONE), encoding="utf-8")
    assert read_vertical(file, columns="t=2,x=4").x[1] == pytest.approx(0.025)
    assert read_vertical(file, columns="t=2,x=4,z=5").x[1] == pytest.approx(0.035)


def test_a_scenario_says_the_same(tmp_path):
    rows = [(";".join(row)).replace(".", ",") for row in PHONE]
    (tmp_path / "a.csv").write_text("\n".join(["by an app", *rows]), encoding="utf-8")
    shaking = {"record": "a.csv", "columns": "t=2,x=3", "skip_lines": 1, "decimal_comma": True}
    scenario = sp.Scenario.parse({"furniture": {"preset": "bookcase"}, "shaking": shaking}, tmp_path)
    assert scenario.motion().x[1] == pytest.approx(0.015)


def test_files_of_another_kind_have_no_location(read):
    with pytest.raises(
        sp.InputError, match="location is given and the file is columns of numbers"
    ) as refused:
        read("0 1\n0.01 2\n", unit="gal", location="00")
    assert "locationが指定されましたが" in refused.value.told("ja")


def test_columns_are_in_one_order_whatever_is_said_first():
    assert list(chosen_columns("z=4,x=2,t=1,y=3")) == ["t", "x", "y", "z"]
    assert chosen_columns(None) == {}
