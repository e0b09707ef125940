// What each thing looks like on a plan, as in the reports: beds with their pillow, doors with their swing, ...

import { svg } from "../dom.js";
import { inFrame, rectangle } from "./geometry.js";
import { WALL, path } from "./sheet.js";

/** A path through points [px], or around them. */
export const drawn = (name, points, closed = false) => svg("path", { class: name, d: path(points, closed) });

const shape = (sheet, points, name, closed = true) => drawn(name, points.map(sheet.place), closed);

/** A piece: its outline and, at its front, a thick side; "stands": how firmly, where that is known. */
export function pieceShapes(sheet, one, stands) {
  const { at, heading, width, length, round } = one,
    inwards = 2 / sheet.scale,
    front = [-0.5, 0.5].map((side) => inFrame(at, heading, [width / 2 - inwards, side * length]));
  return [
    shape(sheet, one.outline, `standing ${stands}`),
    ...(round ? [] : [shape(sheet, front, "front", false)]),
  ];
}

/** A place, as what a person of its kind lies or sits on. */
export function placeShapes(sheet, one, kind) {
  const { width, length, at, heading, blocks } = one;
  const inside = (INSIDE[kind] ?? (() => []))(width, length).map(({ points, name }) =>
    drawn(name, points.map((point) => sheet.place(inFrame(at, heading, point))), name !== "fold"),
  );
  return [shape(sheet, one.outline, blocks ? "place" : "place flat"), ...inside];
}

const soft = (at, width, length) => ({ points: rectangle(at, width, length, 0), name: "soft" });
const fold = (...points) => ({ points, name: "fold" });

/** A pillow at the head, which is at −y, and the edge of the blanket. */
function bed(width, length) {
  const edge = -0.23 * length;
  return [
    soft([0, -0.38 * length], 0.62 * width, 0.14 * length),
    fold([-width / 2, edge], [width / 2, edge]),
  ];
}

function cot(width, length) {
  const bars = [-1, 1].flatMap((side) =>
    Array.from({ length: 7 }, (_, i) => length * (-0.4 + (0.8 * i) / 6)).map((y) =>
      fold([side * 0.5 * width, y], [side * 0.4 * width, y]),
    ),
  );
  return [soft([0, -0.36 * length], 0.5 * width, 0.14 * length), ...bars];
}

/** A chair with its back at −x. */
const desk = (width, length) => [
  soft([0.04 * width, 0], 0.6 * width, 0.62 * length),
  soft([-0.34 * width, 0], 0.12 * width, 0.7 * length),
];

/** A back at −x, and arms. */
const sofa = (width, length) => [
  soft([-0.39 * width, 0], 0.22 * width, length),
  ...[-1, 1].map((side) => soft([0.1 * width, side * 0.45 * length], 0.8 * width, 0.1 * length)),
];

function ball(width, length) {
  const radius = 0.12 * Math.min(width, length),
    angles = Array.from({ length: 24 }, (_, i) => (i * Math.PI) / 12);
  const points = angles.map((a) => [
    0.28 * width + radius * Math.cos(a),
    0.28 * length + radius * Math.sin(a),
  ]);
  return [{ points, name: "soft" }];
}

const INSIDE = { bed, futon: bed, cot, desk, sofa, "play area": ball };

/** A window: an opening with a pane in it. */
export function windowShapes(sheet, { wall, start, width }) {
  const panes = [0.1, 0.5, 0.9].map((part) => inWall(sheet, "pane", wall, [start, start + width], part));
  return [hole(sheet, wall, start, width), ...panes];
}

/** A line within a wall, between two distances along it, at so large a part of its thickness. */
export const inWall = (sheet, name, wall, ends, part) =>
  drawn(name, ends.map((along) => sheet.atWall(wall, along, (-part * WALL) / sheet.scale)));

const hole = (sheet, wall, start, width) =>
  drawn("ground", strip(sheet, wall, [start, start + width], [0, -WALL / sheet.scale]), true);

/** The corners of a part of a wall, from one distance along it and into the room to the other. */
const strip = (sheet, wall, [low, high], [near, far]) =>
  [[low, near], [high, near], [high, far], [low, far]].map((corner) => sheet.atWall(wall, ...corner));

/** A door: its leaf where it stands open, and the arc of its edge; two panels of a sliding one. */
export function doorShapes(sheet, door) {
  const { wall, start, width } = door;
  return [
    hole(sheet, wall, start, width),
    ...(door.opens === "sliding" ? panels(sheet, door) : leaf(sheet, door)),
  ];
}

function panels(sheet, { wall, start, width }) {
  const part = 0.55 * width;
  return [
    inWall(sheet, "leaf", wall, [start, start + part], 0.3),
    inWall(sheet, "leaf", wall, [start + width - part, start + width], 0.7),
  ];
}

const ARC = 24,
  FELT = 12; // how far beside an opening's wall, and beyond its ends, the pointer still takes it [px]

/** Where the pointer takes an opening: around its part of the wall, and where its door swings. */
export function feltAt(sheet, one) {
  const far = FELT / sheet.scale,
    middle = -WALL / 2 / sheet.scale,
    ends = [one.start - far, one.start + one.width + far],
    around = path(strip(sheet, one.wall, ends, [middle - far, middle + far]));
  if (!one.hinge || one.opens === "sliding") return around;
  const { at, edge } = swing(sheet, one);
  return around + path([at, ...edge]);
}

/** Where a door hangs, and the arc of its edge as it opens. */
export function swing(sheet, { wall, start, width, hinge, opens }) {
  const sign = opens === "outwards" ? -1 : 1;
  const edge = Array.from({ length: ARC + 1 }, (_, i) => (i * Math.PI) / 2 / ARC).map((angle) => {
    const reach = width * Math.cos(angle);
    return sheet.atWall(
      wall,
      start + (hinge === "start" ? reach : width - reach),
      sign * width * Math.sin(angle),
    );
  });
  return { at: sheet.atWall(wall, hinge === "start" ? start : start + width), edge };
}

function leaf(sheet, door) {
  const { at, edge } = swing(sheet, door);
  return [drawn("swing", edge), drawn("leaf", [at, edge.at(-1)])];
}
