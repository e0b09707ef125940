// A record of the user's own: dropped on the page or chosen, sent to the server, shown, used.

import * as api from "./api.js";
import { el, fill, part, svg } from "./dom.js";
import { worded } from "./refusals.js";
import { change, current } from "./scene.js";
import { number, t } from "./words.js";

const UNITS = ["m/s²", "gal", "g"];
let waiting = null,
  preview = null,
  trouble = null;

/** Wires the file field and the place to drop a file on. */
export function wire() {
  const drop = part("drop"),
    field = part("file");
  const take = (file) => {
    if (file) send(file, {});
  };
  field.addEventListener("change", () => {
    take(field.files[0]);
    field.value = "";
  });
  for (const name of ["dragenter", "dragover"])
    drop.addEventListener(name, (event) => {
      event.preventDefault();
      drop.classList.add("over");
    });
  for (const name of ["dragleave", "drop"]) drop.addEventListener(name, () => drop.classList.remove("over"));
  drop.addEventListener("drop", (event) => {
    event.preventDefault();
    take(event.dataTransfer.files[0]);
  });
  for (const name of ["dragover", "drop"]) addEventListener(name, (event) => event.preventDefault());
}

async function send(file, said) {
  waiting?.abort();
  waiting = new AbortController();
  tell(() => [el("p", { role: "status", text: t("sending") })]);
  try {
    const motion = await api.upload(file, said, waiting.signal);
    trouble = null;
    use(motion);
  } catch (error) {
    if (error.name === "AbortError") return;
    tell(() => [refusal(worded(error, "unreadable")), asking(file, said, error.field)]);
  }
}

/** Shows something in the place of the record, until the scene changes with a record in it. */
function tell(made) {
  trouble = made;
  again();
}

/** Writes the words again, for another language. */
export function again() {
  if (trouble) fill(part("uploaded"), trouble().filter(Boolean));
  else update();
}

const refusal = (words) => el("p", { class: "refusal", role: "alert" }, ...words);

/** Asks for what a file does not say: its unit and step, or which of its channels is wanted. */
function asking(file, said, field) {
  const unit = () =>
    el("select", { id: "unit" }, ...UNITS.map((one) => el("option", { value: one, text: one })));
  const dt = () => el("input", { id: "step", type: "number", min: "0.0001", max: "1", step: "any" });
  const component = () => el("input", { id: "component", type: "text" });
  const asked = { unit: { unit, dt }, dt: { dt }, component: { component } }[field];
  if (!asked) return null;
  const fields = Object.entries(asked).map(([name, make]) => [name, make()]);
  const values = () => Object.fromEntries(fields.map(([name, one]) => [name, one.value.trim()]));
  return el(
    "div",
    { class: "row" },
    ...fields.flatMap(([name, one]) => [el("label", { for: one.id, text: t(`file_${name}`) }), one]),
    el("button", {
      type: "button",
      text: t("sendAgain"),
      onclick: () => send(file, { ...said, ...values() }),
    }),
  );
}

/** Says that the server no longer has the record. */
export const lost = () => tell(() => [refusal([t("recordGone")])]);

/** Takes a record that is on the server into the scene. */
export async function use(motion) {
  preview = null;
  change({ record: { id: motion.id, name: motion.name, shaking: motion.shaking, motion }, scaled: false });
  preview = await api.motionPreview(motion.id).catch(() => null);
  update();
}

/** Shows the record in use, if there is one. */
export function update() {
  const { record } = current(),
    place = part("uploaded");
  if (trouble && !record) return;
  trouble = null;
  if (!record) return fill(place);
  const { motion } = record,
    strength = motion.intensity === null ? "" : `, ${t("jma")} ${number(motion.intensity, 1)}`;
  fill(
    place,
    el(
      "p",
      {},
      el("strong", { text: record.name }),
      ` ${number(motion.duration_s, 0)} s, ${number(motion.pga_m_s2, 2)} m/s²${strength}`,
    ),
    preview ? picture(preview) : null,
    el("button", {
      type: "button",
      text: t("withoutRecord"),
      onclick: () => change({ record: null, scaled: false }),
    }),
  );
}

function picture({ time_s, low_m_s2, high_m_s2 }) {
  const most = Math.max(...high_m_s2, ...low_m_s2.map((one) => -one), 1e-9),
    end = time_s.at(-1) || 1;
  const at = (values) =>
    values.map((one, i) => `${((300 * time_s[i]) / end).toFixed(1)} ${(24 - (22 * one) / most).toFixed(1)}`);
  return svg(
    "svg",
    { viewBox: "0 0 300 48", class: "trace", role: "img", "aria-label": t("recordAlt") },
    svg("path", { d: `M${at(high_m_s2).join("L")}L${at(low_m_s2).reverse().join("L")}Z` }),
  );
}
