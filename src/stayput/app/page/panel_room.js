// "Set the scene": floor, wall, ceiling.

import { choice, slider, toggle } from "./controls.js";
import { fill, part } from "./dom.js";
import { ceilingTooLow, missing } from "./notices.js";
import { change, current, numberOf, wordsOf } from "./scene.js";
import { both, choiceLabel, number, t } from "./words.js";

const ROOM = ["floor", "wall", "gap", "wallConstruction", "ceiling", "ceilingConstruction"];
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
    wall: toggle({ label: t("wall"), changed: (wall) => change({ wall }) }),
    gap: slider({
      label: t("gap"),
      ...numberOf(presets, "gap"),
      step: 0.005,
      changed: (gap) => change({ gap }),
    }),
    wallConstruction: construction(presets, "wallConstruction"),
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
    ROOM.map((key) => fields[key].element),
  );
  update();
}

/** Puts the scene's values into the fields; fields that do not apply are hidden. */
export function update() {
  const scene = current();
  for (const key of ROOM) fields[key].set(scene[key]);
  fields.gap.element.hidden = fields.wallConstruction.element.hidden = !scene.wall;
  fields.ceilingConstruction.element.hidden = scene.ceiling <= scene.height;
  fields.wall.note(missing(scene, "wall"));
  fields.ceiling.note([ceilingTooLow(scene), missing(scene, "ceiling")].filter(Boolean).join(t("space")));
}
