"""CSV that a spreadsheet opens: texts that look like formulas are texts, and numbers are numbers."""

import csv
import io

import pytest

import stayput as sp
from stayput.files import csv_text, harmless
from stayput.report.verdict.tables import verdict_csv
from stayput.verification import verify


@pytest.mark.parametrize("text", ["=1+1", "+1", "-1", "@SUM(1)", "\t=1", "\r=1"])
def test_a_text_that_looks_like_a_formula_begins_with_a_quote(text):
    assert harmless(text) == f"'{text}"
    assert list(csv.reader(io.StringIO(csv_text(["a"], [[text]]), newline="")))[1] == [f"'{text}"]


@pytest.mark.parametrize("cell", ["a=1", "1-2", "", " ", 0, -1, -1.5, 1e-9, True])
def test_other_cells_stay(cell):
    assert harmless(cell) == cell


def test_nothing_is_an_empty_cell():
    assert csv_text(["a", "b"], [[None, -1.0]]) == "a,b\r\n,-1.0\r\n"


def test_names_in_a_ranking_do_not_run():
    scenario = {
        "furniture": {"preset": "bookcase"},
        "shaking": {"builtin": "near-fault"},
        "uncertainty": {"samples": 1},
        "measures": [{"type": "anti_slip_sheet", "name": "=cmd|' /C calc'!A0"}],
    }
    verdict = verify(sp.Scenario.parse(scenario), levels=(), progress=False)
    cells = [cell for row in csv.reader(io.StringIO(verdict_csv(verdict))) for cell in row]
    assert "'=cmd|' /C calc'!A0" in cells
    assert not [cell for cell in cells if cell.startswith(("=", "+", "@"))]
