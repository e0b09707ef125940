"""Measures in a scenario file and on the command line."""

import json
import re

import pytest
from commands import cli

import stayput as sp
from stayput.measures import MEASURES, GelMats, LBracket, TensionPole, WedgeStopper, parameters
from stayput.scenario import Scenario, read
from stayput.scenario.measures import Option

LEAST = {"furniture": {"preset": "bookcase"}}
FILE = """
[furniture]
preset = "bookcase"
[room]
left_wall = { gap = 0.02 }
ceiling = { height = 2.3 }
[[measures]]
type = "l_bracket"
strength = 1200
screws = "up"
[[measures]]
name = "stopper and pole"
combine = [{ type = "wedge_stopper" }, { type = "tension_pole", count = 3 }]
[[measures]]
type = "gel_mats"
name = "small mats"
area = 0.0009
[uncertainty]
samples = 100
seed = 7
precision = 0.05
"""


def parsed(*measures, **more):
    return Scenario.parse({**LEAST, "measures": list(measures), **more})


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "scenario.toml"
    path.write_text(FILE, encoding="utf-8")
    return path


def test_what_the_file_says_arrives(file):
    scenario = read(file)
    assert [(option.name, option.measures) for option in scenario.options] == [
        ("l_bracket", (LBracket(strength=1200.0, screws="up"),)),
        ("stopper and pole", (WedgeStopper(), TensionPole(count=3))),
        ("small mats", (GelMats(area=0.0009),)),
    ]
    told = scenario.uncertainty
    assert (told.samples, told.seed, told.precision) == (100, 7, 0.05)
    assert scenario.case().measures == ()
    assert scenario.case(scenario.options[1].measures).measures == scenario.options[1].measures


@pytest.mark.parametrize("kind", MEASURES)
def test_every_default_written_out_is_the_default(kind):
    given = {about.name: about.default for about in parameters(MEASURES[kind]) if about.default is not None}
    (found,) = parsed({"type": kind, **given}).options
    assert found == Option(kind, ((MEASURES[kind](),),))
    assert parsed({"type": kind}).options == (found,)


def test_names_that_are_not_given_are_the_types():
    both = {"combine": [{"type": "wedge_stopper"}, {"type": "tension_pole"}]}
    assert [one.name for one in parsed({"type": "belt"}, both).options] == [
        "belt",
        "wedge_stopper + tension_pole",
    ]


@pytest.mark.parametrize(
    ("measure", "message"),
    [
        (
            {"type": "gel_mat"},
            r"^measures\[0\].type is 'gel_mat' \(did you mean 'gel_mats'\?\); it must be one of",
        ),
        ({"area": 1.0}, r"^measures\[0\].type is missing; it must be one of anti_slip_sheet, "),
        ({"type": ["belt"]}, r"^measures\[0\].type is \['belt'\]; it must be one of"),
        (1.0, r"^measures\[0\] is 1.0; it must be a table with type or combine.$"),
        (
            {"type": "belt", "combine": []},
            r"^measures\[0\].type is unknown; a key of \[measures\[0\]\] must be one of name, combine",
        ),
        ({"combine": []}, r"^measures\[0\].combine is \[\]; it must be a list of 1 to 20 items"),
        ({"combine": [{"combine": []}]}, r"^measures\[0\].combine\[0\].type is missing"),
        ({"combine": [2]}, r"^measures\[0\].combine\[0\] is 2; it must be a table with type.$"),
        (
            {"type": "belt", "slak": 0.1},
            r"^measures\[0\].slak is unknown \(did you mean 'slack'\?\); a key of",
        ),
        (
            {"combine": [{"type": "tension_pole", "strength": -1.0}]},
            r"^measures\[0\].combine\[0\].strength is -1.0; it must be 'unbreakable' or a number",
        ),
        (
            {"type": "l_bracket", "count": 2.5},
            r"^measures\[0\].count is 2.5; it must be a whole number between",
        ),
        (
            {"type": "l_bracket", "screws": "left"},
            r"^measures\[0\].screws is 'left'; it must be one of 'down'",
        ),
        (
            {"type": "tension_pole", "preload": 900.0, "strength": 500.0},
            r"^In \[measures\[0\]\]: “Tension poles” preload is 900 N",
        ),
        (
            {"combine": [{"type": "gel_mats"}, {"type": "felt_glides"}]},
            r"^In \[measures\[0\]\]: Adhesive gel mats and Felt glides are given together",
        ),
    ],
)
def test_a_wrong_measure_is_refused_in_one_sentence(measure, message):
    with pytest.raises(sp.InputError, match=message) as refused:
        parsed(measure)
    assert str(refused.value).endswith(".")
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("kind", MEASURES)
def test_every_parameter_that_is_wrong_is_named(kind):
    for about in parameters(MEASURES[kind]):
        high = 2 * about.high + 1
        values = ["sideways", 1.0] if about.choices else ["0.4", True, about.low - 1, high, [1.0], {"a": 1}]
        for value in values:
            said = rf"^measures\[0\].{re.escape(about.name)} is .*; it must be .*\.$"
            with pytest.raises(sp.InputError, match=said):
                parsed({"type": kind, about.name: value})


def test_the_schema_has_every_measure_with_its_parameters_and_their_units():
    defined = Scenario.schema()["$defs"]
    for kind, measure in MEASURES.items():
        table = defined[f"{measure.__name__}Table"]["properties"]
        assert table["type"]["const"] == kind
        assert set(table) == {"type", "name", *(about.name for about in parameters(measure))}
    strength, _ = defined["BeltTable"]["properties"]["strength"]["anyOf"]
    word, number = strength["oneOf"]
    assert word["const"] == "unbreakable"
    assert number["unit"] == "N"


def test_a_measure_on_the_command_line_is_a_name_of_the_file_or_a_type(file):
    def run(*flags):
        done = cli("simulate", file, "--json", *flags)
        assert done.exit_code == 0, done.output
        return json.loads(done.output)

    assert run()["measures"] == []
    assert run("--measure", "stopper and pole")["measures"] == ["wedge_stopper", "tension_pole"]
    found = run("--measure", "ballast", "--measure", "belt")
    assert found["measures"] == ["ballast", "belt"]
    assert [device["measure"] for device in found["devices"]] == ["belt", "belt"]
