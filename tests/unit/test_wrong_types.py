"""Whatever a public function or class is given, it takes it or refuses it in a sentence."""

from __future__ import annotations

import dataclasses
import math
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput import estimates
from stayput.fragility.intensity_measures import PGA
from stayput.measures import Belt
from stayput.standards.equipment import equipment_loads, position_of
from stayput.verification.changes import Change

if TYPE_CHECKING:
    from collections.abc import Callable

BODY = sp.Body(0.4, 1.8, 100.0)
ROOM = sp.Room(left_wall=sp.Wall(0.02))
MOTION = sp.Motion(0.01, np.sin(0.3 * np.arange(50)))
SOLID = sp.Body.box(0.4, 0.9, 1.8, 100.0)
CASE = sp.Case(BODY, ROOM, MOTION)
SCENARIO = sp.Scenario.parse(
    {
        "furniture": {"preset": "bookcase"},
        "room": {"left_wall": {"gap": 0.02}},
        "shaking": {"intensity": 6.0, "suite": {"count": 1}},
        "measures": [{"type": "l_bracket"}],
        "uncertainty": {"samples": 1},
    }
)
TRIALS = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
CURVES = [sp.FragilityCurve("bookcase", TRIALS)]
SIZE = {"width": 0.4, "height": 1.8}
PEAKS = {"pga": 1.0, "pgv": 0.1}
GRAVITY = {"gravity": 9.8}


def fields(kind: Any, **given: Any) -> tuple[Callable[..., Any], dict[str, Any]]:
    """Return a dataclass with its defaults, and what it needs besides."""
    defaults = {
        field.name: field.default
        for field in dataclasses.fields(kind)
        if field.init and field.default is not dataclasses.MISSING
    }
    return kind, {**defaults, **given}


