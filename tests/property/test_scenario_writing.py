"""A scenario that is written and read again is the same scenario."""

import tomllib

from hypothesis import given, settings
from hypothesis import strategies as st

import stayput as sp
from stayput.errors import has_control
from stayput.measures import MEASURES
from stayput.model.body import FURNITURE
from stayput.model.room import SURFACES

names = st.text(st.characters(codec="utf-8"), min_size=1, max_size=200).filter(
    lambda one: not has_control(one)
)


def number(low, high):
    return st.floats(low, high, allow_nan=False).map(lambda value: value + 0.0)


def optional(**fields):
    return st.fixed_dictionaries({}, optional=fields)


furniture = st.one_of(
    st.fixed_dictionaries({"preset": st.sampled_from(sorted(FURNITURE))}, optional={"name": names}),
    st.fixed_dictionaries(
        {"width": number(0.2, 1.0), "height": number(1.0, 2.5), "mass": number(1.0, 500.0)},
        optional={"cg_offset": st.lists(number(-0.05, 0.05), min_size=2, max_size=2)},
    ),
    st.fixed_dictionaries(
        {"preset": st.just("bookcase"), "shelves": st.lists(number(0.0, 60.0), min_size=1, max_size=8)}
    ),
)
wall = st.fixed_dictionaries({"gap": number(0.0, 1.0)}, optional={"restitution": number(0.0, 1.0)})
room = optional(
    floor=st.sampled_from(sorted(SURFACES))
    | optional(surface=st.sampled_from(sorted(SURFACES)), restitution=number(0.0, 1.0)),
    left_wall=wall,
    right_wall=wall,
    ceiling=st.fixed_dictionaries({"height": number(2.5, 4.0)}),
)
suite = optional(count=st.integers(1, 100), seed=st.integers(0, 1000))
shaking = st.one_of(
    st.just({"builtin": "near-fault"}),
    optional(intensity=number(3.0, 7.0) | st.sampled_from(["5-upper", "7"]), suite=suite | names),
    st.fixed_dictionaries(
        {"record": names}, optional={"scale": number(-2.0, 2.0), "vertical": st.booleans() | names}
    ),
    st.fixed_dictionaries(
        {"sine": st.fixed_dictionaries({"amplitude": number(-9.0, 9.0), "frequency": number(0.1, 9.0)})}
    ),
    st.fixed_dictionaries(
        {
            "intensity": number(3.0, 7.0),
            "storey": st.integers(1, 4),
            "building": st.fixed_dictionaries(
                {"storeys": st.integers(4, 9)}, optional={"nonlinear": st.booleans()}
            ),
        }
    ),
)
single = st.sampled_from(sorted(MEASURES)).map(lambda kind: {"type": kind})
measures = st.lists(single | single.map(lambda one: {"combine": [one]}), min_size=1, max_size=5).map(
    lambda tables: [{**table, "name": f'no. {n} "\\'} for n, table in enumerate(tables)]
)
scenarios = st.fixed_dictionaries(
    {"furniture": furniture},
    optional={
        "title": names,
        "room": room,
        "shaking": shaking,
        "gravity": number(1.0, 20.0),
        "initial": optional(tilt=number(-0.1, 0.1)),
        "measures": measures,
        "uncertainty": optional(
            samples=st.integers(1, 1000), seed=st.integers(0, 2**40), precision=number(0.01, 0.4)
        ),
    },
)


@settings(max_examples=150, deadline=None)
@given(scenarios)
def test_what_is_written_is_read_again(data):
    scenario = sp.Scenario.parse(data)
    text = scenario.to_toml()
    again = sp.Scenario.parse(tomllib.loads(text))
    assert again == scenario
    assert again.to_toml() == text
    assert again.model_dump(exclude_unset=True) == scenario.model_dump(exclude_unset=True)
