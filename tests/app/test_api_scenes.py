"""Scenes that are possible but odd: extreme sizes, floors, shaking, buildings, measures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import hypothesis.strategies as st
from hypothesis import HealthCheck, given, settings
from serving import client_of

from stayput.building import STRUCTURES
from stayput.measures import MEASURES
from stayput.model.body import FURNITURE
from stayput.model.room import SURFACES

if TYPE_CHECKING:
    from serving import Running

EXAMPLES = 30

few = settings(
    max_examples=EXAMPLES,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=list(HealthCheck),
)


def between(low: float, high: float) -> st.SearchStrategy[float]:
    return st.one_of(st.sampled_from([low, high]), st.floats(low, high))


def table(required: dict[str, Any], optional: dict[str, Any]) -> st.SearchStrategy[dict[str, Any]]:
    return st.fixed_dictionaries(required, optional=optional)


walls = table({"gap": between(0.0, 2.0)}, {"restitution": between(0.0, 1.0), "friction": between(0.0, 3.0)})
floors = st.one_of(
    st.sampled_from(list(SURFACES)),
    table(
        {"static_friction": between(0.0, 3.0), "kinetic_friction": st.just(0.0)},
        {"restitution": between(0.0, 1.0), "normal_restitution": between(0.0, 1.0)},
    ),
)
furniture = table(
    {"preset": st.sampled_from(list(FURNITURE))},
    {"width": between(0.001, 100.0), "height": between(0.001, 100.0), "mass": between(0.001, 1e6)},
)
rooms = table(
    {"floor": floors},
    {"left_wall": walls, "right_wall": walls, "ceiling": table({"height": between(0.5, 100.0)}, {})},
)
sources = st.one_of(
    st.just({"builtin": "near-fault"}),
    st.fixed_dictionaries({"suite": table({}, {"count": st.just(3), "seed": st.integers(0, 3)})}),
    st.fixed_dictionaries(
        {
            "sine": table(
                {"amplitude": between(-1e4, 1e4), "frequency": between(0.01, 10.0)},
                {"duration": between(1e-3, 60.0), "phase": between(-1e3, 1e3), "quiet": between(0.0, 60.0)},
            )
        }
    ),
)
strengths = st.one_of(
    st.just({}),
    st.fixed_dictionaries({"intensity": between(-3.0, 9.0)}),
    st.fixed_dictionaries({"scale": between(-1e3, 1e3)}),
)
buildings = st.one_of(
    st.just({}),
    st.fixed_dictionaries(
        {
            "building": table(
                {"storeys": st.integers(1, 60)},
                {
                    "structure": st.sampled_from(list(STRUCTURES)),
                    "period": between(0.02, 20.0),
                    "damping": between(0.0, 0.5),
                    "nonlinear": st.booleans(),
                    "yield_coefficient": between(1e-3, 10.0),
                    "post_yield": between(0.0, 0.95),
                },
            ),
            "storey": st.integers(1, 3),
        }
    ),
)
scenes = st.builds(
    lambda what, where, source, strength, building, more: {
        "furniture": what,
        "room": where,
        "shaking": {**source, **strength, **building},
        **more,
    },
    furniture,
    rooms,
    sources,
    strengths,
    buildings,
    table({}, {"gravity": between(0.1, 100.0)}),
)
measures = st.lists(
    st.sampled_from(list(MEASURES)).map(lambda kind: {"type": kind}),
    max_size=3,
    unique_by=lambda one: one["type"],
)


@given(scene=scenes, held=measures)
@few
def test_odd_scenes_are_answered_or_refused(server: Running, scene: Any, held: Any) -> None:
    with client_of(server) as client:
        answer = client.post("/api/v1/simulate", json={"scene": scene, "measures": held})
    assert answer.status_code in (200, 422), answer.text
    if answer.status_code == 200:
        found = answer.json()
        for run in (found["without"], found["with"]):
            if run is not None:
                assert None not in run["x_m"]
                assert None not in run["tilt_rad"]
