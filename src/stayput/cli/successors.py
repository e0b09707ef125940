"""Commands and flags that are gone, and what to write in their place: named for one release."""

from __future__ import annotations

COMMANDS = {
    "fragility": "stayput verify --curves FOLDER",
    "building": "stayput motion plot --building",
    "study": "python -m studies NAME",
}

_KEYS = {
    "scale": "shaking.scale",
    "pgv": "shaking.pgv",
    "sa": "shaking.sa.value",
    "mmi": "shaking.mmi",
    "earthquake": "shaking.earthquake.magnitude",
    "component": "shaking.component",
    "location": "shaking.location",
    "remove-mean": "shaking.remove_mean",
    "skip-lines": "shaking.skip_lines",
    "decimal-comma": "shaking.decimal_comma",
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
    "motion info --plot": "stayput motion plot",
}
