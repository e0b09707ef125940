"""Frames of an animation, drawn with Pillow: their layout, and the room in section."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from PIL import Image, ImageDraw

from stayput.catalogue import say
from stayput.catalogue.names import MODES
from stayput.report.fonts import font, with_face, wrapped
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
    from numpy.typing import NDArray
    from PIL import ImageFont

    from stayput.report.animation import Film
    from stayput.report.scene import PlaneScene, Pose


SMOOTH = 2
"""A scene is drawn so many times larger and reduced, which smooths its edges."""


class _SetText(NamedTuple):
    """A text in lines, its font, and how high it is [pixels]."""

    text: str
    face: ImageFont.FreeTypeFont
    height: float


def _set(text: str, size: float, room: float) -> _SetText:
    words, face = with_face(text, size)
    lines = wrapped(words, face, room)
    draw = ImageDraw.Draw(Image.new("1", (1, 1)))
    return _SetText(lines, face, draw.multiline_textbbox((0, 0), lines, font=face, spacing=2)[3])


class FrameLayout:
    """The parts of a frame, and how all but the scene are drawn.

    Parameters
    ----------
    film : Film
        What is shown; its texts above and below the strip get as many lines as they need.
    acceleration : dict of ndarray
        Components of the floor's acceleration by their names, shape (n,) each [m/s²].
    time : ndarray, shape (n,)
        Their times [s].
    width, height : int
        Size of a frame [pixels].
    """

    def __init__(
        self,
        film: Film[Any],
        acceleration: dict[str, NDArray[np.float64]],
        time: NDArray[np.float64],
        width: int,
        height: int,
    ) -> None:
        heading, caption = film.strip_title, f"{film.note} {film.caption}".strip()
        self._size = (width, height)
        self._span = (film.scene.start, film.scene.end)
        unit = height / 480.0
        self._fonts = {size: font(size * unit) for size in (11, 13, 15)}
        self._header = round(40 * unit)
        left, right = round(46 * unit), width - round(12 * unit)
        self._caption = _set(caption, 11 * unit, width - 16.0)
        self._heading = _set(heading, 13 * unit, right - left - 48 * unit)
        if "\n" in self._heading.text:
            self._heading = _set(heading, 11 * unit, right - left - 48 * unit)
        bottom = height - round(max(46 * unit, self._caption.height + 14 * unit))
        self._strip = (left, bottom - round(58 * unit), right, bottom)
        above = round(max(22 * unit, self._heading.height + 6 * unit))
        self.scene = (width * SMOOTH, (self._strip[1] - above - self._header) * SMOOTH)
        self.line = max(1, round(unit * SMOOTH))
        self._still = self._drawn_once(time, acceleration)

    def _drawn_once(self, time: NDArray[np.float64], parts: dict[str, NDArray[np.float64]]) -> Image.Image:
        """Return what all frames share: the strip with its heading, and the caption."""
        image = Image.new("RGB", self._size, PAPER)
        draw = ImageDraw.Draw(image)
        left, top, right, bottom = self._strip
        small, text = self._fonts[11], self._fonts[13]
        above = (left, top - 3 - self._heading.height)
        draw.multiline_text(above, self._heading.text, fill=INK, font=self._heading.face, spacing=2)
        start, end = self._span
        shown = (time >= start) & (time <= end)
        peak = max(float(np.abs(a[shown]).max(initial=0.0)) for a in parts.values()) or 1.0
        middle, half = 0.5 * (top + bottom), 0.46 * (bottom - top)
        draw.line(((left, middle), (right, middle)), fill=FAINT)
        x = left + (right - left) * (time[shown] - start) / (end - start)
        for place, (name, a) in enumerate(reversed(parts.items())):
            y = middle - half * a[shown] / peak
            draw.line(list(zip(x.tolist(), y.tolist(), strict=True)), fill=COMPONENT_COLOURS[name])
            if len(parts) > 1:
                beside = (right - 1.2 * place * text.size, top - 3)
                draw.text(beside, name, fill=COMPONENT_COLOURS[name], font=text, anchor="rs")
        for level in (peak, -peak):
            place = (left - 4, middle - half * level / peak)
            draw.text(place, f"{level:z.1f}", fill=MUTED, font=small, anchor="rm")
        draw.text((left - 4, middle), "m/s²", fill=MUTED, font=small, anchor="rm")
        below = (8, bottom + 6)
        draw.multiline_text(below, self._caption.text, fill=MUTED, font=self._caption.face, spacing=2)
        return image

    def frame(self, scene: Image.Image, time: float) -> Image.Image:
        """Return a frame without its heading: what all share, the scene, and the time [s]."""
        image = self._still.copy()
        image.paste(scene.reduce(SMOOTH), (0, self._header))
        draw = ImageDraw.Draw(image)
        place = (self._size[0] - 10, 0.5 * self._header)
        draw.text(place, f"{time:.2f} s", fill=INK, font=self._fonts[15], anchor="rm")
        left, top, right, bottom = self._strip
        start, end = self._span
        x = left + (right - left) * (time - start) / (end - start)
        draw.line(((x, top), (x, bottom)), fill=ALARM, width=2)
        return image

    def head(self, image: Image.Image, text: str, chip: str | None = None) -> None:
        """Write a heading on a frame, after a chip of a colour where one is given."""
        draw, middle = ImageDraw.Draw(image), 0.5 * self._header
        side = 0.6 * self._header
        start = 10.0
        if chip is not None:
            draw.rectangle((10, middle - side / 2, 10 + side, middle + side / 2), fill=chip, outline=INK)
            start += side + 10.0
        room = self._size[0] - 80 - start
        words, face = with_face(text, self._fonts[15].size)
        if face.getlength(words) > room:
            words, face = with_face(text, self._fonts[13].size)
        lines = wrapped(words, face, room)
        draw.multiline_text((start, middle), lines, fill=INK, font=face, anchor="lm", spacing=2)

    def legend(self, image: Image.Image, entries: dict[str, str]) -> None:
        """Write names with their colours below the heading of a frame."""
        draw, small = ImageDraw.Draw(image), self._fonts[11]
        side, y = 0.8 * small.size, self._header + small.size
        x = 10.0
        for name, colour in entries.items():
            words, face = with_face(name, small.size)
            if x > 10.0 and x + side + 5 + face.getlength(words) > self._size[0] - 10:
                x, y = 10.0, y + 1.5 * small.size
            draw.rectangle((x, y - side / 2, x + side, y + side / 2), fill=colour, outline=INK)
            draw.text((x + side + 5, y), words, fill=INK, font=face, anchor="lm")
            x += side + 5 + face.getlength(words) + 14


class Painter:
    """Draws the frames of one film.

    Parameters
    ----------
    film : Film
        What is shown.
    width, height : int
        Size of a frame [pixels].
    """

    def __init__(self, film: Film[PlaneScene], width: int, height: int) -> None:
        self._film, motion = film, film.scene.motion
        self._layout = FrameLayout(film, {"x": motion.x}, motion.time, width, height)
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

    def frame(self, time: float) -> Image.Image:
        """Return the frame of an instant [s], in RGB."""
        pose = self._film.scene.pose(time)
        image = self._layout.frame(self._draw_scene(pose), pose.time)
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
        walls = (0.0, 0.0, left, floor), (right, 0.0, width, floor)
        for box in ((0.0, floor, width, height), *walls, (0.0, 0.0, width, top)):
            if box[2] > box[0] and box[3] > box[1]:
                draw.rectangle(box, fill=ROOM)
        draw.line(((left, floor), (right, floor)), fill=INK, width=2 * self._line)
        mark = 0.25 * self._film.scene.view.grid * self._scale
        origin = self._point(shift, 0.0)[0] % mark
        for k in range(-1, int(width / mark) + 2):
            x = origin + k * mark
            ends = ((x, floor + 4 * self._line), (x - 0.5 * mark, height))
            draw.line(ends, fill=ROOM_SHADE, width=self._line)
        for x, inside in ((left, 1.0), (right, -1.0)):
            if 0.0 <= x <= width:
                draw.line(((x, max(top, 0.0)), (x, floor)), fill=INK, width=2 * self._line)
                for z in np.arange(floor - mark, max(top, 0.0), -mark):
                    ends = ((x - inside * 3 * self._line, z), (x - inside * mark, z + 0.5 * mark))
                    draw.line(ends, fill=ROOM_SHADE, width=self._line)
        if self._ceiling is not None:
            draw.line(((max(left, 0.0), top), (min(right, width), top)), fill=INK, width=2 * self._line)
