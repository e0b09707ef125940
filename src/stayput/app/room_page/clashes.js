// What stands in something else: pieces in walls, in each other, and where a person is. The server refuses these.

import { carrier, extents, lying, standing, things } from "./geometry.js";
import { nameOf } from "./kinds.js";
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

/** Each thing that stands where it cannot: {what, other, depth}; other is null for a wall. */
export function clashes(room) {
  const found = [],
    bodies = things(room, ["furniture"]).map((what) => {
      const one = standing(room, what.index);
      return { what, outline: one.outline, low: one.up, high: one.up + one.height };
    }),
    people = things(room, ["places"]).map((what) => ({ what, ...lying(room, what.index) }));
  bodies.forEach((one, number) => {
    const [x0, y0, x1, y1] = extents(one.outline),
      out = Math.max(-x0, -y0, x1 - room.plan.width, y1 - room.plan.length);
    if (out > DEEPEST) found.push({ what: one.what, other: null, depth: out });
    for (const other of [...bodies.slice(0, number), ...people]) {
      if (other.what.table === "furniture" && carrier(room, number) === other.what.index) continue;
      const high = Math.min(one.high - other.low, other.high - one.low),
        depth = Math.min(high, depthOf(one.outline, other.outline));
      if (depth > DEEPEST) found.push({ what: one.what, other: other.what, depth });
    }
  });
  for (const one of people) {
    const [x0, y0, x1, y1] = extents(one.outline),
      out = Math.max(-x0, -y0, x1 - room.plan.width, y1 - room.plan.length);
    if (out > DEEPEST) found.push({ what: one.what, other: null, depth: out });
  }
  return found;
}

/** A clash as a sentence. */
export function clashSentence(room, { what, other, depth }) {
  const name = nameOf(room, what);
  if (!other) return t("inWall", { name, depth: length(depth) });
  return t("inOther", { name, other: nameOf(room, other), depth: length(depth) });
}
