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
import {
  draw,
  drawInto,
  layersShown,
  markRefused,
  plan,
  resultShown,
  showLayer,
  showResult,
  shownRoom,
  whenDrawn,
} from "./view.js";

let refusal = null;

/** Builds the editor into an element; afterwards the room may be taken. Called once. */
export function build(element, presets) {
  learn(presets);
  const svgElement = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svgElement.setAttribute("id", "plan");
  svgElement.setAttribute("tabindex", "-1");
  svgElement.setAttribute("aria-describedby", "plan-keys");
  fill(
    element,
    el(
      "div",
      { class: "editor" },
      el("div", { id: "palette", class: "palette" }),
      el(
        "div",
        { class: "drawing" },
        el("div", { class: "sheet" }, svgElement),
        el("div", { id: "plan-tools", class: "row" }),
        el("div", { id: "plan-problems", role: "status" }),
        el("div", { id: "plan-layers", class: "row" }),
      ),
      el("aside", { id: "inspector", class: "inspector" }),
      el(
        "div",
        { class: "help" },
        el("p", { id: "plan-legend", class: "hint" }),
        el("details", {}, el("summary", { id: "plan-help" }), el("p", { id: "plan-keys", class: "hint" })),
      ),
    ),
    el("p", { id: "editor-said", class: "said", role: "status" }),
  );
  drawInto(svgElement);
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
  new ResizeObserver(settled(30, draw)).observe(svgElement.parentElement);
  addEventListener("resize", settled(30, draw));
  translate();
}

/** Puts the words of the language into the editor, and draws it; called again for another language. */
export function translate() {
  palette.build(part("palette"));
  part("inspector").setAttribute("aria-label", t("inspector"));
  part("plan-help").textContent = t("planHelp");
  part("plan-keys").textContent = t("planKeys");
  fill(
    part("plan-tools"),
    tool("undo", keys.undone, "Control+Z"),
    tool("redo", keys.redone, "Control+Y"),
    tool("turn", () => keys.turn()),
    tool("remove", () => keys.remove()),
    tool("empty", keys.emptied),
  );
  fill(part("plan-layers"), ...LAYERS.map(layerSwitch));
  part("plan-legend").textContent = t("layersHint");
  inspector.buildInto(part("inspector"));
  updateTools();
  draw();
  tellLayers();
}

const tool = (key, press, shortcut = null) =>
  el("button", {
    type: "button",
    id: `plan-${key}`,
    text: t(`${key}It`),
    "aria-keyshortcuts": shortcut,
    onclick: press,
  });

function updateTools() {
  part("plan-undo").disabled = !canUndo();
  part("plan-redo").disabled = !canRedo();
  part("plan-turn").disabled = part("plan-remove").disabled = !selected();
  part("plan-empty").disabled = !current() || isEmpty(current());
}

function layerSwitch(name) {
  const box = el("input", {
    type: "checkbox",
    id: `layer-${name}`,
    checked: layersShown().includes(name),
    onchange: () => showLayer(name, box.checked),
  });
  return el("span", { class: "layer" }, box, el("label", { for: `layer-${name}`, text: t(`layer_${name}`) }));
}

/** Shows a verdict on the plan, or takes it away (null); one that is "old" is of a room that has changed since. */
export function tellResult(result, { old = false } = {}) {
  part("plan").classList.toggle("old", old);
  showResult(result);
  tellLayers();
}

function tellLayers() {
  part("plan-layers").hidden = part("plan-legend").hidden = resultShown() === null;
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
