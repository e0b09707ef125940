// "Set up the room": floor, walls and ceiling.

import { toggle } from "../controls.js";
import { fill, part } from "../dom.js";
import { change, current } from "../scene.js";
import { surfaceFields } from "../scene_fields.js";
import { t } from "../words.js";

const OF_CEILING = ["ceiling", "ceilingConstruction"],
  ORDER = ["floor", "wallConstruction", "ceilingThere", ...OF_CEILING];
let fields = {};

/** Builds the panel; called again for another language. */
export function build(presets) {
  fields = {
    ...surfaceFields(presets),
    ceilingThere: toggle({ label: t("ceilingThere"), changed: (ceilingThere) => change({ ceilingThere }) }),
  };
  fill(
    part("room"),
    ORDER.map((key) => fields[key].element),
  );
  update();
}

/** Puts the room's values into the fields. */
export function update() {
  const scene = current();
  for (const key of ORDER) fields[key].set(scene[key]);
  for (const key of OF_CEILING) fields[key].element.hidden = !scene.ceilingThere;
}
