// The sheet that a plan is drawn on: metres of the room to pixels, y upwards.

import { openingValues } from "./kinds.js";
import { fromWall, onWall } from "./geometry.js";

/** Thickness of a wall [px]. */
export const WALL = 8;

const MARGIN = { left_wall: 70, right_wall: 30, near_side_wall: 50, far_side_wall: 30 }, // names and the scale [px]
  BARE = 14; // beyond each wall, without them

/**
 * A sheet for a room that is at most so wide and high [px], unless its scale is given [px/m]; a bare one has neither
 * metres nor names of walls.
 */
export function sheetFor(room, wide, high, { bare = false, scale: given = null } = {}) {
  const { plan } = room,
    beyond = Object.fromEntries(Object.keys(MARGIN).map((wall) => [wall, swing(room, wall)])),
    margin = bare ? Object.fromEntries(Object.keys(MARGIN).map((wall) => [wall, BARE])) : MARGIN;
  const across = beyond.left_wall + plan.width + beyond.right_wall,
    deep = beyond.near_side_wall + plan.length + beyond.far_side_wall;
  const fitting = Math.max(
    10,
    Math.min(
      (wide - margin.left_wall - margin.right_wall) / across,
      (high - margin.near_side_wall - margin.far_side_wall) / deep,
    ),
  );
  const scale = given ?? fitting;
  const space = (wall) => margin[wall] + scale * beyond[wall],
    left = space("left_wall"),
    top = space("far_side_wall");
  const place = ([x, y]) => [left + scale * x, top + scale * (plan.length - y)];
  return {
    plan,
    scale,
    bare,
    beyond: (wall) => scale * beyond[wall],
    size: [
      left + scale * plan.width + space("right_wall"),
      top + scale * plan.length + space("near_side_wall"),
    ],
    floor: [left, top, left + scale * plan.width, top + scale * plan.length],
    place,
    ofPlace: ([px, py]) => [(px - left) / scale, plan.length - (py - top) / scale],
    atWall: (wall, along, into = 0) => place(onWall(plan, wall, along, into)),
    fromWall: (wall, point) => fromWall(plan, wall, point),
  };
}

/** How far doors swing outwards beyond a wall [m]. */
const swing = (room, wall) =>
  Math.max(
    0,
    ...(room.doors ?? [])
      .map((one) => openingValues("doors", one))
      .filter((one) => one.wall === wall && one.opens === "outwards")
      .map((one) => one.width),
  );

const px = (value) => value.toFixed(1);

/** The path through points [px], closed or not. */
export const path = (points, closed = true) =>
  `M${points.map(([x, y]) => `${px(x)} ${px(y)}`).join("L")}${closed ? "Z" : ""}`;
