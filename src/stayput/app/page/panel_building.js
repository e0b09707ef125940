// "Set the scene": whether the room is on the ground or in a building, and on which of its storeys.

import { oneOf } from "./controls.js";
import { fill, part } from "./dom.js";
import { recalled, remember } from "./memory.js";
import { change, current, limitsOf } from "./scene.js";
import { choiceField, named, numberField } from "./scene_fields.js";
import { t } from "./words.js";

const BUILDING = ["storeys", "storey", "structure"];
let fields = {},
  most = 1;

/** The storey and the building that the reader last had: "5/10" for storey 5 of 10. */
const building = () => {
  const [storey, storeys] = (recalled("building") ?? "").split("/").map(Number);
  return storeys >= 1 && storey >= 1 && storey <= storeys && storeys <= most
    ? { storeys: Math.round(storeys), storey: Math.round(storey) }
    : { storeys: 10, storey: 5 };
};

/** Builds the panel; called again for another language. */
export function build(presets) {
  most = limitsOf(presets, "storeys")[1];
  fields = {
    inside: oneOf({
      label: t("where"),
      options: [
        { id: "ground", label: t("onGround") },
        { id: "building", label: t("inBuilding") },
      ],
      changed: (where) => change(where === "ground" ? { storeys: 0, storey: 1 } : building()),
    }),
    storeys: numberField(presets, "storeys", { whole: true, range: [1, most], limits: [1, most] }),
    storey: numberField(presets, "storey", { whole: true }),
    structure: choiceField("structure", named(presets.structures)),
  };
  fill(
    part("building"),
    ["inside", ...BUILDING].map((key) => fields[key].element),
  );
  update();
}

/** Puts the scene's values into the fields; those of a building are hidden on the ground. */
export function update() {
  const scene = current();
  for (const key of BUILDING) fields[key].set(scene[key]);
  fields.inside.set(scene.storeys > 0 ? "building" : "ground");
  if (scene.storeys > 0) remember("building", `${scene.storey}/${scene.storeys}`);
  for (const key of BUILDING) fields[key].element.hidden = scene.storeys === 0;
}
