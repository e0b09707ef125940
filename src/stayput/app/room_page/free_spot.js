// Where something new goes that is not dragged: a free spot along a wall, or else on the floor.

import { atWall, inWall, newThing, placed, withNew } from "./edits.js";
import { clashes, depthOf } from "./clashes.js";
import { FACING, WALLS, onWall, opening, standing, thing, things, wallLength } from "./geometry.js";

const STEP = 0.1; // between the spots that are tried [m]

/** The room with a new thing of a kind at a free spot, and which it is. */
export function added(room, table, kind) {
  const [next, what] = withNew(room, table, newThing(room, table, kind));
  const tried =
    table === "furniture" ? piece(next, what) : table === "places" ? place(next, what) : openings(next, what);
  let first = null;
  for (const one of tried) {
    first ??= one;
    if (fits(one, what)) return [one, what];
  }
  return [first ?? next, what];
}

const steps = (side, size) => {
  const room = Math.max(0, side - size),
    count = Math.max(1, Math.ceil(room / STEP));
  return Array.from({ length: count + 1 }, (_, i) => size / 2 + (room * i) / count);
};

function* piece(room, what) {
  const { width, length } = standing(room, what.index);
  for (const wall of WALLS)
    for (const along of steps(wallLength(room.plan, wall), length)) yield atWall(room, what, wall, along);
  yield* onFloor(room, what, width, length);
}

function* place(room, what) {
  const { width, length } = thing(room, what);
  yield* onFloor(room, what, width, length);
}

/** Everywhere on the floor, the walls first. */
function* onFloor(room, what, width, length) {
  const { plan } = room;
  for (const heading of [0, FACING.near_side_wall]) {
    const [across, deep] = heading ? [length, width] : [width, length];
    const spots = steps(plan.width, across).flatMap((x) => steps(plan.length, deep).map((y) => [x, y]));
    const inside = ([x, y]) =>
      Math.min(x - across / 2, plan.width - x - across / 2, y - deep / 2, plan.length - y - deep / 2);
    for (const at of spots.sort((one, other) => inside(one) - inside(other)))
      yield placed(room, what, at, heading);
  }
}

function* openings(room, what) {
  const { width } = opening(room, what);
  for (const wall of ["far_side_wall", "right_wall", "near_side_wall", "left_wall"])
    for (const along of steps(wallLength(room.plan, wall), width))
      yield inWall(room, what, wall, along - width / 2);
}

/** Whether nothing is in its way: neither things, nor the floor that doors need, nor windows behind what is high. */
function fits(room, what) {
  if (what.table === "doors" || what.table === "windows") return opensFreely(room, what);
  if (clashes(room).some((one) => same(one.what, what) || (one.other && same(one.other, what)))) return false;
  const { outline, low = 0, high = null, up = 0, height = 0 } = thing(room, what);
  const others = things(room, ["places", "furniture"]).filter((one) => !same(one, what));
  if (others.some((one) => depthOf(outline, thing(room, one).outline) > 1e-6)) return false;
  const top = high ?? up + height;
  return things(room, ["doors", "windows"]).every((one) => {
    const { sill } = opening(room, one);
    return (sill !== undefined && top <= sill && low >= 0) || depthOf(outline, before(room, one)) <= 1e-6;
  });
}

const same = (one, other) => one.table === other.table && one.index === other.index;

/** The floor before an opening: as deep as a door is wide, or a step before a window. */
function before(room, what) {
  const { wall, start, width, sill } = opening(room, what),
    deep = sill === undefined ? width : 0.3;
  const [a, b] = [onWall(room.plan, wall, start), onWall(room.plan, wall, start + width)];
  const [c, d] = [onWall(room.plan, wall, start + width, deep), onWall(room.plan, wall, start, deep)];
  return [a, b, c, d];
}

function opensFreely(room, what) {
  const one = opening(room, what);
  const apart = things(room, ["doors", "windows"])
    .filter((other) => !same(other, what))
    .map((other) => opening(room, other))
    .every(
      (other) =>
        other.wall !== one.wall ||
        other.start + other.width <= one.start + 1e-6 ||
        other.start >= one.start + one.width - 1e-6,
    );
  const floor = before(room, what);
  return (
    apart &&
    things(room, ["furniture"]).every((other) => depthOf(floor, standing(room, other.index).outline) <= 1e-6)
  );
}
