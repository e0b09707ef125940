"""Frames of an animation, drawn with Pillow: from the far bodies to the near ones."""

from __future__ import annotations

import math
from collections.abc import Sequence
from copy import copy
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFilter

from stayput.catalogue import say
from stayput.report import palette
from stayput.report.film.layout import FrameLayout
from stayput.report.film.shape import OPENINGS, STILL_LOOKS, SolidShape, StillShape, cut

if TYPE_CHECKING:
    from stayput.report.animation import Film


Colour: TypeAlias = str | int | tuple[int, ...]
"""A colour as Pillow takes it."""

_LIGHT = np.array([0.5, -0.3, 0.85]) / math.hypot(0.5, -0.3, 0.85)
_SHADOW = 0.26  # what part of the floor's light a shadow takes
_STAGE = 0.9  # how far the floor goes beyond the bodies, in sizes of them


def _mixed(colour: str, other: str, share: float) -> tuple[int, int, int]:
    """Return a colour between two."""
    red, green, blue = (
        round(a + share * (b - a)) for a, b in zip(palette.rgb(colour), palette.rgb(other), strict=True)
    )
    return red, green, blue


class DrawnHull(NamedTuple):
    """A convex body where it is drawn.

    Parameters
    ----------
    corners : ndarray, shape (k, 3)
        Its corners [m].
    normals, on_faces : ndarray, shape (faces, 3)
        Unit normals of its faces, and a point of each [m].
    """

    corners: NDArray[np.float64]
    normals: NDArray[np.float64]
    on_faces: NDArray[np.float64]


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
        self._film, scene = film, film.scene
        self._layout = FrameLayout(film, width, height)
        self._camera = Camera(scene.points, *self._layout.scene, VIEWS[scene.view])
        self._line = self._layout.line
        self._openings, self._swings = list[StillShape](), list[StillShape]()
        for shape in scene.still:
            if shape.role in OPENINGS:  # what is in its wall, and the lines of a door on the floor
                in_wall = tuple(line for line in shape.lines if line[:, 2].any())
                swing = tuple(line for line in shape.lines if not line[:, 2].any())
                self._openings.append(shape._replace(lines=in_wall))
                self._swings += [shape._replace(faces=(), lines=swing)] if swing else []
        self._places = [shape for shape in scene.still if shape.role not in OPENINGS]
        self._boxes = [
            DrawnHull(shape.points, shape.normals, np.array([face[0] for face in shape.faces]))
            for shape in self._places
        ]
        size = float(np.linalg.norm(scene.high - scene.low))
        self._low, self._high = scene.low - _STAGE * size, scene.high + _STAGE * size
        self._high[2] = scene.high[2] + 0.2 * size
        for x, y, z, offset in scene.planes:
            for axis, part in enumerate((x, y, z)):
                if part > 0.5:
                    self._low[axis] = offset
                elif part < -0.5:
                    self._high[axis] = -offset
        self._low[2] = 0.0

    def frame(self, time: float) -> Image.Image:
        """Return the frame of an instant [s], in RGB."""
        film = self._film
        camera = self._camera.moved(-film.scene.shift_at(time))
        scene = self._draw_room(camera)
        places, turns = film.scene.pose(time)
        corners = [film.scene.corners(b, turns[b], places[b]) for b in range(len(places))]
        colours = [palette.STABILITY_COLOURS[film.scene.stability_at(b, time)] for b in range(len(places))]
        self._draw_shadows(scene, camera, corners)
        draw = ImageDraw.Draw(scene)
        pen = ImageDraw.Draw(scene, "RGBA")  # which mixes colours
        # of walls that are seen from within
        beyond = [shape.normals[0] @ (camera.place - shape.faces[0][0]) > 0.0 for shape in self._openings]
        for swing in self._swings:
            _draw_still(pen, camera, self._line, swing)
        for opening, behind in zip(self._openings, beyond, strict=True):
            if behind:
                _draw_still(pen, camera, self._line, opening)
        hulls = [_hull_of(*each) for each in zip(film.scene.shapes, corners, turns, strict=True)]
        for n in _from_far(camera.place, [*hulls, *self._boxes]):
            if n < len(hulls):
                body = film.scene.shapes[n], corners[n], turns[n], colours[n]
                _draw_body(draw, camera, self._line, *body)
            else:
                _draw_still(pen, camera, self._line, self._places[n - len(hulls)])
        for opening, behind in zip(self._openings, beyond, strict=True):
            if not behind:
                _draw_still(pen, camera, self._line, opening)
        self._draw_ties(draw, camera, time, places, turns)
        image = self._layout.frame(scene, time)
        text = "" if len(corners) > 1 else self._state(time)
        self._layout.head(image, film.title if time >= film.scene.end else text)
        names = film.scene.names if len(corners) > 1 else ()
        rows = palette.stability_looks(film.language).values(), zip(names, colours, strict=False)
        self._layout.legend(image, rows)
        return image

    def _state(self, time: float) -> str:
        """Return how the only body stands at a time [s]."""
        run, language = self._film.scene.run, self._film.language
        tilt, slide = (
            float(np.interp(time, run.time, values)) for values in (np.degrees(run.tilt), 100.0 * run.slide)
        )
        state = say("space.state", language, tilt=abs(tilt), slide=abs(slide))
        name, _ = palette.stability_looks(language)[self._film.scene.stability_at(0, time)]
        return f"{name}{say('common.colon', language)}{state}"

    def _draw_room(self, camera: Camera) -> Image.Image:
        """Draw floor, walls and ceiling, where they face the camera, and where bodies stood."""
        image = Image.new("RGB", self._layout.scene, palette.PAPER)
        draw = ImageDraw.Draw(image)
        for *normal, offset in [(0.0, 0.0, 1.0, 0.0), *self._film.scene.planes]:
            if np.dot(normal, camera.place) > offset:
                axis = int(np.argmax(np.abs(normal)))
                self._draw_face(draw, camera, axis, offset * normal[axis], 0.16 if axis == 2 else 0.26)
        for b in range(len(self._film.scene.names)):
            foot = self._film.scene.footprint(b)
            if len(foot):
                outline = camera.seen(np.concatenate([foot, foot[:1]]))
                _stroke(draw, outline, palette.MUTED, self._line)
        return image

    def _draw_face(
        self, draw: ImageDraw.ImageDraw, camera: Camera, axis: int, at: float, tone: float
    ) -> None:
        """Draw a rectangle across an axis with its grid."""
        u, v = (axis + 1) % 3, (axis + 2) % 3
        low, high, grid = self._low, self._high, self._film.scene.grid

        places = [(low[u], low[v]), (high[u], low[v]), (high[u], high[v]), (low[u], high[v])]
        for k in range(math.ceil(low[u] / grid), math.floor(high[u] / grid) + 1):
            places += [(k * grid, low[v]), (k * grid, high[v])]
        for k in range(math.ceil(low[v] / grid), math.floor(high[v] / grid) + 1):
            places += [(low[u], k * grid), (high[u], k * grid)]
        points = np.empty((len(places), 3))
        points[:, axis] = at
        points[:, [u, v]] = places
        lines = [range(end, end + 2) for end in range(4, len(places), 2)]
        face, *seen = camera.outlines(points, [range(4), *lines])
        _fill(draw, face, _mixed(palette.PAPER, palette.ROOM, tone))
        colour = _mixed(palette.PAPER, palette.ROOM, tone + 0.22)
        for ends in seen:
            _stroke(draw, ends, colour, self._line)

    def _draw_shadows(self, scene: Image.Image, camera: Camera, corners: list[NDArray[np.float64]]) -> None:
        """Darken the floor where the light does not reach it."""
        mask = Image.new("L", scene.size)
        draw = ImageDraw.Draw(mask)
        for shape, points in zip(self._film.scene.shapes, corners, strict=True):
            fallen = points - points[:, 2:] / _LIGHT[2] * _LIGHT
            fallen = np.clip(fallen, self._low, self._high)  # none beyond a wall
            for outline in camera.outlines(fallen, [face.tolist() for face in shape.solid.faces]):
                _fill(draw, outline, round(255 * _SHADOW))
        around = mask.getbbox()
        if around is None:
            return
        left, top, right, bottom = around
        soft = 2.5 * self._line
        reach = math.ceil(soft) + 1
        around = (  # only there is anything to soften
            max(0, left - reach),
            max(0, top - reach),
            min(mask.width, right + reach),
            min(mask.height, bottom + reach),
        )
        scene.paste(palette.INK, around, mask.crop(around).filter(ImageFilter.BoxBlur(soft)))

    def _draw_ties(
        self,
        draw: ImageDraw.ImageDraw,
        camera: Camera,
        time: float,
        places: NDArray[np.float64],
        turns: NDArray[np.float64],
    ) -> None:
        """Draw devices and joints over the bodies; of those that have failed a cross where they held."""
        for tie in self._film.scene.ties:
            ends = camera.seen(self._film.scene.ends(tie, places, turns))
            if len(ends) < 2:  # behind the camera
                continue
            if time >= tie.lost:
                _cross(draw, ends[0], 2.5 * self._line)
                continue
            for colour, width in (
                (palette.PAPER, 4 * self._line),
                (palette.ROLE_COLOURS["tie"], 2 * self._line),
            ):
                _stroke(draw, ends, colour, width)
                for x, y in ends:
                    draw.ellipse((x - width, y - width, x + width, y + width), fill=colour)


