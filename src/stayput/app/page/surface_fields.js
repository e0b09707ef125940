// Fields of what a room is made of, which the pages of one piece and of a room share.

import { choice, slider } from "./controls.js";
import { change, numberOf, wordsOf } from "./scene.js";
import { both, choiceLabel, number, t } from "./words.js";

/** A choice of what a surface is made of, from those that the server has. */
const construction = (presets, key) =>
  choice({
    label: t(key),
    options: wordsOf(presets, key).map((id) => ({ id, label: choiceLabel(id) })),
    changed: (made) => change({ [key]: made }),
  });

/** The fields of floor, walls and ceiling: {floor, wallConstruction, ceiling, ceilingConstruction}. */
export const surfaceFields = (presets) => ({
  floor: choice({
    label: t("floor"),
    changed: (floor) => change({ floor }),
    options: presets.surfaces.map((one) => ({
      id: one.id,
      label: `${both(one.label)} (μ ${number(one.static_friction, 2)})`,
    })),
  }),
  wallConstruction: construction(presets, "wallConstruction"),
  ceiling: slider({
    label: t("ceiling"),
    ...numberOf(presets, "ceiling"),
    step: 0.05,
    changed: (ceiling) => change({ ceiling }),
  }),
  ceilingConstruction: construction(presets, "ceilingConstruction"),
});
