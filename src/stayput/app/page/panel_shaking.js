// "Set the scene": how strong the shaking is, and of which kind; or a record of the user's own.

import { oneOf, toggle } from "./controls.js";
import { el, fill, part } from "./dom.js";
import * as earthquake from "./earthquake.js";
import { change, current, forServer, throughBuilding } from "./scene.js";
import { choiceField, named, numberField } from "./scene_fields.js";
import { both, number, t } from "./words.js";

let fields = {},
  entry = null,
  families = [],
  classes = [];

/** An intensity as JMA publishes it: rounded to two decimals, then cut to one. */
export const published = (intensity) => Math.floor(Math.round(100 * intensity) / 10 + 1e-9) / 10;

/** The class of an intensity, as the scale has it. */
export const classOf = (intensity) =>
  classes.findLast((one, i) => i === 0 || published(intensity) >= one.from) ?? classes[0];

/** Where each class begins, from the weakest. */
export const classesKnown = () => classes;

/** Builds the panel; called again for another language. */
export function build(presets) {
  classes = presets.intensities;
  families = presets.families;
  fields = {
    intensity: numberField(presets, "intensity", { step: 0.05 }),
    family: choiceField("family", named(presets.families), (family) => change({ family, member: 1 })),
    member: numberField(presets, "member", { whole: true, hint: t("memberHint") }),
    scaled: toggle({ label: t("scaled"), changed: (scaled) => change({ scaled }) }),
    quick: oneOf({
      label: t("intensityClass"),
      options: named(classes.filter((one) => one.middle >= 3.5)),
      changed: (id) =>
        change({
          intensity: classes.find((one) => one.id === id).middle,
          ...(current().record ? { scaled: true } : {}),
        }),
    }),
  };
  entry = earthquake.build(part("entry"), {
    get: () => current().entry,
    set: (stated) => change({ entry: stated, ...(current().record ? { scaled: true } : {}) }),
    presets,
    scene: () => forServer(current()),
  });
  fill(part("strength"), fields.quick.element, fields.intensity.element);
  fill(part("kind"), fields.family.element, el("p", { class: "hint", id: "family-about" }), fields.member.element);
  fill(part("scaling"), fields.scaled.element);
  update();
}

/** Puts the scene's values into the fields, and says what such shaking does. */
export function update() {
  const scene = current(),
    now = classOf(scene.intensity),
    own = !scene.record || scene.scaled, // a record as it is has its own strength
    byIntensity = own && !scene.entry;
  for (const key of ["intensity", "family", "member", "scaled"]) fields[key].set(scene[key]);
  fields.quick.set(byIntensity ? now.id : null);
  part("entry").hidden = !own;
  entry.update();
  part("strength").hidden = Boolean(own && scene.entry);
  fields.intensity.element.hidden = !byIntensity;
  part("scaling").hidden = !scene.record;
  part("kind").hidden = Boolean(scene.record);
  part("meaning").hidden = part("meaning-source").hidden = !byIntensity;
  fill(part("meaning"), both(now.about), t("space"), both(now.furniture));
  fields.intensity.range.setAttribute("aria-valuetext", `${number(scene.intensity, 2)}, ${both(now.label)}`);
  const { about } = families.find((one) => one.id === scene.family);
  fill(part("family-about"), t("familyAbout", { about: both(about) }));
}

/** How strong the ground shakes, in words. */
export const strengthOf = (motion) =>
  motion.ground_intensity === null
    ? ""
    : t("strength", {
        class: both(classOf(motion.ground_intensity).label),
        at: number(motion.ground_intensity, 2),
      });

const measured = ({ motion }) => (motion?.floor === "borehole" ? "placeBorehole" : "placeMeasured");

/** Where the piece is shaken, how strongly and by what, in words. */
export function summary(scene, motion) {
  const place =
    throughBuilding(scene)
      ? t("placeStorey", { storey: number(scene.storey), storeys: number(scene.storeys) })
      : t(!scene.record || !scene.onFloor ? "placeGround" : measured(scene.record));
  const felt =
    throughBuilding(scene) && motion.floor_intensity !== null
      ? t("felt", { at: number(motion.floor_intensity, 2) })
      : "";
  const source = [
    scene.record ? t("recorded", { name: scene.record.name }) : "",
    motion.synthetic ? t("synthetic") : "",
  ];
  return [place, strengthOf(motion), felt, ...source].filter(Boolean).join(t("space"));
}
