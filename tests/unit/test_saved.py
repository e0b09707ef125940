"""Runs, verdicts and curves in files: the same to the bit, and a sentence for whatever else is read."""

from __future__ import annotations

import dataclasses
import hashlib
import json
from collections.abc import Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import pytest
import xarray as xr

import stayput as sp
from stayput.fragility.intensity_measures import PGA
from stayput.measures import Belt, LBracket

if TYPE_CHECKING:
    from pathlib import Path

BODY = sp.Body(0.3, 1.8, 90.0, length=0.9)
ROOM = sp.Room(sp.Floor.of("carpet"), left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
MOTION = sp.near_fault()
SHAKING: dict[str, Any] = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}}
CURVE = sp.FragilityCurve("本棚", sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40]))


def same(one: Any, other: Any) -> bool:
    """Whether two values are equal in all their parts, to the bit."""
    if type(one) is not type(other):
        return False
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    if isinstance(one, sp.Scenario):
        return one.kept().keys() == other.kept().keys() and same(
            list(one.kept().values()), list(other.kept().values())
        )
    if isinstance(one, sp.InputError):
        return same(
            (one.code, one.field, one.context, one.values),
            (other.code, other.field, other.context, other.values),
        )
    if dataclasses.is_dataclass(one):
        names = [field.name for field in dataclasses.fields(one)]
        return all(same(getattr(one, name), getattr(other, name)) for name in names)
    if isinstance(one, Mapping):
        return same(list(one), list(other)) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, tuple | list):
        return len(one) == len(other) and all(map(same, one, other))
    return one == other or (one != one and other != other)


def flat(measures: tuple[sp.Measure, ...] = (), scale: float = 1.0) -> sp.Run:
    return sp.simulate(BODY, ROOM, MOTION.scaled(scale), measures, dimensions=2)


def verdict(**how: Any) -> sp.Verdict:
    given: dict[str, Any] = {"shaking": SHAKING, "measures": [LBracket(), Belt()], "samples": 4}
    hard = dataclasses.replace(ROOM, floor=sp.Floor.of("wood flooring"))  # on a carpet runs take longer
    return sp.verify(BODY, hard, progress=False, **(given | how))


@pytest.mark.parametrize(
    "make",
    [
        flat,
        lambda: flat((LBracket(), Belt())),
        lambda: flat(scale=1e-3),  # without an event
        lambda: sp.simulate(BODY, ROOM, MOTION, [LBracket()], dimensions=3),
        lambda: sp.simulate(
            sp.Scene([sp.Piece(BODY), sp.Piece(sp.Body.box(0.4, 0.4, 0.5, 20.0), at=(1.0, 0.0, 0.0))]), MOTION
        ),
    ],
    ids=["bare", "held", "still", "in space", "several"],
)
def test_a_run_comes_back_from_netcdf_to_the_bit(make: Any, tmp_path: Path):
    run = make()
    again = type(run).load(run.save(tmp_path / "run.nc"))
    assert same(run, again)
    with xr.open_dataset(tmp_path / "run.nc", engine="scipy", decode_timedelta=False) as data:
        assert np.array_equal(data.tilt, [piece.tilt for piece in run.pieces])
        assert data.attrs["stayput_version"] == sp.__version__


@pytest.mark.parametrize(
    "how",
    [
        {},
        {"shaking": sp.synthetic_suite("crustal", 2).to_intensity(6.0), "levels": []},
        {"uncertainty": sp.Uncertainty({"friction": sp.Lognormal(1.0, 0.3)}), "levels": []},
        {"measures": [LBracket(), sp.MEASURES["tension_pole"]()], "levels": []},
    ],
    ids=["file", "motions", "uncertainty", "impossible"],
)
def test_a_verdict_comes_back_and_goes_on(how: dict[str, Any], tmp_path: Path):
    found = verdict(**how)
    again = sp.Verdict.load(found.save(tmp_path / "verdict.json"))
    assert same(found, again)
    assert again.to_json() == found.to_json()
    assert again.sentence("ja") == found.sentence("ja")
    repeated = sp.verify(again.scenario, levels=how.get("levels"), progress=False)
    assert [one.probabilities for one in repeated.options] == [one.probabilities for one in found.options]


def test_a_verdict_of_a_file_names_its_records_from_anywhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    (tmp_path / "here").mkdir()
    MOTION.write(tmp_path / "here" / "record.csv")
    monkeypatch.chdir(tmp_path / "here")
    (tmp_path / "here" / "s.toml").write_text(
        '[furniture]\npreset = "bookcase"\n[shaking]\nrecord = "record.csv"\n[uncertainty]\nsamples = 4\n'
    )
    found = sp.verify(sp.read("s.toml"), levels=[], progress=False)
    found.save("v.json")
    motion = found.scenario.motion()
    monkeypatch.chdir(tmp_path)
    assert sp.Verdict.load("here/v.json").scenario.motion() == motion


def test_numbers_out_of_arrays_are_kept_as_pythons_own(tmp_path: Path):
    body = sp.Body(np.float32(0.5), np.int64(2), np.float64(80.0))
    assert repr(body) == "Body(width=0.5, height=2, mass=80)"
    run = sp.simulate(body, ROOM, MOTION, dimensions=2)
    assert same(sp.Run.load(run.save(tmp_path / "run.nc")), run)


def test_a_curve_comes_back_with_the_version_that_wrote_it(tmp_path: Path):
    file = CURVE.save(tmp_path / "curve.json")
    assert same(CURVE, sp.FragilityCurve.load(file))
    assert json.loads(file.read_text(encoding="utf-8"))["stayput"] == sp.__version__


