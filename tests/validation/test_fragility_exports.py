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
import math
import re
import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

import numpy as np
import pytest
from scipy.special import expit, ndtr, ndtri
from scipy.stats import lognorm

from stayput import InputError
from stayput.fragility.curve import PROBIT, FragilityCurve
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
from stayput.report.verdict.exports import NAMESPACE, write_nrml, write_pelicun

if TYPE_CHECKING:
    from pathlib import Path

G = 9.80665
SI = {"g": G, "cmps": 0.01, "unitless": 1.0}
"""SI value of pelicun's units."""


def _curve(measure: IntensityMeasure, median: float, beta: float, name: str) -> FragilityCurve:
    u = measure.coordinate(median) + beta * np.linspace(-2.0, 2.0, 9)
    runs = np.full(9, 10**8)
    fell = np.rint(runs * expit(PROBIT * np.linspace(-2.0, 2.0, 9)))
    return FragilityCurve(name, Trials.from_counts(measure, measure.value(u), fell, runs))


CURVES = [
    _curve(PGA, 3.5, 0.4, "no measure"),
    _curve(PGV, 0.6, 0.45, "tension poles + stopper"),
    _curve(JMA_INTENSITY, 6.1, 0.3, "L-bracket"),
]
FLOORS = [_curve(PFA, 4.0, 0.5, "rack (floor A)"), _curve(PFV, 0.8, 0.35, "rack (floor V)")]

ALL = CURVES + FLOORS

DEMANDS = {
    "PGA": ("lognormal", 0.3, 0.3, "g"),
    "PGV": ("lognormal", 70.0, 0.3, "cmps"),
    "JMA": ("normal_std", 6.2, 0.2, "unitless"),
    "PFA": ("lognormal", 0.5, 0.3, "g"),
    "PFV": ("lognormal", 60.0, 0.3, "cmps"),
}
"""Family, median, dispersion and unit of each demand, as pelicun is given them."""

OF_PELICUN = (0.36362, 0.61192, 0.60915, 0.63716, 0.26582)
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
    assert float(first[1].attrib["mean"]) == pytest.approx(mean, rel=2e-3)
    assert float(first[1].attrib["stddev"]) == pytest.approx(deviation, rel=0.01)
    assert second.attrib["format"] == "discrete"
    write_pelicun(curves, tmp_path / "a.csv")
    with (tmp_path / "a.csv").open() as file:
        sa, mmi = csv.DictReader(file)
    assert (sa["Demand-Type"], sa["Demand-Unit"]) == ("Spectral Acceleration|0.3", "g")
    assert float(sa["LS1-Theta_0"]) == pytest.approx(0.8, rel=1e-3)
    assert (mmi["Demand-Type"], mmi["LS1-Family"]) == ("Modified Mercalli Intensity", "normal_std")


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
    assert CURVES[0].lognormal == pytest.approx((3.5, 0.4), rel=2e-3)
    median, dispersion = CURVES[0].lognormal
    mean, deviation = lognorm.stats(dispersion, scale=median / G, moments="mv")
    (params, *_) = ET.parse(model).getroot().iter(f"{{{NAMESPACE}}}params")
    assert float(params.attrib["mean"]) == pytest.approx(float(mean), rel=1e-6)
    assert float(params.attrib["stddev"]) == pytest.approx(float(np.sqrt(deviation)), rel=1e-6)


def test_refused(tmp_path: Path) -> None:
    standing = FragilityCurve("bracket", Trials.from_counts(PGA, [1.0, 2.0], [0, 0], [9, 9]))
    fallen = np.arange(40) < np.array([0, 12, 28, 40])[:, np.newaxis, np.newaxis]
    alone = FragilityCurve("record", Trials.from_runs(PGA, [1.0, 2.0, 3.0, 4.0], fallen))
    for write, path in ((write_pelicun, tmp_path / "a.csv"), (write_nrml, tmp_path / "a.xml")):
        for curves, said in (
            ([standing], "half fall lies beyond what was run"),
            ([alone], "one motion has no scatter"),
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
    assert computed == pytest.approx(OF_PELICUN, abs=4e-3)


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
        nearest = ndtr(np.log(im / curve.lognormal.median) / curve.lognormal.dispersion)
        expected = curve.probability(im) if imt == "JMA" else nearest
        assert np.asarray(function(im * unit)) == pytest.approx(expected, abs=1e-3)
