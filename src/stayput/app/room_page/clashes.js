// What stands in something else: pieces in walls, in each other, and where a person is; doors that open against them.

import { carrier, extents, lying, onWall, opening, standing, thing, things } from "./geometry.js";
import { nameOf } from "./kinds.js";
import { swing } from "./shapes.js";
import { length, t } from "../words.js";

const DEEPEST = 1e-6; // by rounding [m]

/** How deep two convex outlines are in each other [m]; 0 or less: they are apart. */
export function depthOf(first, second) {
  let least = Infinity;
  for (const outline of [first, second])
    outline.forEach(([x, y], i) => {
      const [x2, y2] = outline[(i + 1) % outline.length],
        side = Math.hypot(x2 - x, y2 - y);
      const across = ([px, py]) => (px * (y2 - y) - py * (x2 - x)) / side;
      const [a, b] = [first.map(across), second.map(across)];
      least = Math.min(least, Math.max(...a) - Math.min(...b), Math.max(...b) - Math.min(...a));
    });
  return least;
}

/** How far an outline reaches beyond the walls [m]; 0 or less: it does not. */
export function beyondWalls(plan, outline) {
  const [x0, y0, x1, y1] = extents(outline);
  return Math.max(-x0, -y0, x1 - plan.width, y1 - plan.length);
}

/** The floor over which a door swings, as an outline. */
export function sweep(room, what) {
  const { at, edge } = swing({ atWall: (...spot) => onWall(room.plan, ...spot) }, opening(room, what));
  return [at, ...edge];
}

/** The pieces and places that are on a part of the floor. */
export const inTheWay = (room, floor) =>
  things(room, ["furniture", "places"]).filter((one) => depthOf(floor, thing(room, one).outline) > DEEPEST);

/** Each door that opens against something: {what, other}. The server takes these, and counts the doors as blocked. */
export const obstructed = (room) =>
  things(room, ["doors"])
    .filter((what) => opening(room, what).opens === "inwards")
    .flatMap((what) => inTheWay(room, sweep(room, what)).map((other) => ({ what, other })));

/** Each thing that stands where it cannot: {what, other, depth}; other is null for a wall. The server refuses these. */
export function clashes(room) {
  const found = [],
    bodies = things(room, ["furniture"]).map((what) => {
      const one = standing(room, what.index);
      return { what, outline: one.outline, low: one.up, high: one.up + one.height };
    }),
    people = things(room, ["places"]).map((what) => ({ what, ...lying(room, what.index) }));
  for (const { what, outline } of [...bodies, ...people]) {
    const depth = beyondWalls(room.plan, outline);
    if (depth > DEEPEST) found.push({ what, other: null, depth });
  }
  bodies.forEach((one, number) => {
    for (const other of [...bodies.slice(0, number), ...people]) {
      if (other.what.table === "furniture" && carrier(room, number) === other.what.index) continue;
      const high = Math.min(one.high - other.low, other.high - one.low),
        depth = Math.min(high, depthOf(one.outline, other.outline));
      if (depth > DEEPEST) found.push({ what: one.what, other: other.what, depth });
    }
  });
  return found;
}

/** A clash as a sentence. */
export function clashSentence(room, { what, other, depth }) {
  const name = nameOf(room, what);
  if (depth === undefined) return t("opensAgainst", { name, other: nameOf(room, other) });
  if (!other) return t("inWall", { name, depth: length(depth) });
  return t("inOther", { name, other: nameOf(room, other), depth: length(depth) });
}
