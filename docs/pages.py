"""The parts of the documentation that the code writes: tables of formats, presets and keys, and files."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from itertools import pairwise
from pathlib import Path
from typing import Any

import app_pictures
import building_pages
import calibration_pages
import index_picture
import measure_pages
import motion_pages
import study_pages
import suite_pages
import validation_run

import stayput as sp
from stayput.model.body import FURNITURE, Preset
from stayput.model.parameters import parameters
from stayput.motion import seismogram
from stayput.motion.readers import READERS
from stayput.scenario.toml import kinds
from stayput.simulation.outcome import QUANTITIES
from stayput.vocabulary import also_called

HERE = Path(__file__).parent
ROOT = HERE.parent
EXAMPLES = ROOT / "examples"
MECHANICS = ROOT / "src" / "stayput" / "mechanics"


def formats() -> str:
    """Return the table of formats; each text is a paragraph of its module's docstring."""
    readers = [(reader.name, reader.read.__module__) for reader in READERS]
    rows = []
    for name, module in (*readers, (", ".join(seismogram.FORMATS.values()), seismogram.__name__)):
        paragraphs = (inspect.getdoc(importlib.import_module(module)) or "").split("\n\n")
        about = next((text for text in paragraphs if text.startswith(f"{name}: ")), paragraphs[0])
        rows.append([f"**{name}**", " ".join(about.removeprefix(f"{name}: ").split())])
    return validation_run.markdown(["format", "what a file holds"], rows, "ll")


def surfaces() -> str:
    """Return the table of surface presets."""
    rows = [
        [name, ", ".join(also_called([name])), f"{static:g}", f"{kinetic:g}", f"{1e3 * settlement:g}"]
        for name, (static, kinetic, settlement, _) in sp.SURFACES.items()
    ]
    return validation_run.markdown(
        ["surface", "also called", "static", "kinetic", "sinks in [mm]"], rows, "llrrr"
    )


def furniture() -> str:
    """Return the table of furniture presets."""
    known = [about for about in parameters(Preset) if not about.choices]
    rows = [
        [
            name,
            *(f"{value:g}" if (value := getattr(preset, about.name)) else "" for about in known),
            f"{preset.base} ({preset.base_confidence})",
        ]
        for name, preset in FURNITURE.items()
    ]
    heads = ["preset", *(f"{about.label[0]} [{about.unit}]" for about in known), "base (confidence)"]
    return validation_run.markdown(heads, rows, "lrrrrrl")


def _number(value: float) -> str:
    """Write a bound: 0.001, 1,000,000, 1e+12."""
    return f"{value:,.10g}" if 1e-4 <= abs(value) < 1e7 else f"{value:g}"


def _in_words(kind: dict[str, Any], schema: dict[str, Any]) -> str:
    unit = f" {kind['unit']}" if "unit" in kind else ""
    if "const" in kind:
        return f"`{kind['const']}`"
    if "enum" in kind:
        return ", ".join(f"`{name}`" for name in kind["enum"])
    match kind.get("type"):
        case "number" | "integer":
            return f"number, {_number(kind['minimum'])} to {_number(kind['maximum'])}{unit}"
        case "boolean":
            return "`true`, `false`"
        case "array":
            items = " or ".join(dict.fromkeys(_in_words(one, schema) for one in kinds(kind["items"], schema)))
            least, most = kind.get("minItems", 0), kind.get("maxItems")
            return f"list of {least if least == most else f'{least} to {most}'}: {items}"
        case "object":
            return "table"
        case _:
            return "text"


def _default(node: dict[str, Any], required: bool) -> str:
    if required:
        return "required"
    value = node.get("default")
    if value is None or isinstance(value, dict | list):
        return ""
    return f"`{str(value).lower() if isinstance(value, bool) else value}`"


def _table(name: str, about: dict[str, Any], schema: dict[str, Any]) -> list[str]:
    rows, inner = [], []
    for key, node in about["properties"].items():
        allowed = kinds(node, schema)
        words = " or ".join(_in_words(kind, schema) for kind in allowed)
        needed = key in about.get("required", ())
        rows.append([f"`{key}`", words, _default(node, needed), node.get("description", "")])
        dotted = f"{name}.{key}" if name else key
        items = [item for kind in allowed for item in kinds(kind.get("items", kind), schema)]
        known = {id(table): table for table in items if table.get("properties")}
        inner += [(dotted, table) for table in known.values()]
    head = f"## `[{name}]`" if name else "## Top level"
    text = about.get("description", "") if name else ""
    parts = [
        f"{head}\n\n{text}\n\n{validation_run.markdown(['key', 'value', 'default', 'meaning'], rows, 'llll')}"
    ]
    for dotted, kind in inner:
        parts += _table(dotted, kind, schema)
    return parts


def scenario() -> str:
    """Return the reference of the scenario file, from its JSON Schema."""
    schema = sp.Scenario.model_json_schema()
    return "\n".join(_table("", schema, schema))


def scenario_files() -> str:
    """Return the scenario files among the examples."""
    return "\n".join(
        f"## `{path.name}`\n\n```toml\n{path.read_text(encoding='utf-8').strip()}\n```\n"
        for path in sorted(EXAMPLES.glob("*.toml"))
    )


def tolerances() -> str:
    """Return the table of the mechanics' numbers; the text is that which stands below each in the code."""
    rows = []
    for path in sorted(MECHANICS.rglob("*.py")):
        body = ast.parse(path.read_text(encoding="utf-8")).body
        for given, about in pairwise(body):
            match given, about:
                case (
                    ast.Assign([ast.Name(name)], ast.Constant(int() | float() as value)),
                    ast.Expr(ast.Constant(str(text))),
                ):
                    words = " ".join(text.split("\n\n")[0].split())
                    rows.append([f"`{path.stem}.{name}`", f"{value:g}", words])
    return validation_run.markdown(["name", "value", "meaning"], rows, "lrl")


def quantities() -> str:
    """Return the table of an ensemble's results."""
    rows = [[f"`{q.name}`", q.unit, q.meaning] for q in QUANTITIES]
    return validation_run.markdown(["name", "unit", "meaning"], rows, "lll")


def write_texts(folder: Path) -> None:
    """Write the generated parts that need no run into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for make in (formats, surfaces, furniture, scenario, scenario_files, tolerances, quantities):
        (folder / f"{make.__name__}.md").write_text(make(), encoding="utf-8")


def write_placeholders(folder: Path) -> None:
    """Write the texts, and in place of what runs would add the studies' templates and empty files."""
    write_texts(folder)
    pages_text = "".join(page.read_text(encoding="utf-8") for page in HERE.glob("*.md"))
    for name in set(re.findall(r"generated/(\w+\.\w+)", pages_text)):
        if not (folder / name).exists():
            (folder / name).touch()
    templates = "\n\n".join(text.read_text(encoding="utf-8") for text in study_pages.TEXTS.glob("*.md"))
    (folder / "studies.md").write_text(templates, encoding="utf-8")


def write(folder: Path) -> None:
    """Write every generated part into a folder."""
    write_texts(folder)
    validation_run.write(folder)
    study_pages.write(folder)
    motion_pages.write(folder)
    suite_pages.write(folder)
    building_pages.write(folder)
    measure_pages.write(folder)
    calibration_pages.write(folder)
    index_picture.write(folder)
    app_pictures.write(folder)
