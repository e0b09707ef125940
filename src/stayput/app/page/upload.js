// A record of the user's own: dropped on the page or chosen, sent to the server, shown, used.

import * as api from "./api.js";
import { choice, oneOf } from "./controls.js";
import { el, fill, part } from "./dom.js";
import { inNumbers, picture } from "./record.js";
import { firstByName, isLost, lettersOf, linkedOf, LONGEST, motionOf, ofFurther, whole } from "./linked_record.js";
import { worded } from "./refusals.js";
import { FURTHER, change, current, furtherOf } from "./scene.js";
import { spoken, t } from "./words.js";

const UNITS = ["m/s²", "cm/s²", "gal", "mm/s²", "g", "%g", "mg", "in/s²", "ft/s²"];
let waiting = null,
  preview = null,
  trouble = null,
  shown = null, // the record that stands there
  latest = null; // the file that was sent last, which may be sent again without its mean

/** Whether a dropped file is a scenario, by its name. */
const isScenario = ({ name }) => /\.toml$/i.test(name);

/** Wires the file field and the place to drop files on; "takeScenario" is called with a scenario file. */
export function wire(takeScenario) {
  const drop = part("drop"),
    field = part("file");
  const take = (files) => {
    if (!files.length) return;
    waiting?.abort();
    const scenario = files.find(isScenario);
    if (scenario) takeScenario(scenario);
    else send(files);
  };
  field.addEventListener("change", () => {
    take([...field.files]);
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
    take([...event.dataTransfer.files]);
  });
  for (const name of ["dragover", "drop"]) addEventListener(name, (event) => event.preventDefault());
}

/** Sends files to the server, and takes those of one record together: the first horizontal one by name shakes the piece. */
async function send(files, said = {}) {
  waiting?.abort();
  waiting = new AbortController();
  tell(() => [el("p", { role: "status", text: t("sending") })]);
  const sent = [];
  let file;
  try {
    for (file of files.toSorted((one, other) => (one.name < other.name ? -1 : 1)))
      sent.push({ file, motion: await api.upload(file, said, waiting.signal) });
    sent.sort((one, other) => vertical(one.motion) - vertical(other.motion));
    const [{ motion }] = sent;
    latest = { id: motion.id, file: sent[0].file, said };
    if (vertical(motion) && !ofRecord(current().record, motion)) tell(() => offering(motion, sent[0].file));
    else await take(sent);
  } catch (error) {
    if (error.name === "AbortError") return;
    tell(() => [refusal(worded(error, "unreadable")), still(current()), asking(file, said, error)]);
  }
}

/** Takes files that were sent: into the record in use where they are of it, else the first as a record, with those that are of it. */
async function take(sent) {
  const { record } = current(),
    goesOn = sent.every(({ motion }) => FURTHER.includes(ofRecord(record, motion))),
    begun = goesOn ? record : { ...whole(sent[0].motion, await lettersOf(sent[0].file)), file: sent[0].file.name },
    further = {},
    others = [];
  for (const { motion, file } of goesOn ? sent : sent.slice(1)) {
    const part = ofRecord(begun, motion);
    if (FURTHER.includes(part)) further[part] = await component(motion, file, { ...begun, ...further });
    else others.push(motion.name);
  }
  trouble = null;
  await use(firstByName({ ...begun, ...further, others }), goesOn ? {} : undefined);
}

/** Which component of a record a file holds, "x" being that which shakes the piece; null where they do not say that they are of one. */
function ofRecord(record, motion) {
  if (!motion.record || motion.record !== record?.motion.record) return null;
  if (vertical(motion)) return "vertical";
  return motion.channels[0].name === record.motion.channels[0].name ? "x" : "across";
}

/** A further component of a record, with what a link has place for beside the others of it. */
async function component(motion, file, beside) {
  const others = [beside, ...FURTHER.map((part) => beside[part])].filter(Boolean),
    room = others.reduce((left, { letters }) => left - (letters?.length ?? LONGEST), LONGEST);
  return { ...whole(motion, room > 0 ? await lettersOf(file, room) : null), file: file.name };
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
    el("button", { type: "button", text: t("sendAgain"), onclick: () => send([file], { ...said, ...values() }) }),
  );
}

