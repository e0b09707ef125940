// The scene in the page's address, so that a link shows it again.

import { fromText, written } from "./earthquake.js";
import { FURTHER, clamp, limitsOf, plain, wordsOf } from "./scene.js";

const round = (value) => String(Number(value.toPrecision(6)));
/** The keys of a scene whose values are of a type. */
const keysOf = (type) => Object.keys(plain).filter((key) => typeof plain[key] === type);
const NUMBERS = keysOf("number"),
  NAMES = keysOf("string"),
  FLAGS = keysOf("boolean"),
  WHOLE = ["storeys", "storey", "member", "drawers"],
  WORDS = ["wallConstruction", "ceilingConstruction", "base"];
const SAID = ["component", "unit", "dt", "remove_mean"];

/** What a link says of a record: its id and name, what was said of it when it was sent, and itself where it is small. */
const RECORD = ["record", "name", ...SAID, "wave"];

/** The same of a further component of it, of a file of its own. */
const further = (part) => [part, `${part}Name`, ...SAID.map((key) => `${part}_${key}`), `${part}Wave`];

function setRecord(pairs, keys, { id, name, shaking, letters }) {
  const values = [id, name, ...SAID.map((key) => shaking[key]), letters];
  keys.forEach((key, at) => values[at] !== undefined && values[at] !== null && pairs.set(key, values[at]));
}

/** The record {id, name, said, letters} of a link, or null. */
function recordIn(pairs, keys) {
  const [id, name, ...rest] = keys.map((key) => pairs.get(key)),
    letters = rest.pop();
  return id && { id, name: name ?? "", said: Object.fromEntries(SAID.map((key, at) => [key, rest[at]])), letters };
}

/** The scene as the part of an address after "#", and a file of several pieces {name, letters} that is shown instead. */
export function toHash(scene, file = null) {
  const pairs = new URLSearchParams();
  for (const name of NAMES) pairs.set(name, scene[name]);
  for (const name of NUMBERS) pairs.set(name, round(scene[name]));
  for (const name of FLAGS) pairs.set(name, scene[name] ? "1" : "0");
  if (scene.entry) pairs.set("entry", written(scene.entry));
  if (scene.shelves) pairs.set("shelves", scene.shelves.map(round).join(","));
  if (scene.record) setRecord(pairs, RECORD, scene.record);
  for (const part of FURTHER) if (scene.record?.[part]) setRecord(pairs, further(part), scene.record[part]);
  const measures = Object.entries(scene.measures).map(([type, settings]) =>
    [type, ...Object.entries(settings).map(([name, value]) => `${name}:${value}`)].join(";"),
  );
  if (measures.length) pairs.set("measures", measures.join(","));
  if (file) {
    pairs.set("file", file.name);
    pairs.set("pieces", file.letters);
  }
  return pairs.toString();
}

/** The value of a measure's parameter, or nothing where it makes no sense. */
function allowed(about, text) {
  if (about.choices?.length) return about.choices.includes(text) ? text : undefined;
  if (about.words?.includes(text)) return text;
  const value = Number(text);
  return Number.isFinite(value) ? clamp(value, [about.low, about.high]) : undefined;
}

function measured(text, presets) {
  const measures = {},
    taken = new Set();
  for (const piece of text.split(",")) {
    const [type, ...settings] = piece.split(";");
    const preset = presets.measures.find((one) => one.type === type);
    if (!preset || taken.has(preset.place)) continue;
    if (preset.place) taken.add(preset.place);
    measures[type] = {};
    for (const pair of settings) {
      const [name, value] = pair.split(":");
      const about = preset.parameters.find((one) => one.name === name);
      const checked = about && allowed(about, value);
      if (checked !== undefined) measures[type][name] = checked;
    }
  }
  return measures;
}

/** The scene, the record {id, name, said, letters} and the file of several pieces of an address; what is missing or makes no sense there is as in the scene given. */
export function fromHash(hash, presets, start) {
  const within = (value, name) => clamp(value, limitsOf(presets, name));
  const pairs = new URLSearchParams(hash.replace(/^#/, ""));
  const scene = { ...start };
  const lists = {
    piece: presets.furniture,
    floor: presets.surfaces,
    structure: presets.structures,
    family: presets.families,
    contents: presets.contents,
    doors: presets.doors,
    ...Object.fromEntries(WORDS.map((name) => [name, wordsOf(presets, name).map((id) => ({ id }))])),
  };
  if (!pairs.has("piece")) return { scene, record: null, file: null };
  for (const name of NAMES)
    if (lists[name].some((one) => one.id === pairs.get(name))) scene[name] = pairs.get(name);
  const preset = presets.furniture.find((one) => one.id === scene.piece);
  if (!pairs.has("length")) scene.length = preset.length_m;
  if (!pairs.has("base")) scene.base = preset.base;
  for (const name of NUMBERS) {
    const value = Number(pairs.get(name) ?? NaN);
    if (Number.isFinite(value)) scene[name] = WHOLE.includes(name) ? Math.round(within(value, name)) : within(value, name);
  }
  for (const name of FLAGS) if (pairs.has(name)) scene[name] = pairs.get(name) === "1";
  const loads = pairs.get("shelves")?.split(",").map(Number) ?? [];
  scene.shelves =
    loads.length && loads.every(Number.isFinite)
      ? loads.slice(0, 12).map((load) => within(load, "load"))
      : null;
  scene.measures = pairs.has("measures") ? measured(pairs.get("measures"), presets) : {};
  scene.entry = fromText(pairs.get("entry"), presets);
  scene.record = null;
  const record = recordIn(pairs, RECORD);
  const [file, several] = ["file", "pieces"].map((key) => pairs.get(key));
  return {
    scene,
    record: record && { ...record, ...Object.fromEntries(FURTHER.map((part) => [part, recordIn(pairs, further(part))])) },
    file: several ? { name: file ?? "", letters: several } : null,
  };
}
