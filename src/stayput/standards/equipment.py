"""The Japanese guideline for building equipment: a static coefficient K_H = Z K_s by storey and class.

Read: the coefficients, which storeys are upper ones, and that equipment must not overturn under the static
load. The forces of a tie and of base anchors are the moments of that load about the edge; the guideline's
vertical coefficient and its rules for anchors were not read.
"""

from __future__ import annotations

from dataclasses import dataclass

from stayput.errors import instance_of, whole_within, within, word_of
from stayput.model.body import Body
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY

COEFFICIENTS: dict[str, dict[str, float]] = {
    "upper": {"S": 2.0, "A": 1.5, "B": 1.0},
    "middle": {"S": 1.5, "A": 1.0, "B": 0.6},
    "ground": {"S": 1.0, "A": 0.6, "B": 0.4},
}
"""K_s by position and class: upper storeys, roof and penthouse; storeys between; ground floor, basement."""

ZONE_RANGE = (0.7, 1.0)
"""Smallest and largest regional factor Z."""

CLASSES = ("B", "A", "S")
"""Classes of equipment, the mildest first."""

UPPER_STOREYS = ((13, 4), (10, 3), (7, 2), (2, 1))
"""From so many storeys on, so many of the top ones are upper ones."""


def position_of(storey: int, storeys: int) -> str:
    """Return whether a storey is "ground", "middle" or "upper".

    Upper are the top storey of 2 to 6, the top 2 of 7 to 9, the top 3 of 10 to 12, the top 4 of 13 and more,
    and the roof; the ground floor never is.

    Parameters
    ----------
    storey : int
        1 for the ground floor, ``storeys`` + 1 for the roof.
    storeys : int
        Storeys of the building.

    Raises
    ------
    InputError
        A storey that the building has not.

    Examples
    --------
    >>> [position_of(storey, 10) for storey in (1, 7, 8, 11)]
    ['ground', 'middle', 'upper', 'upper']
    """
    count = whole_within("storeys", storeys, 1, 1000, "", "storeys")
    level = whole_within("storey", storey, 1, count + 1, "", "storey")
    if level == 1:
        return "ground"
    top = next((top for least, top in UPPER_STOREYS if count >= least), 0)
    return "upper" if level > count - top else "middle"


def equipment_coefficient(position: str, grade: str, zone: float = 1.0) -> float:
    """Return K_H = Z K_s, the horizontal static load over the weight.

    Parameters
    ----------
    position : str
        "upper", "middle" or "ground": see `position_of`.
    grade : str
        Class of the equipment: "S", "A" or "B".
    zone : float
        Regional factor Z, 0.7 to 1.

    Raises
    ------
    InputError
        An unknown position or class, or Z out of range.

    Examples
    --------
    >>> equipment_coefficient("upper", "B"), equipment_coefficient("ground", "S", 0.9)
    (1.0, 0.9)
    """
    by_class = COEFFICIENTS[word_of("position", position, COEFFICIENTS, "position")]
    k_s = by_class[word_of("grade", grade, CLASSES, "grade")]
    return within("zone", zone, *ZONE_RANGE, "", "zone") * k_s


def _moment(body: Body, coefficient: float, gravity: float) -> float:
    """Return the overturning moment less the restoring one about the nearer base edge [N m]."""
    k = within("coefficient", coefficient, 0.0, 100.0, "", "coefficient")
    GRAVITY.check(gravity)
    (left, left_z), (right, right_z), *_ = body.corners_at_rest  # from the centre of gravity
    return body.mass * gravity * (k * -min(left_z, right_z) - min(-left, right))


