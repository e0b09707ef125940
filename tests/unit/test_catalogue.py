"""The catalogue: each sentence in two languages, and each id that the code names."""

import ast
import pickle
import re
import string
from pathlib import Path

import pytest

import stayput
from stayput.building.building import STRUCTURES
from stayput.catalogue import TEXTS, names, phrase, say
from stayput.contents.contents import CONTENTS, DOORS, DRAWERS
from stayput.errors import InputError, InputWarning, within
from stayput.model.body import FURNITURE
from stayput.model.room import SURFACES

SOURCES = sorted(Path(stayput.__file__).parent.rglob("*.py"))
SILENT = {"page.state_refused"}  # the refusal itself stands in its place
REFUSALS = ("InputError", "InputWarning")


def placeholders(text: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}


def test_both_languages_are_filled_in_from_the_same_values():
    for key, (english, japanese) in TEXTS.items():
        assert english or japanese or key in SILENT, key  # one language may need nothing between two words
        assert placeholders(japanese) <= placeholders(english), key


@pytest.fixture(scope="module")
def calls():
    """Return where each function is called by its name: the file, the name, and the call."""
    return [
        (file, getattr(node.func, "id", None) or node.func.attr, node)
        for file in SOURCES
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name | ast.Attribute)
    ]


def test_each_refusal_names_a_sentence_and_gives_its_values(calls):
    for file, called, call in calls:
        code = call.args[0] if called in REFUSALS else None
        if isinstance(code, ast.Constant):  # where it is computed, its caller's tests meet it
            given = {word.arg for word in call.keywords} | ({"name"} if len(call.args) > 1 else set())
            assert code.value in TEXTS, (file, call.lineno)
            assert None in given or placeholders(TEXTS[code.value][0]) <= given, (file, call.lineno)


def test_each_text_that_the_code_names_is_there(calls):
    """An id that is put together in the code begins like one that there is."""
    modules = {"phrase": ("",), "say": ("",), "word": ("report.", "common."), "_text": ("report.",)}
    for file, called, call in calls:
        name = call.args[0] if called in modules and call.args else None
        start = name.values[0] if isinstance(name, ast.JoinedStr) else name
        if isinstance(start, ast.Constant) and isinstance(start.value, str):
            wanted = [f"{module}{start.value}" for module in modules[called]]
            begun = start is not name and any(key.startswith(tuple(wanted)) for key in TEXTS)
            assert begun or any(key in TEXTS for key in wanted), (file, start.value)


def test_each_text_of_the_command_line_is_said():
    code = "\n".join(file.read_text(encoding="utf-8") for file in SOURCES if file.parent.name != "catalogue")
    named = {key for key in TEXTS if f'"{key}"' in code}
    by_name = {
        f"cli_help.{name}" for name in re.findall(r"\w+", code)
    }  # of a command, a heading, Typer's own
    assert {key for key in TEXTS if key.startswith("cli.")} <= named
    typers = {"cli_help.install_completion", "cli_help.show_completion"}
    assert {key for key in TEXTS if key.startswith("cli_help.")} <= named | by_name | typers


def test_an_error_tells_its_sentence_in_both_languages_and_survives_another_process():
    with pytest.raises(InputError) as caught:
        within(("The gap", "すき間"), 12.0, 0.0, 10.0, "m", field="left_wall.gap")
    error = pickle.loads(pickle.dumps(caught.value.at("room.toml")))
    assert str(error) == "room.toml: The gap is 12 m; it must be between 0 and 10 m."
    assert error.told("ja") == "room.toml：すき間が12 mになっています。0～10 mにしてください。"
    assert (error.code, error.field, error.values["value"]) == ("common.not_within", "left_wall.gap", 12.0)
    assert isinstance(pickle.loads(pickle.dumps(InputWarning("common.colon"))), InputWarning)


def test_a_value_may_itself_be_in_two_languages():
    told = phrase("common.too_large", name=("The gap", "すき間"))
    assert told[0].startswith("The gap is")
    assert told[1].startswith("すき間が")
    assert say("common.colon", "ja") == "："


@pytest.mark.parametrize(
    ("presets", "called"),
    [
        (SURFACES, names.SURFACES),
        (FURNITURE, names.FURNITURE),
        (STRUCTURES, names.STRUCTURES),
        (CONTENTS, names.CONTENTS),
        (DOORS, names.DOORS),
        (DRAWERS, names.DRAWERS),
    ],
    ids=["surfaces", "furniture", "structures", "contents", "doors", "drawers"],
)
def test_every_preset_has_a_name_in_both_languages(presets, called):
    assert set(presets) == set(called)
    assert all(english and japanese for english, japanese in called.values())
