"""Draw the figures of the pages about motions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import stayput as sp
from stayput.report.spectra import plot_spectra

if TYPE_CHECKING:
    from pathlib import Path


def write(folder: Path) -> None:
    """Draw the figures into a folder."""
    plot_spectra(sp.near_fault(), folder / "spectra.png")
