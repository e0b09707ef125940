"""What is known of a field stands beside it, and class, scenario, API and page say the same of it."""

from __future__ import annotations

import asyncio
import inspect
import math
from dataclasses import MISSING
from typing import TYPE_CHECKING, Any

import httpx
import pytest

import stayput as sp
from stayput.app.presets import NUMBERS
from stayput.app.server import create_app
from stayput.building.building import STRUCTURES, Building, Isolation, Structure
from stayput.building.model import ShearModel
from stayput.contents.contents import ContentsKind
from stayput.errors import InputError
from stayput.mechanics.columns import CASE
from stayput.model.body import FURNITURE, Part, Preset
from stayput.model.parameters import Parameter, check_fields, parameter_of, parameters
from stayput.model.room import Floor
from stayput.model.state import State
from stayput.motion.ground_shaking import EarthquakeSource
from stayput.motion.suites.synthesis import synthetic_suite
from stayput.scenario import Scenario
from stayput.scenario.toml import kinds

if TYPE_CHECKING:
    from collections.abc import Iterator

    from fastapi import FastAPI

NEEDED: dict[Any, dict[str, Any]] = {
    Part: {"mass": 1.0, "x": 0.0, "z": 0.5},
    sp.Body: {"width": 0.4, "height": 1.8, "mass": 100.0},
    sp.Floor: {},
    sp.Wall: {"gap": 0.1},
    sp.Ceiling: {"height": 2.4},
    sp.State: {},
    sp.Everyday: {},
    Isolation: {},
    Building: {},
    ShearModel: {"masses": [1.0], "stiffnesses": [1.0], "damping": 0.05},
    sp.Contents: {},
    sp.sine: {"amplitude": 1.0, "frequency": 1.0},
    synthetic_suite: {},
    EarthquakeSource: {"magnitude": 7.0, "distance": 20.0},
}
"""What is refused by itself, and what must be given beside a field."""

CONSTANTS: dict[Any, tuple[Any, ...]] = {
    Preset: tuple(FURNITURE.values()),
    Structure: tuple(STRUCTURES.values()),
    ContentsKind: tuple(sp.CONTENTS.values()),
}
"""What stayput alone makes, and all that there is."""

TABLES: dict[str, tuple[Any, dict[str, Any]]] = {
    "furniture": (sp.Body, {"preset": "bookcase"}),
    "room.floor": (sp.Floor, {}),
    "room.left_wall": (sp.Wall, {"gap": 0.1}),
    "room.right_wall": (sp.Wall, {"gap": 0.1}),
    "room.near_side_wall": (sp.Wall, {"gap": 0.1}),
    "room.far_side_wall": (sp.Wall, {"gap": 0.1}),
    "room.ceiling": (sp.Ceiling, {"height": 2.4}),
    "initial": (sp.State, {}),
    "everyday": (sp.Everyday, {}),
    "contents": (sp.Contents, {}),
    "shaking.sine": (sp.sine, {"amplitude": 1.0, "frequency": 1.0}),
    "shaking.suite": (synthetic_suite, {}),
    "shaking.earthquake": (EarthquakeSource, {"magnitude": 7.0, "distance": 20.0}),
    "shaking.building": (Building, {"storeys": 3}),
}
"""The tables of a scenario, what each makes, and what must be given beside one of its keys."""

LISTS = {(ShearModel, "masses"), (ShearModel, "stiffnesses"), (ShearModel, "damping"), (sp.Contents, "loads")}
"""Fields that take a number for each storey or shelf."""

NARROWED = {"Body.cg_offset", "Body.inertia", "Body.base_heights", "Body.base_insets"}
"""Fields that other fields of their class bound more narrowly."""

OTHER_SENTENCE = {"Building.storeys", "synthetic_suite.count", "synthetic_suite.seed"}
"""Whole numbers that are refused in a sentence of their own."""

LIMITED = {
    *(f"shaking.sine.{name}" for name in ("duration", "dt", "quiet")),
    "shaking.suite.count",
    "shaking.building.storeys",
}
"""Keys for which a server has limits of its own, and says these first."""

DIMENSIONLESS = (
    "magnitude",
    "friction",
    "share",
    "restitution",
    "damping",
    "post_yield",
    "yield_coefficient",
    "amplification",
    "landing_place",
)
COUNTS = ("storeys", "count", "seed", "drawers", "shelves", "items")


NO_FIELD = {"synthetic_suite": "band"}
"""Arguments that are numbers and stand in no scenario."""

