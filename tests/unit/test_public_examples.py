"""Every public name has an example that runs; what examples import is on the API page."""

from __future__ import annotations

import ast
import doctest
import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from test_documented_python import BLOCKS, RUN

import stayput
from stayput import measures, studies

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[2]
API = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
PLACES = {"stayput": stayput, "measures": measures, "studies": studies}
PUBLIC = {
    f"{place}.{name}": getattr(module, name) for place, module in PLACES.items() for name in module.__all__
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


def used_and_imported() -> tuple[set[str], set[tuple[str, str]]]:
    """Return the names that are used as attributes or imported, and the imports from the package."""
    used, imported = set[str](), set[tuple[str, str]]()
    for source in shown():
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                if node.value.id in {"sp", "stayput", "studies"}:
                    used.add(node.attr)
            elif isinstance(node, ast.ImportFrom) and (node.module or "").partition(".")[0] == "stayput":
                imported |= {(node.module or "", alias.name) for alias in node.names}
    return used, imported


USED, IMPORTED = used_and_imported()


def examples_of(thing: Any, name: str) -> list[doctest.DocTest]:
    """Return the doctests of an object and of its own methods."""
    finder = doctest.DocTestFinder(exclude_empty=True)
    if not callable(thing):
        return []
    return [test for test in finder.find(thing, name) if test.examples]


@pytest.mark.parametrize("name", sorted(PUBLIC))
def test_a_public_name_has_an_example_that_runs(name: str, tmp_path: Path, monkeypatch: Any) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    found = examples_of(PUBLIC[name], name)
    short = name.partition(".")[2]
    if short in DICTIONARIES:  # what is in them stands in tables of the pages
        return
    assert found or short in USED | {imported for _, imported in IMPORTED}, f"{name} has no example"
    for test in found:
        told: list[str] = []
        failed, _ = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=told.append)
        assert not failed, "".join(told)


DICTIONARIES = {"CONTENTS", "SURFACES", "MEASURES"}


def listed() -> set[str]:
    """Return the names of the API page, with their modules."""
    found, module = set[str](), ""
    for line in API.splitlines():
        if line.startswith(".. currentmodule:: "):
            module = line.rpartition(" ")[2]
        elif re.fullmatch(r"   \w+", line):
            found.add(f"{module}.{line.strip()}")
    return found | {f"stayput.{name}" for name in re.findall(r"``(\w+)``", API)}


@pytest.mark.parametrize(("module", "name"), sorted(IMPORTED))
def test_what_examples_import_is_on_the_api_page(module: str, name: str) -> None:
    known = listed()
    assert (module, name) == ("stayput", "studies") or {f"{module}.{name}", f"stayput.{name}"} & known


def test_every_public_name_is_on_the_api_page() -> None:
    missing = [
        name for name in stayput.__all__ if not {f"stayput.{name}", f"stayput.measures.{name}"} & listed()
    ]
    assert not missing