def holding_force(
    body: Body, coefficient: float, height: float | None = None, gravity: float = STANDARD_GRAVITY
) -> float:
    """Return the force of a level tie that keeps a piece upright under K_H times its weight [N].

    F = m g (K_H h_G − l_G)/z: moments about the nearer base edge; 0 where the piece does not overturn. On a
    floor of the acceleration K_H g a rigid tie without slack has this force; a slack or elastic one is loaded
    by impacts, and takes more.

    Parameters
    ----------
    body : Body
        The piece; h_G and l_G are its centre of gravity above and beside that edge.
    coefficient : float
        K_H.
    height : float, optional
        z of the tie above the floor [m]; default the top.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A coefficient, a height or a gravity out of range.

    Examples
    --------
    >>> from stayput import Body
    >>> round(holding_force(Body(0.4, 1.8, 100.0), 1.0), 1)
    381.4
    """
    top = instance_of("body", body, Body).height
    z = within("model.tie_height", top if height is None else height, 1e-3, top, "m", "height")
    return max(_moment(body, coefficient, gravity) / z, 0.0)


def anchor_tension(
    body: Body,
    coefficient: float,
    spacing: float | None = None,
    anchors: int = 2,
    gravity: float = STANDARD_GRAVITY,
) -> float:
    """Return the tension in each base anchor of the lifted side under K_H times the weight [N].

    R = m g (K_H h_G − l_G)/(n l): moments about the anchors of the other side, at which l_G is measured; the
    anchors stand evenly inside the base.

    Parameters
    ----------
    body : Body
        The piece.
    coefficient : float
        K_H.
    spacing : float, optional
        l between the two rows of anchors [m]; default the distance of the feet.
    anchors : int
        n, anchors in the row that is pulled.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        A coefficient, a spacing, a number of anchors or a gravity out of range.

    Examples
    --------
    >>> from stayput import Body
    >>> round(anchor_tension(Body(0.4, 1.8, 100.0), 1.0), 1)
    858.1
    """
    feet = instance_of("body", body, Body).base_width
    length = within("spacing", feet if spacing is None else spacing, 1e-3, feet, "m", "spacing")
    count = whole_within("anchors", anchors, 1, 1000, "", "anchors")
    inset = 0.5 * (feet - length)  # of the anchors from the edge that the moment is about
    moment = _moment(body, coefficient, gravity) + body.mass * gravity * inset
    return max(moment / (count * length), 0.0)


@dataclass(frozen=True, slots=True)
class EquipmentLoad:
    """The static load of a class where a piece stands, and what it does to the piece unheld.

    Parameters
    ----------
    grade : str
        Class "B", "A" or "S".
    position : str
        "ground", "middle" or "upper".
    coefficient : float
        K_H.
    overturns : bool
        Whether the piece overturns under it.
    force : float
        Force of a level tie at the top that holds it [N]; 0 where it does not overturn.
    """

    grade: str
    position: str
    coefficient: float
    overturns: bool
    force: float


def equipment_loads(
    body: Body, position: str, zone: float = 1.0, gravity: float = STANDARD_GRAVITY
) -> tuple[EquipmentLoad, ...]:
    """Return the static loads of every class on a piece, the mildest first.

    Parameters
    ----------
    body : Body
        The piece.
    position : str
        "upper", "middle" or "ground".
    zone : float
        Regional factor Z.
    gravity : float
        g [m/s²].

    Raises
    ------
    InputError
        An unknown position, or Z out of range.

    Examples
    --------
    >>> import stayput as sp
    >>> for load in sp.equipment_loads(sp.Body(0.8, 1.9, 300.0), "middle"):
    ...     print(f"class {load.grade}: {load.coefficient} g, tie at the top {load.force:.0f} N")
    class B: 0.6 g, tie at the top 263 N
    class A: 1.0 g, tie at the top 852 N
    class S: 1.5 g, tie at the top 1587 N
    """
    loads: list[EquipmentLoad] = []
    for grade in CLASSES:
        k = equipment_coefficient(position, grade, zone)
        force = holding_force(body, k, gravity=gravity)
        loads.append(EquipmentLoad(grade, position, k, force > 0.0, force))
    return tuple(loads)
