// Fields of the scene, which the pages of one piece and of a room share: each changes what it is called by.

import { choice, slider } from "./controls.js";
import { change, numberOf, wordsOf } from "./scene.js";
import { both, choiceLabel, number, t } from "./words.js";

/** A slider of a number of the scene; "also" is what else it is made with. Whole numbers go in steps of one. */
export const numberField = (presets, key, { whole = false, ...also }) =>
  slider({
    label: t(key),
    ...numberOf(presets, key),
    changed: (value) => change({ [key]: whole ? Math.round(value) : value }),
    ...(whole && { step: 1 }),
    ...also,
  });

/** A choice of one of several things for the scene. */
export const choiceField = (key, options, changed = (id) => change({ [key]: id })) =>
  choice({ label: t(key), options, changed });

/** What the server names as options of a choice. */
export const named = (list) => list.map(({ id, label }) => ({ id, label: both(label) }));

/** A choice of one of the words that the server has for something. */
export const wordField = (presets, key) =>
  choiceField(
    key,
    wordsOf(presets, key).map((id) => ({ id, label: choiceLabel(id) })),
  );

/** The fields of floor, walls and ceiling: {floor, wallConstruction, ceiling, ceilingConstruction}. */
export const surfaceFields = (presets) => ({
  floor: choiceField(
    "floor",
    presets.surfaces.map((one) => ({ id: one.id, label: `${both(one.label)} (μ ${number(one.static_friction, 2)})` })),
  ),
  wallConstruction: wordField(presets, "wallConstruction"),
  ceiling: numberField(presets, "ceiling", { step: 0.05 }),
  ceilingConstruction: wordField(presets, "ceilingConstruction"),
});