def _from_far(eye: NDArray[np.float64], hulls: Sequence[DrawnHull]) -> list[int]:
    """Return convex bodies in an order in which each is drawn over those that it hides."""
    behind: list[set[int]] = [set() for _ in hulls]
    for a, hull in enumerate(hulls):
        for b, other in enumerate(hulls[:a]):
            beyond_a, seen_a = _apart(hull, other.corners, eye)
            beyond_b, seen_b = _apart(other, hull.corners, eye)
            b_in_front = seen_a if beyond_a > beyond_b else not seen_b
            behind[b if b_in_front else a].add(a if b_in_front else b)
    farness = [float(np.linalg.norm(hull.corners.mean(axis=0) - eye)) for hull in hulls]
    left, order = set(range(len(hulls))), list[int]()
    while left:
        free = [b for b in left if not behind[b] & left] or list(left)  # three may lie in a circle
        order.append(max(free, key=farness.__getitem__))
        left.remove(order[-1])
    return order


def _fill(draw: ImageDraw.ImageDraw, outline: Outline, colour: Colour) -> None:
    if len(outline) > 2:  # else it is behind the camera
        draw.polygon(outline, fill=colour)


def _cross(draw: ImageDraw.ImageDraw, middle: tuple[float, float], reach: float) -> None:
    x, y = middle
    for colour, width in ((palette.PAPER, round(reach)), (palette.ALARM, round(0.5 * reach))):
        for way in (reach, -reach):
            draw.line([(x - reach, y - way), (x + reach, y + way)], fill=colour, width=width)