GOOD: tuple[tuple[Callable[..., Any], dict[str, Any]], ...] = (
    fields(sp.Body, width=0.4, height=1.8, mass=100.0),
    (sp.Body.from_parts, SIZE | {"parts": [sp.Part(10.0, 0.0, 0.9, 0.4, 1.8)]}),
    (sp.Body.bookcase, SIZE | {"mass": 10.0, "loads": [5.0]}),
    fields(sp.Part, mass=1.0, x=0.0, z=0.5),
    fields(Change, what="shelf", measure=Belt(), at=(1.0, 0.5), heading=0.0),
    fields(sp.Floor),
    (sp.Floor.of, {"surface": "vinyl"}),
    fields(sp.Wall, gap=0.02),
    fields(sp.Ceiling, height=2.4),
    fields(sp.Room),
    fields(sp.State),
    fields(sp.Case, body=BODY, room=ROOM, motion=MOTION),
    *(fields(measure) for measure in sp.MEASURES.values()),
    (sp.hold, {"body": BODY, "room": ROOM, "measures": []}),
    (
        sp.simulate,
        {"body": BODY, "room": ROOM, "motion": MOTION, "measures": (), "contact": "coulomb"}
        | {"initial": None, "most_events": None, "dimensions": None}
        | GRAVITY,
    ),
    (
        sp.simulate,
        {"body": SOLID, "room": ROOM, "motion": MOTION, "measures": (), "contact": "coulomb"}
        | {"initial": None, "dimensions": None, "step": None}
        | GRAVITY,
    ),
    fields(sp.Piece, body=SOLID),
    fields(sp.Scene, pieces=[sp.Piece(SOLID), sp.Piece(SOLID)]),
    fields(sp.Joint, first=0, second=1, at=(0.0, 0.0, 0.0)),
    (sp.sweep, {"case": CASE, "axes": {"body.width": [0.4]}, "histories": (), "threads": 1, "chunk": 1}),
    (sp.simulate_many, {"case": CASE, "columns": {"body.width": [0.4]}, "threads": 1, "chunk": 1}),
    (sp.overturning_map, {"case": CASE, "amplitudes": [1.0, 2.0], "axes": None, "threads": 1}),
    (
        sp.trace_boundary,
        {"case": CASE, "amplitudes": [1.0, 2.0], "axes": None, "edge": "all", "tolerance": 0.01},
    ),
    fields(sp.Contents),
    (sp.spill, {"of": CASE, "contents": sp.Contents()}),
    fields(sp.Everyday),
    (sp.tip_over, {"body": BODY, "everyday": None} | GRAVITY),
    fields(sp.Fallen, body=BODY, fell=1, total=2, room=ROOM),
    (
        sp.intensity_from_fallen,
        {"pieces": [sp.Fallen(BODY, 1, 2)], "motions": sp.Suite((MOTION,)), "scatter": 0.2, "samples": 1}
        | {"levels": [5.0, 6.0, 7.0], "seed": 1, "threads": 1},
    ),
    fields(sp.Motion, dt=0.01, x=MOTION.x),
    (sp.sine, {"amplitude": 1.0, "frequency": 1.0, "duration": 1.0, "phase": 0.0, "dt": 0.01, "quiet": 0.0}),
    (sp.pulse, {"kind": "ricker", "amplitude": 1.0, "frequency": 1.0, "gamma": 2.0, "nu": 0.0, "dt": 0.01}),
    (MOTION.spectrum, {"periods": [0.1, 1.0], "damping": 0.05, "component": "x"}),
    (sp.synthetic_suite, {"family": "mixed", "count": 1, "seed": 1, "target": None}),
    fields(sp.Suite, motions=(MOTION,)),
    fields(sp.TargetSpectrum, periods=[0.1, 1.0], sa=[1.0, 1.0]),
    (sp.asce7, {"sds": 1.0, "sd1": 0.5, "tl": 8.0}),
    (sp.japanese_design, {"level": "rare", "soil": 2}),
    fields(sp.Building, storeys=5, isolation=sp.Isolation()),
    fields(sp.Isolation),
    fields(sp.ShearModel, masses=[1e5, 1e5], stiffnesses=[1e8, 1e8], damping=0.05),
    (sp.Trials.from_counts, {"measure": PGA, "im": [2.0, 4.0], "fell": [4, 19], "runs": [40, 40]}),
    (sp.FragilityCurve, {"name": "bookcase", "trials": TRIALS}),
    (sp.verify, {"what": SCENARIO, "levels": [], "slide_limit": 0.1, "threads": 1}),
    (
        sp.verify,
        {"what": BODY, "room": ROOM, "shaking": MOTION, "measures": [sp.MEASURES["l_bracket"]()]}
        | {"uncertainty": None, "samples": 1, "seed": 1, "precision": 0.5, "levels": [], "threads": 1},
    ),
    (sp.ac156, {"sds": 1.0, "height_ratio": 0.5, "edition": "7-16"}),
    (sp.ac156_motion, {"required": sp.ac156(1.0), "number": 1, "seed": 1, "lowest": 1.3}),
    (position_of, {"storey": 2, "storeys": 10}),
    (sp.equipment_coefficient, {"position": "upper", "grade": "S", "zone": 0.9}),
    (equipment_loads, {"body": BODY, "position": "upper", "zone": 0.9} | GRAVITY),
    (sp.holding_force, {"body": BODY, "coefficient": 1.0, "height": 1.2} | GRAVITY),
    (sp.anchor_tension, {"body": BODY, "coefficient": 1.0, "spacing": 0.3, "anchors": 2} | GRAVITY),
    (sp.asce43_sliding, {"motion": MOTION, "friction": 0.5} | GRAVITY),
    (estimates.rocking_acceleration, {"body": BODY} | GRAVITY),
    (estimates.ishiyama_velocity, {"body": BODY} | GRAVITY),
    (estimates.kaneko_hayashi, {"body": BODY} | PEAKS | GRAVITY | {"scatter": 0.5}),
    (estimates.kaneko_hayashi_median, {"body": BODY} | GRAVITY | {"frequency": 1.0}),
    (estimates.kaneko_hayashi_velocity, {"body": BODY}),
    (sp.read, {"path": "none.toml"}),
    (
        sp.read_motion,
        {"path": "none.csv", "columns": "x=1", "skip_lines": 1, "decimal_comma": True, "location": "00"},
    ),
    (sp.read_suite, {"source": ["none.csv"]}),
    (sp.read_target, {"path": "none.csv"}),
    (sp.write_nrml, {"curves": CURVES, "path": "none.txt"}),
    (sp.write_pelicun, {"curves": CURVES, "path": "none.txt"}),
    (sp.assess, {"inventory": "none.csv", "scenario": "none.toml", "out": "none"}),
)
"""Functions and classes with arguments that they take, or of files that are not there."""

WRONG = (
    *(None, "x", "\ud800", math.nan, math.inf, -1, 2.5, True, Decimal(1), Fraction(1, 2)),
    *([], [[1, 2], [3]], {}, object(), [None], np.array([[1.0]])),
)

