// "And without an earthquake?": what people do to the piece, and the margin in each case.

import { el, fill, part } from "./dom.js";
import { current } from "./scene.js";
import { numberField } from "./scene_fields.js";
import { both, number, t } from "./words.js";

const STEPS = { drawers: 1, drawerLoad: 1, pull: 5 };
let fields = {};

/** Whether a key of the scene is asked for here, and so decides nothing that is simulated. */
export const asks = (key) => key in STEPS;

/** Builds the fields; called again for another language. */
export function build(presets) {
  fields = Object.fromEntries(
    Object.entries(STEPS).map(([key, step]) => [key, numberField(presets, key, { whole: key === "drawers", step })]),
  );
  fill(
    part("everyday-ask"),
    Object.values(fields).map((field) => field.element),
  );
  update();
}

/** Puts the scene's values into the fields. */
export function update() {
  const scene = current();
  for (const [key, field] of Object.entries(fields)) field.set(scene[key]);
}

/** Writes the worst case in words, and the margin of each. */
export function show({ everyday }) {
  part("everyday").textContent = both(everyday.sentence);
  fill(
    part("everyday-cases"),
    everyday.cases.map((one) =>
      el(
        "li",
        {},
        both(one.label),
        el("span", {
          class: one.tips_over ? "tag gradeC" : "tag",
          // without a margin there is no moment that could tip it
          text: one.margin === null ? t("everydayNever") : t("everydayMargin", { margin: number(one.margin, 2) }),
        }),
      ),
    ),
  );
}
