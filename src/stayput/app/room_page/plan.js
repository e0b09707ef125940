// The plan of a room, to scale and with y upwards: for the editor, and as a small picture that is only looked at.

import { svg } from "../dom.js";
import { length, spoken, t } from "../words.js";
import { described } from "./described.js";
import { extents, onWall, thing, things } from "./geometry.js";
import { DEFAULTS, TABLES, nameOf } from "./kinds.js";
import { nameTexts } from "./labels.js";
import { LAYERS, inOrderOf, notes, shareOf, telling, zones } from "./layers.js";
import { doorShapes, feltAt, inWall, pieceShapes, placeShapes, windowShapes } from "./shapes.js";
import { WALL, path, sheetFor } from "./sheet.js";

const HIGH = 460; // of a picture where nothing else is said [px]
const groups = new WeakMap(); // of the pictures that were drawn: their groups, which stay so that one keeps the focus

/**
 * Draws a room into an <svg> and returns its sheet with where names stand on it.
 *
 * result: a verdict as the server sends it, or null; shown: which of its layers; selected: {table, index} or null;
 * readOnly: a picture that is only looked at; bare: without scale and names of walls; clashing: keys of things that
 * stand wrong; guides: lines across the plan, {x} or {y} [m]; wide and high: its largest size [px], unless a scale is
 * given [px/m].
 */
export function drawPlan(element, room, options = {}) {
  const { shown = LAYERS, selected = null, readOnly = false, bare = false } = options,
    result = inOrderOf(room, options.result);
  const { clashing = new Set(), guides = [], wide = element.clientWidth || HIGH, high = HIGH } = options;
  const sheet = sheetFor(room, wide, high, { bare, scale: options.scale }),
    all = things(room, TABLES);
  frame(element, sheet, room, readOnly, all);
  const layer = layersOf(element);
  layer.ground.replaceChildren(...ground(sheet));
  layer.zones.replaceChildren(...zones(sheet, result, shown).filter(Boolean));
  for (const table of TABLES) {
    const own = all.filter((what) => what.table === table);
    matched(layer[table], own.length).forEach((group, index) => {
      const what = { table, index };
      group.replaceChildren(
        ...[
          readOnly ? svg("title", { text: described(room, what) }) : null,
          ...shapes(sheet, room, what, result?.pieces[index]?.stability),
          mark(sheet, room, what, result, shown),
        ].filter(Boolean),
      );
      const chosen = selected?.table === table && selected.index === index;
      group.setAttribute(
        "class",
        ["thing", chosen && "chosen", clashing.has(keyOf(what)) && "wrong"].filter(Boolean).join(" "),
      );
      if (!readOnly) operable(group, room, what, chosen);
    });
  }
  layer.felt.replaceChildren(
    ...(readOnly ? [] : all)
      .filter((what) => thing(room, what).wall)
      .map((what) => svg("path", { "data-felt": keyOf(what), d: feltAt(sheet, thing(room, what)) })),
  );
  const boxes = new Map(all.map((what) => [keyOf(what), boxOf(sheet, room, what)]));
  const named = all.filter(({ table }) => table !== "windows");
  const labels = named.map((what) => ({
    name: nameOf(room, what),
    notes: notes(result, shown, what),
    box: boxes.get(keyOf(what)),
  }));
  const solid = named.filter(({ table }) => table !== "doors").map((what) => boxes.get(keyOf(what)));
  const { texts, spots } = nameTexts(labels, solid, sheet.floor);
  layer.names.replaceChildren(...texts, ...(bare ? [] : scale(sheet)));
  layer.guides.replaceChildren(...guides.map((one) => guide(sheet, one)));
  return { ...sheet, names: spots };
}

/** A thing's name within a picture. */
export const keyOf = ({ table, index }) => `${table}-${index}`;

/** The thing of such a name. */
export function ofKey(key) {
  const [table, index] = key.split("-");
  return { table, index: Number(index) };
}

function frame(element, sheet, room, readOnly, all) {
  const [wide, high] = sheet.size;
  element.classList.add("plan-room");
  element.setAttribute("viewBox", `0 0 ${wide.toFixed(1)} ${high.toFixed(1)}`);
  element.setAttribute("role", readOnly ? "img" : "application");
  const { width, length: deep } = room.plan,
    content = all.map((what) => nameOf(room, what)).join(t("listed"));
  const sides = { width: length(width), length: length(deep) };
  element.setAttribute("aria-label", readOnly ? t("planAlt", { ...sides, content }) : t("planEdited", sides));
}

const ORDER = ["ground", "felt", "places", "zones", "furniture", "windows", "doors", "names", "guides", "handles"];