@dataclasses.dataclass(frozen=True, slots=True)
class Doubled(LBracket):
    kind: ClassVar[str] = "doubled"


def test_what_is_not_of_the_package_is_not_saved(tmp_path: Path):
    with pytest.raises(sp.InputError, match="A Doubled cannot be saved"):
        verdict(measures=[Doubled()], levels=[]).save(tmp_path / "v.json")
    assert not list(tmp_path.iterdir())


def signed(value: Any, /, **others: Any) -> dict[str, Any]:
    """Return the content of a JSON file as `save` writes it, whatever its value."""
    text = json.dumps(["9.0", value], sort_keys=True, separators=(",", ":"))
    digest = hashlib.sha256(text.encode()).hexdigest()
    return {"stayput": "9.0", "format": 2, "sha256": digest, "value": value} | others


def of_array(**parts: Any) -> dict[str, Any]:
    return signed({"array": {"dtype": "<f8", "shape": [1], "values": [1.0]} | parts})


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"", "holds no FragilityCurve"),
        (b"[1, 2]", "holds no FragilityCurve"),
        (b"\xff\xfe", "holds no FragilityCurve"),
        (b"[" * 200_000, "holds no FragilityCurve"),
        (b'{"a":' * 200_000, "holds no FragilityCurve"),
        ({"stayput": "9.0", "value": 3}, "holds no FragilityCurve"),
        (signed(3), "holds no FragilityCurve"),
        (signed(3, format=3), "stayput 9.0 wrote it, or be read by that"),
        (signed(3, format=0), "as save.* of stayput 9.0 wrote it"),
        (signed(3, stayput="banana"), "changed after it was saved"),
        (signed(3, format=1e999), "holds no FragilityCurve"),
        (signed(3, value=4), "changed after it was saved"),
        (signed(3, sha256=None), "changed after it was saved"),
        (signed({"object": "stayput.fragility.curve.Gone", "fields": {}}), "stayput 9.0"),
        (signed({"object": "os.system", "fields": {"command": "true"}}), "stayput 9.0"),
        (signed({"object": "stayput.cli.main", "fields": {}}), "stayput 9.0"),
        (signed({"enum": "stayput.errors.InputError", "value": 1}), "stayput 9.0"),
        (signed({"kept": "stayput.files.check_target", "parts": []}), "stayput 9.0"),
        (of_array(), "holds no FragilityCurve"),
        (of_array(dtype="<U500000000"), "stayput 9.0"),
        (of_array(dtype="O"), "stayput 9.0"),
        (of_array(shape=[10**12]), "stayput 9.0"),
        (of_array(shape=[-1]), "stayput 9.0"),
        (signed({"array": {"columns": [["a", "<f8", [10**9]]], "shape": [1], "bytes": ""}}), "stayput 9.0"),
    ],
)
def test_other_files_are_refused_in_a_sentence(content: Any, told: str, tmp_path: Path):
    file = tmp_path / "it.json"
    file.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
    with pytest.raises(sp.InputError, match=told):
        sp.FragilityCurve.load(file)


def test_numbers_changed_by_hand_are_refused(tmp_path: Path):
    file = CURVE.save(tmp_path / "curve.json")
    text = file.read_text(encoding="utf-8")
    file.write_text(json.dumps(json.loads(text), indent=1), encoding="utf-8")  # the same content
    assert same(CURVE, sp.FragilityCurve.load(file))
    changed = text.replace(" 36", " -36", 1)
    assert changed != text
    file.write_text(changed, encoding="utf-8")
    with pytest.raises(sp.InputError, match="changed after it was saved"):
        sp.FragilityCurve.load(file)


def test_histories_changed_by_hand_are_refused(tmp_path: Path):
    run, file = flat(), tmp_path / "run.nc"
    run.save(file)
    with xr.open_dataset(file, engine="scipy", decode_times=False, decode_timedelta=False) as opened:
        data = opened.load()
    data.place[0, 3] += 1.0
    data.to_netcdf(file, engine="scipy")
    with pytest.raises(sp.InputError, match="changed after it was saved"):
        sp.Run.load(file)
    run.save(file)
    whole = file.read_bytes()
    for part in (0, 3, 40, 400, len(whole) // 2, len(whole) - 8):
        file.write_bytes(whole[:part])
        with pytest.raises(sp.InputError):
            sp.Run.load(file)
    for place in range(8, 400, 3):  # lengths of dimensions, names, types and offsets
        file.write_bytes(whole[:place] + b"\x7f" + whole[place + 1 :])
        with suppress(sp.InputError):
            sp.Run.load(file)


def test_files_of_another_kind_or_missing_are_refused(tmp_path: Path):
    run, curve = flat().save(tmp_path / "run.nc"), CURVE.save(tmp_path / "curve.json")
    for kind, file, told in (
        (sp.Verdict, curve, "holds no Verdict"),
        (sp.Run, curve, "holds no Run"),
        (sp.Verdict, run, "holds no Verdict"),
        (sp.Run, tmp_path / "no.nc", "no such file"),
        (sp.Verdict, tmp_path, "is a directory"),
    ):
        with pytest.raises(sp.InputError, match=told):
            kind.load(file)
    with pytest.raises(sp.InputError, match=r"\.nc"):
        flat().save(tmp_path / "run.json")
    (tmp_path / "other.nc").write_bytes(b"")
    xr.Dataset({"a": ("x", [1.0])}).to_netcdf(tmp_path / "other.nc", engine="scipy")
    with pytest.raises(sp.InputError, match="holds no Run"):
        sp.Run.load(tmp_path / "other.nc")
