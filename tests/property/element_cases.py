"""Random elements for the mechanics: devices of every kind, sensible and wild."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from mechanics_cases import Source, Standing, _among, _one_in

from stayput.cases import standing_corners
from stayput.mechanics.restrained import columns as el
from stayput.mechanics.restrained.runner import no_elements
from stayput.simulation import State

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def random_element(source: Source, standing: Standing) -> NDArray[np.void]:
    """Return one element, shape [1], on a body that stands at rest."""
    e = no_elements(1)[0:1]
    body = standing.body
    corners = body.corners
    left, right = corners[0][0], corners[1][0]
    bottom, top = min(corners[0][1], corners[1][1]), corners[2][1]
    g = 9.8
    stiffness = g / (_among(source, 1e-5, 0.1))  # bears its weight with this elongation
    e["stiffness"][:, 0] = stiffness
    if not _one_in(source, 3):
        e["damping"][:, 0] = 2.0 * math.sqrt(stiffness) * _among(source, 1e-3, 1.5)
    e["u"], e["v"] = source.uniform(left, right), source.uniform(bottom, top)
    if _one_in(source, 2):
        e["v"] = top
    strength = g * _among(source, 0.01, 10.0)
    how = source.whole(0, 4)
    if how <= 1:
        e["kind"] = el.AXIAL
        reach = _among(source, 0.02, 1.0)
        angle = source.uniform(-math.pi, math.pi)
        rest = standing_corners(body, State())
        tilt = body.resting_tilt
        u, v = float(e["u"][0]) - corners[0][0], float(e["v"][0]) - corners[0][1]
        x = rest[0][0] + u * math.cos(tilt) + v * math.sin(tilt)
        z = rest[0][1] + v * math.cos(tilt) - u * math.sin(tilt)
        e["x"], e["z"], e["length"] = x + reach * math.cos(angle), z + reach * math.sin(angle), reach
        e["slack_plus"][:, 0] = 0.0 if _one_in(source, 2) else _among(source, 1e-4, 0.1)
        if how == 1:
            e["slack_minus"][:, 0] = source.whole(0, 1) * float(e["slack_plus"][0, 0])
        e["limit_plus"][:, 0] = strength
        if _one_in(source, 2):
            e["limit_minus"][:, 0] = strength
        if _one_in(source, 2):
            e["ultimate"][:, 0] = _among(source, 1e-4, 0.1)
        return e
    e["kind"] = el.PLANAR
    plane = source.whole(0, 3)
    e["cos"], e["sin"] = ((1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (-1.0, 0.0))[plane]
    e["stiffness"][:, 1] = 0.0 if _one_in(source, 4) else stiffness * _among(source, 0.05, 1.0)
    e["slack_plus"][:, 1] = e["slack_minus"][:, 1] = 0.0 if _one_in(source, 2) else _among(source, 1e-4, 0.1)
    if how == 2:  # a pole
        e["slack_minus"][:, 0] = -g * _among(source, 0.01, 1.0) / stiffness
        e["limit_minus"][:, 0] = strength + g
        e["damping"] = 0.0
        e["friction"] = source.uniform(0.0, 1.0)
        e["drops_out"] = source.whole(0, 1)
        return e
    e["slack_plus"][:, 0] = 0.0 if _one_in(source, 2) else _among(source, 1e-4, 0.02)
    if how == 4:
        e["slack_minus"][:, 0] = 0.0
    e["limit_plus"][:, 0] = strength
    if _one_in(source, 2):
        e["limit_plus"][:, 1] = e["limit_minus"][:, 1] = strength * _among(source, 0.3, 3.0)
        if _one_in(source, 2):
            e["interaction"] = 1
    if int(e["interaction"][0]) == 0 and _one_in(source, 3):
        e["ultimate"] = _among(source, 1e-4, 0.1)
    if not _one_in(source, 3):
        e["damping"][:, 1] = e["damping"][:, 0] if float(e["stiffness"][0, 1]) > 0.0 else 0.0
    return e


def random_elements(source: Source, standing: Standing, most: int = 3) -> NDArray[np.void]:
    """Return a row of ``most`` elements, some of them of no kind."""
    rows = no_elements(most)
    for n in range(source.whole(1, most)):
        rows[n : n + 1] = random_element(source, standing)
    return rows


def mirrored_elements(elements: NDArray[np.void]) -> NDArray[np.void]:
    """Return elements with right and left exchanged."""
    image = elements.copy()
    image["u"], image["x"] = -elements["u"], -elements["x"]
    image["sin"] = -elements["sin"]
    # along the mirrored tangent what was to one side is to the other
    for side, other in (("slack_plus", "slack_minus"), ("limit_plus", "limit_minus")):
        image[side][..., 1], image[other][..., 1] = elements[other][..., 1], elements[side][..., 1]
    return image
