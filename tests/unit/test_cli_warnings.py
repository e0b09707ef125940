"""What is doubtful about a record: one line on standard error, told once."""

import pytest
from commands import cli

import stayput as sp

ROWS = "".join(f"{0.01 * i:.2f} {2.0 * (i % 50 - 25) / 25:.3f}\n" for i in range(400))


@pytest.fixture
def run(tmp_path):
    """Run a command in whose arguments {} stands for the folder of files."""
    (tmp_path / "floor42.txt").write_text("# unit: m/s2\n" + ROWS)
    (tmp_path / "plain.txt").write_text("# unit: m/s2\n" + ROWS)
    (tmp_path / "scene.toml").write_text(
        '[furniture]\npreset = "bookcase"\n[shaking]\nrecord = "floor42.txt"\nstorey = 3\n'
        "[shaking.building]\nstoreys = 4\n[uncertainty]\nsamples = 4\n"
    )

    def invoke(*words):
        return cli(*(word.replace("{}", str(tmp_path)) for word in words))

    return invoke


def told(done):
    return [line for line in done.stderr.splitlines() if line.startswith("Warning: ")]


def test_a_floor_under_a_building_is_refused(run):
    for words in (
        ("simulate", "--motion", "{}/floor42.txt", "--building", "4,RC", "--storey", "3", "--json"),
        ("simulate", "{}/scene.toml", "--json"),
        ("verify", "{}/scene.toml", "--json"),
        ("motion", "info", "{}/floor42.txt", "--building", "4", "--json"),
    ):
        done = run(*words)
        assert done.exit_code
        said = " ".join(f"{done.exception} {done.stderr}".split())
        assert "is of floor 42, not of the ground; a building stands on the ground" in said
        (line,) = told(done)
        assert "floor42.txt (columns of numbers): The name or the header says" in line


def test_a_floor_by_itself_and_the_ground_under_a_building(run):
    assert len(told(run("simulate", "--motion", "{}/floor42.txt"))) == 1
    assert told(run("simulate", "--motion", "{}/plain.txt", "--building", "4,RC", "--storey", "3")) == []


def test_a_unit_that_is_not_known_names_the_flag_on_the_command_line(tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("time [s],acc [ug]\n" + "".join(f"{0.01 * i:.2f},{i % 3}\n" for i in range(50)))
    with pytest.raises(sp.InputError, match=r"; unit must be given as one of") as refused:
        sp.read_motion(file)
    assert refused.value.values["option"] == "unit"
    assert "対応していません" in refused.value.told("ja")
