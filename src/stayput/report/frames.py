"""Frames of an animation, drawn with Pillow: the room in section above the floor's acceleration."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw

from stayput.catalogue import say
from stayput.catalogue.names import MODES
from stayput.report.fonts import font, with_face
from stayput.report.palette import (
    ALARM,
    COMPONENT_COLOURS,
    FAINT,
    INK,
    MODE_COLOURS,
    MUTED,
    PAPER,
    ROLE_COLOURS,
    ROOM,
    ROOM_SHADE,
)
from stayput.report.scene import room_data, section

if TYPE_CHECKING:
    from stayput.report.film import Film
    from stayput.report.scene import Pose

_SMOOTH = 2  # the scene is drawn so many times larger and reduced, which smooths its edges


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
        self._size = (width, height)
        unit = height / 480.0
        self._fonts = {size: font(size * unit) for size in (11, 13, 15)}
        self._header = round(40 * unit)
        self._strip = (
            round(46 * unit),
            height - round(104 * unit),
            width - round(12 * unit),
            height - round(46 * unit),
        )
        self._scene = (width * _SMOOTH, (self._strip[1] - round(22 * unit) - self._header) * _SMOOTH)
        self._line = max(1, round(unit * _SMOOTH))
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
        self._still = self._still_part()

    def frame(self, time: float) -> Image.Image:
        """Return the frame of an instant [s], in RGB."""
        pose = self._film.scene.pose(time)
        image = self._still.copy()
        scene = self._draw_scene(pose)
        image.paste(scene.reduce(_SMOOTH), (0, self._header))
        draw = ImageDraw.Draw(image)
        self._draw_header(draw, pose)
        left, top, right, bottom = self._strip
        start, end = self._film.scene.start, self._film.scene.end
        x = left + (right - left) * (pose.time - start) / (end - start)
        draw.line(((x, top), (x, bottom)), fill=ALARM, width=2)
        return image

    def _still_part(self) -> Image.Image:
        """Draw the static part of all frames: the acceleration strip and the caption."""
        image = Image.new("RGB", self._size, PAPER)
        draw = ImageDraw.Draw(image)
        left, top, right, bottom = self._strip
        small, text = self._fonts[11], self._fonts[13]
        heading, face = with_face(self._film.strip_title, text.size)
        draw.text((left, top - 3), heading, fill=INK, font=face, anchor="ls")
        scene = self._film.scene
        motion, start, end = scene.motion, scene.start, scene.end
        shown = (motion.time >= start) & (motion.time <= end)
        a = motion.x[shown]
        peak = float(np.abs(a).max(initial=0.0)) or 1.0
        middle, half = 0.5 * (top + bottom), 0.46 * (bottom - top)
        draw.line(((left, middle), (right, middle)), fill=FAINT)
        x = left + (right - left) * (motion.time[shown] - start) / (end - start)
        draw.line(
            list(zip(x.tolist(), (middle - half * a / peak).tolist(), strict=True)),
            fill=COMPONENT_COLOURS["x"],
        )
        for level in (peak, -peak):
            draw.text(
                (left - 4, middle - half * level / peak), f"{level:.1f}", fill=MUTED, font=small, anchor="rm"
            )
        draw.text((left - 4, middle), "m/s²", fill=MUTED, font=small, anchor="rm")
        characters = int(1.08 * (right - 8) / small.getlength("e"))
        lines = "\n".join(textwrap.wrap(self._film.caption, characters))
        draw.multiline_text((8, bottom + 8), lines, fill=MUTED, font=small, spacing=3)
        return image

    def _draw_header(self, draw: ImageDraw.ImageDraw, pose: Pose) -> None:
        width, middle = self._size[0], 0.5 * self._header
        draw.text((width - 10, middle), f"{pose.time:.2f} s", fill=INK, font=self._fonts[15], anchor="rm")
        chip = 0.3 * self._header
        draw.rectangle(
            (10, middle - chip, 10 + 2 * chip, middle + chip), fill=MODE_COLOURS[pose.mode], outline=INK
        )
        ended = pose.time >= self._film.scene.end
        text = self._film.title if ended else say(MODES[pose.mode], self._film.language)
        room = width - 90 - 2 * chip
        words, face = with_face(text, self._fonts[15].size)
        if face.getlength(words) > room:
            words, face = with_face(text, self._fonts[13].size)
        lines = "\n".join(textwrap.wrap(words, max(20, int(1.08 * room / face.getlength("e")))))
        draw.multiline_text((20 + 2 * chip, middle), lines, fill=INK, font=face, anchor="lm", spacing=2)

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
