"""Which columns of a file are a motion, as the caller says it."""

from __future__ import annotations

import pytest

import stayput as sp
from stayput.motion.readers import read_shaking
from stayput.motion.readers.columns import chosen_columns

PHONE = (
    ("timestamp", "Time (ms)", "Acc X (gal)", "Acc Y (gal)", "Acc Z (gal)", "Absolute acceleration"),
    *((f"12:00:0{i}", f"{10 * i}", f"{i}.5", f"{2 * i}.5", f"{3 * i}.5", "n/a") for i in range(5)),
)
"""What an app of a phone may export: a column of words, and one that is no component."""


def phone(mark: str = ",") -> str:
    return "".join(f"{mark.join(row)}\n" for row in PHONE)


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
    motion, _ = read(phone(mark), columns=columns)
    assert motion.dt == 0.01
    assert [values[2] for values in motion.components.values()] == pytest.approx([0.025, 0.045, 0.065])
    assert "x = Acc X, column 3, y = Acc Y, column 4, z = Acc Z, column 5" in motion.source


def test_what_is_said_of_a_column_holds_against_its_heading(read):
    motion, _ = read(phone(), columns="t=2,x=acc z,z=acc x")  # the phone stood upright
    assert (motion.x[1], motion.z[1]) == pytest.approx((0.035, 0.015))


def test_without_a_column_of_time_the_step_is_given(read, refusal):
    motion, _ = read(phone(), columns={"x": "acc y", "y": "acc x"}, dt=0.005)
    assert (motion.dt, motion.x[1], motion.y[1]) == pytest.approx((0.005, 0.025, 0.015))
    assert "dt must be given" in str(refusal(phone(), columns={"x": 3}))
    bare = "".join(f"{','.join(row[2:5])}\n" for row in PHONE[1:])
    assert read(bare, unit="m/s²", columns={"x": 2}, dt=0.01)[0].x[1] == 2.5


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        ("x", "columns has 'x'; it must be such as"),
        ("t=1", "columns has 't=1'"),
        ("t=1,x=", "columns has 'x='"),
        ("t=1,x=1", "columns has 't=1,x=1'"),
        ("x=1,x=2", "columns has 'x=1,x=2'"),
        ({}, "columns has {}"),
        ({"x": 2.5}, "columns has {'x': 2.5}"),
        (3, "columns has 3"),
        ("x=1,w=2", "columns is 'w'; it must be one of 't', 'x', 'y', 'z'"),
        ("t=2,x=0", "say x='0'; each must be a column of the file"),
        ("t=2,x=7", "say x='7'"),
        ("t=2,x=Acc", "say x='Acc'"),
        ("t=2,x=acc x,y=3", "say y='3'; each must be a column of the file, and another one"),
        ("t=1,x=3", "'12:00:00'"),
        ("t=2,x=6", "'n/a'"),
    ],
)
def test_columns_that_are_refused(refusal, columns, message):
    assert message in str(refusal(phone(), columns=columns, unit="gal"))


def test_what_a_chosen_column_is_none_the_less(refusal):
    velocity = refusal("t;NS [cm/s];EW [gal]\n0;1;2\n0.01;3;4\n", columns="t=1,x=2")
    assert "is of velocity" in str(velocity)
    assert "component is given beside columns" in str(refusal(phone(), columns="t=2,x=3", component="NS"))
    proposed = refusal("t,z (gal),x (gal),y (gal),foo (gal)\n0,1,2,3,4\n0.01,1,2,3,4\n")
    assert "unless columns says which they are (t=1,x=3,y=4,z=2)," in str(proposed)


def test_the_file_of_a_vertical_component_may_have_chosen_columns(tmp_path):
    file = tmp_path / "up.csv"
    file.write_text(phone(), encoding="utf-8")
    assert read_shaking(file, columns="t=2,x=4", vertical=True).x[1] == pytest.approx(0.025)
    assert read_shaking(file, columns="t=2,x=4,z=5", vertical=True).x[1] == pytest.approx(0.035)


def test_a_scenario_says_the_same(tmp_path):
    text = phone(";").replace(".", ",")
    (tmp_path / "a.csv").write_text(f"by an app\n{text}", encoding="utf-8")
    shaking = {"record": "a.csv", "columns": "t=2,x=3", "skip_lines": 1, "decimal_comma": True}
    scenario = sp.Scenario.parse({"furniture": {"preset": "bookcase"}, "shaking": shaking}, tmp_path)
    assert scenario.motion().x[1] == pytest.approx(0.015)


def test_columns_are_in_one_order_whatever_is_said_first():
    assert list(chosen_columns("z=4,x=2,t=1,y=3")) == ["t", "x", "y", "z"]
    assert chosen_columns(None) == {}