/** Says that the server no longer has the record. */
const lost = () => tell(() => [refusal([t("recordGone", { name: "" })])]);

/** The server has the record of a scene no more: it is sent again where the link holds it, else said to be gone. */
export const takeAgain = ({ record, ...scene }) =>
  takeLinked({ ...linkedOf(record), ...ofFurther(record, linkedOf) }, scene);

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

/** Takes the record of a link into the scene, with its further components or, where one is gone, with a notice; see `motionOf`. */
async function useLinked(linked) {
  const record = whole(await motionOf(linked), linked.letters);
  let gone = null;
  for (const part of FURTHER.filter((one) => linked[one])) {
    const one = linked[part],
      known = await motionOf(one).catch((error) => {
        if (!isLost(error, one)) throw error;
      });
    if (known) record[part] = whole(known, one.letters);
    else gone = { name: one.name, further: true };
  }
  await use(record);
  if (gone) change({ gone });
}

/** Whether a record holds a vertical component alone. */
const vertical = ({ channels: all }) => all.length > 0 && all.every((one) => one.vertical);

/** Offers a vertical record as what it is: the vertical component of the horizontal record in use. */
function offering(motion, file) {
  const { record } = current(),
    name = motion.name;
  if (!record) return [refusal([t("verticalAlone", { name })])];
  const onclick = async () => {
    const above = await component(motion, file, record);
    trouble = null;
    await use({ ...current().record, vertical: above }, {}).catch((error) => tell(() => [refusal(worded(error))]));
  };
  return [
    el("p", { role: "status", text: t("verticalOffered", { name, record: record.name }) }),
    el("button", { type: "button", text: t("takeVertical"), onclick }),
  ];
}

/** Takes a record that is on the server into the scene, as it is, with its further components. */
async function use(record, also = { scaled: false, onFloor: Boolean(record.motion.floor) }) {
  const { id, shaking } = record,
    further = furtherOf(record);
  const motion = Object.keys(further).length ? await api.motion(id, shaking.component, further) : record.motion;
  preview = null;
  change({ record: { ...record, motion }, gone: null, ...also });
  preview = await api.motionPreview(id, shaking.component).catch(() => null);
  update();
}

/** Takes another component of the record in use. */
async function turn(component) {
  const { record } = current();
  try {
    const motion = await api.motion(record.id, component);
    if (current().record?.id === motion.id) await use({ ...record, motion, shaking: motion.shaking }, {});
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

/** The further components that act: of files of their own, or a vertical one in the record's. */
function furtherComponents({ across, vertical: up, motion: { channels: all = [], components } }) {
  const above = up?.name ?? (components.includes("z") ? all.find((one) => one.vertical)?.name : null);
  const names = Object.entries({ withAcross: across?.name, withVertical: above });
  return names.filter(([, name]) => name).map(([key, name]) => el("p", { text: t(key, { name }) }));
}

/** What the server has to say of the record, with a button that sends it again less its mean where that would help. */
const warnings = ({ id, warnings: all }) =>
  (all ?? []).flatMap((one) => [
    el("p", { class: "refusal", text: spoken() === "ja" ? (one.message_ja ?? one.message) : one.message }),
    ...(one.field === "remove_mean" && latest?.id === id ? [lessItsMean()] : []),
  ]);

const lessItsMean = () => {
  const onclick = () => send([latest.file], { ...latest.said, remove_mean: "true" });
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
  return current().onFloor ? [field.element, el("p", { class: "hint", text: t("measuredNote") })] : [field.element];
}

/** What is known of the record in use, and the button that ends its use. */
function about(record) {
  const { motion } = record;
  return [
    el("p", {}, el("strong", { text: record.name }), ` ${inNumbers(motion)}`),
    channels(motion) ?? [],
    furtherComponents(record),
    record.others?.length ? refusal([t("otherRecords", { names: record.others.join(t("listed")) })]) : [],
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
