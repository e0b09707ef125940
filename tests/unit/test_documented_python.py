"""The Python of the documentation's pages runs as it is told, each page by itself, beside the examples."""

import re
from pathlib import Path

import pytest

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
    (tmp_path / "examples").mkdir()
    for file in (PAGES.parent / "examples").glob("*.toml"):  # with few motions and samples
        few = re.sub(r"\b(count|samples) = \d+", r"\1 = 4", file.read_text(encoding="utf-8"))
        (tmp_path / "examples" / file.name).write_text(few, encoding="utf-8")
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