FIELDS = [
    pytest.param(kind, about, id=f"{kind.__name__}.{about.name}")
    for kind in (*NEEDED, *CONSTANTS)
    for about in parameters(kind)
    if not about.choices
]

WORDS = [
    pytest.param(kind, about, id=f"{kind.__name__}.{about.name}")
    for kind in NEEDED
    for about in parameters(kind)
    if about.choices
]


def keys() -> Iterator[tuple[str, Any, Parameter]]:
    for table, (kind, _) in TABLES.items():
        for about in parameters(kind):
            if not about.choices:
                yield f"{table}.{about.name}", kind, about
    for name in ("masses", "stiffnesses"):
        yield f"shaking.building.{name}", ShearModel, parameter_of(ShearModel, name)


KEYS = [pytest.param(*key, id=key[0]) for key in keys()]
SCHEMA = Scenario.schema()
OF_A_ROOM = sp.Scenario.model_json_schema()


def node_of(dotted: str) -> dict[str, Any]:
    schema = SCHEMA if dotted.split(".")[0] in SCHEMA["properties"] else OF_A_ROOM
    node: dict[str, Any] = schema
    for part in dotted.split("."):
        tables = [table for kind in kinds(node, schema) for table in kinds(kind.get("items", kind), schema)]
        node = next(table["properties"][part] for table in tables if part in table.get("properties", {}))
    return node


def number_of(node: dict[str, Any]) -> dict[str, Any]:
    (kind,) = kinds(node, SCHEMA)
    return number_of(kind["items"]) if kind["type"] == "array" else kind


def outside(about: Parameter) -> tuple[float, float]:
    """Return the largest number below the range, and the smallest above it."""
    if about.whole:
        return int(about.low) - 1, int(about.high) + 1
    return math.nextafter(about.low, -math.inf), math.nextafter(about.high, math.inf)


def allowed(about: Parameter) -> str:
    unit = f" {about.unit}" if about.unit else ""
    return f"between {about.low:g} and {about.high:g}{unit}."


def scene(dotted: str, value: object) -> dict[str, Any]:
    table, _, name = dotted.rpartition(".")
    given: dict[str, Any] = {**TABLES[table][1], name: value}
    if name in ("masses", "stiffnesses"):
        given = {"masses": [1.0], "stiffnesses": [1.0], name: [value]}
    elif name in ("cg_offset", "base_heights", "base_insets"):
        given[name] = [0.0, value]
    for part in reversed(table.split(".")):
        given = {part: given}
    if table == "shaking.building":
        given["shaking"]["storey"] = 1
    return {"furniture": {"preset": "bookcase"}, **given}


@pytest.mark.parametrize("kind", [*NEEDED, *CONSTANTS])
def test_every_number_has_its_parameter(kind: Any) -> None:
    of_numbers = [
        name
        for name, given in inspect.signature(kind).parameters.items()
        if str(given.annotation).startswith(("float", "int", "Sequence[float]", "tuple[float"))
        and name != NO_FIELD.get(kind.__name__)
    ]
    assert [about.name for about in parameters(kind) if not about.choices] == of_numbers


@pytest.mark.parametrize(("kind", "about"), WORDS)
def test_a_word_is_one_of_its_choices_in_class_and_scenario(kind: Any, about: Parameter) -> None:
    assert about.default == about.choices[0]
    assert about.label[0].isascii()
    assert not about.label[1].isascii()
    for word in about.choices:
        assert getattr(kind(**NEEDED[kind], **{about.name: word}), about.name) == word
    with pytest.raises(InputError, match="is 'straw'; it must be one of"):
        kind(**NEEDED[kind], **{about.name: "straw"})
    tables = [table for table, (made, _) in TABLES.items() if made is kind]
    for table in tables:
        node = node_of(f"{table}.{about.name}")
        assert kinds(node, SCHEMA)[0]["enum"] == list(about.choices)
        assert node["default"] == (None if kind is sp.Body else about.default)  # a preset has its own
        assert node["description"] == about.meaning
        with pytest.raises(InputError, match="it must be one of"):
            Scenario.parse(scene(f"{table}.{about.name}", "straw"))


