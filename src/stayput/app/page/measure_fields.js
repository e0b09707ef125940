// A parameter of a measure as a field: a choice of words, or a slider around its usual value.

import { choice, slider } from "./controls.js";
import { both, choiceLabel, t } from "./words.js";

/** The field of a parameter with its value, or null where it has none; "changed" is called with another value. */
export function measureField(about, given, changed) {
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
