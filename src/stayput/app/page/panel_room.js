// "Set the scene": floor, wall, ceiling.

import { toggle } from "./controls.js";
import { fill, part } from "./dom.js";
import { ceilingTooLow, missing } from "./notices.js";
import { change, current } from "./scene.js";
import { numberField, surfaceFields } from "./scene_fields.js";
import { t } from "./words.js";

const ROOM = ["floor", "wall", "gap", "wallConstruction", "ceiling", "ceilingConstruction"];
let fields = {};

/** Builds the panel; called again for another language. */
export function build(presets) {
  fields = {
    ...surfaceFields(presets),
    wall: toggle({ label: t("wall"), changed: (wall) => change({ wall }) }),
    gap: numberField(presets, "gap", { step: 0.005 }),
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
