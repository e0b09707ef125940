"""Optional libraries: loaded when they are needed, refused where they are not installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from stayput.errors import absent


def arrow(part: str = "") -> Any:
    """Return PyArrow, or a part of it such as "parquet"; it has no types for a checker.

    Raises
    ------
    InputError
        It is not installed.
    """
    try:
        return import_module(f"pyarrow.{part}" if part else "pyarrow")
    except ImportError:
        raise absent("An assessment", "PyArrow", "inventory") from None