@pytest.mark.parametrize(("kind", "about"), FIELDS)
def test_a_parameter_has_unit_label_and_range(kind: Any, about: Parameter) -> None:
    english, japanese = about.label
    assert english.isascii()
    assert not japanese.isascii()
    assert math.isfinite(about.low)
    assert math.isfinite(about.high)
    assert about.low < about.high
    assert bool(about.unit) != (about.name in COUNTS or any(word in about.name for word in DIMENSIONLESS))
    assert about.default == inspect.signature(kind).parameters[about.name].default or about.default is MISSING
    if isinstance(about.default, float | int):
        assert about.check(about.default) == about.default


@pytest.mark.parametrize("kind", CONSTANTS)
def test_presets_are_within_their_ranges(kind: Any) -> None:
    for value in CONSTANTS[kind]:
        check_fields(value)


@pytest.mark.parametrize(("dotted", "kind", "about"), KEYS)
def test_the_schema_of_a_scenario_says_the_same(dotted: str, kind: Any, about: Parameter) -> None:
    node = node_of(dotted)
    number = number_of(node)
    assert (number["minimum"], number["maximum"]) == (about.low, about.high)
    assert number.get("unit", "") == about.unit
    assert number["type"] == ("integer" if about.whole else "number")
    assert node["description"]
    assert node.get("default", MISSING) in (None, about.default)  # None: a preset or a surface says it


@pytest.mark.parametrize(
    ("kind", "about"),
    [one for one in FIELDS if one.values[0] in NEEDED and one.id not in NARROWED | OTHER_SENTENCE],
)
def test_a_value_just_outside_is_refused(kind: Any, about: Parameter) -> None:
    for value in outside(about):
        given = [value] if (kind, about.name) in LISTS else value
        with pytest.raises(InputError, match=r"; it must be between .*\.$") as refused:
            kind(**{**NEEDED[kind], about.name: given})
        error = refused.value
        assert (error.field or "").removeprefix("isolation.") == about.name
        assert (error.values["low"], error.values["high"]) == (about.low, about.high)
        assert str(error).startswith(about.label[0])
        assert str(error).endswith(allowed(about))
        assert error.told("ja").startswith(about.label[1])


@pytest.mark.parametrize(
    ("kind", "name"), [(Building, "storeys"), (synthetic_suite, "count"), (synthetic_suite, "seed")]
)
def test_whole_numbers_just_outside_are_refused(kind: Any, name: str) -> None:
    about = parameter_of(kind, name)
    for value in outside(about):
        with pytest.raises(
            InputError, match=f"whole number from {about.low} to {about.high}|between {about.low:g} and "
        ):
            kind(**{name: int(value)})


@pytest.fixture(scope="module")
def app() -> Iterator[FastAPI]:
    made = create_app(warming=False)
    yield made
    made.state.service.close()


def asked(app: FastAPI, method: str, route: str, content: object = None) -> httpx.Response:
    """Ask the API within this process."""

    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://127.0.0.1") as client:
            return await client.request(method, f"/api/v1/{route}", json=content)

    return asyncio.run(ask())


@pytest.mark.parametrize(("dotted", "kind", "about"), KEYS)
def test_scenario_and_api_refuse_what_is_just_outside(
    dotted: str, kind: Any, about: Parameter, app: FastAPI
) -> None:
    for value in outside(about):
        data = scene(dotted, value)
        with pytest.raises(InputError) as refused:
            Scenario.parse(data)
        said = str(refused.value)
        assert said.startswith(dotted)
        assert said.endswith(allowed(about))
        answer = asked(app, "POST", "simulate", {"scene": data})
        assert answer.status_code == 422
        if dotted not in LIMITED:
            assert answer.json()["message"] == said
            assert answer.json()["message_ja"] == refused.value.told("ja")


@pytest.mark.parametrize("dotted", NUMBERS)
def test_the_page_is_told_the_same(dotted: str, app: FastAPI) -> None:
    found = asked(app, "GET", "presets").json()["numbers"][dotted]
    node = node_of(dotted)
    if found["choices"]:
        assert found["choices"] == kinds(node, SCHEMA)[0]["enum"]
    else:
        number = number_of(node)
        assert (found["low"], found["high"]) == (number["minimum"], number["maximum"])
        assert found["unit"] == number.get("unit", "")
    assert found["label"]["en"]
    assert found["label"]["ja"]


def test_the_mechanics_read_every_number_of_a_floor_and_of_an_initial_state():
    missing = {about.name for kind in (Floor, State) for about in parameters(kind)} - set(CASE.names)
    # this one changes the base corners of the row
    assert missing == {"settlement"}, f"not a column of CASE: {missing}"