/** The groups of a picture, from the lowest to the topmost; those of things stay from drawing to drawing. */
export function layersOf(element) {
  if (!groups.has(element)) {
    const made = Object.fromEntries(ORDER.map((name) => [name, svg("g", { class: `layer-${name}` })]));
    for (const name of ["ground", "felt", "zones", "names", "guides"]) made[name].setAttribute("aria-hidden", "true");
    element.replaceChildren(...Object.values(made));
    groups.set(element, made);
  }
  return groups.get(element);
}

/** So many groups within one, of which those that are there already stay. */
function matched(layer, count) {
  while (layer.children.length > count) layer.lastChild.remove();
  while (layer.children.length < count) layer.append(svg("g"));
  return [...layer.children];
}

function operable(group, room, what, chosen) {
  const about = { "data-thing": keyOf(what), tabindex: 0, role: "button", "aria-pressed": String(chosen) };
  for (const [name, value] of Object.entries({ ...about, "aria-label": described(room, what) }))
    group.setAttribute(name, value);
}

function ground(sheet) {
  const [x0, y0, x1, y1] = sheet.floor;
  const box = (far, name) =>
    svg("rect", { class: name, x: x0 - far, y: y0 - far, width: x1 - x0 + 2 * far, height: y1 - y0 + 2 * far });
  return [box(WALL, "walls"), box(0, "ground")];
}

/** What a thing looks like; a piece by how firmly it stands. */
export function shapes(sheet, room, what, stands = "unknown") {
  const one = thing(room, what);
  if (what.table === "furniture") return pieceShapes(sheet, one, stands);
  if (what.table === "places")
    return placeShapes(sheet, one, room.places[what.index].kind ?? DEFAULTS.places.kind);
  return what.table === "doors" ? doorShapes(sheet, one) : windowShapes(sheet, one);
}

/** A line around a place whose person is hit, thicker the more often; a bar across a door that stays blocked. */
function mark(sheet, room, what, result, shown) {
  const chance = shareOf(result, shown, what);
  if (!telling(chance)) return null;
  const one = thing(room, what);
  if (what.table === "places")
    return svg("path", {
      class: "hit",
      d: path(one.outline.map(sheet.place)),
      "stroke-width": (2 + 6 * chance.estimate).toFixed(1),
    });
  return inWall(sheet, "blocked", one.wall, [one.start, one.start + one.width], 0.5);
}

function boxOf(sheet, room, what) {
  const one = thing(room, what);
  const before = (into) =>
    [one.start, one.start + one.width].map((along) => onWall(room.plan, one.wall, along, into));
  const outline = one.wall ? [...before(0), ...before(one.width)] : one.outline;
  return extents(outline.map(sheet.place));
}

const TICKS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50];

/** Metres along the near and the left wall, and the names of all walls. */
function scale(sheet) {
  const { plan } = sheet,
    [x0, y0, x1, y1] = sheet.floor,
    [wide, high] = sheet.size,
    every = TICKS.find((one) => one * sheet.scale > 48) ?? 100;
  const low = y1 + WALL + sheet.beyond("near_side_wall"),
    left = x0 - WALL - sheet.beyond("left_wall");
  const ticks = (side) => Array.from({ length: Math.floor(side / every + 1e-9) + 1 }, (_, i) => i * every);
  const told = (value) => `${Number(value.toFixed(2)).toLocaleString(spoken())}\u00a0m`;
  const axis = (d) => svg("path", { class: "axis", d });
  const text = (x, y, words, anchor = "middle", turn = null) =>
    svg("text", { x, y, "text-anchor": anchor, text: words, transform: turn });
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  const side = (x, wall) => text(0, 0, t(wall), "middle", `translate(${x} ${middle[1]}) rotate(-90)`);
  return [
    ...ticks(plan.width).flatMap((value) => {
      const [x] = sheet.place([value, 0]);
      return [axis(`M${x} ${low}v5`), text(x, low + 18, told(value))];
    }),
    ...ticks(plan.length).flatMap((value) => {
      const [, y] = sheet.place([0, value]);
      return [axis(`M${left} ${y}h-5`), text(left - 8, y + 4, told(value), "end")];
    }),
    side(12, "left_wall"),
    side(wide - 8, "right_wall"),
    text(middle[0], high - 6, t("near_side_wall")),
    text(middle[0], 14, t("far_side_wall")),
  ];
}

function guide(sheet, { x, y }) {
  const [x0, y0, x1, y1] = sheet.floor;
  const [px, py] = sheet.place([x ?? 0, y ?? 0]);
  return svg("path", { class: "guide", d: x === undefined ? `M${x0} ${py}H${x1}` : `M${px} ${y0}V${y1}` });
}
