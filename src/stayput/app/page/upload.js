// A record of the user's own: dropped on the page or chosen, sent to the server, shown, used.

import * as api from "./api.js";
import { choice } from "./controls.js";
import { el, fill, part, svg } from "./dom.js";
import { classOf } from "./panel_shaking.js";
import { worded } from "./refusals.js";
import { change, current } from "./scene.js";
import { both, number, spoken, t } from "./words.js";

const UNITS = ["m/s²", "gal", "g"];
let waiting = null,
  preview = null,
  trouble = null,
  shown = null; // the record that stands there

/** Whether a dropped file is a scenario, by its name. */
const isScenario = ({ name }) => /\.toml$/i.test(name);

/** Wires the file field and the place to drop a file on; "takeScenario" is called with a scenario file. */
export function wire(takeScenario) {
  const drop = part("drop"),
    field = part("file");
  const take = (file) => {
    if (!file) return;
    waiting?.abort();
    if (isScenario(file)) takeScenario(file);
    else send(file, {});
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
export function tell(made) {
  trouble = made;
  again();
}

/** Writes the words again, for another language. */
export function again() {
  const { record } = current();
  shown = record;
  fill(part("uploaded"), ...(trouble?.().filter(Boolean) ?? []), ...(record ? about(record) : []));
}

export const refusal = (words) => el("p", { class: "refusal", role: "alert" }, ...words);

/** Asks for what a file does not say: its unit and step, or which of its channels is wanted. */
function asking(file, said, field) {
  const unit = () =>
    el("select", { id: "unit" }, ...UNITS.map((one) => el("option", { value: one, text: one })));
  const dt = () => el("input", { id: "step", type: "number", step: "any" });
  const component = () => el("input", { id: "component", type: "text" });
  const missing = { unit: { unit, dt }, dt: { dt }, component: { component } }[field];
  if (!missing) return null;
  const fields = Object.entries(missing).map(([name, make]) => [name, make()]);
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
export const lost = () => tell(() => [refusal([t("recordGone", { name: "" })])]);

/** Takes a record that is on the server into the scene, as it is. */
export async function use(motion) {
  take(motion, { scaled: false });
  preview = await api.motionPreview(motion.id, motion.shaking.component).catch(() => null);
  update();
}

function take(motion, also) {
  preview = null;
  const record = { id: motion.id, name: motion.name, shaking: motion.shaking, motion };
  change({ record, gone: null, ...also });
}

/** Takes another component of the record in use. */
async function turn(component) {
  const { record } = current();
  try {
    const motion = await api.motion(record.id, component);
    if (current().record?.id !== motion.id) return;
    take(motion, {});
    preview = await api.motionPreview(motion.id, component).catch(() => null);
    update();
  } catch (error) {
    tell(() => [refusal(worded(error, "unreadable"))]);
  }
}

/** Which of the file's channels shakes the piece, and the others, which may be taken in its place. */
function channels({ channels: all = [] }) {
  const used = all.find((one) => one.used);
  if (!used) return null;
  const name = (one) => (one.vertical ? t("verticalChannel", { name: one.name }) : one.name);
  if (all.length === 1)
    return used.name.startsWith("channel") ? null : el("p", { text: t("oneChannel", { name: name(used) }) });
  const field = choice({
    label: t("whichChannel", { n: all.length }),
    options: all.map((one) => ({ id: one.name, label: name(one) })),
    changed: turn,
  });
  field.set(used.name);
  return field.element;
}

/** What the server has to say of the record. */
const warnings = ({ warnings: all }) =>
  (all ?? []).map((one) =>
    el("p", { class: "refusal", text: spoken() === "ja" ? (one.message_ja ?? one.message) : one.message }),
  );

/** Shows the record in use, if there is one; what was wrong with another file goes with the next change. */
export function update() {
  const place = part("uploaded");
  if (trouble && !current().record && !shown) return; // what is asked of a file keeps what was typed
  trouble = null;
  const choosing = place.contains(document.activeElement) && document.activeElement.tagName === "SELECT";
  again();
  if (choosing) place.querySelector("select")?.focus();
}

/** What is known of the record in use, and the button that ends its use. */
function about(record) {
  const { motion } = record;
  const strength =
    motion.intensity === null
      ? ""
      : t("recordStrength", {
          at: number(motion.intensity, 1),
          class: both(classOf(motion.intensity).label),
        });
  return [
    el(
      "p",
      {},
      el("strong", { text: record.name }),
      ` ${number(motion.duration_s, 0)}\u00a0s, ${number(motion.pga_m_s2, 2)}\u00a0m/s²${strength}`,
    ),
    channels(motion) ?? [],
    ...warnings(motion),
    preview ? picture(preview) : [],
    el("button", {
      type: "button",
      text: t("withoutRecord"),
      onclick: () => change({ record: null, scaled: false }),
    }),
  ].flat();
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
