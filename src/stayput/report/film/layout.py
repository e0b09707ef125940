"""The layout of an animation's frames, and what of them is not the scene, drawn with Pillow."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from stayput.report.figures import font, with_face, wrapped
from stayput.report.palette import ALARM, COMPONENT_COLOURS, FAINT, INK, MUTED, PAPER, STABILITY_COLOURS

if TYPE_CHECKING:
    from stayput.report.animation import Film


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
    width, height : int
        Size of a frame [pixels].
    """

    def __init__(self, film: Film, width: int, height: int) -> None:
        heading, caption = film.strip_title, f"{film.note} {film.caption}".strip()
        self._run, self._steps = film.scene.run, film.scene.stability
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
        self._band = round(7 * unit) if len(self._steps) == 1 else 0
        bottom = height - self._band - round(max(46 * unit, self._caption.height + 14 * unit))
        self._strip = (left, bottom - round(58 * unit), right, bottom)
        above = round(max(22 * unit, self._heading.height + 6 * unit))
        self.scene = (width * SMOOTH, (self._strip[1] - above - self._header) * SMOOTH)
        self.line = max(1, round(unit * SMOOTH))
        self._still = self._drawn_once()

    def _drawn_once(self) -> Image.Image:
        """Return what all frames share: the strip, how firmly a lone piece stands below it, and the texts."""
        time, parts = self._run.motion.time, self._run.motion.components
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
        for first, step in self._steps[0] if self._band else ():
            low = left + (right - left) * (first - start) / (end - start)
            draw.rectangle((low, bottom + 1, right, bottom + self._band), fill=STABILITY_COLOURS[step])
        below = (8, bottom + self._band + 6)
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

    def head(self, image: Image.Image, text: str) -> None:
        """Write a heading on a frame."""
        draw, middle, start = ImageDraw.Draw(image), 0.5 * self._header, 10.0
        room = self._size[0] - 80 - start
        words, face = with_face(text, self._fonts[15].size)
        if face.getlength(words) > room:
            words, face = with_face(text, self._fonts[13].size)
        lines = wrapped(words, face, room)
        draw.multiline_text((start, middle), lines, fill=INK, font=face, anchor="lm", spacing=2)

    def legend(self, image: Image.Image, rows: Iterable[Iterable[tuple[str, str]]]) -> None:
        """Write rows of names with their colours below the heading of a frame."""
        draw, small = ImageDraw.Draw(image), self._fonts[11]
        side, y = 0.8 * small.size, self._header - 0.5 * small.size
        for row in rows:
            x, y = 10.0, y + 1.5 * small.size
            for name, colour in row:
                words, face = with_face(name, small.size)
                if x > 10.0 and x + side + 5 + face.getlength(words) > self._size[0] - 10:
                    x, y = 10.0, y + 1.5 * small.size
                draw.rectangle((x, y - side / 2, x + side, y + side / 2), fill=colour, outline=INK)
                draw.text((x + side + 5, y), words, fill=INK, font=face, anchor="lm")
                x += side + 5 + face.getlength(words) + 14
