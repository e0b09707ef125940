// Where things are on the plan: x from the left wall to the right one, y from the near wall to the far one.

import { DEFAULTS, openingValues, pieceSizes, placeValues } from "./kinds.js";

/** Directions that a piece faces with its back to a wall [rad]; as in the server's floor plan. */
export const FACING = {
  left_wall: 0,
  near_side_wall: Math.PI / 2,
  right_wall: Math.PI,
  far_side_wall: -Math.PI / 2,
};
export const WALLS = Object.keys(FACING);

/** The wall behind something of a heading, if it is right behind it. */
export const wallBehind = (heading) => WALLS.find((wall) => Math.abs(tidyAngle(FACING[wall] - heading)) < 1e-3);

/** The next wall, counter-clockwise, or one farther on. */
export function nextWall(wall, steps = 1) {
  const round = ["near_side_wall", "right_wall", "far_side_wall", "left_wall"];
  return round[(round.indexOf(wall) + steps) % 4];
}

/** Whether a wall goes along y. */
export const upright = (wall) => wall === "left_wall" || wall === "right_wall";

/** How long a wall is [m]. */
export const wallLength = (plan, wall) => (upright(wall) ? plan.length : plan.width);

/** The point so far along a wall and so far from it into the room. */
export function onWall(plan, wall, along, into = 0) {
  if (wall === "left_wall") return [into, along];
  if (wall === "right_wall") return [plan.width - into, along];
  return [along, wall === "near_side_wall" ? into : plan.length - into];
}

/** How far a point is along a wall, and into the room from it. */
export function fromWall(plan, wall, [x, y]) {
  if (wall === "left_wall") return [y, x];
  if (wall === "right_wall") return [y, plan.width - x];
  return [x, wall === "near_side_wall" ? y : plan.length - y];
}

/** A point of a frame that stands at `at` and is turned by `heading`. */
export const inFrame = ([x, y], heading, [u, v]) => [
  x + u * Math.cos(heading) - v * Math.sin(heading),
  y + u * Math.sin(heading) + v * Math.cos(heading),
];

/** The same point seen from that frame. */
export const ofFrame = ([x, y], heading, [px, py]) => inFrame([0, 0], -heading, [px - x, py - y]);

/** An angle from -π to π, without the noise of turning. */
export const tidyAngle = (angle) => {
  const turned = Math.atan2(Math.sin(angle), Math.cos(angle)),
    quarter = (Math.round((2 * turned) / Math.PI) * Math.PI) / 2;
  return Math.abs(turned - quarter) < 1e-6 ? quarter : turned;
};

export function rectangle(at, width, length, heading) {
  const [u, v] = [width / 2, length / 2];
  return [
    [-u, -v],
    [u, -v],
    [u, v],
    [-u, v],
  ].map((corner) => inFrame(at, heading, corner));
}

const CORNERS = 24;

function circle(at, across) {
  const angles = Array.from({ length: CORNERS }, (_, i) => (2 * Math.PI * i) / CORNERS);
  return angles.map((angle) => inFrame(at, angle, [across / 2, 0]));
}

/** The smallest upright rectangle around points: least x and y, greatest x and y. */
export function extents(points) {
  const xs = points.map(([x]) => x),
    ys = points.map(([, y]) => y);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** Where a piece stands: its middle, what it faces, the height of its base, its sizes and outline. */
export function standing(room, index) {
  const piece = room.furniture[index],
    sizes = pieceSizes(piece);
  let at = (piece.at ?? DEFAULTS.furniture.at).slice(0, 2),
    up = piece.at?.[2] ?? 0,
    heading = piece.heading ?? DEFAULTS.furniture.heading;
  if (piece.against) {
    heading = FACING[piece.against];
    at = onWall(
      room.plan,
      piece.against,
      piece.along,
      (piece.gap ?? DEFAULTS.furniture.gap) + sizes.width / 2,
    );
  }
  const below = carrier(room, index);
  if (below !== null) {
    const under = standing(room, below);
    at = [at[0] + under.at[0], at[1] + under.at[1]];
    up = under.up + under.height;
  }
  const outline = sizes.round ? circle(at, sizes.width) : rectangle(at, sizes.width, sizes.length, heading);
  return { at, heading, up, ...sizes, outline };
}

/** The number of the piece on which a piece stands, or null. */
export function carrier(room, index) {
  const below = room.furniture.slice(0, index).findIndex((one) => one.name === room.furniture[index].on);
  return below < 0 ? null : below;
}

/** Where a person's place is, with all its values and outline. */
export function lying(room, index) {
  const place = room.places[index],
    values = placeValues(place),
    heading = place.heading ?? DEFAULTS.places.heading;
  return {
    at: place.at,
    heading,
    ...values,
    outline: rectangle(place.at, values.width, values.length, heading),
  };
}

/** Where an opening is, with all its values; its outline is the wall's face. */
export function opening(room, { table, index }) {
  const values = openingValues(table, room[table][index]);
  const ends = [values.start, values.start + values.width];
  return { ...values, outline: ends.map((along) => onWall(room.plan, values.wall, along)) };
}

/** What stands somewhere, whatever table it is of. */
export function thing(room, what) {
  if (what.table === "furniture") return standing(room, what.index);
  return what.table === "places" ? lying(room, what.index) : opening(room, what);
}

/** All things of a room of some tables. */
export const things = (room, tables) =>
  tables.flatMap((table) => (room[table] ?? []).map((_, index) => ({ table, index })));

/** The same without one of them. */
export const others = (room, tables, { table, index }) =>
  things(room, tables).filter((one) => one.table !== table || one.index !== index);

/** Whether something is a door or a window. */
export const isOpening = ({ table }) => table === "doors" || table === "windows";

/** The middle of something so that it is within the room as far as it fits. */
export function within(plan, at, outline) {
  const [x0, y0, x1, y1] = extents(outline);
  const shift = (low, high, side) =>
    high - low >= side ? side / 2 - (low + high) / 2 : Math.max(0, -low) - Math.max(0, high - side);
  return [at[0] + shift(x0, x1, plan.width), at[1] + shift(y0, y1, plan.length)];
}
