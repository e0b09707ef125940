"""Each part imports only from those below it, no two types share a name, and names say what a thing is."""

from __future__ import annotations

import ast
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

import stayput

SOURCES = Path(stayput.__file__).parent

LAYERS = (
    {"catalogue", "errors"},
    {"files", "saved", "wording", "vocabulary"},
    {"progress", "execution", "uncertainty"},
    {"compiling"},
    {"mechanics", "model"},
    {"motion"},
    {"building", "measures", "estimates", "standards"},
    {"simulation", "fragility"},
    {"contents"},
    {"montecarlo", "scenario"},
    {"verification", "fallen"},
    {"rooms"},
    {"report"},
    {"inventory"},
    {"app"},
    {"cli"},
)
"""The parts of the package, from the lowest; those of a layer may use each other, but not in a circle."""

LEVELS = {part: level for level, parts in enumerate(LAYERS) for part in parts}

DRAWN = "report"
"""What a method that draws a value may import, where it is called."""


@cache
def tree_of(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"))


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

    visit(tree_of(file), True)
    return found


def test_every_part_has_its_layer():
    parts = {part_of(file) for file in SOURCES.rglob("*.py")} - {"__init__", "__main__"}
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


def types(file: Path) -> list[str]:
    """Return the names of a module's classes and of its aliases of types, which are written like classes."""
    tree = tree_of(file)
    names = [node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
    checked = [node for node in tree.body if isinstance(node, ast.If)]  # types that only a checker reads
    for node in (*tree.body, *(inner for block in checked for inner in block.body)):
        if isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            assigned = [target.id for target in targets if isinstance(target, ast.Name)]
            names += [name for name in assigned if name[0].isupper() and not name.isupper()]
    return names


def test_no_two_types_share_a_name():
    """A reader who meets a name knows which it is, wherever that is."""
    count = Counter(name for file in SOURCES.rglob("*.py") for name in types(file))
    assert not [name for name, times in count.items() if times > 1]


VAGUE = {"one", "own", "told", "found", "given"}
"""Names of variables and arguments that do not say what a thing is."""


def vague_names(file: Path) -> list[str]:
    return [
        f"{file.relative_to(SOURCES)}:{node.lineno} {name}"
        for node in ast.walk(tree_of(file))
        if (isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and (name := node.id) in VAGUE)
        or (isinstance(node, ast.arg) and (name := node.arg) in VAGUE)
    ]


@pytest.mark.parametrize("part", sorted(LEVELS))
def test_names_say_what_a_thing_is(part):
    files = (file for file in SOURCES.rglob("*.py") if part_of(file) == part)
    assert not [name for file in files for name in vague_names(file)]
