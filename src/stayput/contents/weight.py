"""What contents are worth to the piece itself: bodies whose contents are gone, or whose drawers are open.

A piece is computed with its contents fixed to it, all of them taking part in its inertia. Things that slide
take part in less of it. The other bound is a piece without them: how it stands lies between, as far as it
changes steadily with what takes part.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.measures.place import with_mass

if TYPE_CHECKING:
    from stayput.contents.contents import Contents
    from stayput.model.body import Body


def emptied(body: Body, contents: Contents) -> Body:
    """Return the piece without its contents, each shelf's taken away as a rectangle that fills its shelf.

    Raises
    ------
    InputError
        The contents are heavier than the piece, or leave it without inertia.
    """
    clear = body.height / contents.levels
    left = body
    try:
        for height, mass in zip(contents.heights(body), contents.masses(body), strict=True):
            left = with_mass(left, -mass, height + 0.5 * clear, (body.width, clear))
    except InputError:
        total = sum(contents.masses(body))
        raise InputError("contents.too_heavy", "contents", loads=total, mass=body.mass) from None
    return left


def opened(body: Body, contents: Contents, extension: float) -> Body:
    """Return the piece with all drawers, or what stands on its shelves, drawn out to the front.

    Mass and heights stay; the centre of gravity moves forwards, by x, and the inertia grows.

    Parameters
    ----------
    body : Body
        The piece with its contents.
    contents : Contents
        What is in it.
    extension : float
        How far out they are [m].

    Raises
    ------
    InputError
        The centre of gravity is beyond the front edge: the piece falls by itself.

    Examples
    --------
    >>> import stayput as sp
    >>> chest = opened(sp.Body(0.42, 1.365, 81.0), sp.Contents("boxes", drawers="stops"), 0.2)
    >>> round(chest.centre_of_gravity[0], 3)
    0.12
    """
    x = body.cg_offset[0]
    mass = sum(contents.masses(body))
    moved = x + mass * extension / body.mass
    inertia = body.inertia_about_cg + mass * ((extension - x) ** 2 - x**2) - body.mass * (moved - x) ** 2
    return replace(body, cg_offset=(moved, body.cg_offset[1]), inertia=inertia)