def _stroke(draw: ImageDraw.ImageDraw, points: Outline, colour: Colour, width: int) -> None:
    if len(points) > 1:
        draw.line(points, fill=colour, width=width)


def _draw_body(
    draw: ImageDraw.ImageDraw,
    camera: Camera,
    line: int,
    shape: SolidShape,
    corners: NDArray[np.float64],
    turn: NDArray[np.float64],
    colour: str,
) -> None:
    solid = shape.solid
    normals = solid.normals @ turn.T
    firsts = corners[[face[0] for face in solid.faces]]
    facing = np.einsum("fi,fi->f", normals, camera.place - firsts) > 0.0
    sides: dict[tuple[int, int], int] = {}
    seen = np.flatnonzero(facing).tolist()
    faces = [solid.faces[number].tolist() for number in seen]
    for number, face, outline in zip(seen, faces, camera.outlines(corners, faces), strict=True):
        _fill(draw, outline, _shaded(colour, normals[number]))
        for i, j in zip(face, [*face[1:], face[0]], strict=True):
            side = (min(i, j), max(i, j))
            sides[side] = sides.get(side, 0) + 1
    origin = corners[0] - turn @ solid.vertices[0]
    for mark in shape.marks:
        if facing[mark.face]:
            tone = _mixed(colour, "#ffffff", 0.42) if mark.light else _mixed(colour, "#000000", 0.65)
            fill = _shaded("#{:02x}{:02x}{:02x}".format(*tone), normals[mark.face])
            _fill(draw, camera.seen(origin + mark.corners @ turn.T), fill)
    sharp = {(min(i, j), max(i, j)) for i, j in shape.edges.tolist()}
    lines = [side for side, count in sides.items() if count == 1 or side in sharp]  # outlines and edges
    for ends in camera.outlines(corners, lines):
        _stroke(draw, ends, palette.INK, line)


def _shaded(colour: str, normal: NDArray[np.float64]) -> tuple[int, int, int]:
    """Return how a face of a colour looks in the light, with the sky's and the floor's."""
    light = 0.46 + 0.12 * normal[2] + 0.7 * max(0.0, float(_LIGHT @ normal))
    red, green, blue = (min(255, round(part * light ** (1.0 / 2.2))) for part in palette.rgb(colour))
    return red, green, blue


def _draw_still(draw: ImageDraw.ImageDraw, camera: Camera, line: int, still: StillShape) -> None:
    """Draw the faces that look at the camera, through which one sees what is behind, and all lines."""
    look = STILL_LOOKS[still.role]
    shade = (*palette.rgb(look.colour), round(255 * look.shade))
    for normal, face in zip(still.normals, still.faces, strict=True):
        if normal @ (camera.place - face[0]) > 0.0:
            _fill(draw, camera.seen(face), shade)
    for points in still.lines:
        for ends in pairwise(points):
            _stroke(draw, camera.seen(np.array(ends)), palette.rgb(look.colour), line)


