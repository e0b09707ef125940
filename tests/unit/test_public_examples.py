"""Every public name shows an example that runs on its own page; what examples import is on the API page."""

from __future__ import annotations

import ast
import doctest
import json
import re
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from few_runs import copy_examples
from test_documented_python import BLOCKS, RUN

import stayput
from stayput import measures

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[2]
API = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
PLACES = (stayput, measures)
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE  # tables of pandas end in blanks
DICTIONARIES = {"CONTENTS", "SURFACES", "MEASURES"}
"""Public dictionaries: they have no page of their own; their content stands in tables of other pages."""


def on_pages() -> set[tuple[str, str]]:
    """Return the module and the name of each page that the API page asks for."""
    found, module = set[tuple[str, str]](), ""
    for line in API.splitlines():
        if line.startswith(".. currentmodule:: "):
            module = line.rpartition(" ")[2]
        elif re.fullmatch(r"   [\w.]+", line):
            where, _, name = f"{module}.{line.strip()}".rpartition(".")
            found.add((where, name))
    return found


PAGES = on_pages()
PUBLIC = {
    name: thing
    for thing, name in {  # each once, though some are in two modules
        getattr(import_module(module), name): f"{module.removeprefix('stayput.')}.{name}"
        for module, name in sorted(
            PAGES | {(place.__name__, name) for place in PLACES for name in place.__all__}
        )
        if name not in DICTIONARIES and f"{module}.{name}" != measures.__name__
    }.items()
}


def cells_of_the_tutorial() -> Iterator[str]:
    for cell in json.loads((ROOT / "docs" / "tutorial.ipynb").read_text(encoding="utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            yield "".join(line for line in cell["source"] if not line.startswith("%"))


def shown() -> list[str]:
    """Return all Python that readers are shown."""
    readme = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    programs = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "examples").glob("*.py"))]
    pages = [block for name in RUN for block in BLOCKS[name]]
    return [*readme, *programs, *pages, *cells_of_the_tutorial()]


def imports() -> set[tuple[str, str]]:
    """Return the modules and names that readers are shown to import from the package."""
    return {
        (node.module, alias.name)
        for source in shown()
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.ImportFrom) and node.module and node.module.partition(".")[0] == "stayput"
        for alias in node.names
    }


def examples_of(thing: Any, name: str) -> list[doctest.DocTest]:
    """Return the doctests of an object, its own first, and of its own methods."""
    tests = doctest.DocTestFinder(exclude_empty=True).find(thing, name)
    return sorted((test for test in tests if test.examples), key=lambda test: test.name != name)


@pytest.mark.parametrize("name", sorted(PUBLIC))
def test_a_public_name_shows_an_example_that_runs(name: str, tmp_path: Path, monkeypatch: Any) -> None:
    copy_examples(tmp_path)
    monkeypatch.chdir(tmp_path)
    found = examples_of(PUBLIC[name], name)
    assert found, f"{name} has no example"
    assert found[0].name == name, f"{name} has examples of its methods only"
    assert "\n    Examples\n    --------\n" in PUBLIC[name].__doc__
    for test in found:
        told: list[str] = []
        failed, _ = doctest.DocTestRunner(optionflags=FLAGS).run(test, out=told.append)
        assert not failed, "".join(told)


def test_no_two_names_show_the_same_example() -> None:
    sources: dict[str, str] = {}
    for name, thing in PUBLIC.items():
        for test in examples_of(thing, name)[:1]:
            source = "".join(example.source for example in test.examples)
            assert source not in sources, f"{name} shows the example of {sources[source]}"
            sources[source] = name


def listed() -> set[str]:
    """Return the names of the API page, with their modules."""
    pages = {f"{module}.{name}" for module, name in PAGES}
    return pages | {f"stayput.{name}" for name in re.findall(r"``(\w+)``", API)}


@pytest.mark.parametrize(("module", "name"), sorted(imports()))
def test_what_examples_import_is_on_the_api_page(module: str, name: str) -> None:
    known = listed()
    assert {f"{module}.{name}", f"stayput.{name}"} & known


def test_every_public_name_is_on_the_api_page() -> None:
    missing = [
        name for name in stayput.__all__ if not {f"stayput.{name}", f"stayput.measures.{name}"} & listed()
    ]
    assert not missing
