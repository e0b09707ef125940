"""What stayput answers for some fifteen scenes, frozen: no change of an answer passes unseen.

``GOLDEN=write make test PYTEST_ARGS=tests/golden`` writes the files of ``expected`` anew; the commit that
does so says which answers changed on purpose, and why. Where a motion is a polynomial the bits of a run in
the plane are kept, by a digest; where NumPy or SciPy computed it, whose last digit depends on the processor,
numbers are compared to six digits. Factors, draws and floors' motions are rounded, so that runs do not depend
on that digit; a test lets it err.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app

if TYPE_CHECKING:
    from collections.abc import Callable

HERE = Path(__file__).parent
EXPECTED = HERE / "expected"
SCENES = sorted((HERE / "scenes").glob("*.toml"))
VOLATILE = {"seconds", "version", "stayput"}
"""Keys whose values differ from run to run, or with each version."""

LONG = 12
"""Lists with more items are kept by three of them."""

STRIDE = 20
"""Each such sample of a run in space is kept."""

LAST_DIGITS = 1e-6
"""What machines differ by in these [m, rad]: a stack makes 1e-16 to 1e-8 before it falls."""

WALL = sp.Wall(0.02)
WALLED = sp.Room(sp.Floor(0.4, 0.3), left_wall=WALL)
BRACKET = [sp.MEASURES["l_bracket"]()]
STACK = sp.Scene(
    [
        sp.Piece(sp.Body.box(0.45, 0.9, 1.0, 60.0)),
        sp.Piece(sp.Body.box(0.35, 0.9, 0.9, 30.0), at=(-0.05, 0.0, 1.0)),
    ]
)
BOOKCASE = sp.Body(0.3, 1.8, 60.0, length=0.9)


def waves(peak: float, vertical: float = 0.0) -> sp.Motion:
    """Return parabolic waves of half a second, whose samples are exact in any arithmetic."""
    count = np.arange(800)
    u = (count % 50) / 50.0
    wave = 4.0 * u * (1.0 - u) * np.where(count // 50 % 2, -1.0, 1.0) * np.minimum(count / 200.0, 1.0)
    return sp.Motion(0.01, peak * wave, z=vertical * wave[::-1] if vertical else None, name="waves")


def bits(run: sp.Run) -> dict[str, Any]:
    """Return a digest of a run's histories, and its peaks, by which a change of the digest is understood.

    In space samples of the histories take its place.
    """
    if run.engine == "space":
        told = {name: [getattr(piece, name) for piece in run.pieces] for name in ("peak_tilt", "peak_slide")}
        tilts = [piece.tilt[::STRIDE].tolist() for piece in run.pieces]
        slides = [piece.slide_in_plan[::STRIDE].tolist() for piece in run.pieces]
        return {"outcome": str(run.outcome), **told, "tilt": tilts, "slide": slides}
    told = {"peak_tilt": run.peak_tilt, "peak_slide": run.peak_slide}
    histories = (run.time, run.tilt, run.slide)
    digest = hashlib.sha256(b"".join(np.ascontiguousarray(one, dtype=float).tobytes() for one in histories))
    return {"digest": digest.hexdigest()[:16], "outcome": str(run.outcome), **told}


RUNS: dict[str, Callable[[], sp.Run]] = {
    "plane": lambda: sp.simulate(BOOKCASE, WALLED, waves(4.0, 1.0)),
    "plane_slides": lambda: sp.simulate(sp.Body(0.6, 0.7, 40.0), sp.Room(sp.Floor(0.25, 0.2)), waves(5.0)),
    "plane_held": lambda: sp.simulate(BOOKCASE, WALLED, waves(6.0), BRACKET, dimensions=2),
    "plane_paper": lambda: sp.simulate(BOOKCASE, sp.Room(left_wall=WALL), waves(4.0), contact="paper"),
    "space": lambda: sp.simulate(BOOKCASE, WALLED, waves(4.0, 1.0), dimensions=3),
    "space_held": lambda: sp.simulate(BOOKCASE, WALLED, waves(6.0), BRACKET, dimensions=3),
    "space_stack": lambda: sp.simulate(STACK, waves(3.0).trimmed(0.0, 2.5)),
}


def plain(value: Any) -> Any:
    """Return a value of JSON without what differs from run to run; of long lists first, middle and last."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items() if key not in VOLATILE}
    if isinstance(value, list):
        if len(value) > LONG:
            return {"count": len(value), "some": plain([value[0], value[len(value) // 2], value[-1]])}
        return [plain(one) for one in value]
    if isinstance(value, float) and math.isfinite(value):
        return float(f"{value:.6g}")
    return value


def agree(found: Any, expected: Any, within: float, place: str = "") -> None:
    """Compare two values of JSON; numbers may differ in their sixth digit, or by what is within rounding."""
    if isinstance(expected, dict):
        assert isinstance(found, dict), place
        assert found.keys() == expected.keys(), place
        for key, value in expected.items():
            agree(found[key], value, within, f"{place}.{key}")
    elif isinstance(expected, list):
        assert isinstance(found, list), place
        assert len(found) == len(expected), place
        for i, (one, other) in enumerate(zip(found, expected, strict=True)):
            agree(one, other, within, f"{place}[{i}]")
    elif isinstance(expected, float):
        assert found == pytest.approx(expected, rel=3e-6, abs=within), place
    else:
        assert found == expected, place


def check(name: str, answer: Any, within: float = 1e-9) -> None:
    """Compare an answer with the file of that name, or write that."""
    file = EXPECTED / f"{name}.json"
    if os.environ.get("GOLDEN") == "write":
        EXPECTED.mkdir(exist_ok=True)
        file.write_text(json.dumps(answer, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    agree(answer, json.loads(file.read_text(encoding="utf-8")), within)


def cli(*arguments: object) -> str:
    done = CliRunner().invoke(app, [str(argument) for argument in arguments], env={"COLUMNS": "100"})
    assert done.exit_code == 0, done.output
    return done.stdout


@pytest.mark.parametrize("name", RUNS)
def test_the_bits_of_runs(name: str) -> None:
    run = RUNS[name]()
    if run.engine == "space":
        check(f"run_{name}", bits(run), LAST_DIGITS)
    else:
        check(f"run_{name}", plain(bits(run)))


def test_the_stack_falls_in_the_end() -> None:
    assert sp.simulate(STACK, waves(3.0)).outcome is sp.Outcome.FELL_OFF


@pytest.mark.parametrize("scene", SCENES, ids=[scene.stem for scene in SCENES])
def test_verdicts(scene: Path) -> None:
    check(f"verdict_{scene.stem}", plain(json.loads(cli("verify", scene, "--json", "--quiet"))))


INEXACT = ("arccos", "arcsinh", "arctan2", "cos", "exp", "expm1", "hypot", "log", "log10", "power", "sin")
"""Functions of NumPy whose last digit depends on the processor."""


def with_wrong_last_digit(function: Callable[..., Any], rng: np.random.Generator) -> Callable[..., Any]:
    """Return a function whose results are those of another, each with its last digit one more or less."""

    def wrong(*values: Any, **more: Any) -> Any:
        found = function(*values, **more)
        if not isinstance(found, float | np.ndarray) or np.asarray(found).dtype != float or "out" in more:
            return found
        exact = (found == 0.0) | (found == 1.0) | ~np.isfinite(found)
        shifted = np.nextafter(found, np.where(rng.random(np.shape(found)) < 0.5, -np.inf, np.inf))
        return np.where(exact, found, shifted)[()]

    return wrong


@pytest.mark.parametrize("scene", ["alone", "upstairs"])
def test_verdicts_of_another_processor(scene: str, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(1)
    for name in INEXACT:
        monkeypatch.setattr(np, name, with_wrong_last_digit(getattr(np, name), rng))
    file = HERE / "scenes" / f"{scene}.toml"
    check(f"verdict_{scene}", plain(json.loads(cli("verify", file, "--json", "--quiet"))))


@pytest.mark.parametrize("scene", ["alone", "stacked", "room"])
def test_verdicts_in_words(scene: str) -> None:
    file = HERE / "scenes" / f"{scene}.toml"
    told = {lang: cli("verify", file, "--markdown", "-", "--lang", lang, "--quiet") for lang in ("en", "ja")}
    check(f"words_{scene}", {lang: text.splitlines() for lang, text in told.items()})


@pytest.mark.parametrize("scene", ["alone", "shelves", "upstairs"])
def test_runs_of_scenes(scene: str) -> None:
    answer = json.loads(cli("simulate", HERE / "scenes" / f"{scene}.toml", "--json", "--quiet"))
    check(f"simulate_{scene}", plain({**answer, "events": answer.get("events", [])[:20]}))


def test_an_inventory(tmp_path: Path) -> None:
    table = tmp_path / "inventory.csv"
    table.write_text(
        "id,preset,building,storey,width\n"
        "a,bookcase,8 RC,6,\nb,chest,,,\nc,wardrobe,8 RC,B1,0.5\nd,bookcase,,,-1\n",
        encoding="utf-8",
    )
    scenario = tmp_path / "city.toml"
    scenario.write_text(
        '[shaking]\nintensity = "6-lower"\nsuite = { count = 3 }\n[uncertainty]\nsamples = 4\n'
        '[[measures]]\ntype = "l_bracket"\n',
        encoding="utf-8",
    )
    done = sp.assess(table, scenario, tmp_path / "out", progress=False)
    rows = (done.folder / "summary.csv").read_text(encoding="utf-8-sig")
    facts = {key: value for key, value in done.facts.items() if key in ("rows", "pieces", "rejects")}
    check("inventory", {"facts": facts, "summary": list(csv.DictReader(io.StringIO(rows)))})


def test_motions() -> None:
    check("motion", plain(json.loads(cli("motion", "info", "near-fault", "--json", "--quiet"))))
    floor = sp.Building(6, "RC").floor_motion(sp.near_fault(), 5)
    check("floor", plain({"pga": floor.pga, "pgv": floor.pgv, "peaks": floor.x[::300].tolist()}))
