"""The pictures of the first page, stills of a film of a bookcase that falls, and of the README, a verdict.

The README's stands among the sources: ``python docs/index_picture.py`` draws it anew, the documentation's
build does not, as its bytes depend on the machine.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from PIL import Image

import stayput as sp

BEFORE = (2.6, 0.62, 0.26, 0.06)
"""When the stills are taken, before the body lies [s]."""
DOCS = Path(__file__).parent
SHOWN = (0, 0, 520, 345)
"""The part of a still without the history of the floor [px]."""


def write(folder: Path) -> None:
    """Write the picture of the first page."""
    room = sp.Room(floor=sp.Floor.of("wood flooring"), left_wall=sp.Wall(gap=0.02))
    run = sp.simulate(sp.Body(width=0.30, height=1.80, mass=200.0), room, sp.near_fault())
    assert run.overturn_time is not None
    width, height = SHOWN[2] - SHOWN[0], SHOWN[3] - SHOWN[1]
    strip = Image.new("RGB", (width * len(BEFORE), height))
    with (
        tempfile.TemporaryDirectory() as scratch,
        Image.open(run.animate(Path(scratch) / "fall.gif")) as film,
    ):
        step = 1e-3 * film.info["duration"]
        for place, before in enumerate(BEFORE):
            film.seek(round((run.overturn_time - before) / step))
            strip.paste(film.convert("RGB").crop(SHOWN), (width * place, 0))
    strip.save(folder / "index_film.png")


def write_readme_picture() -> None:
    """Write the README's picture; its description is the verdict's sentence, which a test compares."""
    verdict = sp.verify(sp.read(DOCS.parent / "examples" / "bookcase.toml"))
    about = {"Software": None, "Description": verdict.sentence("en")}
    verdict.plot().figure.savefig(DOCS / "verdict.png", dpi=110, metadata=about)


if __name__ == "__main__":
    write_readme_picture()
