// Where something comes to stand that is dragged near a wall, a corner, or in line with something else.

import { atWall, cm, inWall, placed } from "./edits.js";
import { WALLS, carrier, extents, fromWall, isOpening, opening, others, standing } from "./geometry.js";
import { thing, upright, wallBehind, wallLength } from "./geometry.js";
import { DEFAULTS } from "./kinds.js";

const TO_WALL = 0.15, // how near a piece comes to a wall until it stands against it [m]
  TO_EDGE = 0.06; // how near to an edge of something else until it is in line [m]
const QUARTER = Math.PI / 2;

/**
 * Something dragged so that its middle would be at a point: {room, guides}; guides are lines across the plan, {x} or
 * {y}. Where it is "free" nothing draws it.
 */
export function dragged(room, what, point, free = false) {
  const to = point.map(cm);
  if (isOpening(what)) return draggedOpening(room, what, to, free);
  const { heading } = thing(room, what);
  if (what.table === "furniture" && carrier(room, what.index) === null && !free) {
    const wall = nearWall(room, what, to);
    if (wall) return alongWall(room, what, wall, to);
  }
  const next = placed(room, what, to, heading);
  return free ? { room: next, guides: [] } : inLine(next, what);
}

/** A piece against the wall that its back comes near to; of two at a corner the one behind it. */
function nearWall(room, what, point) {
  const { width, heading } = standing(room, what.index),
    { against, gap = DEFAULTS.furniture.gap } = room.furniture[what.index];
  const reach = (wall) => fromWall(room.plan, wall, point)[1] - width / 2 - gap,
    faces = (wall) => (wall === against || wall === wallBehind(heading) ? TO_WALL : 0);
  const near = WALLS.filter((wall) => reach(wall) < TO_WALL);
  return near.sort((one, other) => reach(one) - faces(one) - (reach(other) - faces(other)))[0] ?? null;
}

/** Moves something against the wall behind it where it is near enough; used after it was turned. */
export function backToWall(room, what) {
  if (what.table !== "furniture" || carrier(room, what.index) !== null) return room;
  const { at, heading, width } = standing(room, what.index);
  const wall = wallBehind(heading);
  if (!wall || fromWall(room.plan, wall, at)[1] - width / 2 >= TO_WALL) return room;
  return atWall(room, what, wall, fromWall(room.plan, wall, at)[0]);
}

function alongWall(room, what, wall, point) {
  const along = fromWall(room.plan, wall, point)[0],
    { length } = standing(room, what.index);
  const found = best([along - length / 2, along + length / 2], edges(room, what, upright(wall) ? 1 : 0));
  const next = atWall(room, what, wall, found ? along + found.by : along);
  return { room: next, guides: found ? [upright(wall) ? { y: found.line } : { x: found.line }] : [] };
}

function inLine(room, what) {
  const one = thing(room, what),
    [x0, y0, x1, y1] = extents(one.outline),
    straight = Math.abs(one.heading / QUARTER - Math.round(one.heading / QUARTER)) < 1e-6;
  if (!straight) return { room, guides: [] };
  const x = best([x0, x1], edges(room, what, 0)),
    y = best([y0, y1], edges(room, what, 1));
  const next = placed(room, what, [one.at[0] + (x?.by ?? 0), one.at[1] + (y?.by ?? 0)], one.heading);
  const guides = [...(x ? [{ x: x.line }] : []), ...(y ? [{ y: y.line }] : [])];
  return { room: next, guides };
}

/** Lines across the plan at walls and at the edges of everything else, along x (axis 0) or y (1). */
function edges(room, what, axis) {
  const own = what.table === "furniture" ? room.furniture[what.index].name : null;
  const ends = others(room, ["furniture", "places"], what)
    .filter((one) => own === null || room[one.table][one.index].on !== own)
    .flatMap((one) => {
      const box = extents(thing(room, one).outline);
      return [box[axis], box[axis + 2]];
    });
  return [0, axis ? room.plan.length : room.plan.width, ...ends];
}

/** The line nearest to one of the sides, and by how much they are apart; null where none is near. */
function best(sides, lines) {
  const pairs = sides.flatMap((side) => lines.map((line) => ({ line, by: line - side })));
  return pairs.reduce(
    (found, pair) => (Math.abs(pair.by) < Math.abs(found?.by ?? TO_EDGE) ? pair : found),
    null,
  );
}

function draggedOpening(room, what, point, free) {
  const one = opening(room, what),
    far = (wall) => Math.abs(fromWall(room.plan, wall, point)[1]) - (wall === one.wall ? TO_WALL : 0);
  const wall = [...WALLS].sort((a, b) => far(a) - far(b))[0],
    side = wallLength(room.plan, wall),
    start = fromWall(room.plan, wall, point)[0] - one.width / 2;
  const beside = others(room, ["doors", "windows"], what)
    .map((other) => opening(room, other))
    .filter((other) => other.wall === wall);
  const lines = [0, side, ...beside.flatMap((other) => [other.start, other.start + other.width])],
    ends = [start, start + one.width];
  const found = free ? null : (best(ends, lines) ?? best([start + one.width / 2], [side / 2]));
  const next = inWall(room, what, wall, found ? start + found.by : start);
  return { room: next, guides: found ? [upright(wall) ? { y: found.line } : { x: found.line }] : [] };
}
