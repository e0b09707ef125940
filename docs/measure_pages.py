"""Write the tables of the page about measures, and draw each."""

from __future__ import annotations

from typing import TYPE_CHECKING

import validation_run
from PIL import Image

import stayput as sp
from stayput.measures import MEASURES, Chain, TensionPole, WedgeStopper, parameters
from stayput.model.furniture import FURNITURE
from stayput.report.film import film_of
from stayput.report.frames import Painter

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.measures import Measure, Parameter

ROOM = sp.Room(left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.3))


def bookcase() -> sp.Body:
    """Return the bookcase of the examples."""
    preset = FURNITURE["bookcase"]
    return sp.Body(preset.width, preset.height, preset.mass)


def _default(about: Parameter) -> str:
    match about.default:
        case None:
            return "the room's"
        case str():
            return f"`{about.default}`"
        case _:
            return f"{about.default:g}"


def _range(about: Parameter) -> str:
    return ", ".join(f"`{word}`" for word in about.choices) or f"{about.low:g} to {about.high:g}"


def _section(kind: str, measure: type[Measure]) -> str:
    rows = [
        [f"`{p.name}`", _default(p), p.unit, _range(p), str(p.confidence), p.label[0], p.label[1]]
        for p in parameters(measure)
    ]
    heads = ["parameter", "default", "unit", "range", "confidence", "meaning", "意味"]
    english, japanese = measure.label
    return "\n\n".join(
        (
            f"### {english} · {japanese}",
            f"`{kind}`, {{class}}`~stayput.measures.{measure.__name__}`",
            measure.about[0],
            measure.about[1],
            validation_run.markdown(heads, rows, "lrlllll"),
        )
    )


def measures() -> str:
    """Return a section for each measure, with the table of its parameters."""
    return "\n".join(_section(kind, measure) for kind, measure in MEASURES.items())


def outcomes() -> str:
    """Return the table of what a bookcase does with each measure under the built-in motion."""
    body, motion = bookcase(), sp.near_fault()
    rows: list[list[str]] = []
    sets: list[tuple[Measure, ...]] = [(), *((measure(),) for measure in MEASURES.values())]
    for chosen in (*sets, (WedgeStopper(), TensionPole())):
        run = sp.simulate(body, ROOM, motion, chosen)
        devices = "; ".join(
            f"{max(d.peak_pull, d.peak_push, d.peak_shear):.0f} N, {d.cause or 'holds'}" for d in run.devices
        )
        names = " + ".join(measure.label[0] for measure in chosen) or "nothing"
        rows.append([names, run.outcome.value, f"{100.0 * run.peak_slide:.1f}", devices])
    return validation_run.markdown(["measure", "outcome", "peak slide [cm]", "devices"], rows, "llrl")


def pictures(folder: Path) -> None:
    """Draw the bookcase on a chain, taut and just after it broke."""
    run = sp.simulate(bookcase(), ROOM, sp.near_fault(), (Chain(),))
    film = film_of(run, "bookcase")
    painter = Painter(film, 560, 420)
    broken = run.devices[0].failure_time
    sheet = Image.new("RGB", (1120, 420))
    for n, time in enumerate((broken - 0.01, broken + 0.35)):
        sheet.paste(painter.frame(time), (560 * n, 0))
    sheet.save(folder / "measures_chain.png")


def write(folder: Path) -> None:
    """Write every generated part into a folder."""
    (folder / "measures.md").write_text(measures(), encoding="utf-8")
    (folder / "measures_outcomes.md").write_text(outcomes(), encoding="utf-8")
    pictures(folder)
