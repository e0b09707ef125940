"""A base that bears evenly, where the mechanics know its corners or rim: how it resists turning in plan.

Friction μp of a pressure p resists turning about the vertical with M = μ N d, d the mean distance of the
pressure from its centre. It is that of the whole base where this is flat, of its outline where it stands on a
plinth or on edges, of the corners themselves where these are feet. The mechanics let the friction of a
contact at r act at c + κ (r − c), c the centre of pressure: with

    κ = d/d',        d' the mean distance of the contacts under the load that they share,

it resists turning about c like the base does. While a body slides, too, friction at so few points is not that
of even pressure: `tests/validation/test_space_flat_base.py` sets both side by side.

With the distance h of an edge from c, and s along it from the foot of that, ∫ r ds = ½ [s r + h² asinh(s/h)],
and over the triangle from c to the edge ∫ r dA is h/3 times that.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics.space.columns import LINE

if TYPE_CHECKING:
    from stayput.model.solid import Solid


def friction_ratio(solid: Solid) -> float:
    """Return κ of the base that a body stands on; 1 of feet.

    Examples
    --------
    >>> import stayput as sp
    >>> for base in ("flat", "edges", "feet"):
    ...     bodies = sp.Body.box(0.4, 0.4, 1.0, 50.0, base=base), sp.Body.cylinder(0.4, 1.0, 50.0, base=base)
    ...     print(base, *(round(friction_ratio(body.solid), 3) for body in bodies))
    flat 0.541 0.667
    edges 0.812 1.0
    feet 1.0 1.0
    """
    if solid.base == "feet":
        return 1.0
    if solid.standing_rim is not None:
        return 2.0 / 3.0 if solid.base == "flat" else 1.0
    points = solid.base_points[:, :2]
    around = _around_box(points) or _hull(points)
    if around is None:
        return LINE
    outline, ahead = points[around], points[[*around[1:], around[0]]]
    length = np.linalg.norm(ahead - outline, axis=1)
    area = 0.5 * _cross(outline, ahead)
    edges = solid.base == "edges"
    share, middle = (length, (outline + ahead) / 2.0) if edges else (area, (outline + ahead) / 3.0)
    centre = share @ middle / share.sum()
    start, along = outline - centre, (ahead - outline) / length[:, np.newaxis]
    h, s = _cross(start, along), np.einsum("ij,ij->i", start, along)
    over_edges = _integral(s + length, h) - _integral(s, h)
    d = (over_edges if edges else h * over_edges / 3.0).sum() / share.sum()
    arms = points - centre
    # the least loads that balance about the centre
    balance = np.column_stack((np.ones(len(arms)), arms))
    loads = balance @ np.linalg.solve(balance.T @ balance, [1.0, 0.0, 0.0])
    ratio = float(d / (loads @ np.linalg.norm(arms, axis=1)))
    return min(1.0, round(ratio, 10))  # not to the last digits, which depend on the processor


def _hull(points: NDArray[np.float64]) -> Sequence[int] | None:
    """Return the points around a base, counter-clockwise; None of fewer than three, or in a line."""
    from scipy.spatial import ConvexHull, QhullError  # which a box need not load

    try:
        return ConvexHull(points).vertices.tolist()
    except (QhullError, ValueError):
        return None


def _around_box(points: NDArray[np.float64]) -> list[int] | None:
    """Return the way around the feet of a box as Qhull goes, which takes its time; None of others."""
    match points.tolist():
        case [[a, y], [b, z], [c, v], [d, w]] if a == b < 0.0 < c == d and y == v == -z == -w < 0.0:
            return [0, 2, 3, 1]
        case _:
            return None


def _cross(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def _integral(s: NDArray[np.float64], h: NDArray[np.float64]) -> NDArray[np.float64]:
    return 0.5 * (s * np.hypot(s, h) + h * h * np.arcsinh(s / h))