UNCHECKED = {
    (kind, "name") for kind in (sp.Motion, sp.Suite, sp.TargetSpectrum, sp.ShearModel, sp.Fallen)
} | {(sp.Motion, name) for name in ("synthetic", "source", "floor", "listing")}
"""What something is called or comes from: nothing is computed from it."""

SAID = [
    pytest.param(function, given, name, id=f"{function.__qualname__}-{name}")
    for function, given in GOOD
    for name in given
]


@pytest.mark.parametrize(("function", "given", "name"), SAID)
def test_what_is_wrong_is_refused_in_a_sentence(
    function: Callable[..., Any], given: dict[str, Any], name: str, monkeypatch: Any, tmp_path: Any
) -> None:
    monkeypatch.chdir(tmp_path)
    for wrong in WRONG:
        try:
            function(**{**given, name: wrong})
            refused = None
        except sp.InputError as error:
            refused = error
        if refused is None:
            assert type(wrong) is not object or (function, name) in UNCHECKED
        else:
            assert refused.told("en").endswith(".")
            assert refused.told("ja") != refused.told("en")


@pytest.mark.parametrize(
    "number", ["50", b"50", True, np.True_, np.array("50"), Decimal(50), Fraction(50), 50 + 0j]
)
def test_what_is_not_a_number_is_not_taken_for_one(number: Any) -> None:
    with pytest.raises(sp.InputError, match=r"Body mass is .*; it must be a number"):
        sp.Body(0.3, 1.8, number)
    with pytest.raises(sp.InputError, match=r"Place is .*; it must be (numbers|3 numbers)"):
        sp.Piece(SOLID, at=(0.0, number, 0.0))


def test_a_boolean_is_no_number_and_a_number_no_boolean() -> None:
    for call in (
        lambda: sp.Joint(0, True, (0.0, 0.0, 0.0)),
        lambda: sp.simulate(sp.Scene([sp.Piece(SOLID)]), MOTION, gravity=True),
        lambda: sp.Piece(SOLID, at=np.zeros(3, bool)),  # type: ignore[arg-type]
        lambda: sp.Door("left_wall", 0.1, 0.8, way_out=math.nan),  # type: ignore[arg-type]
        lambda: sp.Floor(surface=np.zeros(3)),  # type: ignore[arg-type]
        lambda: sp.PersonPlace("bed", (1.0, 1.0), 1.0, 2.0, 0.4, 0.7, blocks="no"),  # type: ignore[arg-type]
    ):
        with pytest.raises(sp.InputError, match=r"must be (a number|numbers|of type bool|one of)"):
            call()


@pytest.mark.parametrize("step", ["x", math.nan, -1.0])
def test_a_step_is_checked_in_the_plane_too(step: Any) -> None:
    with pytest.raises(sp.InputError, match=r"^Step is "):
        sp.simulate(BODY, ROOM, MOTION, step=step)


def test_a_name_is_a_text_that_can_be_written() -> None:
    for name in ("", "\ud800"):
        with pytest.raises(sp.InputError, match=r"name is .*; it must be a text of one or more characters"):
            sp.Piece(SOLID, name=name)
    run = sp.simulate(sp.Scene([sp.Piece(SOLID), sp.Piece(SOLID, (2.0, 0.0, 0.0))]), MOTION)
    for names, message in ((["a", "a"], "must not be that of"), (["a", ""], "names is ''")):
        with pytest.raises(sp.InputError, match=message):
            run.named(names)


def test_a_run_tells_which_pieces_it_has() -> None:
    run = sp.simulate(sp.Scene([sp.Piece(SOLID), sp.Piece(SOLID, (2.0, 0.0, 0.0))]), MOTION).named(["a", "b"])
    with pytest.raises(sp.InputError, match=r"name one, as in run\['a'\].peak_slide\. Its pieces are a, b"):
        _ = run.peak_slide
    for wrong in (2, -3, 0.0, None, "c"):
        with pytest.raises(sp.InputError, match=r"no piece .* in the run; its pieces are a, b"):
            _ = run[wrong]  # type: ignore[index]
    assert list(run) == list(run.pieces)


def test_a_path_with_a_zero_byte_is_refused() -> None:
    with pytest.raises(sp.InputError, match="null byte"):
        sp.read("a\0b")
