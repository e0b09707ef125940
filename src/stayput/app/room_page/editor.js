// The editor of the room's plan: palette, plan, what is selected, and what a verdict says on the plan.

import { el, fill, part, settled } from "../dom.js";
import { worded } from "../refusals.js";
import { t } from "../words.js";
import { clashSentence } from "./clashes.js";
import { isEmpty } from "./edits.js";
import { drawHandles } from "./handles.js";
import * as inspector from "./inspector.js";
import * as keys from "./keys.js";
import { learn } from "./kinds.js";
import { LAYERS } from "./layers.js";
import * as palette from "./palette.js";
import * as pointer from "./pointer.js";
import { canRedo, canUndo, current, selected, watch } from "./room.js";
import { draw, markRefused, plan, showLayer, showResult, shownRoom, whenDrawn } from "./view.js";

let refusal = null;

/** Wires the editor; afterwards the room may be taken. Called once. */
export function wire(presets) {
  learn(presets);
  palette.wire(part("palette"));
  pointer.wire();
  keys.wire();
  whenDrawn(drawHandles);
  whenDrawn(tellProblems);
  watch(() => {
    draw();
    inspector.update();
    updateTools();
  });
  const { undone: undo, redone: redo, turn, remove, emptied: empty } = keys;
  for (const [name, press] of Object.entries({ undo, redo, turn, remove, empty }))
    part(`plan-${name}`).addEventListener("click", () => press());
  for (const name of LAYERS)
    part(`layer-${name}`).addEventListener("change", ({ target }) => showLayer(name, target.checked));
  new ResizeObserver(settled(30, draw)).observe(plan().parentElement);
  addEventListener("resize", settled(30, draw));
  build();
}

/** Writes what depends on the language; called again for another one. */
export function build() {
  palette.build(part("palette"));
  inspector.buildInto(part("inspector"));
  updateTools();
  draw();
}

function updateTools() {
  part("plan-undo").disabled = !canUndo();
  part("plan-redo").disabled = !canRedo();
  part("plan-turn").disabled = part("plan-remove").disabled = !selected();
  part("plan-empty").disabled = !current() || isEmpty(current());
}

/** Shows a verdict on the plan, or takes it away (null); one that is "old" is of a room that has changed since. */
export function tellResult(result, { old = false } = {}) {
  part("plan").classList.toggle("old", old);
  showResult(result);
  part("plan-layers").hidden = part("plan-legend").hidden = result === null;
}

/** Says what the server refuses about the room, at the thing that it is about; null: nothing any more. */
export function tellRefusal(error) {
  const [, table, index] = /(furniture|places|doors|windows)\[(\d+)\]/.exec(error?.field ?? "") ?? [];
  const thing = table && current()[table]?.[index] ? { table, index: Number(index) } : null;
  refusal = error && { words: worded(error), thing };
  markRefused(thing);
}

/** The sentences about what is wrong: what is seen here, else the server's where one came. */
function tellProblems(found) {
  const lines = found.map((one) => [clashSentence(shownRoom(), one)]);
  if (shownRoom().furniture.length === 0) lines.push([t("noFurniture")]);
  const servers = refusal && found.length === lines.length && found.every(({ depth }) => depth === undefined);
  if (servers) lines.push(refusal.words);
  // what is about no thing of the plan is said in the verdict alone where that stands beside the plan
  part("plan-problems").classList.toggle("general", Boolean(servers && !refusal.thing));
  fill(part("plan-problems"), ...lines.map((words) => el("p", { class: "refusal" }, ...words)));
  plan().classList.toggle("wrong", lines.length > 0);
}
