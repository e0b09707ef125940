"""Run the studies, and write their figures and texts for the page about the paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

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
    """Write ``studies.md`` and its figures into a folder."""
    text = "\n\n".join(section(study, folder) for study in run())
    (folder / "studies.md").write_text(text + "\n", encoding="utf-8")
