"""Run the studies; write their figures and texts for the pages about the paper and about tested measures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import stayput as sp
import workload
from stayput import studies

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.studies import Study


def run() -> list[Study]:
    """Run all studies; those of a record with JMA Kobe NS where the file is at hand."""
    record = workload.record()
    return [
        studies.friction(),
        studies.critical_ratio(),
        studies.wall_gap(),
        studies.wall_gap_record(record),
        studies.spectrum(record),
    ]


def three_components() -> sp.Motion:
    """Return 30 s of JMA Kobe, NS along x, where its files are at hand, else the built-in motion."""
    files = [workload.RECORD.with_stem(f"jma_kobe_1995_{name}") for name in ("ns", "ew", "ud")]
    if not all(file.is_file() for file in files):
        return sp.near_fault()
    motion = sp.Motion.combine(*(sp.read_motion(file) for file in files), name="JMA Kobe 1995, x NS, y EW")
    return motion.trimmed(0.0, min(workload.DURATION, motion.duration))


def tested() -> list[Study]:
    """Run the studies that stand beside tests of devices and beside a formula for bare furniture."""
    return [studies.tokyo(three_components()), studies.capacity()]


def section(study: Study, folder: Path) -> str:
    """Write a study's figures; return its title, text, figures and tables."""
    parts = [f"## {study.title}", f"`stayput study {study.name}`", study.text.strip()]
    for name, figure in study.figures.items():
        file = folder / f"study_{study.name}_{name}.png"
        figure.savefig(file)
        about = name.replace("_", " ")
        parts.append(f"```{{image}} {folder.name}/{file.name}\n:alt: {study.title}, {about}\n```")
    return "\n\n".join((*parts, *study.captioned_tables()))


def write(folder: Path) -> None:
    """Write ``studies.md``, ``tested.md`` and their figures into a folder."""
    for name, found in (("studies", run()), ("tested", tested())):
        text = "\n\n".join(section(study, folder) for study in found)
        (folder / f"{name}.md").write_text(text + "\n", encoding="utf-8")
