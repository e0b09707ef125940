"""Frames of an animation, drawn with Pillow: the room in section above the floor's acceleration."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw

from stayput.report.film import section
from stayput.report.fonts import drawable, font
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

if TYPE_CHECKING:
    from stayput.report.film import Film, Pose

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
        left, right, low, high = film.view
        self._scale = min(self._scene[0] / (right - left), self._scene[1] / (high - low))
        self._half = 0.5 * self._scene[0] / self._scale
        self._middle = film.middle(2.0 * self._half)
        self._low = low
        self._still = self._still_part()

    def frame(self, pose: Pose) -> Image.Image:
        """Return the frame of a pose, in RGB."""
        image = self._still.copy()
        scene = self._draw_scene(pose)
        image.paste(scene.reduce(_SMOOTH), (0, self._header))
        draw = ImageDraw.Draw(image)
        self._draw_header(draw, pose)
        left, top, right, bottom = self._strip
        start, end = float(self._film.history.time[0]), self._film.history.end
        x = left + (right - left) * (pose.time - start) / (end - start)
        draw.line(((x, top), (x, bottom)), fill=ALARM, width=2)
        return image

    def _still_part(self) -> Image.Image:
        """Draw what no frame changes: the acceleration strip and the caption."""
        image = Image.new("RGB", self._size, PAPER)
        draw = ImageDraw.Draw(image)
        left, top, right, bottom = self._strip
        small, text = self._fonts[11], self._fonts[13]
        draw.text(
            (left, top - 3),
            drawable(f"Floor acceleration: {self._film.motion_title}"),
            fill=INK,
            font=text,
            anchor="ls",
        )
        time, motion = self._film.history.time, self._film.motion
        shown = (motion.time >= time[0]) & (motion.time <= time[-1])
        a = motion.x[shown]
        peak = float(np.abs(a).max(initial=0.0)) or 1.0
        middle, half = 0.5 * (top + bottom), 0.46 * (bottom - top)
        draw.line(((left, middle), (right, middle)), fill=FAINT)
        x = left + (right - left) * (motion.time[shown] - time[0]) / (time[-1] - time[0])
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
        words = drawable(self._film.title) if pose.time >= self._film.history.end else pose.mode.value
        room = width - 90 - 2 * chip
        face = self._fonts[15] if self._fonts[15].getlength(words) <= room else self._fonts[13]
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
        film, body = self._film, self._film.body
        stood = [
            self._point(x + pose.shift, z) for x, z in section(body, film.at(float(film.history.time[0])))
        ]
        draw.line([*stood, stood[0]], fill=FAINT, width=self._line)
        self._draw_room(draw, pose.shift)
        outline = [self._point(x + pose.shift, z) for x, z in section(body, pose)]
        draw.polygon(outline, fill=MODE_COLOURS[pose.mode])
        draw.line([*outline, outline[0], outline[1]], fill=INK, width=2 * self._line, joint="curve")
        self._draw_props(draw, pose)
        x, z = self._point(pose.x + pose.shift, pose.z)
        r = 5.0 * self._line
        draw.ellipse((x - r, z - r, x + r, z + r), fill=PAPER, outline=INK, width=self._line)
        for start in (0, 180):
            draw.pieslice((x - r, z - r, x + r, z + r), start, start + 90, fill=INK)
        return image

    def _draw_props(self, draw: ImageDraw.ImageDraw, pose: Pose) -> None:
        """Draw the devices over the body."""
        for prop in self._film.props:
            if not prop.shows(pose.time):
                continue
            points = [self._point(x + pose.shift, z) for x, z in prop.placed(pose)]
            colour = ROLE_COLOURS[prop.role]
            if prop.filled:
                draw.polygon(points, fill=colour)
            else:
                draw.line(points, fill=colour, width=4 * self._line)

    def _draw_grid(self, draw: ImageDraw.ImageDraw) -> None:
        """Draw the dotted lines that do not move with the room."""
        step, half = self._film.grid, self._half
        dot = 3 * self._line
        for k in range(int((self._middle - half) // step), int((self._middle + half) // step) + 1):
            x, _ = self._point(k * step, 0.0)
            for z in range(0, self._scene[1], 3 * dot):
                draw.line(((x, z), (x, z + dot)), fill=FAINT, width=self._line)

    def _draw_room(self, draw: ImageDraw.ImageDraw, shift: float) -> None:
        """Draw the slab, the walls and the ceiling, with marks that move with them."""
        film, (width, height) = self._film, self._scene
        floor = self._point(0.0, 0.0)[1]
        top = -1.0 if film.ceiling is None else self._point(0.0, film.ceiling)[1]
        left = -1.0 if film.left_wall is None else self._point(film.left_wall + shift, 0.0)[0]
        right = width + 1.0 if film.right_wall is None else self._point(film.right_wall + shift, 0.0)[0]
        for box in (
            (0.0, floor, width, height),
            (0.0, 0.0, left, floor),
            (right, 0.0, width, floor),
            (0.0, 0.0, width, top),
        ):
            if box[2] > box[0] and box[3] > box[1]:
                draw.rectangle(box, fill=ROOM)
        draw.line(((left, floor), (right, floor)), fill=INK, width=2 * self._line)
        mark = 0.25 * film.grid * self._scale
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
        if film.ceiling is not None:
            draw.line(((max(left, 0.0), top), (min(right, width), top)), fill=INK, width=2 * self._line)
