// Fields: a slider beside a number, a choice, a switch. Each gives its element and a way to set its value.

import { el } from "./dom.js";

let made = 0;
const freshId = () => `field-${++made}`;

/**
 * A slider with a number field beside it. Values are in SI; "factor" times them are shown in "unit".
 * Returns {element, set(value)}; "changed" is called with the value while the user moves it.
 */
export function slider({ label, unit = "", range: [low, high], step, factor = 1, hint = null, changed }) {
  const id = freshId(),
    decimals = Math.max(0, -Math.floor(Math.log10(step * factor) + 1e-9));
  const shown = { min: tidy(low * factor), max: tidy(high * factor), step: tidy(step * factor) };
  const range = el("input", { type: "range", id, ...shown, "aria-describedby": hint ? `${id}-hint` : null });
  const field = el("input", {
    type: "number",
    ...shown,
    step: "any",
    inputmode: "decimal",
    "aria-label": unit ? `${label} (${unit})` : label,
  });
  const told = (text, from) => {
    const value = Number(text);
    if (text === "" || !Number.isFinite(value)) return;
    const kept = Math.min(high, Math.max(low, value / factor));
    (from === range ? field : range).value = (kept * factor).toFixed(decimals);
    changed(kept);
  };
  range.addEventListener("input", () => told(range.value, range));
  field.addEventListener("input", () => told(field.value, field));
  field.addEventListener("change", () => {
    field.value = range.value;
  });
  const set = (value) => {
    const text = (value * factor).toFixed(decimals);
    range.value = text;
    if (document.activeElement !== field) field.value = text;
  };
  const element = el(
    "div",
    { class: "field" },
    el("label", { for: id, text: label }),
    el("span", { class: "pair" }, range, el("span", { class: "amount" }, field, unit)),
    hint ? el("p", { class: "hint", id: `${id}-hint`, text: hint }) : null,
  );
  return { element, set, range };
}

const tidy = (value) => String(Number(value.toPrecision(12)));

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

/** A switch with words beside it. */
export function toggle({ label, hint = null, changed }) {
  const id = freshId();
  const input = el("input", {
    type: "checkbox",
    id,
    onchange: () => changed(input.checked),
    "aria-describedby": hint ? `${id}-hint` : null,
  });
  const element = el(
    "div",
    { class: "field check" },
    input,
    el("label", { for: id, text: label }),
    hint ? el("p", { class: "hint", id: `${id}-hint`, text: hint }) : null,
  );
  return {
    element,
    input,
    set: (value) => {
      input.checked = value;
    },
  };
}

/** One of a few, side by side: radio buttons that look like a switch. */
export function oneOf({ label, options, changed }) {
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
  );
  return {
    element,
    set: (value) => {
      if (inputs[value]) inputs[value].checked = true;
    },
  };
}
