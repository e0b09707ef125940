"""What stands in for the lists of names of other projects' pages where there is no network."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

HEAD = b"""# Sphinx inventory version 2
# Project: none
# Version: none
# The remainder of this file is compressed using zlib.
"""


def none(path: Path) -> str:
    """Write an inventory without names; return its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(HEAD + zlib.compress(b""))
    return str(path)
