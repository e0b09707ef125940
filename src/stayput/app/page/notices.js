// What the picture is not of what was asked: said beside the field, and above the picture.

import { el, fill, part } from "./dom.js";
import { leftOut } from "./panel_measures.js";
import { wordedOfScenario } from "./refusals.js";
import { change, current } from "./scene.js";
import { length, t } from "./words.js";

/** What is left out for want of a wall or a ceiling, as a sentence, or nothing. */
export function missing(scene, what) {
  const measures = leftOut(scene).filter(({ lacks }) => lacks === what);
  return measures.length
    ? t(`leftOut_${what}`, { measures: measures.map(({ label }) => label).join(t("listed")) })
    : null;
}

/** That the piece does not go under the ceiling, as a sentence, or nothing. */
export const ceilingTooLow = (scene) =>
  scene.ceiling > scene.height
    ? null
    : t("ceilingTooLow", { ceiling: length(scene.ceiling), height: length(scene.height) });

/** Why what a link names is not shown: a record that the server has no more, or a file of several pieces. */
function whyGone({ name, further, file, error }) {
  if (further) return [t("recordGone", { name: t("recordName", { name }) }), t("space"), t("withoutFurther")];
  if (!file)
    return [t("recordGone", { name: name ? t("recordName", { name }) : "" }), t("space"), t("recordReplaced")];
  return error ? [`${file}${t("colon")}`, ...wordedOfScenario(error)] : [t("linkDamaged", { name: file })];
}

/** Writes all of it above the picture. */
export function update() {
  const scene = current();
  const sentences = [
    missing(scene, "wall"),
    ceilingTooLow(scene),
    missing(scene, "ceiling"),
  ].filter(Boolean);
  const gone = scene.gone && [
    ...whyGone(scene.gone),
    " ",
    el("button", { type: "button", text: t("understood"), onclick: () => change({ gone: null }) }),
  ];
  const all = [...(gone ? [gone] : []), ...sentences.map((one) => [one])];
  part("notices").hidden = !all.length;
  fill(part("notices"), ...all.map((one) => el("p", {}, ...one)));
}
