"""Commands and flags that are gone, and what to write in their place: named for one release."""

from __future__ import annotations

COMMANDS = {
    "fragility": "stayput verify --curves FOLDER",
    "building": "stayput motion plot --building",
    "study": "python -m studies NAME",
}

_OF_SHAKING = ("scale", "pgv", "mmi", "component", "location", "remove_mean", "skip_lines", "decimal_comma")
_KEYS = {name.replace("_", "-"): f"shaking.{name}" for name in _OF_SHAKING} | {
    "sa": "shaking.sa.value",
    "earthquake": "shaking.earthquake.magnitude",
    "vertical": "shaking.vertical",
    "no-vertical": "shaking.vertical",
    "x": "shaking.record",
    "y": "shaking.across",
    "z": "shaking.vertical",
    "length": "furniture.length",
    "heading": "furniture.heading",
    "friction": "room.floor.static_friction",
    "wall": "room.left_wall.construction",
    "left-wall": "room.left_wall.gap",
    "right-wall": "room.right_wall.gap",
}

FLAGS = {f"--{name}": f"--set {key}=VALUE" for name, key in _KEYS.items()} | {
    "--contact": 'simulate(…, contact="paper")',
    "--every-run": "--set uncertainty.samples=VALUE",
    "motion info --plot": "stayput motion plot",
}
