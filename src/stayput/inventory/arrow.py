"""PyArrow, loaded when it is needed; it has no types for a checker."""

from __future__ import annotations

from typing import Any

from stayput.errors import absent


def arrow() -> Any:
    """Return PyArrow.

    Raises
    ------
    InputError
        It is not installed.
    """
    try:
        import pyarrow
    except ImportError:
        raise absent("An assessment", "PyArrow", "inventory") from None
    return pyarrow


def parquet() -> Any:
    """Return PyArrow's part for Parquet."""
    arrow()
    import pyarrow.parquet

    return pyarrow.parquet


def dataset() -> Any:
    """Return PyArrow's part for many files."""
    arrow()
    import pyarrow.dataset

    return pyarrow.dataset
