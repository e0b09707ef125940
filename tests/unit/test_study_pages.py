"""The documentation's texts about the studies: every number that they quote is one of the study's run."""

import importlib
import re
import sys
from pathlib import Path

import numpy as np
import pytest

import stayput as sp
import studies

DOCS = Path(__file__).parents[2] / "docs"
TEXTS = sorted((DOCS / "studies").glob("*.md"))


@pytest.fixture(scope="module")
def study_numbers():
    sys.path.insert(0, str(DOCS))
    yield importlib.import_module("study_numbers")
    sys.path.remove(str(DOCS))


@pytest.fixture(scope="module")
def runs():
    """Return every study on a coarse grid, with its motion."""
    record = sp.near_fault()
    along = record.component("x")
    amplitudes, frequencies = [5.0, 7.0, 9.0, 11.0, 13.0], [2.0, 3.0, 4.0]
    return {
        study.name: (study, motion)
        for study, motion in (
            (
                studies.friction(amplitudes=amplitudes, frequencies=frequencies, coefficients=[0.1, 0.6]),
                None,
            ),
            (studies.critical_ratio(ratios=[0.2, 0.4, 0.6], frequencies=[0.5, 1.0, 1.5], step=0.2), None),
            (
                studies.wall_gap(
                    widths=[0.5, 0.9, 1.1],
                    gaps=[0.0, 0.1, 0.2],
                    amplitudes=[5.0],
                    frequencies=[0.8],
                    ratios=[0.3, 0.5],
                ),
                None,
            ),
            (studies.wall_gap_record(along, gaps=np.linspace(0.0, 0.4, 9)), along),
            (studies.spectrum(along, periods=[1.0, 1.8, 3.0], slenderness=[0.2, 0.4], step=0.05), along),
            (studies.tokyo(record, samples=1), record),
            (studies.baseline(2, samples=1), None),
            (studies.tip_over(), None),
            (studies.consumer_centre(3, samples=1), None),
            (studies.tombstones(4, stones=4), None),
            (studies.ac156(sds=[1.0], tests=1, motions=2), None),
            (studies.contents(record, intensities=[6.0]), record),
            (studies.three_dimensions(2, headings=[0.0]), None),
            (studies.capacity(4, corners=(0.4, 1.6), sizes=("chest", "cupboard"), step=0.1), None),
        )
    }


def test_every_study_has_a_text(runs):
    assert {path.stem for path in TEXTS} == set(runs)


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.stem)
def test_its_numbers_are_those_of_the_run(path, runs, study_numbers):
    study, motion = runs[path.stem]
    numbers = study_numbers.numbers_of(study, motion)
    text = path.read_text(encoding="utf-8")
    filled = study_numbers.filled(text, numbers)
    assert "{" not in filled
    assert not re.search(r"\bnan\b", filled)
    for name in re.findall(r"\{\{(\w+)\}\}", text):
        assert str(numbers[name]) in filled


def test_every_number_is_quoted(runs, study_numbers):
    for path in TEXTS:
        quoted = set(re.findall(r"\{\{(\w+)", path.read_text(encoding="utf-8")))
        study, motion = runs[path.stem]
        assert set(study_numbers.NUMBERS[path.stem](study, motion)) <= quoted


def test_a_number_that_there_is_not_stops_the_build(study_numbers):
    assert study_numbers.filled("{{share:.0f}} %", {"share": 12.3}) == "12 %"
    with pytest.raises(KeyError):
        study_numbers.filled("{{shares}} %", {"share": 12.3})
