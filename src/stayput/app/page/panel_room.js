// "Set the scene": floor, wall, ceiling, and where in which building.

import { choice, oneOf, slider, toggle } from "./controls.js";
import { fill, part } from "./dom.js";
import { recalled, remember } from "./memory.js";
import { ceilingTooLow, missing } from "./notices.js";
import { change, current, limitsOf, numberOf, wordsOf } from "./scene.js";
import { both, choiceLabel, number, t } from "./words.js";

const ROOM = ["floor", "wall", "gap", "wallConstruction", "ceiling", "ceilingConstruction"],
  BUILDING = ["storeys", "storey", "structure"];
let fields = {},
  most = 1;

/** The storey and the building that the reader last had: "5/10" for storey 5 of 10. */
const building = () => {
  const [storey, storeys] = (recalled("building") ?? "").split("/").map(Number);
  return storeys >= 1 && storey >= 1 && storey <= storeys && storeys <= most
    ? { storeys: Math.round(storeys), storey: Math.round(storey) }
    : { storeys: 10, storey: 5 };
};

/** A choice of what a surface is made of, from those that the server has. */
const construction = (presets, key) =>
  choice({
    label: t(key),
    options: wordsOf(presets, key).map((id) => ({ id, label: choiceLabel(id) })),
    changed: (made) => change({ [key]: made }),
  });

/** Builds the panel; called again for another language. */
export function build(presets) {
  const named = (list) => list.map((one) => ({ id: one.id, label: both(one.label) }));
  most = limitsOf(presets, "storeys")[1];
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
    inside: oneOf({
      label: t("where"),
      options: [
        { id: "ground", label: t("onGround") },
        { id: "building", label: t("inBuilding") },
      ],
      changed: (where) => change(where === "ground" ? { storeys: 0, storey: 1 } : building()),
    }),
    storeys: slider({
      label: t("storeys"),
      range: [1, most],
      step: 1,
      changed: (storeys) => change({ storeys: Math.round(storeys) }),
    }),
    storey: slider({
      label: t("storey"),
      ...numberOf(presets, "storey"),
      step: 1,
      changed: (storey) => change({ storey: Math.round(storey) }),
    }),
    structure: choice({
      label: t("structure"),
      options: named(presets.structures),
      changed: (structure) => change({ structure }),
    }),
  };
  fill(
    part("room"),
    ROOM.map((key) => fields[key].element),
  );
  fill(
    part("building"),
    ["inside", ...BUILDING].map((key) => fields[key].element),
  );
  update();
}

/** Puts the scene's values into the fields; fields that do not apply are hidden. */
export function update() {
  const scene = current();
  for (const key of [...ROOM, ...BUILDING]) fields[key].set(scene[key]);
  fields.inside.set(scene.storeys > 0 ? "building" : "ground");
  fields.gap.element.hidden = fields.wallConstruction.element.hidden = !scene.wall;
  fields.ceilingConstruction.element.hidden = scene.ceiling <= scene.height;
  fields.wall.note(missing(scene, "wall"));
  fields.ceiling.note([ceilingTooLow(scene), missing(scene, "ceiling")].filter(Boolean).join(t("space")));
  if (scene.storeys > 0) remember("building", `${scene.storey}/${scene.storeys}`);
  for (const key of BUILDING) fields[key].element.hidden = scene.storeys === 0;
}
