"""Files for loss tools against the formats' own rules, and against the tools themselves.

The tools exclude versions that stayput is tested with (pelicun 3.10: SciPy from 1.16, pandas from 3 on), so
the tests that call them run in an environment of their own: `make peers`. What pelicun computed there is
kept here; every machine holds the files, read by the same rules, against it.

pelicun: rules of its damage model parameters, read from pelicun 3.10 (model/damage_model.py, uq.py,
settings/default_units.json) and its model library (dlml/vocabulary.py). NRML 0.5: rules of the OpenQuake
manual, "Fragility Models", and of openquake.engine 3.26 (risklib/read_nrml.py, risklib/scientific.py).
"""

from __future__ import annotations

import csv
import io
import math
import re
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.special import ndtr, ndtri
from scipy.stats import lognorm

from stayput import InputError
from stayput.fragility.curve import CurveState, FragilityCurve, fragility_curve
from stayput.fragility.intensity_measures import (
    JMA_INTENSITY,
    MMI,
    PFA,
    PFV,
    PGA,
    PGV,
    IntensityMeasure,
    spectral_acceleration,
)
from stayput.fragility.trials import Trials
from stayput.report.verdict.exports import NAMESPACE, pelicun_csv, write_nrml, write_pelicun

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import ArrayLike, NDArray

G = 9.80665
SI = {"g": G, "cmps": 0.01, "unitless": 1.0}
"""SI value of pelicun's units."""


def _curve(measure: IntensityMeasure, median: float, beta: float, name: str) -> FragilityCurve:
    u = measure.coordinate(median) + beta * np.linspace(-2.0, 2.0, 9)
    runs = np.full(9, 10**8)
    fell = np.rint(runs * ndtr(np.linspace(-2.0, 2.0, 9)))
    return fragility_curve(Trials.from_counts(measure, measure.value(u), fell, runs), name)


CURVES = [
    _curve(PGA, 3.5, 0.4, "no measure"),
    _curve(PGV, 0.6, 0.45, "tension poles + stopper"),
    _curve(JMA_INTENSITY, 6.1, 0.3, "L-bracket"),
]
FLOORS = [_curve(PFA, 4.0, 0.5, "rack (floor A)"), _curve(PFV, 0.8, 0.35, "rack (floor V)")]

# 30 % fall early and stay the only ones for long
PLATEAU = [0, 6, 11, 12, 12, 13, 25, 38, 40]


def _plateau(
    measure: IntensityMeasure, im: ArrayLike, name: str, fell: list[int] = PLATEAU
) -> FragilityCurve:
    curve = fragility_curve(Trials.from_counts(measure, im, fell, [40] * 9), name)
    assert curve.lognormal is not None
    assert not curve.lognormal.fits
    return curve


BY_POINTS = [
    _plateau(PGV, np.geomspace(0.2, 2.0, 9), "plateau"),
    _plateau(JMA_INTENSITY, np.linspace(4.5, 7.0, 9), "plateau I"),
    # the weakest level has falls, and the strongest survivors
    _plateau(PFA, np.geomspace(1.5, 9.0, 9), "plateau, cut off", [4, *PLATEAU[1:8], 39]),
]
ALL = CURVES + FLOORS + BY_POINTS

DEMANDS = {
    "PGA": ("lognormal", 0.3, 0.3, "g"),
    "PGV": ("lognormal", 70.0, 0.3, "cmps"),
    "JMA": ("normal_std", 6.2, 0.2, "unitless"),
    "PFA": ("lognormal", 0.5, 0.3, "g"),
    "PFV": ("lognormal", 60.0, 0.3, "cmps"),
}
"""Family, median, dispersion and unit of each demand, as pelicun is given them."""

OF_PELICUN = (0.36362, 0.61192, 0.60915, 0.63716, 0.26582, 0.36067, 0.48392, 0.51222)
"""Probability of falling of each of `ALL` under these, by pelicun 3.10.0: 100,000 samples, seed 1."""


@pytest.fixture
def table(tmp_path: Path) -> Path:
    path = tmp_path / "fragility.csv"
    write_pelicun(ALL, path)
    return path


@pytest.fixture
def model(tmp_path: Path) -> Path:
    path = tmp_path / "fragility.xml"
    write_nrml(CURVES, path, "Bookcase, 5階")
    return path


