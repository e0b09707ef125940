// The plan that is edited: what it shows now, which may be a room that is only tried while something is dragged.

import { part } from "../dom.js";
import { clashes, obstructed } from "./clashes.js";
import { LAYERS } from "./layers.js";
import { drawPlan, keyOf, layersOf } from "./plan.js";
import { current, selected } from "./room.js";

const HIGHEST = 760, // of the plan [px]
  LOWEST = 280,
  AROUND = 250; // what stands above and below it

const element = part("plan");
let sheet = null,
  tried = null,
  guides = [],
  origin = [0, 0], // of the tried room in the one that is held [m]
  held = null,
  verdict = null,
  refused = null,
  layers = [...LAYERS];
const listeners = [];

export const plan = () => element;
export const sheetNow = () => sheet;

/** The room that is shown. */
export const shownRoom = () => tried ?? current();

/** Calls a function after each drawing with the clashes of the room that is shown. */
export const whenDrawn = (listener) => listeners.push(listener);

/** Shows a room that is only tried, with lines across the plan, and its origin where that is another [m]. */
export function show(room, lines = [], from = [0, 0]) {
  tried = room;
  guides = lines;
  origin = from;
  draw();
}

/** Shows the room again as it is. */
export function showCurrent() {
  tried = null;
  guides = [];
  draw();
}

/** Shows a verdict on the room, or none. */
export function showResult(result) {
  verdict = result;
  draw();
}

/** Marks what the server refuses, by {table, index}, or nothing. */
export function markRefused(what) {
  refused = what;
  draw();
}

/** Draws a layer of verdicts, or leaves it out. */
export function showLayer(name, on) {
  layers = LAYERS.filter((one) => (one === name ? on : layers.includes(one)));
  draw();
}

/** Draws the plan. */
export function draw() {
  const room = shownRoom();
  if (!room) return;
  const found = [...clashes(room), ...obstructed(room)],
    wrong = found.flatMap((one) => [one.what, one.other]).filter(Boolean);
  if (refused) wrong.push(refused);
  sheet = drawPlan(element, room, {
    result: tried ? null : verdict,
    shown: layers,
    selected: selected(),
    clashing: new Set(wrong.map(keyOf)),
    guides,
    scale: held?.sheet.scale,
    wide: element.parentElement.clientWidth,
    high: Math.max(LOWEST, Math.min(HIGHEST, innerHeight - AROUND)),
  });
  if (held) keepInPlace();
  else element.style.maxWidth = `${sheet.size[0]}px`;
  for (const listener of listeners) listener(found);
}

/** Puts what the held room has in common with the tried one where it was on the screen. */
function keepInPlace() {
  const before = held.sheet.place([0, 0]),
    now = sheet.place(origin.map((value) => -value));
  element.setAttribute("viewBox", [now[0] - before[0], now[1] - before[1], ...held.sheet.size].join(" "));
}

/** Keeps the scale, and what the pointer points at, as they are now, although the room gets other sides. */
export function hold() {
  held = { sheet, toSheet: element.getScreenCTM().inverse() };
  element.classList.add("held");
}

/** Lets the plan fit its place again. */
export function release() {
  held = null;
  element.classList.remove("held");
}

/** Where an event of the pointer is in the plan [m]. */
export function pointOf(event) {
  const { sheet: on, toSheet } = held ?? { sheet, toSheet: element.getScreenCTM().inverse() };
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(toSheet);
  return on.ofPlace([x, y]);
}

/** The element of a thing, which has the keyboard's focus. */
const elementOf = (what) => layersOf(element)[what.table].children[what.index];

/** Puts the keyboard's focus on a thing. */
export const focusOn = (what) => elementOf(what)?.focus({ preventScroll: true });

/** Says something to readers of screens. */
export function say(text) {
  part("editor-said").textContent = text;
}
