"""Whatever holds numbers is taken as an array; bare samples in the place of a motion are refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import stayput as sp
from stayput.fragility.intensity_measures import PGA

SAMPLES = np.sin(0.1 * np.arange(200)).astype(np.float32).astype(np.float64)
BODY, ROOM = sp.Body(0.3, 1.8, 90.0), sp.Room()
LIKE: dict[str, Any] = {
    "list": list,
    "tuple": tuple,
    "float32": np.float32,
    "reversed view": lambda values: np.asarray(values)[::-1].copy()[::-1],
    "pandas": lambda values: pd.Series(values, index=np.linspace(5.0, 6.0, len(values))),
    "xarray": lambda values: xr.DataArray(values, dims="sample"),
    "memory": lambda values: memoryview(np.asarray(values)),
}


@pytest.mark.parametrize("like", LIKE.values(), ids=LIKE)
def test_numbers_are_taken_as_they_come(like: Any):
    motion = sp.Motion(0.01, like(SAMPLES), y=like(SAMPLES), z=like(SAMPLES))
    assert motion == sp.Motion(0.01, SAMPLES, y=SAMPLES, z=SAMPLES)
    assert motion.x.dtype == np.float64
    periods = [0.125, 0.5, 2.0]
    assert np.array_equal(motion.spectrum(like(periods)).sa, motion.spectrum(periods).sa)
    target = sp.TargetSpectrum(like(periods), like([5.0, 3.0, 1.0]))
    assert target(like([0.25, 1.0])) == pytest.approx(target([0.25, 1.0]))
    trials = sp.Trials.from_counts(
        PGA, like([2.0, 4.0, 8.0]), like([4.0, 19.0, 36.0]), like([40.0, 40.0, 40.0])
    )
    curve = sp.FragilityCurve("bookcase", trials)
    assert np.array_equal(curve.probability(like([3.0, 4.0])), curve.probability([3.0, 4.0]))
    swept = sp.sweep(sp.Case(BODY, ROOM, motion), {"body.width": like([0.25, 0.5])})
    assert swept.overturned.shape == (2,)
    verdict = sp.verify(BODY, ROOM, shaking=motion, samples=2, levels=like([5.0, 6.0]), progress=False)
    assert np.array_equal(verdict.levels, [5.0, 6.0])


BARE = (SAMPLES, SAMPLES.tolist(), pd.Series(SAMPLES), xr.DataArray(SAMPLES))


@pytest.mark.parametrize("samples", BARE, ids=lambda one: type(one).__name__)
@pytest.mark.parametrize(
    "call",
    [
        lambda bare: sp.simulate(BODY, ROOM, bare),
        lambda bare: sp.simulate(sp.Body.box(0.4, 0.4, 1.0, 20.0), ROOM, bare),
        lambda bare: sp.Case(BODY, ROOM, bare),
        lambda bare: sp.Building(3).respond(bare),
    ],
)
def test_bare_samples_are_refused_with_what_to_do(call: Any, samples: Any):
    kind = type(samples).__name__
    with pytest.raises(
        sp.InputError, match=rf"motion is {kind} of length 200; .*Motion\(dt=0\.01, x=samples\)"
    ):
        call(samples)


@pytest.mark.parametrize("path", ["record.csv", Path("record.csv")])
def test_a_path_in_the_place_of_a_motion_is_refused_with_what_to_do(path: Any):
    with pytest.raises(sp.InputError, match=r"read_motion\('record\.csv'\)"):
        sp.simulate(BODY, ROOM, path)


def test_what_else_is_given_is_told_shortly():
    with pytest.raises(sp.InputError, match=r"body is 0\.3; it must be of type Body \| Piece"):
        sp.simulate(0.3, ROOM, sp.near_fault())  # type: ignore[call-overload]
    with pytest.raises(sp.InputError, match=r"motion is {'dt': 0\.01}; it must be of type Motion"):
        sp.simulate(BODY, ROOM, {"dt": 0.01})  # type: ignore[call-overload]
