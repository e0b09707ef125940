// "Set the scene": what holds the piece; several measures at once.

import { toggle } from "./controls.js";
import { fill, part } from "./dom.js";
import { measureList, measureRow, replaces } from "./measure_fields.js";
import { change, current } from "./scene.js";
import { both, t } from "./words.js";

let rows = [],
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
  rows = kinds.map((kind) =>
    measureRow(kind, {
      hint: both(kind.about),
      values: () => current().measures[kind.type],
      set: (on) => set(kind, on),
      give: (name, value) => give(kind, name, value),
    }),
  );
  fill(part("measures"), measureList(rows, open), installed.element);
  update();
}

/** Puts a measure in place or takes it away; what was in the same place goes. */
function set(kind, on) {
  const measures = { ...current().measures };
  delete measures[kind.type];
  if (on) {
    for (const type of Object.keys(measures))
      if (replaces(kind, measureOf(type))) delete measures[type];
    measures[kind.type] = {};
  }
  change({ measures });
}

function give(kind, name, value) {
  const measures = current().measures;
  change({ measures: { ...measures, [kind.type]: { ...measures[kind.type], [name]: value } } });
}

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
  for (const { kind, update: put } of rows) {
    const on = kind.type in scene.measures,
      lacks = lacking(kind, scene);
    put(on, lacks && [on ? t("isLeftOut") : "", t(`needs_${lacks}`)].filter(Boolean).join(t("space")));
  }
}
