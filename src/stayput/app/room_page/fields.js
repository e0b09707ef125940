// Fields of the inspector: a number with its unit that is taken when it is typed to the end, a name.

import { fit, remark } from "../controls.js";
import { el } from "../dom.js";
import { t } from "../words.js";

let made = 0;

/**
 * A number field: values are in SI, "factor" times them are shown in "unit" with so many decimals. "limits" returns
 * the smallest and the largest value; what is beyond is said and not taken.
 */
export function amount({ label, unit = "", factor = 1, decimals = 0, limits, changed }) {
  const id = `amount-${++made}`,
    { element: why, note } = remark(`${id}-why`);
  const field = el("input", {
    type: "number",
    id,
    step: 10 ** -decimals,
    inputmode: "decimal",
    "aria-describedby": `${id}-why`,
  });
  let current = null;
  const written = (value) => String(Number((value * factor).toFixed(decimals)));
  const complain = (text) => {
    note(text);
    if (text) field.setAttribute("aria-invalid", "true");
    else field.removeAttribute("aria-invalid");
  };
  const ends = () => limits().map((value) => Number((value * factor).toFixed(3)));
  field.addEventListener("change", () => {
    const value = Number(field.value),
      [low, high] = ends();
    if (field.value === "" || !(value >= low - 1e-9 && value <= high + 1e-9)) {
      complain(t("outside", { low, high, unit: unit && ` ${unit}` }));
      return;
    }
    complain(null);
    if (written(current) !== field.value) changed(value / factor);
    else field.value = written(current);
  });
  const set = (value) => {
    if (value === current && why.hidden === false && document.activeElement === field) return;
    current = value;
    complain(null);
    [field.min, field.max] = ends();
    field.value = written(value);
    fit(field);
  };
  const element = el(
    "div",
    { class: "field number" },
    el("label", { for: id, text: label }),
    el("span", { class: "amount" }, field, unit),
    why,
  );
  return { element, set };
}

/** A name; refuse(text) returns why one is not possible, or null. */
export function naming({ label, refuse, changed }) {
  const id = `amount-${++made}`,
    { element: why, note } = remark(`${id}-why`),
    field = el("input", { type: "text", id, maxlength: 80, "aria-describedby": `${id}-why` });
  field.addEventListener("change", () => {
    const problem = refuse(field.value.trim());
    note(problem);
    if (!problem) changed(field.value.trim());
  });
  const set = (value) => {
    note(null);
    field.value = value;
  };
  return {
    element: el("div", { class: "field wide" }, el("label", { for: id, text: label }), field, why),
    set,
  };
}
