// Where something new goes that is not dragged: a free spot along a wall, or else on the floor.

import { atWall, inWall, newThing, placed, withNew } from "./edits.js";
import { beyondWalls, depthOf, inTheWay, sweep } from "./clashes.js";
import { FACING, WALLS, isOpening, onWall, opening, others, standing, thing, things, wallLength } from "./geometry.js";

const STEP = 0.1, // between the spots that are tried [m]
  APART = 0.5; // so far from others a spot is as good as one that is farther [m]

/** The room with a new thing of a kind at a free spot, and which it is. */
export function added(room, table, kind) {
  const [next, what] = withNew(room, table, newThing(room, table, kind));
  if (isOpening(what)) return [freelyOpening(next, what), what];
  let first = null;
  for (const one of table === "furniture" ? piece(next, what) : onFloor(next, what)) {
    if (fits(one, what)) return [one, what];
    first ??= one;
  }
  return [first ?? next, what];
}

const steps = (side, size) => {
  const room = Math.max(0, side - size),
    count = Math.max(1, Math.ceil(room / STEP));
  return Array.from({ length: count + 1 }, (_, i) => size / 2 + (room * i) / count);
};

function* piece(room, what) {
  const { length } = standing(room, what.index);
  for (const wall of emptiestFirst(room)) {
    const spots = steps(wallLength(room.plan, wall), length).map((along) => atWall(room, what, wall, along)),
      free = spots.filter((one) => fits(one, what)).map((one) => [one, Math.min(APART, clearance(one, what))]);
    yield* free.sort(([, one], [, other]) => other - one).map(([one]) => one);
  }
  yield atWall(room, what, WALLS[0], 0);
  yield* onFloor(room, what);
}

/** The walls, those first of which pieces take the least share. */
function emptiestFirst(room) {
  const taken = (wall) => {
    const at = room.furniture.flatMap((one, i) => (one.against === wall ? standing(room, i).length : []));
    return at.reduce((sum, one) => sum + one, 0) / wallLength(room.plan, wall);
  };
  return [...WALLS].sort((one, other) => taken(one) - taken(other));
}

/** How far something is from what is nearest to it: pieces, places, the floor that doors need [m]. */
function clearance(room, what) {
  const { outline } = thing(room, what),
    apart = others(room, ["furniture", "places", "doors"], what),
    taken = apart.map((one) => (one.table === "doors" ? before(room, one) : thing(room, one).outline));
  return Math.min(...taken.map((one) => -depthOf(outline, one)));
}

/** Everywhere on the floor, the walls first. */
function* onFloor(room, what) {
  const { plan } = room,
    { width, length } = thing(room, what);
  for (const heading of [0, FACING.near_side_wall]) {
    const [across, deep] = heading ? [length, width] : [width, length];
    const spots = steps(plan.width, across).flatMap((x) => steps(plan.length, deep).map((y) => [x, y]));
    const inside = ([x, y]) =>
      Math.min(x - across / 2, plan.width - x - across / 2, y - deep / 2, plan.length - y - deep / 2);
    for (const at of spots.sort((one, other) => inside(one) - inside(other)))
      yield placed(room, what, at, heading);
  }
}

/** With an opening where the floor before it is free; else where at least its swing is; else anywhere. */
function freelyOpening(room, what) {
  const { width } = opening(room, what);
  const spots = ["far_side_wall", "right_wall", "near_side_wall", "left_wall"].flatMap((wall) =>
    steps(wallLength(room.plan, wall), width).map((along) => inWall(room, what, wall, along - width / 2)),
  );
  const apart = spots.filter((one) => besideOthers(one, what));
  const free = (floor) => apart.find((one) => !inTheWay(one, floor(one, what)).length);
  return free(before) ?? (what.table === "doors" ? free(sweep) : null) ?? apart[0] ?? spots[0];
}

/** Whether nothing is in its way: neither things, nor the floor that doors need, nor windows behind what is high. */
function fits(room, what) {
  const { outline, low = 0, high = null, up = 0, height = 0 } = thing(room, what);
  if (beyondWalls(room.plan, outline) > 1e-6) return false;
  const standing = others(room, ["places", "furniture"], what);
  if (standing.some((one) => depthOf(outline, thing(room, one).outline) > 1e-6)) return false;
  const top = high ?? up + height;
  return things(room, ["doors", "windows"]).every((one) => {
    const { sill } = opening(room, one);
    return (sill !== undefined && top <= sill && low >= 0) || depthOf(outline, before(room, one)) <= 1e-6;
  });
}

/** The floor before an opening: as deep as a door is wide, or a step before a window. */
function before(room, what) {
  const { wall, start, width, sill } = opening(room, what),
    deep = sill === undefined ? width : 0.3;
  const [a, b] = [onWall(room.plan, wall, start), onWall(room.plan, wall, start + width)];
  const [c, d] = [onWall(room.plan, wall, start + width, deep), onWall(room.plan, wall, start, deep)];
  return [a, b, c, d];
}

/** Whether no other opening is where an opening is. */
function besideOthers(room, what) {
  const one = opening(room, what);
  return others(room, ["doors", "windows"], what)
    .map((other) => opening(room, other))
    .every(
      (other) =>
        other.wall !== one.wall ||
        other.start + other.width <= one.start + 1e-6 ||
        other.start >= one.start + one.width - 1e-6,
    );
}
