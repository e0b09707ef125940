"""Write the tables of the page about measures, and draw each."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import validation_run
from PIL import Image

import stayput as sp
from stayput.measures import MEASURES, Belt, Chain, LBracket, TensionPole, WedgeStopper, parameters
from stayput.measures.fixing import (
    BELT,
    BRACKET,
    CEILING_LINKS,
    CHAIN,
    FASTENINGS,
    POLE,
    TOP_BOARDS,
    TOPS,
    panel,
)
from stayput.model.body import FURNITURE
from stayput.report.animation import film_of
from stayput.report.film.frames import Painter

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.measures import Measure, Parameter
    from stayput.measures.fixing import Link

ROOM = sp.Room(left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.3))


def bookcase() -> sp.Body:
    """Return the bookcase of the examples."""
    preset = FURNITURE["bookcase"]
    return sp.Body(preset.width, preset.height, preset.mass)


def _default(about: Parameter) -> str:
    match about.default:
        case None:
            return "follows"
        case str():
            return f"`{about.default}`"
        case _:
            return f"{about.default:g}"


def _range(about: Parameter) -> str:
    numbers = () if about.choices else (f"{about.low:g} to {about.high:g}",)
    return ", ".join([*numbers, *(f"`{word}`" for word in (*about.choices, *about.words))])


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


def _number(value: float, form: str) -> str:
    return format(value, form) if math.isfinite(value) else ""


def links() -> str:
    """Return the table of the links that devices are made of."""
    screws = [
        (where, link)
        for of in (FASTENINGS, TOPS)
        for fastening in of.values()
        for where, link in (("drawn out", fastening.pull), ("pushed sideways", fastening.shear))
    ]
    walls = [("at 1.8 m of 2.4 m", panel(wall, 1.8, 2.4)) for wall in ("stud", "hanging strip")]
    others = (BRACKET, BELT, CHAIN, POLE, *CEILING_LINKS.values(), *TOP_BOARDS.values())
    rows = [
        [
            f"{link.label[0]}, {where}" if where else link.label[0],
            _number(link.stiffness / 1e3, ".0f"),
            _number(link.strength, ".0f"),
            f"{1e3 * link.ultimate:g}" if math.isfinite(link.strength) else "",
            link.fails[0] if math.isfinite(link.strength) else "",
            str(link.confidence),
            link.source,
        ]
        for where, link in (*screws, *walls, *(("", link) for link in others))
    ]
    heads = ["link", "kN/m", "strength [N]", "plastic [mm]", "what happens", "confidence", "source"]
    return validation_run.markdown(heads, rows, "lrrrlll")


def chains() -> str:
    """Return the table of what is weakest, by device and by what it is fixed to."""
    rows = [
        [wall, *_of_chain(device.label[0], device.drawn(wall, 1.8, 2.4))]
        for wall in FASTENINGS
        for device in (LBracket(), Belt(), Chain())
    ]
    rows += [
        [f"ceiling: {ceiling}", *_of_chain(TensionPole.label[0], TensionPole().chain(ceiling))]
        for ceiling in CEILING_LINKS
    ]
    heads = ["fixed to", "device", "kN/m of one", "strength of one [N]", "weakest"]
    return validation_run.markdown(heads, rows, "llrrl")


def _of_chain(device: str, link: Link) -> list[str]:
    return [device, f"{link.stiffness / 1e3:.0f}", f"{link.strength:.0f}", link.fails[0]]


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
            f"{max(d.peak_pull, d.peak_push, d.peak_shear):.0f} N, "
            f"{'holds' if not d.failed or d.weakest is None else d.weakest[0]}"
            for d in run.devices
        )
        names = " + ".join(measure.label[0] for measure in chosen) or "nothing"
        rows.append([names, run.outcome.value, f"{100.0 * run.peak_slide:.1f}", devices])
    return validation_run.markdown(
        ["measure", "outcome", "peak slide [cm]", "largest force that the devices bore"], rows, "llrl"
    )


def pictures(folder: Path) -> None:
    """Draw the bookcase on a chain, taut and just after its hook let go."""
    run = sp.simulate(bookcase(), ROOM, sp.near_fault(), (Chain(),))
    film = film_of(run.named(["bookcase"]))
    painter = Painter(film, 560, 420)
    broken = run.devices[0].failure_time
    sheet = Image.new("RGB", (1120, 420))
    for n, time in enumerate((broken - 0.01, broken + 0.35)):
        sheet.paste(painter.frame(time), (560 * n, 0))
    sheet.save(folder / "measures_chain.png")


def write(folder: Path) -> None:
    """Write every generated part into a folder."""
    (folder / "measures.md").write_text(measures(), encoding="utf-8")
    (folder / "measures_links.md").write_text(links(), encoding="utf-8")
    (folder / "measures_chains.md").write_text(chains(), encoding="utf-8")
    (folder / "measures_outcomes.md").write_text(outcomes(), encoding="utf-8")
    pictures(folder)
