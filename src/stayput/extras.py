"""Refusal of what needs an optional library that is not installed."""

from __future__ import annotations

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
