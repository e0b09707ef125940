// Fields: a slider beside a number, a choice, a switch. Each gives its element and a way to set its value.

import { el } from "./dom.js";
import { t } from "./words.js";

let made = 0;
const freshId = () => `field-${++made}`;
const SPINNER = "2.2rem";

/** Makes a number field as wide as what stands in it. */
export function fit(field) {
  field.style.width = `calc(${Math.max(4, field.value.length, field.placeholder.length)}ch + ${SPINNER})`;
}

/** A line under a field that says what is amiss; it is hidden where nothing is. */
export function remark(id = null) {
  const element = el("p", { class: "hint why", id, role: "status", hidden: true });
  const note = (text) => {
    element.hidden = !text;
    element.textContent = text ?? "";
  };
  return { element, note };
}

/**
 * A slider with a number field beside it. Values are in SI; "factor" times them are shown in "unit".
 * Returns {element, set(value), note(text)}; "changed" is called with the value while the user moves it. The
 * number may be within "limits", which can be wider than the slider's range.
 */
export function slider({ label, unit = "", range: reach, limits = reach, step, factor = 1, hint = null, changed }) {
  const id = freshId(),
    decimals = Math.max(0, -Math.floor(Math.log10(step * factor) + 1e-9));
  const ends = ([low, high]) => ({ min: tidy(low * factor), max: tidy(high * factor) });
  const [low, high] = limits,
    allowed = ends(limits);
  const range = el("input", {
    type: "range",
    id,
    ...ends(reach),
    step: tidy(step * factor),
    "aria-describedby": hint ? `${id}-hint` : null,
  });
  const field = el("input", {
    type: "number",
    ...allowed,
    step: "any",
    inputmode: "decimal",
    "aria-label": unit ? `${label} (${unit})` : label,
  });
  const { element: why, note } = remark();
  const written = (value) => {
    const rounded = (value * factor).toFixed(decimals);
    return Math.abs(Number(rounded) - value * factor) < 1e-9 ? rounded : tidy(value * factor, 6);
  };
  let current = low,
    outside = false,
    noted = null;
  const take = (text, from) => {
    const value = Number(text);
    if (text === "" || !Number.isFinite(value)) return;
    current = Math.min(high, Math.max(low, value / factor));
    outside = Math.abs(current * factor - value) > 1e-9 * Math.max(1, Math.abs(value));
    say();
    if (from === range) field.value = written(current);
    else range.value = tidy(current * factor);
    fit(field);
    changed(current);
  };
  const say = () =>
    note(outside ? t("outside", { low: allowed.min, high: allowed.max, unit: unit ? ` ${unit}` : "" }) : noted);
  range.addEventListener("input", () => take(range.value, range));
  field.addEventListener("input", () => take(field.value, field));
  field.addEventListener("change", () => {
    field.value = written(current);
    fit(field);
  });
  const set = (value) => {
    if (Math.abs(value - current) > 1e-12) {
      current = value;
      outside = false;
      say();
    }
    range.value = tidy(value * factor);
    if (document.activeElement !== field) field.value = written(value);
    fit(field);
  };
  const element = el(
    "div",
    { class: "field" },
    el("label", { for: id, text: label }),
    el("span", { class: "pair" }, range, el("span", { class: "amount" }, field, unit)),
    hint ? el("p", { class: "hint", id: `${id}-hint`, text: hint }) : null,
    why,
  );
  return {
    element,
    set,
    range,
    note: (text) => {
      noted = text;
      say();
    },
  };
}

const tidy = (value, digits = 12) => String(Number(value.toPrecision(digits)));

/** A choice of one of several: options are {id, label}. */
export function choice({ label, options, changed }) {
  const id = freshId();
  const select = el(
    "select",
    { id, onchange: () => changed(select.value) },
    ...options.map((one) => el("option", { value: one.id, text: one.label })),
  );
  return {
    element: el("div", { class: "field" }, el("label", { for: id, text: label }), select),
    set: (value) => {
      select.value = value;
    },
  };
}

/** A switch with words beside it; note(text) says what is amiss with it. */
export function toggle({ label, hint = null, changed }) {
  const id = freshId();
  const input = el("input", {
    type: "checkbox",
    id,
    onchange: () => changed(input.checked),
    "aria-describedby": hint ? `${id}-hint` : null,
  });
  const { element: why, note } = remark();
  const element = el(
    "div",
    { class: "field check" },
    input,
    el("label", { for: id, text: label }),
    hint ? el("p", { class: "hint", id: `${id}-hint`, text: hint }) : null,
    why,
  );
  return {
    element,
    input,
    note,
    set: (value) => {
      input.checked = value;
    },
  };
}

/** One of a few, side by side: radio buttons that look like a switch; set(null): none of them. */
export function oneOf({ label, options, hint = null, changed }) {
  const name = freshId(),
    inputs = {};
  const element = el(
    "fieldset",
    { class: "oneof" },
    el("legend", { text: label }),
    ...options.map((one) => {
      inputs[one.id] = el("input", {
        type: "radio",
        name,
        id: `${name}-${one.id}`,
        value: one.id,
        onchange: () => changed(one.id),
      });
      return el("span", {}, inputs[one.id], el("label", { for: `${name}-${one.id}`, text: one.label }));
    }),
    hint ? el("p", { class: "hint", text: hint }) : null,
  );
  return {
    element,
    set: (value) => {
      for (const [id, input] of Object.entries(inputs)) input.checked = id === value;
    },
  };
}