def test_pelicun_rules(table: Path) -> None:
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert [row["ID"] for row in rows] == [
        "no_measure",
        "tension_poles_and_stopper",
        "L_bracket",
        "rack_floor_A",
        "rack_floor_V",
        "plateau",
        "plateau_I",
        "plateau_cut_off",
    ]
    demands = {
        "PGA": "Peak Ground Acceleration",
        "PGV": "Peak Ground Velocity",
        "PFA": "Peak Floor Acceleration",
        "PFV": "Peak Floor Velocity",
        "JMA": "JMA Instrumental Intensity",
    }
    for row, curve in zip(rows, ALL, strict=True):
        assert row["Demand-Type"] == demands[curve.measure.key]
        assert (row["Incomplete"], row["Demand-Offset"], row["Demand-Directional"]) == ("0", "0", "0")
        if curve in BY_POINTS:
            continue
        # of "normal" the second parameter would be a coefficient of variation
        assert row["LS1-Family"] == ("normal_std" if curve.measure is JMA_INTENSITY else "lognormal")
        assert float(row["LS1-Theta_0"]) * SI[row["Demand-Unit"]] == pytest.approx(curve.lognormal.median)
        assert float(row["LS1-Theta_1"]) == pytest.approx(curve.lognormal.dispersion)


def test_spectral_accelerations_and_mercalli_intensities(tmp_path: Path) -> None:
    """OpenQuake calls them SA(0.3) [g] and MMI; pelicun splits a demand at | into its type and the period."""
    curves = [_curve(spectral_acceleration(0.3), 0.8 * G, 0.4, "本棚"), _curve(MMI, 8.5, 0.5, "本棚 2")]
    write_nrml(curves, tmp_path / "a.xml")
    first, second = ET.parse(tmp_path / "a.xml").getroot().iter(f"{{{NAMESPACE}}}fragilityFunction")
    assert [function[0].attrib["imt"] for function in (first, second)] == ["SA(0.3)", "MMI"]
    mean = 0.8 * math.exp(0.5 * 0.4**2)
    deviation = mean * math.sqrt(math.exp(0.4**2) - 1.0)
    assert float(first[1].attrib["mean"]) == pytest.approx(mean, rel=1e-3)
    assert float(first[1].attrib["stddev"]) == pytest.approx(deviation, rel=0.01)
    assert second.attrib["format"] == "discrete"
    write_pelicun(curves, tmp_path / "a.csv")
    with (tmp_path / "a.csv").open() as file:
        sa, mmi = csv.DictReader(file)
    assert (sa["Demand-Type"], sa["Demand-Unit"]) == ("Spectral Acceleration|0.3", "g")
    assert float(sa["LS1-Theta_0"]) == pytest.approx(0.8, rel=1e-3)
    assert (mmi["Demand-Type"], mmi["LS1-Family"]) == ("Modified Mercalli Intensity", "normal_std")


def test_curve_that_no_lognormal_fits_is_written_by_its_levels(tmp_path: Path) -> None:
    write_nrml(BY_POINTS[:1], tmp_path / "a.xml")
    (function,) = ET.parse(tmp_path / "a.xml").getroot().iter(f"{{{NAMESPACE}}}fragilityFunction")
    imls, poes = function
    assert (function.attrib["format"], imls.attrib["imt"]) == ("discrete", "PGV")
    levels, shares = ([float(x) for x in (node.text or "").split()] for node in (imls, poes))
    assert levels == pytest.approx(100.0 * np.geomspace(0.2, 2.0, 9), rel=1e-5)
    assert shares == pytest.approx(np.array(PLATEAU) / 40.0)


