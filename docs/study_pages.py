"""Run the studies; write texts, figures and tables of the pages about the paper and tested measures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import study_numbers

import stayput as sp
import workload
import studies
from studies.study import NO, PARTLY, YES, claims_table, table_as_markdown

if TYPE_CHECKING:
    from studies import Study
    from studies.study import Claim

TEXTS = Path(__file__).parent / "studies"
"""What was done and found, study by study; ``{{name}}`` stands for a number of the run."""


Runs = list[tuple["Study", "sp.Motion | None"]]
"""Studies, and the motion of each that has one."""


def of_the_paper() -> Runs:
    """Run the paper's studies and the spectra; a record is JMA Kobe NS where the file is at hand."""
    record = workload.record()
    alone = [studies.friction(), studies.critical_ratio(), studies.wall_gap()]
    under = [studies.wall_gap_record(record), studies.spectrum(record)]
    return [(study, None) for study in alone] + [(study, record) for study in under]


def three_components() -> sp.Motion:
    """Return 30 s of JMA Kobe, NS along x, where its files are at hand, else the built-in motion."""
    north, east, up = (workload.RECORD.with_stem(f"jma_kobe_1995_{name}") for name in ("ns", "ew", "ud"))
    if not all(file.is_file() for file in (north, east, up)):
        return sp.near_fault()
    vertical = sp.read_motion(up, component="channel 1")
    records = sp.read_motion(north), sp.read_motion(east), vertical
    motion = sp.Motion.combine(*records, name="JMA Kobe 1995, x NS, y EW")
    return motion.trimmed(0.0, min(workload.DURATION, motion.duration))


def tested() -> Runs:
    """Run the studies that stand beside tests of devices and beside a formula for bare furniture."""
    motion = three_components()
    return [
        (studies.tokyo(motion), motion),
        (studies.consumer_centre(), None),
        (studies.baseline(), None),
        (studies.capacity(), None),
    ]


def of_standards() -> Runs:
    """Run the study of a standard's test beside real floors."""
    return [(studies.ac156(), None)]


def of_everyday() -> Runs:
    """Run the study of tip-over without an earthquake."""
    return [(studies.tip_over(), None)]


def of_stones() -> Runs:
    """Run the study of gravestones beside surveys."""
    return [(studies.tombstones(), None)]


def of_space() -> Runs:
    """Run the study of the plane beside space."""
    return [(studies.three_dimensions(), None)]


def inside() -> Runs:
    """Run the study of what is in furniture."""
    motion = three_components()
    return [(studies.contents(motion), motion)]


def section(study: Study, motion: sp.Motion | None, folder: Path) -> str:
    """Write a study's figures; return its title, text, numbers, figures and tables."""
    text = (TEXTS / f"{study.name}.md").read_text(encoding="utf-8")
    filled = study_numbers.filled(text, study_numbers.numbers_of(study, motion))
    parts = [f"## {study.title}", f"`stayput study {study.name}`", filled.strip()]
    parts.append(f"**Key numbers, published and of this run**\n\n{table_as_markdown(study.summary)}")
    for name, figure in study.figures.items():
        file = folder / f"study_{study.name}_{name}.png"
        figure.savefig(file)
        about = name.replace("_", " ")
        parts.append(f"```{{image}} {folder.name}/{file.name}\n:alt: {study.title}, {about}\n```")
    return "\n\n".join((*parts, *study.captioned_tables()))


def write(folder: Path) -> None:
    """Write a text for each page that includes studies, with its figures, into a folder."""
    pages = {
        "studies": of_the_paper,
        "tested": tested,
        "inside": inside,
        "standards": of_standards,
        "everyday": of_everyday,
        "fallen": of_stones,
        "plane_or_space": of_space,
    }
    claims: list[Claim] = []
    for name, run in pages.items():
        runs = run()
        claims += [claim for study, _ in runs for claim in study.claims]
        text = "\n\n".join(section(study, motion, folder) for study, motion in runs)
        (folder / f"{name}.md").write_text(text + "\n", encoding="utf-8")
    outcomes = [claim.outcome for claim in claims]
    counts = ", ".join(f"{outcomes.count(word)} {word}" for word in (YES, PARTLY, NO))
    table = table_as_markdown(claims_table(claims))
    world = f"Of {len(claims)} rows, whether it comes out: {counts}.\n\n{table}"
    (folder / "validation_world.md").write_text(world + "\n", encoding="utf-8")
