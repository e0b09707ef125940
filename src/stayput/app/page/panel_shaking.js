// "Set the scene": how strong the shaking is, and of which kind; or a record of the user's own.

import { choice, oneOf, slider, toggle } from "./controls.js";
import { fill, part } from "./dom.js";
import { change, current, numberOf } from "./scene.js";
import { both, number, t } from "./words.js";

let fields = {},
  classes = [];

/** The class of an intensity, as the scale has it. */
export const classOf = (intensity) =>
  classes.findLast((one, i) => i === 0 || intensity + 1e-9 >= one.from) ?? classes[0];

/** Where each class begins, from the weakest. */
export const classesKnown = () => classes;

/** Builds the panel; called again for another language. */
export function build(presets) {
  classes = presets.intensities;
  fields = {
    intensity: slider({
      label: t("intensity"),
      ...numberOf(presets, "intensity"),
      step: 0.05,
      changed: (intensity) => change({ intensity }),
    }),
    family: choice({
      label: t("family"),
      options: presets.families.map((one) => ({ id: one.id, label: both(one.label) })),
      changed: (family) => change({ family, member: 1 }),
    }),
    member: slider({
      label: t("member"),
      ...numberOf(presets, "member"),
      step: 1,
      hint: t("memberHint"),
      changed: (member) => change({ member: Math.round(member) }),
    }),
    scaled: toggle({ label: t("scaled"), changed: (scaled) => change({ scaled }) }),
    quick: oneOf({
      label: t("intensityClass"),
      options: classes
        .filter((one) => one.middle >= 3.5)
        .map((one) => ({ id: one.id, label: both(one.label) })),
      changed: (id) =>
        change({
          intensity: classes.find((one) => one.id === id).middle,
          ...(current().record ? { scaled: true } : {}),
        }),
    }),
  };
  fill(part("strength"), fields.quick.element, fields.intensity.element);
  fill(part("kind"), fields.family.element, fields.member.element);
  fill(part("scaling"), fields.scaled.element);
  update();
}

/** Puts the scene's values into the fields, and says what such shaking does. */
export function update() {
  const scene = current(),
    now = classOf(scene.intensity),
    own = !scene.record || scene.scaled;
  for (const key of ["intensity", "family", "member", "scaled"]) fields[key].set(scene[key]);
  fields.quick.set(own ? now.id : null); // a record as it is has its own strength
  fields.intensity.element.hidden = !own;
  part("scaling").hidden = !scene.record;
  part("kind").hidden = Boolean(scene.record);
  part("meaning").hidden = part("meaning-source").hidden = !own;
  fill(part("meaning"), both(now.about), t("space"), both(now.furniture));
  fields.intensity.range.setAttribute("aria-valuetext", `${number(scene.intensity, 2)}, ${both(now.label)}`);
}

/** How strong the ground shakes, in words. */
export const strengthOf = (motion) =>
  motion.ground_intensity === null
    ? ""
    : t("strength", {
        class: both(classOf(motion.ground_intensity).label),
        at: number(motion.ground_intensity, 2),
      });

/** Where the piece is shaken, how strongly and by what, in words. */
export function summary(scene, motion) {
  const place =
    scene.storeys > 0
      ? t("placeStorey", { storey: number(scene.storey), storeys: number(scene.storeys) })
      : t("placeGround");
  const felt =
    scene.storeys > 0 && motion.floor_intensity !== null
      ? t("felt", { at: number(motion.floor_intensity, 2) })
      : "";
  const source = [
    scene.record ? t("recorded", { name: scene.record.name }) : "",
    motion.synthetic ? t("synthetic") : "",
  ];
  return [place, strengthOf(motion), felt, ...source].filter(Boolean).join(t("space"));
}
