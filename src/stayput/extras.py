"""What stayput needs only for a part of what it does, and where it comes from."""

from __future__ import annotations

from stayput.errors import InputError


def absent(what: str, module: str, extra: str) -> InputError:
    """Return the refusal of something whose library is not installed.

    Parameters
    ----------
    what : str
        What needs it.
    module : str
        The library.
    extra : str
        Name of the extra that holds it.
    """
    return InputError("model.not_installed", what=what, module=module, extra=extra)
