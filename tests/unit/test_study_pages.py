"""The documentation's texts about the studies: every number that they quote is one of the study's run."""

import importlib
import sys
from pathlib import Path

import jinja2
import numpy as np
import pytest

import stayput as sp
import studies
from long_cases import long
from studies import __main__ as run_studies

DOCS = Path(__file__).parents[2] / "docs"
NAMES = [study.__name__ for study in (*studies.PAPER, *studies.EVIDENCE)]
RECORD = sp.near_fault()
COARSE = {
    "friction": {"amplitudes": [5.0, 7.0, 9.0, 11.0, 13.0], "frequencies": [2.0, 3.0, 4.0]},
    "critical_ratio": {"ratios": [0.2, 0.4, 0.6], "frequencies": [0.5, 1.0, 1.5], "step": 0.2},
    "wall_gap": {
        "widths": [0.5, 0.9, 1.1],
        "gaps": [0.0, 0.1, 0.2],
        "amplitudes": [5.0],
        "frequencies": [0.8],
        "ratios": [0.3, 0.5],
    },
    "wall_gap_record": {"motion": RECORD, "gaps": np.linspace(0.0, 0.4, 9)},
    "tokyo": {"motion": RECORD, "samples": 1},
    "consumer_centre": {"motions": 3, "samples": 1},
    "baseline": {"motions": 2, "samples": 1},
    "capacity": {"motions": 4, "corners": (0.4, 1.6), "sizes": ("chest", "cupboard"), "step": 0.1},
    "contents": {"motion": RECORD, "intensities": [6.0]},
    "tombstones": {"motions": 4, "stones": 4},
    "races": {"count": 1},
    "three_dimensions": {"motions": 1, "headings": [0.0]},
}
"""Coarse grids and few runs of each study."""


@pytest.fixture(scope="module")
def study_pages():
    added = [str(DOCS), str(DOCS.parent / "benchmarks")]
    sys.path[:0] = added
    yield importlib.import_module("study_pages")
    sys.path[:] = [path for path in sys.path if path not in added]


def test_every_study_has_a_text():
    assert {path.stem for path in (DOCS / "studies").glob("*.md")} == set(NAMES) == set(COARSE)


DEAR = ("baseline", "races", "three_dimensions")
"""Studies that take seconds however few their runs; the validations run them."""


@pytest.mark.parametrize("name", [*(name for name in NAMES if name not in DEAR), *long(*DEAR)])
def test_its_section_has_the_numbers_of_the_run_and_files_to_download(name, study_pages, tmp_path):
    study = getattr(studies, name)(**COARSE[name])
    assert study.name == name
    section = study_pages.section(study, COARSE[name].get("motion"), tmp_path)
    assert "{{" not in section
    assert "nan" not in section.split()
    for caption in study.tables:
        assert caption in section
    files = {file.name for file in (tmp_path / "studies").iterdir()}
    assert {f"{name}.{kind}" for kind in ("nc", "md", "png", "csv")} <= files
    assert len(files) == 4 + len(study.tables)
    for row in study.claims:
        assert row["comes out"] in ("yes", "partly", "no")


def test_a_number_that_there_is_not_stops_the_build(study_pages, tmp_path, monkeypatch):
    (tmp_path / "contents.md").write_text("{{ agree }} and {{ shares }}", encoding="utf-8")
    monkeypatch.setattr(study_pages, "TEXTS", tmp_path)
    with pytest.raises(jinja2.UndefinedError, match="shares"):
        study_pages.filled(studies.contents(intensities=[6.0]), None)


def test_the_module_runs_the_paper_s_sections_or_those_named(monkeypatch, tmp_path, capsys):
    record = tmp_path / "record.csv"
    record.write_text("time [s],x [m/s2]\n" + "".join(f"{0.01 * n:g},{n % 7 - 3}\n" for n in range(300)))
    seen, made = [], studies.contents(intensities=[])

    def wall_gap_record(motion=None):
        seen.append(motion)
        return made

    monkeypatch.setattr(run_studies, "PAPER", (wall_gap_record,))
    for arguments in ([], ["--record", str(record)], ["wall_gap_record"]):
        monkeypatch.setattr(sys, "argv", ["studies", "--out", str(tmp_path / "out"), *arguments])
        run_studies.main()
    assert [motion is not None for motion in seen] == [False, True, False]
    assert seen[1].pga == 3.0
    assert (tmp_path / "out" / "contents.png").is_file()
    assert "| quantity | published | stayput | difference |" in capsys.readouterr().out
    monkeypatch.setattr(sys, "argv", ["studies", "spectra"])
    with pytest.raises(SystemExit, match="2"):
        run_studies.main()
    assert "there is no study spectra; there are wall_gap_record, tokyo" in capsys.readouterr().err
