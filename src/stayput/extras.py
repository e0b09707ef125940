"""Optional libraries: loaded when they are needed, refused where they are not installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from stayput.errors import InputError


def absent(what: str, module: str, extra: str) -> InputError:
    """Return the error for a feature whose optional library is not installed.

    Parameters
    ----------
    what : str
        The feature.
    module : str
        Import name of the library.
    extra : str
        Extra of the package that installs it.
    """
    return InputError("model.not_installed", what=what, module=module, extra=extra)


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
