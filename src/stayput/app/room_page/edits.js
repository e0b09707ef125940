// What can be done to a room: each function returns the next room and leaves the one it was given as it is.

import { WALLS, carrier, extents, fromWall, inFrame, isOpening, ofFrame, opening, standing } from "./geometry.js";
import { thing, tidyAngle, upright, wallLength, within } from "./geometry.js";
import { DEFAULTS, freeName, limitsOf } from "./kinds.js";

/** To whole centimetres [m]. */
export const cm = (metres) => Math.round(metres * 100) / 100;
const SMALLEST = 0.05; // to what a side can be pulled [m]
const fine = (metres) => Math.round(metres * 1e6) / 1e6;
const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

/** The same room with other values of one thing; a value of undefined leaves its table. */
export function given(room, { table, index }, values) {
  const next = Object.fromEntries(
    Object.entries({ ...room[table][index], ...values }).filter(([, value]) => value !== undefined),
  );
  return { ...room, [table]: room[table].map((one, i) => (i === index ? next : one)) };
}

/** A piece or a place with its middle at a point, turned; within the room, and away from the wall it stood against. */
export function placed(room, what, at, heading) {
  if (what.table === "furniture" && carrier(room, what.index) !== null)
    return placedOn(room, what, at, heading);
  const free = { against: undefined, along: undefined, gap: undefined };
  const next = given(room, what, { at, heading, ...(what.table === "furniture" ? free : {}) });
  const inside = within(room.plan, at, thing(next, what).outline);
  const old = room[what.table][what.index].at?.slice(2) ?? []; // its height above the floor stays
  return given(next, what, { at: [...inside.map(fine), ...old] });
}

function placedOn(room, what, at, heading) {
  const below = standing(room, carrier(room, what.index)),
    [x0, y0, x1, y1] = extents(below.outline);
  const on = [clamp(at[0], x0, x1) - below.at[0], clamp(at[1], y0, y1) - below.at[1]];
  return given(room, what, { at: on.map(fine), heading });
}

/** A piece with its back to a wall. */
export function atWall(room, what, wall, along) {
  const { length } = standing(room, what.index),
    side = wallLength(room.plan, wall);
  return given(room, what, {
    at: undefined,
    heading: undefined,
    against: wall,
    along: fine(length >= side ? side / 2 : clamp(along, length / 2, side - length / 2)),
    gap: room.furniture[what.index].gap ?? DEFAULTS.furniture.gap,
  });
}

/** An opening in a wall that begins somewhere along it, within the wall. */
export function inWall(room, what, wall, start) {
  const { width } = opening(room, what),
    side = wallLength(room.plan, wall);
  return given(room, what, {
    wall,
    start: fine(clamp(start, 0, Math.max(0, side - width))),
    width: fine(Math.min(width, side)),
  });
}

/** Something turned to a heading about its middle; a piece then stands free. */
export const turned = (room, what, heading) => placed(room, what, thing(room, what).at, tidyAngle(heading));

/** A piece as a box of its sizes, which may then be others. */
function asBox(room, what, sizes) {
  const { width, length, height, mass } = standing(room, what.index);
  return given(room, what, { preset: undefined, width, length, height, mass, ...sizes });
}

/** A piece or a place with other sizes, its middle where it was or, at a wall, its back. */
export function sized(room, what, sizes) {
  const next = what.table === "furniture" ? asBox(room, what, sizes) : given(room, what, sizes);
  return settled(next, what);
}

/** A side of a piece or a place pulled to a point, the other side staying; sides are [1, 0] for the front, … */
export function pulled(room, what, [u, v], point) {
  const { at, heading, width, length } = thing(room, what),
    key = u ? "width" : "length",
    old = u ? width : length,
    sign = u + v,
    reach = ofFrame(at, heading, point)[u ? 0 : 1] * sign + old / 2,
    [low, high] = limitsOf(`${what.table}.${key}`),
    size = cm(clamp(reach, Math.max(low, SMALLEST), high)),
    middle = inFrame(at, heading, [(u * (size - old)) / 2, (v * (size - old)) / 2]);
  const next =
    what.table === "furniture" ? asBox(room, what, { [key]: size }) : given(room, what, { [key]: size });
  const { against } = next[what.table][what.index];
  if (against) return atWall(next, what, against, fromWall(room.plan, against, middle)[0]);
  return placed(next, what, middle, heading);
}

/** An end of an opening pulled along its wall: "start" or "end". */
export function pulledEnd(room, what, end, along) {
  const { wall, start, width } = opening(room, what),
    [least, most] = limitsOf(`${what.table}.width`),
    side = wallLength(room.plan, wall);
  if (end === "end")
    return given(room, what, { width: cm(clamp(along - start, least, Math.min(most, side - start))) });
  const from = cm(clamp(along, Math.max(0, start + width - most), start + width - least));
  return given(room, what, { start: from, width: fine(start + width - from) });
}

