"""Measures named in any script: names in the files of loss tools, names of files, files all or none."""

import csv
import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest
import verdict_cases
from hypothesis import given
from hypothesis import strategies as st

from stayput import InputError
from stayput.files import harmless, name_part
from stayput.fragility.intensity_measures import INTENSITY_MEASURES
from stayput.report.verdict import exports
from stayput.report.verdict.exports import plain_names
from stayput.scenario.measures import Option

PGA = INTENSITY_MEASURES["PGA"]
NAMES = st.text(st.characters(exclude_categories=("Cs",)), min_size=1, max_size=200)


def named(*names):
    """Return a verdict whose options that fall have these names, beside no measure."""
    verdict = verdict_cases.made()
    bare = verdict.without
    options = tuple(
        replace(bare, option=Option(name), curves=verdict_cases.curves(name, 6.0)) for name in names
    )
    return replace(verdict, options=(bare, *options))


@given(st.lists(NAMES, min_size=1, max_size=8, unique=True))
def test_names_are_plain_and_differ_whatever_they_are(names):
    found = plain_names(names)
    assert all(re.fullmatch(r"[A-Za-z0-9_]{1,100}", name) for name in found)
    assert len({name.casefold() for name in found}) == len(names)


@given(NAMES, NAMES)
def test_a_name_that_stands_alone_is_the_same_beside_others(name, other):
    alone = plain_names([name])[0]
    if other != name and not plain_names([other])[0].casefold().startswith(alone.casefold()):
        assert plain_names([other, name])[1] == alone


def test_names_that_are_plain_already_stay():
    names = ["l_bracket", "tension_pole + wedge_stopper", "no measure"]
    assert plain_names(names) == ["l_bracket", "tension_pole_and_wedge_stopper", "no_measure"]
    for refused in (["a", "a"], [""]):
        with pytest.raises(InputError, match="a name of its own"):
            plain_names(refused)


@given(NAMES)
def test_a_name_as_part_of_a_file_s_name(name):
    part = name_part(name, "motion")
    assert part
    assert len(part.encode()) <= 100
    assert not set(part) & set('/\\:*?"<>|\0\n')
    assert not part.startswith((".", "-"))
    assert not part.endswith((".", "-"))


@pytest.mark.parametrize(
    "names",
    [
        ("ポールとストッパー", "滑り止め"),
        ("a/b", "a\\b", "A b"),
        ("con", "nul.txt", "../../etc"),
        ("x" * 200, "x" * 199 + "y"),
        (" ", "\t"),
        ("é", "e\u0301"),
    ],
)
def test_curves_of_measures_with_any_names_are_written(tmp_path, names):
    files, _ = exports.write_curves(named(*names), PGA, tmp_path / "curves")
    assert [file.name for file in files] == [
        "curves.csv", "observed.csv", "fragility.svg", "pelicun.csv", "nrml.xml",
    ]  # fmt: skip
    with files[0].open(encoding="utf-8-sig", newline="") as text:
        assert {row["option"] for row in csv.DictReader(text)} == {"none", *map(harmless, names)}
    ids = [one.get("id") for one in ET.parse(files[4]).iter() if one.tag.endswith("fragilityFunction")]
    assert len(set(ids)) == len(names) + 1
    assert [row.split(",")[0] for row in files[3].read_text().splitlines()[1:]] == ids


@pytest.mark.parametrize("fails", ["plot_options", "nrml_xml", "pelicun_csv"])
def test_curves_are_written_all_or_none(tmp_path, monkeypatch, fails):
    def broken(*_):
        raise InputError("It cannot be.")

    monkeypatch.setattr(exports, fails, broken)
    with pytest.raises(InputError, match="cannot be"):
        exports.write_curves(named("mats"), PGA, tmp_path / "new")
    assert not (tmp_path / "new").exists()
    old = tmp_path / "old"
    old.mkdir()
    (old / "curves.csv").write_text("kept")
    with pytest.raises(InputError, match="cannot be"):
        exports.write_curves(named("mats"), PGA, old)
    assert [(path.name, path.read_text()) for path in old.iterdir()] == [("curves.csv", "kept")]
