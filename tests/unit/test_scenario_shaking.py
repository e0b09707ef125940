"""The shaking of a scenario: intensities, suites, buildings; one motion or many."""

import numpy as np
import pytest

import stayput as sp
from stayput.scenario import Scenario


def shaking(folder, **keys):
    return Scenario.parse({"furniture": {"preset": "bookcase"}, "shaking": keys}, folder).shaking


def refused(keys, message, folder="."):
    with pytest.raises(sp.InputError, match=message):
        Scenario.parse({"furniture": {"preset": "bookcase"}, "shaking": keys}).case()


def test_an_intensity_alone_is_the_built_in_suite(tmp_path):
    table = shaking(tmp_path, intensity="6-lower")
    suite = table.motions(tmp_path)
    assert len(suite) == 40
    assert suite.synthetic
    assert suite.intensities == pytest.approx(np.full(40, 5.75), abs=1e-9)
    assert table.motion(tmp_path) == suite[0]
    assert shaking(tmp_path, intensity="6-lower", member=7).motion(tmp_path) == suite[6]


def test_a_motion_that_is_given_is_scaled_itself(tmp_path):
    table = shaking(tmp_path, builtin="near-fault", intensity=5.2)
    assert table.motion(tmp_path).intensity == pytest.approx(5.2, abs=1e-9)
    assert len(table.motions(tmp_path)) == 1


def test_family_count_and_seed(tmp_path):
    table = shaking(tmp_path, suite={"family": "subduction", "count": 3, "seed": 5}, scale=0.5)
    expected = sp.synthetic_suite("subduction", 3, 5)
    for made, given in zip(table.motions(tmp_path), expected, strict=True):
        assert np.array_equal(made.x, 0.5 * given.x)


def test_a_folder_of_records(tmp_path):
    records = tmp_path / "records"
    records.mkdir()
    for k in (1, 2):
        sp.sine(float(k), 1.0, 5.0).write(records / f"{k}.csv")
    table = shaking(tmp_path, suite="records", member=2)
    assert [motion.pga for motion in table.motions(tmp_path)] == pytest.approx([1.0, 2.0])
    assert table.motion(tmp_path).pga == pytest.approx(2.0)
    (records / "bad.csv").write_text("0.00,1\n0.01,x\n")
    with pytest.raises(sp.InputError, match=r"bad\.csv"):
        table.motions(tmp_path)


def test_a_vertical_channel_is_no_component_along_the_shaking(tmp_path):
    rows = "".join(f"{0.01 * i:.2f},{i % 7},{i % 5},{i % 3}\n" for i in range(400))
    (tmp_path / "own.csv").write_text(f"# unit: gal\nt,NS,EW,UD\n{rows}")
    with pytest.raises(
        sp.InputError, match=r"^own\.csv .*'UD' is a vertical channel; it must be a horizontal one"
    ):
        shaking(tmp_path, record="own.csv", component="UD").motion(tmp_path)
    assert list(shaking(tmp_path, record="own.csv", component="EW").motion(tmp_path).components) == [
        "x",
        "y",
        "z",
    ]
    (tmp_path / "up.csv").write_text(
        "# unit: gal\nt,UD\n" + "".join(f"{0.01 * i:.2f},{i % 3}\n" for i in range(400))
    )
    with pytest.warns(sp.InputWarning, match="a vertical channel alone"):
        assert shaking(tmp_path, record="up.csv").motion(tmp_path).pga > 0.0


def test_the_floor_of_a_storey(tmp_path):
    keys = {"builtin": "near-fault", "scale": 0.1}
    ground = shaking(tmp_path, **keys).motion(tmp_path)
    table = shaking(tmp_path, **keys, building={"storeys": 8, "structure": "steel"}, storey=6)
    floor = table.motion(tmp_path)
    building = sp.Building(8, "steel")
    assert np.array_equal(floor.x, building.floor_motion(ground, 6).x)
    linear = sp.Building(8, "steel", nonlinear=False)
    assert floor.x == pytest.approx(linear.floor_motion(ground, 6).x, abs=1e-9)
    assert "storey 6 of 8-storey steel building" in floor.name
    first = shaking(tmp_path, **keys, building={"storeys": 8}, storey=1).motion(tmp_path)
    assert np.array_equal(first.x, ground.x)


def test_one_motion_and_many_are_the_same_floors(tmp_path):
    keys = {"intensity": 5.5, "suite": {"count": 3}, "building": {"storeys": 5}, "storey": 4}
    suite = shaking(tmp_path, **keys).motions(tmp_path)
    for number, floor in enumerate(suite, start=1):
        assert shaking(tmp_path, **keys, member=number).motion(tmp_path) == floor


def test_a_building_yields_unless_told_not_to(tmp_path):
    keys = {"builtin": "near-fault", "storey": 11}
    yields = shaking(tmp_path, **keys, building={"storeys": 10}).motion(tmp_path)
    linear = shaking(tmp_path, **keys, building={"storeys": 10, "nonlinear": False}).motion(tmp_path)
    assert yields.pga < 0.7 * linear.pga


def test_masses_of_ones_own(tmp_path):
    keys = {"building": {"masses": [2e5, 1e5], "stiffnesses": [1e8, 5e7], "damping": 0.03}, "storey": 3}
    floor = shaking(tmp_path, **keys).motion(tmp_path)
    model = sp.ShearModel([2e5, 1e5], [1e8, 5e7], 0.03)
    assert np.array_equal(floor.x, model.floor_motion(sp.near_fault(), 3).x)


def test_without_the_vertical(tmp_path):
    keys = {"intensity": 5.0, "suite": {"count": 2}, "vertical": False}
    table = shaking(tmp_path, **keys)
    assert table.motion(tmp_path).z is None
    assert all(motion.z is None for motion in table.motions(tmp_path))
    with_it = shaking(tmp_path, intensity=5.0, suite={"count": 2}).motion(tmp_path)
    assert np.array_equal(table.motion(tmp_path).x, with_it.x)  # scaled with all three components


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"intensity": "6-upper", "scale": 2.0}, r"shaking.scale is given beside shaking.intensity"),
        ({"suite": "nowhere"}, "must be a folder, or a list of files"),
        ({"member": 2}, r"shaking\.member is given without a suite"),
        ({"suite": {"count": 3}, "member": 4}, r"shaking\.member is 4; it must be between 1 and 3"),
        ({"suite": {"family": "crust"}}, r"did you mean 'crustal'"),
        ({"suite": {}, "builtin": "near-fault"}, "only one of the two must be given"),
        ({"storey": 2}, r"shaking\.storey is given without shaking\.building"),
        ({"building": {"storeys": 3}}, r"shaking\.building is given without shaking\.storey"),
        ({"building": {"storeys": 3}, "storey": 5}, r"must be a whole number from 1 to 4"),
        ({"building": {"structure": "RC"}, "storey": 1}, r"shaking\.building\.storeys is missing"),
        ({"building": {"masses": [1e5]}, "storey": 1}, r"without shaking\.building\.stiffnesses"),
        (
            {"building": {"masses": [1e5, 1e5], "stiffnesses": [1e8]}, "storey": 1},
            r"In \[shaking\.building\]",
        ),
        (
            {"building": {"masses": [1e5], "stiffnesses": [1e8], "storeys": 1}, "storey": 1},
            r"storeys is given beside shaking\.building\.masses",
        ),
        ({"intensity": "6-middle"}, r"shaking\.intensity is '6-middle'"),
    ],
)
def test_what_contradicts_itself(keys, message):
    refused(keys, message)
