"""Texts of a user's inside pages and tables: they stay texts."""

from __future__ import annotations

import csv
import dataclasses
import io
import json
import re
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st
from report_runs import falling
from space_runs import spinning
from verdict_cases import made

from stayput.files import csv_text
from stayput.report.animation import film_of, player_page
from stayput.report.page import canvas_files, script_json, script_module
from stayput.report.verdict.exports import curves_csv, observed_csv
from stayput.report.verdict.tables import verdict_csv

if TYPE_CHECKING:
    import stayput as sp

HOSTILE = ["<!--<script>", "</script><script>alert(1)</script>", "{{data}}", "{{title}}", "a&amp;b"]


@given(st.recursive(st.text(), lambda inside: st.lists(inside) | st.dictionaries(st.text(), inside)))
def test_json_in_a_script_has_none_of_html_s_characters_and_is_the_same(values: object) -> None:
    text = script_json(values)
    assert not set(text) & set("<>&\u2028\u2029")
    assert json.loads(text) == values


def test_json_in_a_script_has_finite_numbers_only() -> None:
    with pytest.raises(ValueError, match="JSON"):
        script_json([float("nan")])


def test_an_inline_module_has_no_imports_and_no_exports() -> None:
    text = script_module('import { flatPainter } from "./canvas/space_flat.js";\nflatPainter();\n')
    assert not re.search(r"^(import|export)\b", text, re.MULTILINE)
    assert text.count("function flatPainter(") == 1
    assert text.endswith("flatPainter();\n")
    names = re.findall(r"^(?:const|let|function) (\w+)", text, re.MULTILINE)
    assert len(names) == len(set(names)), "all modules share one scope"
    assert "</script" not in text
    assert "inks.css" in canvas_files()


@pytest.mark.parametrize(
    ("run", "names"), [*((falling(), [name]) for name in HOSTILE), (spinning(), HOSTILE[:3])]
)
def test_a_player_stands_alone_and_holds_any_name(run: sp.Run, names: list[str]) -> None:
    page = player_page([film_of(run.named(names))], 1.0, 1.0)
    assert not re.search(r"https?:|src=|@import|url\(", page)
    assert (page.count("<script"), page.count("</script>")) == (2, 2)
    found = re.search(r'<script id="run" type="application/json">(.*?)</script>', page, re.DOTALL)
    assert found
    (data,) = json.loads(found[1])["films"]
    assert [body["name"] for body in data["bodies"]] == names
    steps = [["stays", "moves", "falls"]] if run.engine == "plane" else [["stays"], ["moves"], ["stays"]]
    assert [[step for _, step in body["stability"]] for body in data["bodies"]] == steps
    declared = re.findall(r"^(?:const|let|function) (\w+)", page.rsplit("<script", 1)[1], re.MULTILINE)
    assert len(declared) == len(set(declared)), "all modules share one scope"
    assert len(page) < 130_000


@pytest.mark.parametrize("begins", ["=", "+", "-", "@", "\t", "\r", "＝"])
def test_cells_that_a_spreadsheet_would_run_are_texts(begins: str) -> None:
    name = f"{begins}cmd|' /C calc'!A0"
    shown = name.replace("\r", " ")
    assert csv_text([name], [[f"a{name}"]], "\n") == f"'{shown}\na{shown}\n"
    verdict = made()
    one = verdict.options[0]
    curve, *_ = one.curves.values()
    one = dataclasses.replace(one, option=dataclasses.replace(one.option, name=name))
    curve = dataclasses.replace(curve, name=name)
    texts = (
        verdict_csv(dataclasses.replace(verdict, options=(one, *verdict.options[1:]))),
        curves_csv([curve], curve.measure),
        observed_csv([curve]),
    )
    for text in texts:
        rows = list(csv.DictReader(io.StringIO(text, newline="")))
        assert rows[0]["option"] == f"'{shown}"


def test_numbers_keep_their_signs() -> None:
    rows = list(csv.DictReader(verdict_csv(made()).splitlines()))
    numbers = [value for row in rows for key, value in row.items() if "_text" not in key and key != "option"]
    assert not [value for value in numbers if value.startswith("'")]
