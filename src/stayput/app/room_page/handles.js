// Handles of what is selected: at its sides, one to turn it, at the ends of an opening; of the room where nothing is.

import { svg } from "../dom.js";
import { t } from "../words.js";
import { cm, pulled, pulledEnd, turned, withOrigin, withSides } from "./edits.js";
import { carrier, inFrame, isOpening, opening, thing, tidyAngle } from "./geometry.js";
import { limitsOf, pieceSizes } from "./kinds.js";
import { layersOf } from "./plan.js";
import { selected } from "./room.js";
import { backToWall } from "./snap.js";
import { plan, sheetNow, shownRoom } from "./view.js";

const OFF = 13, // a handle from its side [px]
  IN_WALL = 4, // one of the room from its floor
  ASIDE = 60, // the same from the middle of the wall
  TURN = [40, 58, 76], // the handle to turn with, from the same: as near as no name is there
  SEEN = 6,
  FELT = 15, // radius in which the pointer takes it [px]
  FELT_BY_FINGER = 20;
const SIDES = { front: [1, 0], back: [-1, 0], left: [0, 1], right: [0, -1] };
const STEP = Math.PI / 12,
  QUARTER = Math.PI / 2,
  TO_QUARTER = 0.14; // how near to a quarter of a turn until it is one [rad]

/**
 * The handles now: name, where [px], and what pulling it to a point of the plan makes of a room, whose origin may then
 * be another point of the plan.
 */
export function handles() {
  const room = shownRoom(),
    what = selected();
  if (!room) return [];
  if (!what) return roomHandles();
  return isOpening(what) ? endHandles(room, what) : sideHandles(room, what);
}

/** A handle in each wall; of the left and the near one it moves the origin too. */
function roomHandles() {
  const [x0, y0, x1, y1] = sheetNow().floor,
    [x, y] = [(x0 + x1) / 2 - ASIDE, (y0 + y1) / 2 - ASIDE],
    off = IN_WALL / sheetNow().scale;
  const side = (key, value) => {
    const [low, high] = limitsOf(`plan.${key}`);
    return cm(Math.max(low, Math.min(high, value)));
  };
  const far = (start, width, length) => ({ room: withSides(start, width, length) });
  const near = (start, width, length) => {
    const origin = [start.plan.width - width, start.plan.length - length];
    return { room: withOrigin(start, origin, width, length), origin };
  };
  const across = (made, width) => (start, [px]) => made(start, side("width", width(start.plan, px)), start.plan.length);
  const deep = (made, length) => (start, [, py]) => made(start, start.plan.width, side("length", length(start.plan, py)));
  return [
    { name: "room-width", at: [x1 + IN_WALL, y], pull: across(far, (_, px) => px - off) },
    { name: "room-length", at: [x, y0 - IN_WALL], pull: deep(far, (_, py) => py - off) },
    { name: "room-left", at: [x0 - IN_WALL, y], pull: across(near, ({ width }, px) => width - px - off) },
    { name: "room-near", at: [x, y1 + IN_WALL], pull: deep(near, ({ length }, py) => length - py - off) },
  ];
}

function endHandles(room, what) {
  const { wall, start, width } = opening(room, what),
    sheet = sheetNow();
  const off = OFF / sheet.scale;
  return [
    ["start", start - off],
    ["end", start + width + off],
  ].map(([end, along]) => ({
    name: end,
    at: sheet.atWall(wall, along),
    pull: (from, point) => {
      const [to] = sheet.fromWall(wall, point);
      return { room: pulledEnd(from, what, end, end === "start" ? to + off : to - off) };
    },
  }));
}

function sideHandles(room, what) {
  const one = thing(room, what),
    sheet = sheetNow(),
    table = room[what.table][what.index];
  const at = ([u, v], far) => {
    const off = far / sheet.scale;
    return sheet.place(inFrame(one.at, one.heading, [u * (one.width / 2 + off), v * (one.length / 2 + off)]));
  };
  const resizable = what.table === "places" || pieceSizes(table).box;
  const sides = Object.entries(SIDES)
    .filter(([name]) => resizable && !(name === "back" && table.against))
    .map(([name, side]) => ({
      name,
      at: at(side, OFF),
      pull: (from, point) => {
        const off = OFF / sheet.scale;
        const edge = inFrame(point, one.heading, [-side[0] * off, -side[1] * off]);
        return { room: pulled(from, what, side, edge) };
      },
    }));
  return [...sides, turnHandle(room, what, at)];
}

/** A handle to turn something with, at the first of its sides where it is on the sheet and on no name. */
function turnHandle(room, what, at) {
  const { names, size } = sheetNow(),
    [wide, high] = size;
  const seen = ([x, y]) => x > OFF && y > OFF && x < wide - OFF && y < high - OFF,
    onName = ([x, y]) => names.some(([x0, y0, x1, y1]) => x > x0 - OFF && x < x1 + OFF && y > y0 - OFF && y < y1 + OFF);
  const spots = TURN.flatMap((far) => Object.values(SIDES).map((side) => ({ side, spot: at(side, far) }))),
    onSheet = spots.filter(({ spot }) => seen(spot)),
    { side, spot } = onSheet.find((one) => !onName(one.spot)) ?? onSheet[0] ?? spots[0],
    offset = Math.atan2(side[1], side[0]);
  return {
    name: "turn",
    at: spot,
    pull: (from, [x, y], free) => {
      const middle = thing(from, what).at,
        angle = tidyAngle(Math.atan2(y - middle[1], x - middle[0]) - offset);
      const next = turned(from, what, free ? angle : stepped(angle));
      return { room: free || carrier(from, what.index) !== null ? next : backToWall(next, what) };
    },
  };
}

/** An angle at a quarter of a turn where it is near, else at the next 15°. */
function stepped(angle) {
  const quarter = QUARTER * Math.round(angle / QUARTER);
  return Math.abs(angle - quarter) < TO_QUARTER ? quarter : STEP * Math.round(angle / STEP);
}

/** Draws the handles, larger to the touch where a finger points. */
export function drawHandles() {
  const felt = matchMedia("(pointer: coarse)").matches ? FELT_BY_FINGER : FELT;
  layersOf(plan()).handles.replaceChildren(
    ...handles().map(({ name, at: [x, y] }) =>
      svg(
        "g",
        {
          class: `handle pull-${name}`,
          "data-handle": name,
          transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
        },
        svg("title", { text: t(name === "turn" ? "pullToTurn" : "pullToSize") }),
        svg("circle", { class: "felt", r: felt }),
        name === "turn"
          ? svg("path", { class: "seen", d: "M-6 -3A7 7 0 1 1 -5 5M-6 -3l-2 -5M-6 -3l5 -1" })
          : svg("circle", { class: "seen", r: SEEN }),
      ),
    ),
  );
  layersOf(plan()).handles.setAttribute("aria-hidden", "true");
}
