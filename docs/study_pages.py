"""Run the studies; write texts, figures and tables of the pages that include them."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import jinja2
import pandas as pd

import stayput as sp
import studies
import workload
from studies.study import NO, PARTLY, YES, as_markdown

if TYPE_CHECKING:
    from studies import Study

TEXTS = Path(__file__).parent / "studies"
"""What was done and found, study by study; ``{{ name }}`` is a quantity or a constant of the study."""


def three_components() -> sp.Motion:
    """Return 30 s of JMA Kobe, NS along x, where its files are at hand, else the built-in motion."""
    north, east, up = (workload.RECORD.with_stem(f"jma_kobe_1995_{name}") for name in ("ns", "ew", "ud"))
    if not all(file.is_file() for file in (north, east, up)):
        return sp.near_fault()
    vertical = sp.read_motion(up, component="channel 1")
    records = sp.read_motion(north), sp.read_motion(east), vertical
    motion = sp.Motion.combine(*records, name="JMA Kobe 1995, x NS, y EW")
    return motion.trimmed(0.0, min(workload.DURATION, motion.duration))


def filled(study: Study, motion: sp.Motion | None) -> str:
    """Return a study's text with the numbers of its run.

    Raises
    ------
    jinja2.UndefinedError
        The text names a number that there is not.
    """
    constants = vars(sys.modules[f"studies.{study.name}"])
    quantities = {name: str(quantity) for name, quantity in study.quantities.items()}
    if motion is not None:
        quantities["motion"] = f"“{motion.name}”{' (synthetic)' if motion.synthetic else ''}"
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined, autoescape=False)
    text = (TEXTS / f"{study.name}.md").read_text(encoding="utf-8")
    return environment.from_string(text).render(constants | quantities)


def section(study: Study, motion: sp.Motion | None, folder: Path) -> str:
    """Write a study's files; return its title, text, figure and tables, which can be downloaded."""
    study.write(folder / "studies")
    files = f"{folder.name}/studies/{study.name}"
    image = f"```{{image}} {files}.png\n:alt: {study.title}\n```"
    parts = [f"## {study.title}", f"`python -m studies {study.name}`", filled(study, motion), image]
    tables = {"Key numbers, published and of this run": study.summary} | study.tables
    for number, (caption, table) in enumerate(tables.items()):
        file = f"{files}{f'_{number}' if number else ''}.csv"
        parts.append(f"**{caption}** ({{download}}`CSV <{file}>`)\n\n{as_markdown(table)}")
    return "\n\n".join(parts)


def write(folder: Path) -> None:
    """Write a text for each page that includes studies, with its figures, into a folder."""
    record, three = workload.record(), three_components()
    pages = {
        "studies": (studies.friction, studies.critical_ratio, studies.wall_gap, studies.wall_gap_record),
        "tested": (studies.tokyo, studies.consumer_centre, studies.baseline, studies.capacity),
        "inside": (studies.contents,),
        "fallen": (studies.tombstones,),
        "plane_or_space": (studies.three_dimensions,),
        "intervals": (studies.races,),
    }
    motions = {studies.wall_gap_record: record, studies.tokyo: three, studies.contents: three}
    claims: list[dict[str, str]] = []
    for name, of_page in pages.items():
        sections: list[str] = []
        for run in of_page:
            motion = motions.get(run)
            study = run() if motion is None else run(motion)
            claims += study.claims
            sections.append(section(study, motion, folder))
        (folder / f"{name}.md").write_text("\n\n".join(sections) + "\n", encoding="utf-8")
    outcomes = [claim["comes out"] for claim in claims]
    counts = ", ".join(f"{outcomes.count(word)} {word}" for word in (YES, PARTLY, NO))
    world = f"Of {len(claims)} rows, whether it comes out: {counts}.\n\n{as_markdown(pd.DataFrame(claims))}"
    (folder / "validation_world.md").write_text(world + "\n", encoding="utf-8")
