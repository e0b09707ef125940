"""Frames of an animation, drawn with Pillow: the room in section above the floor's acceleration."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw

from stayput.catalogue import say
from stayput.catalogue.names import MODES
from stayput.report.layout import FrameLayout
from stayput.report.palette import (
    FAINT,
    INK,
    MODE_COLOURS,
    PAPER,
    ROLE_COLOURS,
    ROOM,
    ROOM_SHADE,
)
from stayput.report.scene import room_data, section

if TYPE_CHECKING:
    from stayput.report.film import Film
    from stayput.report.scene import Pose


class Painter:
    """Draws the frames of one film.

    Parameters
    ----------
    film : Film
        What is shown.
    width, height : int
        Size of a frame [pixels].
    """

    def __init__(self, film: Film, width: int, height: int) -> None:
        self._film = film
        caption = " ".join(filter(None, (film.note, film.caption)))
        self._layout = FrameLayout(width, height, film.scene.start, film.scene.end, film.strip_title, caption)
        self._scene, self._line = self._layout.scene, self._layout.line
        room, view = room_data(film.scene.runs[0]), film.scene.view
        # A face of the room that the view leaves out would only be seen where the frame is wider than it.
        left, right, ceiling = room["left_wall_x_m"], room["right_wall_x_m"], room["ceiling_z_m"]
        self._left_wall = None if left is None or left < view.left else left
        self._right_wall = None if right is None or right > view.right else right
        self._ceiling = None if ceiling is None or ceiling > view.high else ceiling
        self._scale = min(self._scene[0] / (view.right - view.left), self._scene[1] / (view.high - view.low))
        self._half = 0.5 * self._scene[0] / self._scale
        self._middle = 0.5 * (view.left + view.right)
        if (self._left_wall is None) != (self._right_wall is None):  # a single wall stays at its edge
            wall_is_left = self._right_wall is None
            self._middle = view.left + self._half if wall_is_left else view.right - self._half
        self._low = view.low
        motion = film.scene.motion
        self._still = self._layout.still(motion.time, {"x": motion.x})

    def frame(self, time: float) -> Image.Image:
        """Return the frame of an instant [s], in RGB."""
        pose = self._film.scene.pose(time)
        image = self._layout.frame(self._still, self._draw_scene(pose), pose.time)
        ended = pose.time >= self._film.scene.end
        text = self._film.title if ended else say(MODES[pose.mode], self._film.language)
        self._layout.head(image, text, MODE_COLOURS[pose.mode])
        return image

    def _point(self, x: float, z: float) -> tuple[float, float]:
        return (
            0.5 * self._scene[0] + (x - self._middle) * self._scale,
            self._scene[1] - (z - self._low) * self._scale,
        )

    def _draw_scene(self, pose: Pose) -> Image.Image:
        image = Image.new("RGB", self._scene, PAPER)
        draw = ImageDraw.Draw(image)
        self._draw_grid(draw)
        scene = self._film.scene
        body = scene.runs[0].body
        stood = [self._point(x + pose.shift, z) for x, z in section(body, scene.pose(scene.start))]
        draw.line([*stood, stood[0]], fill=FAINT, width=self._line)
        self._draw_room(draw, pose.shift)
        outline = [self._point(x + pose.shift, z) for x, z in section(body, pose)]
        draw.polygon(outline, fill=MODE_COLOURS[pose.mode])
        draw.line([*outline, outline[0], outline[1]], fill=INK, width=2 * self._line, joint="curve")
        self._draw_devices(draw, pose)
        x, z = self._point(pose.x + pose.shift, pose.z)
        r = 5.0 * self._line
        draw.ellipse((x - r, z - r, x + r, z + r), fill=PAPER, outline=INK, width=self._line)
        for start in (0, 180):
            draw.pieslice((x - r, z - r, x + r, z + r), start, start + 90, fill=INK)
        return image

    def _draw_devices(self, draw: ImageDraw.ImageDraw, pose: Pose) -> None:
        """Draw the devices over the body, moved with the room."""
        for shape in self._film.scene.devices(pose):
            points = [self._point(x + pose.shift, z) for x, z in shape["points"]]
            colour = ROLE_COLOURS["broken" if shape["broken"] else shape["role"]]
            if shape["kind"] == "polygon":
                draw.polygon(points, fill=colour)
            else:
                draw.line(points, fill=colour, width=4 * self._line)

    def _draw_grid(self, draw: ImageDraw.ImageDraw) -> None:
        """Draw the dotted lines that do not move with the room."""
        step, half = self._film.scene.view.grid, self._half
        dot = 3 * self._line
        for k in range(int((self._middle - half) // step), int((self._middle + half) // step) + 1):
            x, _ = self._point(k * step, 0.0)
            for z in range(0, self._scene[1], 3 * dot):
                draw.line(((x, z), (x, z + dot)), fill=FAINT, width=self._line)

    def _draw_room(self, draw: ImageDraw.ImageDraw, shift: float) -> None:
        """Draw the slab, the walls and the ceiling, with marks that move with them."""
        width, height = self._scene
        floor = self._point(0.0, 0.0)[1]
        top = -1.0 if self._ceiling is None else self._point(0.0, self._ceiling)[1]
        left = -1.0 if self._left_wall is None else self._point(self._left_wall + shift, 0.0)[0]
        right = width + 1.0 if self._right_wall is None else self._point(self._right_wall + shift, 0.0)[0]
        for box in (
            (0.0, floor, width, height),
            (0.0, 0.0, left, floor),
            (right, 0.0, width, floor),
            (0.0, 0.0, width, top),
        ):
            if box[2] > box[0] and box[3] > box[1]:
                draw.rectangle(box, fill=ROOM)
        draw.line(((left, floor), (right, floor)), fill=INK, width=2 * self._line)
        mark = 0.25 * self._film.scene.view.grid * self._scale
        origin = self._point(shift, 0.0)[0] % mark
        for k in range(-1, int(width / mark) + 2):
            x = origin + k * mark
            draw.line(
                ((x, floor + 4 * self._line), (x - 0.5 * mark, height)), fill=ROOM_SHADE, width=self._line
            )
        for x, inside in ((left, 1.0), (right, -1.0)):
            if 0.0 <= x <= width:
                draw.line(((x, max(top, 0.0)), (x, floor)), fill=INK, width=2 * self._line)
                for z in np.arange(floor - mark, max(top, 0.0), -mark):
                    draw.line(
                        ((x - inside * 3 * self._line, z), (x - inside * mark, z + 0.5 * mark)),
                        fill=ROOM_SHADE,
                        width=self._line,
                    )
        if self._ceiling is not None:
            draw.line(((max(left, 0.0), top), (min(right, width), top)), fill=INK, width=2 * self._line)