/** The room with other sides; everything is moved as far as it must be. */
export function withSides(room, width, length) {
  let next = { ...room, plan: { ...room.plan, width, length } };
  for (const table of ["furniture", "places", "doors", "windows"])
    (next[table] ?? []).forEach((_, index) => {
      next = settled(next, { table, index });
    });
  return next;
}

/**
 * The room with other sides whose left or near wall has been moved, by which its origin goes to another point of the
 * old one [m]; what stands in it stays, except what has its back to that wall or is in it.
 */
export function withOrigin(room, [x, y], width, length) {
  const along = (wall) => (upright(wall) ? y : x);
  const free = (one) => (one.at && !room.furniture.some(({ name }) => name === one.on)
    ? { ...one, at: [fine(one.at[0] - x), fine(one.at[1] - y), ...one.at.slice(2)] }
    : one);
  const back = (one) => (one.against ? { ...one, along: fine(one.along - along(one.against)) } : free(one));
  const all = (one) => (one.was?.place ? { ...back(one), was: { ...one.was, place: back(one.was.place) } } : back(one));
  const opened = (one) => ({ ...one, start: fine(one.start - along(one.wall)) });
  const next = { ...room, furniture: room.furniture.map(all) };
  if (room.places) next.places = room.places.map(all);
  for (const table of ["doors", "windows"]) if (room[table]) next[table] = room[table].map(opened);
  return withSides(next, width, length);
}

/** Something put within the room where it is not. */
function settled(room, what) {
  const { wall, start, at, heading } = thing(room, what),
    { against, along } = room[what.table][what.index];
  if (wall) return inWall(room, what, wall, start);
  return against ? atWall(room, what, against, along) : placed(room, what, at, heading);
}

/** The room without something; what stood on a piece then stands on the floor. */
export function removed(room, { table, index }) {
  let next = room;
  if (table === "furniture") {
    const { name } = room.furniture[index];
    room.furniture.forEach((one, i) => {
      if (one.on === name)
        next = given(next, { table, index: i }, { on: undefined, at: standing(room, i).at });
    });
    if (room.joints)
      next = { ...next, joints: room.joints.filter((one) => ![one.first, one.second].includes(name)) };
  }
  return { ...next, [table]: next[table].filter((_, i) => i !== index) };
}

/** The room with nothing in it and without doors and windows. */
export function emptied(room) {
  const next = { ...room, furniture: [], places: [], doors: [], windows: [] };
  delete next.joints;
  return next;
}

/** Whether nothing is in a room, nor in its walls. */
export const isEmpty = (room) =>
  ["furniture", "places", "doors", "windows"].every((table) => !room[table]?.length);

/** A piece, a place or a door called otherwise. */
export function renamed(room, what, name) {
  const old = room[what.table][what.index].name;
  const next = given(room, what, { name });
  if (what.table !== "furniture") return next;
  const other = (one) => (one === old ? name : one);
  const furniture = next.furniture.map((one) => (one.on === old ? { ...one, on: name } : one));
  const joints = next.joints?.map((one) => ({ ...one, first: other(one.first), second: other(one.second) }));
  return { ...next, furniture, ...(joints ? { joints } : {}) };
}

/** The room with another thing at the end of a table, and which it is. */
export const withNew = (room, table, made) => [
  { ...room, [table]: [...(room[table] ?? []), made] },
  { table, index: room[table]?.length ?? 0 },
];

/** The table of a new thing of a kind, not yet at its place. */
export function newThing(room, table, kind) {
  const name = freeName(room, table, kind);
  const middle = { at: [room.plan.width / 2, room.plan.length / 2], heading: 0 };
  if (table === "furniture") return { name, preset: kind, ...middle };
  if (table === "places") return { name, kind, ...middle };
  const wall = WALLS[2],
    width = Math.min(DEFAULTS[table].width, room.plan.width);
  return { ...DEFAULTS[table], ...(table === "doors" ? { name } : {}), wall, start: 0, width };
}

/** Another of the same, a little beside it, and which it is. */
export function doubled(room, what) {
  const { table, index } = what,
    old = room[table][index],
    { was, ...copy } = structuredClone(old); // what is tried with the first is not tried with this one
  if (table !== "windows")
    copy.name = freeName(room, table, old.preset ?? old.kind ?? old.name ?? DEFAULTS[table].name);
  const [next, made] = withNew(room, table, copy);
  if (isOpening(what)) {
    const { wall, start, width } = opening(next, made),
      after = start + 2 * width <= wallLength(room.plan, wall);
    return [inWall(next, made, wall, after ? start + width : start - width), made];
  }
  const one = thing(next, made),
    beside = inFrame(one.at, one.heading, [0, one.length]);
  if (old.against) {
    const [along] = fromWall(room.plan, old.against, beside),
      fits = along + one.length / 2 <= wallLength(room.plan, old.against);
    return [atWall(next, made, old.against, fits ? along : old.along - one.length), made];
  }
  return [placed(next, made, beside, one.heading), made];
}
