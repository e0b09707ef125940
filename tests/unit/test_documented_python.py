"""The Python of the documentation's pages runs as it is told, as do the tutorial and every example."""

import re
import runpy
from pathlib import Path

import nbformat
import pytest
from few_runs import EXAMPLES, copy_examples
from nbclient import NotebookClient

import stayput as sp
from stayput.cli.flags import EXAMPLE

PAGES = Path(__file__).parents[2] / "docs"
PYTHON = re.compile(r"```python\n(.*?)```", re.DOTALL)
QUOTED = re.compile(r'^([\w.()\[\], ]+?)  # "(.*)"$', re.MULTILINE)
"""A value on its own line, with the text that it is."""

NEEDS_MORE = {
    "buildings.md": "a folder of records",
    "intensity.md": "a record",
    "motions.md": "a record",
    "space.md": "a mesh",
    "suites.md": "a folder of records",
    "verify.md": "the examples",
}
"""Pages whose blocks go on from what the reader has."""

BLOCKS = {page.name: PYTHON.findall(page.read_text(encoding="utf-8")) for page in sorted(PAGES.glob("*.md"))}
RUN = [name for name, blocks in BLOCKS.items() if blocks and name not in NEEDS_MORE]


def test_the_pages_are_found():
    assert {"contents.md", "everyday.md", "fragility.md", "standards.md"} <= set(RUN)
    assert set(NEEDS_MORE) <= {name for name, blocks in BLOCKS.items() if blocks}


@pytest.mark.parametrize("name", RUN)
def test_the_python_of_a_page_runs(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    copy_examples(tmp_path)
    told = {}
    for block in BLOCKS[name]:
        exec(block, told)
        for value, shown in QUOTED.findall(block):
            assert eval(value, told) == shown


def test_the_bookcase_of_the_page_on_contents_stands_and_its_lip_holds():
    told = {}
    exec(BLOCKS["contents.md"][0], told)
    assert not told["spilt"].overturned
    assert 0.0 < told["spilt"].share_out < 1.0
    assert told["sp"].spill(told["bookcase"], told["sp"].Contents("books", lip=0.02)).share_out == 0.0


def printed(notebook: nbformat.NotebookNode) -> str:
    outputs = [out for cell in notebook.cells if cell.cell_type == "code" for out in cell.outputs]
    return "".join(out.get("text", "") for out in outputs)


def test_the_tutorial_is_kept_without_what_it_prints() -> None:
    notebook = nbformat.read(PAGES / "tutorial.ipynb", as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in code)


def test_the_tutorial_runs() -> None:
    notebook = nbformat.read(PAGES / "tutorial.ipynb", as_version=4)
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    assert "It lies after" in printed(notebook)
    shown = [
        out["data"]
        for cell in notebook.cells
        if cell.cell_type == "code"
        for out in cell.outputs
        if "data" in out
    ]
    assert sum("image/png" in data for data in shown) == 1
    body, run, film, verdict = (data["text/html"] for data in shown if "text/html" in data)
    assert "g tan α" in body
    assert "overturned" in run
    assert film.startswith("<iframe")
    assert verdict.index("Screwed L-brackets") < verdict.index("Without measures")


@pytest.mark.parametrize("script", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_script(script):
    runpy.run_path(str(script), run_name="__main__")


@pytest.mark.parametrize("file", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_scenario_file(file):
    run = sp.read(file).run()
    assert run.outcome is not sp.Outcome.FAILED
    assert run.motion.synthetic  # so it needs no other file


def test_the_command_lines_example_is_the_bookcase_of_the_examples():
    built_in, file = sp.Scenario.parse(EXAMPLE).case(), sp.read(EXAMPLES / "bookcase.toml").case()
    assert (built_in.body, built_in.room) == (file.body, file.room)
