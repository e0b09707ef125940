// "Set the scene": what holds the piece; several measures at once.

import { toggle } from "./controls.js";
import { el, fill, part } from "./dom.js";
import { measureField } from "./measure_fields.js";
import { change, current } from "./scene.js";
import { both, t } from "./words.js";

let rows = {},
  kinds = [],
  installed = null;

/** The kinds of measures, as the server has them. */
export const measureOf = (type) => kinds.find((one) => one.type === type);

/** Builds the panel; called again for another language. */
export function build(presets) {
  kinds = presets.measures;
  installed = toggle({
    label: t("installed"),
    hint: t("installedHint"),
    changed: (installed) => change({ installed }),
  });
  const open = part("measures").querySelector("details.more")?.open ?? false;
  rows = Object.fromEntries(kinds.map((one) => [one.type, row(one)]));
  const of = (usual) => kinds.filter((one) => one.usual === usual).map((one) => rows[one.type].element);
  fill(
    part("measures"),
    of(true),
    el("details", { class: "more", open }, el("summary", { text: t("moreMeasures") }), ...of(false)),
    installed.element,
  );
  update();
}

function row(kind) {
  const box = toggle({ label: both(kind.label), hint: both(kind.about), changed: (on) => set(kind, on) });
  const settings = el("details", { class: "settings" }, el("summary", { text: t("adjust") }));
  settings.addEventListener("toggle", () => {
    if (settings.open && settings.children.length === 1)
      settings.append(...kind.parameters.map((one) => field(kind, one)).filter(Boolean));
  });
  const why = el("p", { class: "hint why", hidden: true });
  return {
    element: el("div", { class: "measure" }, box.element, why, kind.parameters.length ? settings : null),
    box,
    settings,
    why,
  };
}

/** Puts a measure in place or takes it away; what was in the same place goes. */
function set(kind, on) {
  const measures = { ...current().measures };
  delete measures[kind.type];
  if (on) {
    for (const type of Object.keys(measures))
      if (kind.place && measureOf(type)?.place === kind.place) delete measures[type];
    measures[kind.type] = {};
  }
  change({ measures });
}

function give(kind, name, value) {
  const measures = current().measures;
  change({ measures: { ...measures, [kind.type]: { ...measures[kind.type], [name]: value } } });
}

const field = (kind, about) =>
  measureField(about, current().measures[kind.type]?.[about.name], (value) => give(kind, about.name, value));

/** What a kind of measure needs and the scene has not: "wall", "ceiling", or nothing. */
function lacking(kind, scene) {
  const has = { wall: scene.wall, ceiling: scene.ceiling > scene.height };
  return (kind?.needs ?? []).find((need) => !has[need]);
}

/** The measures that are chosen and left out, each with what it lacks: {label, lacks}. */
export const leftOut = (scene) =>
  Object.keys(scene.measures)
    .map((type) => ({ label: both(measureOf(type)?.label), lacks: lacking(measureOf(type), scene) }))
    .filter(({ lacks }) => lacks);

/** The measures of a scene that can be put there, as the server reads them. */
export const inPlace = (scene) =>
  Object.entries(scene.measures)
    .filter(([type]) => !lacking(measureOf(type), scene))
    .map(([type, value]) => ({ type, ...value }));

/** Puts the scene's values into the switches; what cannot be put there says why. */
export function update() {
  const scene = current();
  installed.set(scene.installed);
  for (const kind of kinds) {
    const { box, settings, why } = rows[kind.type],
      on = kind.type in scene.measures;
    const lacks = lacking(kind, scene);
    box.set(on);
    box.input.disabled = Boolean(lacks) && !on;
    settings.hidden = !on;
    why.hidden = !lacks;
    if (lacks) why.textContent = [on ? t("isLeftOut") : "", t(`needs_${lacks}`)].filter(Boolean).join(t("space"));
  }
}