def _points(theta: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    x, y = (np.array(part.split(","), np.float64) for part in theta.split("|"))
    return x, y


SHARES = st.lists(st.integers(0, 40), min_size=2, max_size=12).filter(lambda fell: fell[0] < fell[-1])


@settings(max_examples=150, deadline=None)
@given(
    fell=SHARES,
    measure=st.sampled_from([PGA, PGV, JMA_INTENSITY]),
    first=st.floats(0.05, 3.0),
    # levels may be nearer than pelicun's six digits tell apart
    steps=st.lists(st.sampled_from([1e-9, 1e-5, 0.05, 1.0]), min_size=11, max_size=11),
)
def test_points_that_pelicun_takes(
    fell: list[int], measure: IntensityMeasure, first: float, steps: list[float]
) -> None:
    """It wants shares from 0 to 1, and both to rise by more than 1e-8 as it keeps them: six digits, SI."""
    im = first + np.cumsum([0.0, *steps])[: len(fell)]
    curve = fragility_curve(Trials.from_counts(measure, im, fell, [40] * len(fell)), "curve")
    assume(curve.state is CurveState.FITTED and not (curve.lognormal and curve.lognormal.fits))
    (row,) = csv.DictReader(io.StringIO(pelicun_csv([curve])))
    assert (row["LS1-Family"], row["LS1-Theta_1"]) == ("multilinear_CDF", "")
    x, y = _points(row["LS1-Theta_0"])
    unit = SI[row["Demand-Unit"]]
    kept = np.array([float(f"{value:g}") for value in unit * x])
    assert (y[0], y[-1]) == (0.0, 1.0)
    assert (np.diff(kept) > 1e-8).all()
    assert (np.diff([float(f"{share:g}") for share in y]) > 1e-8).all()
    # and is the curve, wherever levels are not as near as the digits
    if min(steps[: len(fell) - 1]) > 1e-3:
        inside = curve.grid(50)[1:-1]
        assert np.interp(inside / unit, x, y) == pytest.approx(curve.probability(inside), abs=2.5e-3)


def test_pelicuns_points_outside_what_was_run() -> None:
    (row,) = csv.DictReader(io.StringIO(pelicun_csv(BY_POINTS[2:])))
    x, y = _points(row["LS1-Theta_0"])
    assert x[0] == 0.0
    assert (x[1] * G, x[-2] * G) == (pytest.approx(1.5, rel=1e-4), pytest.approx(9.0, rel=1e-4))
    assert (y[1], y[-2]) == (0.1, pytest.approx(39 / 40))
    assert x[-1] < 1.01 * x[-2]  # above, everything falls


def test_nrml_rules(model: Path) -> None:
    root = ET.parse(model).getroot()
    tag = f"{{{NAMESPACE}}}"
    assert root.tag == f"{tag}nrml"
    (fragility,) = root
    assert fragility.tag == f"{tag}fragilityModel"
    assert re.fullmatch(r"[A-Za-z0-9_-]{1,100}", fragility.attrib["id"])
    assert fragility.attrib["lossCategory"] == "contents"
    assert [child.tag for child in fragility][:2] == [f"{tag}description", f"{tag}limitStates"]
    description, states, *functions = fragility
    assert (description.text or "").isascii()
    (state,) = (states.text or "").split()
    assert [f.attrib["id"] for f in functions] == ["no_measure", "tension_poles_and_stopper", "L_bracket"]
    for function in functions[:2]:
        assert (function.attrib["format"], function.attrib["shape"]) == ("continuous", "logncdf")
        imls, params = function
        assert (imls.tag, params.tag, params.attrib["ls"]) == (f"{tag}imls", f"{tag}params", state)
        assert 0.0 < float(imls.attrib["minIML"]) < float(imls.attrib["maxIML"])
    imls, poes = functions[2]
    assert (functions[2].attrib["format"], imls.attrib["imt"], poes.attrib["ls"]) == (
        "discrete",
        "JMA",
        state,
    )
    levels, shares = ([float(x) for x in (node.text or "").split()] for node in (imls, poes))
    assert len(levels) == len(shares)
    assert (np.diff(levels) > 0.0).all()
    assert (np.diff(shares) >= 0.0).all()
    assert shares[0] >= 0.0
    assert shares[-1] <= 1.0


def test_nrml_moments_are_those_of_the_variable(model: Path) -> None:
    # the manual: mean and standard deviation of the intensity measure, not of its logarithm
    mean, deviation = lognorm.stats(0.4, scale=3.5 / G, moments="mv")
    (params, *_) = ET.parse(model).getroot().iter(f"{{{NAMESPACE}}}params")
    assert float(params.attrib["mean"]) == pytest.approx(float(mean), rel=1e-6)
    assert float(params.attrib["stddev"]) == pytest.approx(float(np.sqrt(deviation)), rel=1e-6)


def test_refused(tmp_path: Path) -> None:
    standing = fragility_curve(Trials.from_counts(PGA, [1.0, 2.0], [0, 0], [9, 9]), "bracket")
    fallen = np.arange(40) < np.array([0, 12, 28, 40])[:, np.newaxis, np.newaxis]
    alone = fragility_curve(Trials.from_runs(PGA, [1.0, 2.0, 3.0, 4.0], fallen), "record")
    for write, path in ((write_pelicun, tmp_path / "a.csv"), (write_nrml, tmp_path / "a.xml")):
        for curves, said in (
            ([standing], "none fell"),
            ([alone], "of one motion"),
            ([CURVES[0], CURVES[0]], "Two are named"),
            ([], "curves is empty"),
        ):
            with pytest.raises(InputError, match=said):
                write(curves, path)
        with pytest.raises(InputError, match="ends in"):
            write([CURVES[0]], tmp_path / "a.txt")
    with pytest.raises(InputError, match="PFA"):
        write_nrml(FLOORS, tmp_path / "a.xml")
    assert list(tmp_path.iterdir()) == []


def _falling(row: dict[str, str], key: str) -> float:
    """Return the probability of falling of a row of the file under its demand, by pelicun's rules."""
    family, median, spread, unit = DEMANDS[key]
    assert row["Demand-Unit"] == unit
    margin = ndtri((np.arange(20_000) + 0.5) / 20_000)
    demand = median * np.exp(spread * margin) if family == "lognormal" else median + spread * margin
    theta, spread_of_theta = row["LS1-Theta_0"], row["LS1-Theta_1"]
    match row["LS1-Family"]:
        case "multilinear_CDF":
            shares = np.interp(demand, *_points(theta))
        case "lognormal":
            shares = ndtr(np.log(demand / float(theta)) / float(spread_of_theta))
        case _:
            shares = ndtr((demand - float(theta)) / float(spread_of_theta))
    return float(np.mean(shares))


def test_our_files_hold_what_pelicun_computed_from_them(table: Path) -> None:
    rows = csv.DictReader(table.open())
    computed = [_falling(row, curve.measure.key) for row, curve in zip(rows, ALL, strict=True)]
    assert computed == pytest.approx(OF_PELICUN, abs=0.006)


def test_pelicun_reads_and_computes(table: Path) -> None:
    assessment = pytest.importorskip("pelicun.assessment", reason="pelicun is not installed: make peers")
    import pandas as pd
    from pelicun import file_io  # pyright: ignore[reportMissingImports]

    own = {"JMA Instrumental Intensity": {"Acronym": "JMA", "UnitType": "unitless"}}
    options = {"CustomDemandTypes": own, "NonDirectionalMultipliers": {"ALL": 1.0}}
    ours = assessment.Assessment({"PrintLog": False, "Seed": 1, **options})
    demands = pd.DataFrame(
        list(DEMANDS.values()),
        columns=["Family", "Theta_0", "Theta_1", "Units"],
        # pelicun counts floors from 0: storey 1 stands on floor 0
        index=pd.MultiIndex.from_tuples([(key, "0" if "F" in key else "1", "1") for key in DEMANDS]),
    )
    ours.demand.load_model({"marginals": demands})
    ours.demand.generate_sample({"SampleSize": 100_000})
    ours.stories = 1
    names = [row["ID"] for row in csv.DictReader(table.open())]
    columns = {"Units": "ea", "Location": "1", "Direction": "1", "Theta_0": 1.0, "Blocks": 1}
    ours.asset.load_cmp_model({"marginals": pd.DataFrame(columns, index=names)})
    ours.asset.generate_cmp_sample(100_000)
    factors = ours.unit_conversion_factors
    parameters = file_io.load_data(str(table), reindex=False, unit_conversion_factors=factors)
    ours.damage.load_model_parameters([parameters], set(names))
    ours.damage.calculate()
    fallen = ours.damage.ds_model.probabilities()[1]
    computed = [fallen.xs(name, level=0).item() for name in names]
    assert computed == pytest.approx(OF_PELICUN, abs=1e-3)  # the same seed


def test_openquake_reads_and_computes(model: Path) -> None:
    pytest.importorskip("openquake.risklib", reason="OpenQuake is not installed: make peers")
    from openquake.hazardlib import nrml  # pyright: ignore[reportMissingImports]
    from openquake.hazardlib.imt import from_string  # pyright: ignore[reportMissingImports]

    found = nrml.to_python(str(model))
    assert found.limitStates == ["overturned"]
    names = ("no_measure", "tension_poles_and_stopper", "L_bracket")
    for name, curve, imt, unit in zip(names, CURVES, ("PGA", "PGV", "JMA"), (1 / G, 100.0, 1.0), strict=True):
        assert from_string(imt).string == imt
        (function,) = found[imt, name].build(found.limitStates)
        im = curve.grid(9)
        assert np.asarray(function(im * unit)) == pytest.approx(curve.probability(im), abs=1e-3)
