"""Each part of the package imports only from those below it."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import stayput

SOURCES = Path(stayput.__file__).parent

LAYERS = (
    {"catalogue", "errors"},
    {"extras", "files", "wording", "randomness", "spreadsheets", "machine_code"},
    {"progress", "execution", "uncertainty", "compiled"},
    {"mechanics", "model"},
    {"motion"},
    {"building", "measures", "estimates"},
    {"simulation", "fragility"},
    {"montecarlo", "scenario"},
    {"verification"},
    {"report"},
    {"studies", "inventory"},
    {"app"},
    {"cli"},
)
"""The parts of the package, from the lowest; those of a layer may use each other, but not in a circle."""

LEVELS = {part: level for level, parts in enumerate(LAYERS) for part in parts}

DRAWN = "report"
"""What a method that draws a value may import, where it is called."""


def part_of(file: Path) -> str:
    return file.relative_to(SOURCES).parts[0].removesuffix(".py")


def imports(file: Path) -> list[tuple[str, bool]]:
    """Return the parts of the package that a module imports, and whether as it is loaded itself."""
    found: list[tuple[str, bool]] = []

    def visit(node: ast.AST, loading: bool) -> None:
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            return
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("stayput."):
            found.append((str(node.module).split(".")[1], loading))
        inner = loading and not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        for child in ast.iter_child_nodes(node):
            visit(child, inner)

    visit(ast.parse(file.read_text(encoding="utf-8")), True)
    return found


def test_every_part_has_its_layer():
    parts = {part_of(file) for file in SOURCES.rglob("*.py")} - {"__init__"}
    assert parts <= set(LEVELS)


@pytest.mark.parametrize("part", sorted(LEVELS))
def test_a_part_imports_from_those_below(part):
    wrong = [
        f"{file.relative_to(SOURCES)} imports {other}"
        for file in SOURCES.rglob("*.py")
        if part_of(file) == part
        for other, loading in imports(file)
        if LEVELS[other] > LEVELS[part] and (loading or other != DRAWN)
    ]
    assert not wrong
