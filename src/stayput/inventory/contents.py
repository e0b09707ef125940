"""What a row of an inventory says is inside its piece."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from stayput.contents import Contents
from stayput.contents.contents import emptied
from stayput.errors import InputError
from stayput.inventory.cells import number_of, numbers_of, text_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.inventory.cells import Cell
    from stayput.model.body import Body
    from stayput.scenario import Scenario

NOTHING = "none"
"""What a row says of a piece with nothing inside, where the scenario has contents."""

OF_THE_CONTENTS = ("contents", "doors", "drawers", "lip", "load")


def contents_of(cells: Mapping[str, Cell], body: Body, scenario: Scenario) -> Contents | None:
    """Return what is in a row's piece: the scenario's contents, with what the row says; None for nothing.

    A load shelf by shelf is that of the contents; one that is spread evenly is their share of the mass.

    Parameters
    ----------
    cells : mapping
        The row.
    body : Body
        The piece with its load.
    scenario : Scenario
        Where the piece stands.

    Raises
    ------
    InputError
        No such contents, doors or drawers; doors, drawers or a lip without contents; contents that are too
        heavy for the piece.
    """
    kind = text_of("contents", cells.get("contents"))
    words = {name: text_of(name, cells.get(name)) for name in ("doors", "drawers")}
    stated: dict[str, Any] = {**words, "lip": number_of("lip", cells.get("lip"), "m")}
    stated = {name: value for name, value in stated.items() if value is not None}
    table = scenario.contents_table
    if kind == NOTHING or (kind is None and table is None and not stated):
        return None
    if kind is None and table is None:
        name = next(iter(stated))
        raise InputError("inventory.contents_missing", "contents", name=name)
    given: dict[str, Any] = {} if table is None else table.model_dump(exclude_unset=True)
    given |= stated if kind is None else {"kind": kind, **stated}
    loads = numbers_of("load", cells.get("load"), "kg")
    if len(loads) == 1:
        given |= {"loads": None, "mass_share": loads[0] / body.mass}
    elif loads:  # they say how many shelves there are, and what is on all of them
        given = {name: value for name, value in given.items() if name not in ("shelves", "mass_share")}
        given["loads"] = loads
    elif given.get("loads"):
        given["loads"] = tuple(given["loads"])
    try:
        contents = Contents(**given)
    except InputError as error:
        columns = {"kind": "contents", "loads": "load"}
        raise error.about(columns.get(error.field or "", error.field)) from None
    emptied(body, contents)  # refuses what is too heavy
    return contents
