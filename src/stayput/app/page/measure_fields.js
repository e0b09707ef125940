// A measure as a switch, and its parameters as fields: a choice of words, or a slider around the usual value.

import { choice, slider, toggle } from "./controls.js";
import { el, fill } from "./dom.js";
import { both, choiceLabel, t } from "./words.js";

/**
 * A kind of measure: {kind, element, update(on, why)}; "why" says what is amiss with it, or nothing. values() gives its
 * parameters as far as they are set; set(on) puts it in place or takes it away, give(name, value) sets a parameter.
 */
export function measureRow(kind, { hint = null, values, set, give }) {
  const box = toggle({ label: both(kind.label), hint, changed: set }),
    settings = el("details", { class: "settings" }, el("summary", { text: t("adjust") }));
  const field = (about) => measureField(about, values()?.[about.name], (value) => give(about.name, value));
  settings.addEventListener("toggle", () => {
    if (settings.open) fill(settings, settings.firstChild, kind.parameters.map(field).filter(Boolean));
  });
  const update = (on, why) => {
    box.set(on);
    box.input.disabled = Boolean(why) && !on;
    box.note(why);
    settings.hidden = !on || !kind.parameters.length;
  };
  return { kind, element: el("div", { class: "measure" }, box.element, settings), update };
}

/** Rows of measures: the usual ones, the others in an element that opens. */
export function measureList(rows, open = false) {
  const of = (usual) => rows.filter(({ kind }) => kind.usual === usual).map(({ element }) => element);
  const more = el("details", { class: "more", open }, el("summary", { text: t("moreMeasures") }), ...of(false));
  return [...of(true), more];
}

/** Whether one measure takes the place of another. */
export const replaces = (one, other) => Boolean(one.place) && one.place === other?.place;

/** The field of a parameter with its value, or null where it has none; "changed" is called with another value. */
function measureField(about, given, changed) {
  const label = both(about.label),
    value = given ?? about.default ?? about.usual;
  if (about.choices?.length) {
    const one = choice({ label, options: about.choices.map((id) => ({ id, label: choiceLabel(id) })), changed });
    one.set(value);
    return one.element;
  }
  if (typeof value !== "number") return null;
  const high = Math.min(about.high, Math.max(4 * value, about.low + 1e-3)),
    low = Math.max(about.low, 0);
  const one = slider({
    label,
    unit: about.unit,
    range: [low, high],
    limits: [Math.min(low, about.low), about.high],
    step: about.whole ? 1 : 10 ** Math.floor(Math.log10(high / 100)),
    hint: t(`confidence_${about.confidence}`),
    changed: (next) => changed(about.whole ? Math.round(next) : next),
  });
  one.set(value);
  return one.element;
}