def _hull_of(shape: SolidShape, corners: NDArray[np.float64], turn: NDArray[np.float64]) -> DrawnHull:
    firsts = corners[[face[0] for face in shape.solid.faces]]
    return DrawnHull(corners, shape.solid.normals @ turn.T, firsts)


def _apart(hull: DrawnHull, others: NDArray[np.float64], eye: NDArray[np.float64]) -> tuple[float, bool]:
    """Return how far others lie beyond the plane of the face that parts them best, and if the eye does."""
    offsets = np.einsum("fi,fi->f", hull.normals, hull.on_faces)
    gaps = (others @ hull.normals.T).min(axis=0) - offsets
    best = int(np.argmax(gaps))
    return float(gaps[best]), bool(hull.normals[best] @ eye > offsets[best])


Outline: TypeAlias = list[tuple[float, float]]
"""Corners in a picture, right and down [pixels]."""

VIEWS = {"free": (-1.02, 0.33), "side": (-0.5 * math.pi, 0.06)}
"""Directions from which a scene is seen, as in report/canvas/camera.js: azimuth and height [rad]."""

_TANGENT = math.tan(math.radians(14.0))  # of half the angle of the picture's height
_MARGIN = 1.13
_NEAREST = 0.2  # nothing nearer than this is seen, in the distance of the nearest point


class Camera:
    """A camera that sees all of some points.

    Parameters
    ----------
    points : ndarray, shape (k, 3)
        The points [m].
    width, height : int
        Size of the picture [pixels].
    direction : tuple of float
        Azimuth from x towards y, and height above the floor, of where it stands [rad].
    """

    def __init__(
        self, points: NDArray[np.float64], width: int, height: int, direction: tuple[float, float]
    ) -> None:
        self._half = 0.5 * np.array([width, height])
        azimuth, height_angle = direction
        c, s, level = math.cos(azimuth), math.sin(azimuth), math.cos(height_angle)
        back = np.array([c * level, s * level, math.sin(height_angle)])
        right = np.array([-s, c, 0.0])
        self._axes = np.array([right, np.cross(back, right), back])
        # The planes through the points that bound the picture meet in the eye: see `orbit` of camera.js.
        along = points @ self._axes.T
        tangents = _TANGENT * np.array([width / height, 1.0])
        above = (along[:, :2] + tangents * along[:, 2:]).max(axis=0)
        below = (-along[:, :2] + tangents * along[:, 2:]).max(axis=0)
        nearest = along[:, 2].max()
        far = _MARGIN * (((above + below) / (2.0 * tangents)).max() - nearest)
        self._place = np.array([*(above - below) / 2.0, nearest + far])
        self._nearest = _NEAREST * far
        self._focus = self._half[1] / _TANGENT

    def moved(self, way: NDArray[np.float64]) -> Camera:
        """Return the camera moved, shape (3,) [m]."""
        other = copy(self)
        other._place = self._place + self._axes @ way
        return other

    @property
    def place(self) -> NDArray[np.float64]:
        """Where it stands, shape (3,) [m]."""
        return self._place @ self._axes

    def seen(self, points: NDArray[np.float64]) -> Outline:
        """Return where the corners of a convex polygon or the ends of a line lie in the picture [pixels].

        Right and down; what is behind the camera, or nearly so, is cut off.
        """
        return self.outlines(points, [range(len(points))])[0]

    def outlines(self, points: NDArray[np.float64], parts: Sequence[Sequence[int]]) -> list[Outline]:
        """Return the same of several polygons or lines, whose corners are given by their numbers."""
        apart = points @ self._axes.T - self._place
        inside = -apart[:, 2] - self._nearest
        behind = inside < 0.0
        hidden = set(np.flatnonzero(behind).tolist())
        places = self._projected(np.where(behind[:, np.newaxis], [0.0, 0.0, -1.0], apart))
        return [
            [places[corner] for corner in part]
            if hidden.isdisjoint(part)
            else self._projected(cut(apart[list(part)], inside[list(part)]))
            for part in parts
        ]

    def _projected(self, apart: NDArray[np.float64]) -> Outline:
        """Return where points in front of the camera lie in the picture, from places along its axes."""
        across, up, back = apart.T
        scale = self._focus / -back
        right, down = self._half[0] + scale * across, self._half[1] - scale * up
        return list(zip(right.tolist(), down.tolist(), strict=True))
