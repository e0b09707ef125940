"""The examples with few motions and runs: as they are, the kitchen takes half a minute, the city longer."""

import re
import shutil
from pathlib import Path

EXAMPLES = Path(__file__).parents[2] / "examples"


def copy_examples(folder: Path) -> None:
    """Copy the examples into a folder; their scenarios ask for four motions, and a run of each."""
    copied = shutil.copytree(EXAMPLES, folder / "examples")
    for file in copied.rglob("*.toml"):
        text = re.sub(r"\bcount = \d+", "count = 4", file.read_text(encoding="utf-8"))
        if "suite" not in text:
            text = re.sub(r"^(intensity = .*)", r"\1\nsuite = { count = 4 }", text, flags=re.MULTILINE)
        table, few = "[uncertainty]\n", "[uncertainty]\nsamples = 4\n"
        text = text.replace(table, few) if table in text else f"{text}\n{few}"
        file.write_text(text, encoding="utf-8")
