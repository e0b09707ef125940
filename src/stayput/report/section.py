"""A piece in its room, to scale and from the side, on Matplotlib's axes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Polygon, Rectangle

from stayput.measures import Held
from stayput.measures.element import at_rest
from stayput.measures.sketch import sketch
from stayput.model.body import Body
from stayput.model.state import State, standing_corners, wall_faces
from stayput.report.figures import FONT, label_axes
from stayput.report.palette import INK, MUTED, ROLE_COLOURS, ROOM, STABILITY_COLOURS
from stayput.simulation.space_fate import Stability

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.model.room import Room

STAND_IN = Body(width=0.4, height=1.8, mass=100.0)
"""What stands dashed in a room that is drawn without a piece."""

_WALL = 0.04
"""How thick floor, walls and ceiling are drawn, as a part of the piece's larger side."""

_TEXT = 0.22
"""Room above the drawing for two lines of text, as a part of the piece's larger side."""

_NEAR = 1.2
"""A wall or ceiling is drawn where it is no farther than this part of the piece's larger side."""


def draw_body_in_room(axis: Axes, body: Body | None, room: Room, language: str) -> None:
    """Draw a body without measures in a room; without one, `STAND_IN` is indicated."""
    draw_section(axis, Held(body or STAND_IN, room), language, dashed=body is None)


def draw_section(
    axis: Axes, held: Held, language: str, *, dashed: bool = False, stands: Stability | None = None
) -> None:
    """Draw a body at rest with its measures, and what of the room is near.

    Parameters
    ----------
    axis : Axes
        Where to draw; its scales are made equal [m].
    held : Held
        The body, its room, and the measures.
    language : str
        "en" or "ja".
    dashed : bool
        Whether the body is only indicated.
    stands : str, optional
        How firmly it stands, for its colour; then with depth and height in place of axes, R and α.
    """
    body = held.body
    size = max(body.width, body.height)
    a, b, c, d = standing_corners(body, State())
    outline = [a, b, d, c]
    if dashed:
        axis.add_patch(Polygon(outline, fill=False, edgecolor=MUTED, linestyle="--"))
    else:
        axis.add_patch(Polygon(outline, facecolor=STABILITY_COLOURS[stands or Stability.STAYS]))
        axis.add_patch(Polygon(outline, fill=False, edgecolor=INK, linewidth=1.4))
        _draw_centre(axis, body, (a, b) if stands is None else ())
        _draw_measures(axis, held)
    left, right, top = _draw_room(axis, held.room, body, size)
    if not dashed and stands is None:
        place: dict[str, Any] = {"transform": axis.transAxes, "ha": "center", "va": "top"}
        axis.text(0.5, 0.99, _quantities(body), fontsize=FONT - 1.0, **place)
        top += _TEXT * size
    axis.locator_params(axis="x", nbins=3)
    axis.set_aspect("equal")
    axis.set_xlim(left, right)
    axis.set_ylim(-_WALL * size, top)
    if stands is None:
        label_axes(axis, language, "plots.across_room", "plots.above_floor")
    else:  # its depth and height alone
        axis.set_xticks([0.0], [f"{100.0 * body.width:.3g} cm"])
        axis.set_yticks([0.0, body.height], ["0", f"{100.0 * body.height:.3g} cm"])
    axis.tick_params(labelsize=FONT - 1.0, colors=INK)
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)


def _draw_centre(axis: Axes, body: Body, feet: Sequence[tuple[float, float]]) -> None:
    """Draw the centre of gravity, and from it the distances R to the base corners A and B, where given."""
    x, z = at_rest(body, body.centre_of_gravity)
    for (u, v), name, aside in zip(feet, "AB", (4.0, -4.0), strict=False):
        axis.plot([x, u], [z, v], color=INK, linestyle="--", linewidth=1.0)
        place: dict[str, Any] = {"textcoords": "offset points", "ha": "left" if aside > 0.0 else "right"}
        axis.annotate(name, (u, v), (aside, 2.0), fontsize=FONT - 1.0, **place)
    axis.plot(x, z, "o", color=INK, markersize=5.0)


def _quantities(body: Body) -> str:
    """Return R and α about the base corners: of A, then of B where they differ."""
    R = [f"{value:#.3g}" for value in body.size]
    alpha = [f"{math.degrees(value):.1f}°" for value in body.slenderness]
    if (R[0], alpha[0]) == (R[1], alpha[1]):
        return f"R = {R[0]} m\nα = {alpha[0]}"
    return f"R = {R[0]} / {R[1]} m\nα = {alpha[0]} / {alpha[1]}"


def _draw_measures(axis: Axes, held: Held) -> None:
    for shape in sketch(held):
        colour = ROLE_COLOURS[shape.role]
        if shape.kind == "polygon":
            axis.add_patch(Polygon(shape.points, facecolor=colour, edgecolor=INK, linewidth=0.6, zorder=4))
        else:
            axis.plot(*zip(*shape.points, strict=True), color=colour, linewidth=2.4, zorder=4)


def _draw_room(axis: Axes, room: Room, body: Body, size: float) -> tuple[float, float, float]:
    """Draw floor, walls and ceiling that are near; return the ends of what is shown [m]."""
    near, thick = _NEAR * size, _WALL * size
    left, right, top = -0.5 * body.width - 0.15 * size, 0.5 * body.width + 0.15 * size, 1.06 * body.height
    at_left, at_right = wall_faces(body, room)
    low = room.ceiling is not None and room.ceiling.height <= body.height + near
    if room.ceiling is not None and low:
        top = room.ceiling.height + thick
    if room.left_wall is not None and room.left_wall.gap <= near:
        left = min(left, at_left - thick)
        axis.add_patch(Rectangle((left, -thick), at_left - left, top + thick, facecolor=ROOM))
    if room.right_wall is not None and room.right_wall.gap <= near:
        right = max(right, at_right + thick)
        axis.add_patch(Rectangle((at_right, -thick), right - at_right, top + thick, facecolor=ROOM))
    axis.add_patch(Rectangle((left, -thick), right - left, thick, facecolor=ROOM))
    if room.ceiling is not None and low:
        axis.add_patch(Rectangle((left, room.ceiling.height), right - left, thick, facecolor=ROOM))
    return left, right, top
