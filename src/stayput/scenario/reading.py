"""Reading a scenario file."""

from __future__ import annotations

from pathlib import Path

from stayput.errors import InputError
from stayput.scenario.scenario import Scenario
from stayput.scenario.toml import read_toml


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
        return Scenario.parse(read_toml(file), file.parent)
    except InputError as error:
        raise error.at(file.name) from None
