"""Reading a scenario file."""

from __future__ import annotations

import tomllib
from pathlib import Path

from stayput.errors import InputError
from stayput.scenario.scenario import Scenario


def read_scenario(path: str | Path) -> Scenario:
    """Read a scenario file.

    Parameters
    ----------
    path : str or Path
        The file, in TOML.

    Raises
    ------
    InputError
        The file cannot be read, is not TOML, or says something that is not allowed.
    """
    file = Path(path)
    try:
        return Scenario.parse(scenario_table(file), file.parent)
    except InputError as error:
        raise InputError(f"{file.name}: {error}") from None


def scenario_table(file: Path) -> dict[str, object]:
    """Return the keys and values of a scenario file, not yet checked.

    Raises
    ------
    InputError
        The file cannot be read, or is not TOML.
    """
    try:
        return tomllib.loads(file.read_text(encoding="utf-8-sig"))
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(f"The scenario file is {str(file)!r}; it could not be read: {reason}.") from None
    except UnicodeDecodeError:
        raise InputError(f"The scenario file is {str(file)!r}; it must be a text in UTF-8.") from None
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"The scenario file is {str(file)!r}; it must be TOML, but: {error}.") from None
