// "Set up the room": floor, walls and ceiling.

import { choice, slider, toggle } from "../controls.js";
import { fill, part } from "../dom.js";
import { change, current, numberOf, wordsOf } from "../scene.js";
import { both, choiceLabel, number, t } from "../words.js";

const CHOICES = ["floor", "wallConstruction", "ceilingConstruction"],
  OF_CEILING = ["ceiling", "ceilingConstruction"];
let fields = {};

/** A choice of what a surface is made of, from those that the server has. */
const construction = (presets, key) =>
  choice({
    label: t(key),
    options: wordsOf(presets, key).map((id) => ({ id, label: choiceLabel(id) })),
    changed: (made) => change({ [key]: made }),
  });

/** Builds the panel; called again for another language. */
export function build(presets) {
  fields = {
    floor: choice({
      label: t("floor"),
      changed: (floor) => change({ floor }),
      options: presets.surfaces.map((one) => ({
        id: one.id,
        label: `${both(one.label)} (μ ${number(one.static_friction, 2)})`,
      })),
    }),
    wallConstruction: construction(presets, "wallConstruction"),
    ceilingThere: toggle({ label: t("ceilingThere"), changed: (ceilingThere) => change({ ceilingThere }) }),
    ceiling: slider({
      label: t("ceiling"),
      ...numberOf(presets, "ceiling"),
      step: 0.05,
      changed: (ceiling) => change({ ceiling }),
    }),
    ceilingConstruction: construction(presets, "ceilingConstruction"),
  };
  fill(
    part("room"),
    Object.values(fields).map(({ element }) => element),
  );
  update();
}

/** Puts the room's values into the fields. */
export function update() {
  const scene = current();
  for (const key of [...CHOICES, "ceiling", "ceilingThere"]) fields[key].set(scene[key]);
  for (const key of OF_CEILING) fields[key].element.hidden = !scene.ceilingThere;
}
