// The keyboard on the plan: arrows, R, D, Delete, Enter, Escape; and, anywhere on the page, undo and redo.

import { part } from "../dom.js";
import { described, where } from "./described.js";
import { atWall, doubled, emptied as cleared, inWall, placed, removed, turned } from "./edits.js";
import { carrier, fromWall, isOpening, nextWall, onWall, opening, thing, upright, wallBehind } from "./geometry.js";
import { DEFAULTS, nameOf } from "./kinds.js";
import { ofKey } from "./plan.js";
import { change, current, redo, select, selected, undo } from "./room.js";
import { backToWall } from "./snap.js";
import { t } from "../words.js";
import { focusOn, plan, say } from "./view.js";

const STEP = 0.05,
  FINE = 0.01;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Wires the plan, and undo and redo of the whole page. */
export function wire() {
  plan().addEventListener("keydown", pressed);
  part("inspector").addEventListener("keydown", backToPlan);
  plan().addEventListener("focusin", (event) => {
    const what = focused(event.target);
    if (what) select(what);
  });
  document.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !["z", "y"].includes(key)) return;
    if (event.target.matches("input:is([type=text], [type=number]), textarea")) return; // it has its own
    event.preventDefault();
    if (key === "y" || event.shiftKey) redone();
    else undone();
  });
}

/** Takes the last change back, and says so. */
export function undone() {
  undo();
  say(t("undone"));
}

export function redone() {
  redo();
  say(t("redone"));
}

function focused(element) {
  const key = element.closest("[data-thing]")?.dataset.thing;
  return key ? ofKey(key) : null;
}

function pressed(event) {
  const what = focused(event.target);
  if (!what || event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.toLowerCase();
  if (event.key in ARROWS) nudge(what, ARROWS[event.key], event.shiftKey ? FINE : STEP);
  else if (key === "r") turn(what);
  else if (key === "d") double(what);
  else if (key === "delete" || key === "backspace") remove(what);
  else if (key === "escape") select(null);
  else if (key === " ") select(what);
  else if (key === "enter") toNumbers(what);
  else return;
  event.preventDefault();
}

/** Goes to the numbers of a thing, past the others that stand between on the way with the tabulator. */
function toNumbers(what) {
  select(what);
  part("inspector").querySelector("input, select").focus();
}

/** From the numbers back to the thing on the plan. */
function backToPlan({ key, target }) {
  if (key === "Escape" && selected() && !target.matches("select")) focusOn(selected());
}

function nudge(what, direction, step) {
  const room = current(),
    by = direction.map((one) => one * step),
    next = nudged(room, what, by);
  change(next, { mergeKey: `nudge ${what.table} ${what.index}` });
  say(where(next, what).join(t("comma")));
}

/** A thing moved by so much; along its wall where it stands against one. */
function nudged(room, what, [dx, dy]) {
  if (isOpening(what)) {
    const { wall, start } = opening(room, what),
      along = upright(wall) ? dy : dx;
    if (along) return inWall(room, what, wall, start + along);
    return inWall(room, what, acrossTo(wall, [dx, dy]) ? nextWall(wall, 2) : wall, start);
  }
  const { at, heading, width } = thing(room, what),
    to = [at[0] + dx, at[1] + dy];
  if (what.table === "places" || carrier(room, what.index) !== null) return placed(room, what, to, heading);
  const { against, gap = DEFAULTS.furniture.gap } = room.furniture[what.index];
  const wall = against ?? wallBehind(heading);
  if (wall) {
    const [along, into] = fromWall(room.plan, wall, to);
    if (into <= width / 2 + gap + 1e-9) return atWall(room, what, wall, along);
  }
  return placed(room, what, to, heading);
}

/** Whether a direction leads from a wall into the room. */
function acrossTo(wall, [dx, dy]) {
  const [x, y] = onWall({ width: 0, length: 0 }, wall, 0, 1);
  return x * dx + y * dy > 0;
}

/** Turns something by a quarter; an opening goes to the next wall. */
export function turn(what = selected()) {
  const room = current(),
    { wall, start, heading } = thing(room, what);
  const next = wall
    ? inWall(room, what, nextWall(wall), start)
    : backToWall(turned(room, what, heading + Math.PI / 2), what);
  change(next);
  say(described(next, what));
}

/** Makes another of the same and selects it. */
export function double(what = selected()) {
  const [next, made] = doubled(current(), what);
  change(next);
  select(made);
  focusOn(made);
  say(t("added", { what: described(next, made) }));
}

/** Removes something; then nothing is selected, so that the next press removes nothing unseen. */
export function remove(what = selected()) {
  const name = nameOf(current(), what);
  change(removed(current(), what));
  leave(t("removed", { name }));
}

/** Takes everything out of the room: one entry for undo. */
export function emptied() {
  change(cleared(current()));
  leave(t("emptied"));
}

function leave(said) {
  select(null);
  plan().focus({ preventScroll: true });
  say(said);
}
