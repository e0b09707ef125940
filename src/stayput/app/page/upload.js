// A record of the user's own: dropped on the page or chosen, sent to the server, shown, used.

import * as api from "./api.js";
import { choice, oneOf } from "./controls.js";
import { el, fill, part } from "./dom.js";
import { inNumbers, picture } from "./record.js";
import { patiently } from "./connection.js";
import { packed, unpackedBytes } from "./packing.js";
import { worded } from "./refusals.js";
import { change, current } from "./scene.js";
import { spoken, t } from "./words.js";

const UNITS = ["m/s²", "cm/s²", "gal", "mm/s²", "g", "%g", "mg", "in/s²", "ft/s²"];
const LONGEST = 4096; // letters of a record in a link, with those of its vertical component
const sent = new Map(); // the ids of the records in links that were sent to the server again, by their letters
let waiting = null,
  preview = null,
  trouble = null,
  shown = null, // the record that stands there
  latest = null; // the file that was sent last, which may be sent again without its mean

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
    const letters = await lettersOf(file);
    latest = { id: motion.id, file, said };
    trouble = null;
    if (vertical(motion)) tell(() => offering(motion, file));
    else use(motion, letters);
  } catch (error) {
    if (error.name === "AbortError") return;
    tell(() => [refusal(worded(error, "unreadable")), still(current()), asking(file, said, error)]);
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

/** That the record of before is in use. */
const still = ({ record }) => record && el("p", { text: t("stillUsed", { name: record.name }) });

export const refusal = (words) => el("p", { class: "refusal", role: "alert" }, ...words);

/** Asks for what a file does not say: its unit and step, or which of its channels is wanted. */
function asking(file, said, { field, perhaps, also }) {
  const unit = () =>
    el(
      "select",
      { id: "unit" },
      ...UNITS.map((one) => el("option", { value: one, text: one, selected: one === perhaps })),
    );
  const dt = () => el("input", { id: "step", type: "number", step: "any" });
  const component = () => el("input", { id: "component", type: "text" });
  const remove_mean = () => el("input", { id: "mean", type: "checkbox", checked: true, value: "true" });
  const ways = { unit, dt, component, remove_mean };
  if (!ways[field]) return null;
  const fields = [field, ...also].map((name) => [name, ways[name]()]);
  const values = () => Object.fromEntries(fields.map(([name, one]) => [name, one.type === "checkbox" && !one.checked ? "" : one.value.trim()]));
  return el(
    "div",
    { class: "row" },
    ...fields.flatMap(([name, one]) => [el("label", { for: one.id, text: t(`file_${name}`) }), one]),
    el("button", { type: "button", text: t("sendAgain"), onclick: () => send(file, { ...said, ...values() }) }),
  );
}

/** Says that the server no longer has the record. */
const lost = () => tell(() => [refusal([t("recordGone", { name: "" })])]);

/** What a link holds of a record: its file in letters, or null where that is too long. */
async function lettersOf(file, most = LONGEST) {
  if (file.size > 16 * most) return null; // which no file of numbers is made smaller by
  const letters = await packed(await file.arrayBuffer());
  return letters.length <= most ? letters : null;
}

/** The server has the record of a scene no more: it is sent again where the link holds it, else said to be gone. */
export const takeAgain = ({ record: { vertical: up, ...record }, ...scene }) =>
  takeLinked({ ...linkedOf(record), vertical: up && linkedOf(up) }, scene);

/** A record as a link has it. */
const linkedOf = ({ id, name, shaking: { component, unit, dt, remove_mean }, letters }) => ({
  id,
  name,
  said: { component, unit, dt, remove_mean },
  letters,
});

/** Takes the record of a link into the scene, or says that it is gone. */
export async function takeLinked(linked, { scaled, onFloor }) {
  try {
    await useLinked(linked);
    change({ scaled, onFloor });
    update(); // which the page does by itself only once it has begun
  } catch (error) {
    if (!isLost(error, linked)) throw error;
    change({ record: null, gone: { name: linked.name }, scaled: false, onFloor: false });
    lost();
  }
}

/** Whether a record of a link is neither on the server nor in the link. */
const isLost = (error, { letters }) => error instanceof api.Refused || Boolean(letters);

/** Takes the record of a link into the scene, with its vertical component or, where that is gone, with a notice; see `motionOf`. */
async function useLinked({ vertical: up, ...linked }) {
  const record = await motionOf(linked);
  const above = up && (await motionOf(up).catch((error) => {
    if (!isLost(error, up)) throw error;
  }));
  await use(record, linked.letters, above ? upright(above, up.name, up.letters) : null);
  if (up && !above) change({ gone: { name: up.name, vertical: true } });
}

/** The vertical component of a record, as the scene has it. */
export const upright = ({ id, shaking }, name, letters) => ({ id, name, shaking, letters });

/** The record of a link as the server knows it; one that it has no more is sent again, if the link holds it. */
export async function motionOf({ id, name, said, letters }) {
  const on = (which) => patiently(() => api.motion(which, said.component));
  const known = await on(letters && sent.has(letters) ? sent.get(letters) : id).catch((error) => {
    if (error.status !== 404 || !letters) throw error;
  });
  if (known) return known;
  const file = new File([await unpackedBytes(letters)], name ?? ""),
    motion = await patiently(() => api.upload(file, said));
  sent.set(letters, motion.id);
  return motion;
}

/** Whether a record holds a vertical component alone. */
const vertical = ({ channels: all }) => all.length > 0 && all.every((one) => one.vertical);

/** Offers a vertical record as what it is: the vertical component of the horizontal record in use. */
function offering(motion, file) {
  const { record } = current(),
    name = motion.name;
  if (!record) return [refusal([t("verticalAlone", { name })])];
  const taken = async () => {
    const letters = record.letters && (await lettersOf(file, LONGEST - record.letters.length));
    trouble = null;
    change({ record: { ...current().record, vertical: upright(motion, name, letters) } });
  };
  return [
    el("p", { role: "status", text: t("verticalOffered", { name, record: record.name }) }),
    el("button", { type: "button", text: t("takeVertical"), onclick: taken }),
  ];
}

/** Takes a record that is on the server into the scene, as it is; "letters" are what a link holds of it, "up" is its vertical component. */
async function use(motion, letters, up = null, also = { scaled: false, onFloor: Boolean(motion.floor) }) {
  preview = null;
  const { id, name, shaking } = motion;
  change({ record: { id, name, shaking, motion, letters, vertical: up }, gone: null, ...also });
  preview = await api.motionPreview(id, shaking.component).catch(() => null);
  update();
}

/** Takes another component of the record in use. */
async function turn(component) {
  const { record } = current();
  try {
    const motion = await api.motion(record.id, component);
    if (current().record?.id === motion.id) await use(motion, record.letters, current().record.vertical, {});
  } catch (error) {
    tell(() => [refusal(worded(error, "unreadable"))]);
  }
}

/** Which of the file's horizontal channels shakes the piece, and the others, which may be taken in its place. */
function channels({ channels: all = [] }) {
  const used = all.find((one) => one.used);
  if (!used) return null;
  const level = all.filter((one) => !one.vertical);
  if (level.length < 2) {
    if (used.name.startsWith("channel")) return null;
    const name = used.vertical ? t("verticalChannel", { name: used.name }) : used.name;
    return el("p", { text: t("oneChannel", { name }) });
  }
  const field = choice({
    label: t("whichChannel", { n: level.length }),
    options: level.map((one) => ({ id: one.name, label: one.name })),
    changed: turn,
  });
  field.set(used.name);
  return field.element;
}

/** The vertical component that acts: of a file of its own, or beside the horizontal ones of the record's. */
function verticalOf({ vertical: up, motion: { channels: all = [], components } }) {
  const name = up?.name ?? (components.includes("z") ? all.find((one) => one.vertical)?.name : null);
  return name ? el("p", { text: t("withVertical", { name }) }) : [];
}

/** What the server has to say of the record, with a button that sends it again less its mean where that would help. */
const warnings = ({ id, warnings: all }) =>
  (all ?? []).flatMap((one) => [
    el("p", { class: "refusal", text: spoken() === "ja" ? (one.message_ja ?? one.message) : one.message }),
    ...(one.field === "remove_mean" && latest?.id === id ? [lessItsMean()] : []),
  ]);

const lessItsMean = () => {
  const onclick = () => send(latest.file, { ...latest.said, remove_mean: "true" });
  return el("button", { type: "button", text: t("file_remove_mean"), onclick });
};

/** Shows the record in use, if there is one; what was wrong with another file goes with the next change. */
export function update() {
  const place = part("uploaded");
  if (trouble && !current().record && !shown) return; // what is asked of a file keeps what was typed
  trouble = null;
  const choosing = place.contains(document.activeElement) && document.activeElement.tagName === "SELECT";
  again();
  if (choosing) place.querySelector("select")?.focus();
}

/** Asks where the record was measured: on a floor, there is no building between it and the piece. */
function measured() {
  const field = oneOf({
    label: t("measuredWhere"),
    options: [
      { id: "ground", label: t("measuredGround") },
      { id: "floor", label: t("measuredFloor") },
    ],
    changed: (place) => change({ onFloor: place === "floor" }),
  });
  field.set(current().onFloor ? "floor" : "ground");
  const note = current().onFloor ? el("p", { class: "hint", text: t("measuredNote") }) : null;
  return [field.element, ...(note ? [note] : [])];
}

/** What is known of the record in use, and the button that ends its use. */
function about(record) {
  const { motion } = record;
  return [
    el("p", {}, el("strong", { text: record.name }), ` ${inNumbers(motion)}`),
    channels(motion) ?? [],
    verticalOf(record),
    measured(),
    ...warnings(motion),
    preview ? picture(preview) : [],
    el("button", {
      type: "button",
      text: t("withoutRecord"),
      onclick: () => change({ record: null, scaled: false, onFloor: false }),
    }),
  ].flat();
}
