"""Pictures of the gallery: the Matplotlib figures that an example keeps in variables."""

from __future__ import annotations

from typing import Any

from matplotlib import pyplot as plt
from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst


def figures_made(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
    """Save the figures that a block has made; return what shows them, as sphinx-gallery asks."""
    names = block_vars["example_globals"]
    shown: set[int] = names.setdefault("__shown__", set())
    saved = []
    for value in list(names.values()):
        if isinstance(value, Figure) and id(value) not in shown:
            shown.add(id(value))
            saved.append(next(block_vars["image_path_iterator"]))
            value.savefig(saved[-1], dpi=150)
    plt.close("all")
    return figure_rst(saved, gallery_conf["src_dir"])
