// How strong the earthquake is, by what people know of it, and what that amounts to; for any page with a scene.

import * as api from "./api.js";
import { choice, slider } from "./controls.js";
import { el, fill, settled } from "./dom.js";
import { worded } from "./refusals.js";
import { clamp, numberOf, wordsOf } from "./scene.js";
import { both, t } from "./words.js";

const WAYS = ["intensity", "mmi", "pga", "pgv", "sa", "earthquake"];
const SINGLE = ["mmi", "pga", "pgv"]; // those that are one number, whose field is called as the way
const MERCALLI = [4, 5, 6, 7, 8, 9, 10];
const GROUNDS = [600, 300, 180];

/** What each way begins with, as the shaking of a scene says it; of an intensity the page has its own fields. */
const FIRST = {
  intensity: null,
  mmi: { mmi: 8 },
  pga: { pga: 4 },
  pgv: { pgv: 0.4 },
  sa: { sa: { period: 0.3, value: 8 } },
  earthquake: { earthquake: { magnitude: 7, distance: 20, depth: 10, kind: "crustal", vs30: 300 } },
};

/** By which way an entry says it: one of WAYS; null is an intensity. */
const wayOf = (entry) => (entry ? Object.keys(entry)[0] : "intensity");

/**
 * Builds the entry in an element, and returns {update()}, which is to be called after every change of the scene.
 * get() and set(entry) read and change the entry: {mmi}, {pga}, {pgv}, {sa: {…}} or {earthquake: {…}}, null for an
 * intensity. scene() is what the server is asked of: a whole scene as it reads it.
 */
export function build(container, { get, set, presets, scene }) {
  const quake = () => get()?.earthquake ?? FIRST.earthquake.earthquake;
  const spectral = () => get()?.sa ?? FIRST.sa.sa;
  const turn = (part) => set({ earthquake: { ...quake(), ...part } });
  const number = (name, also) => slider({ label: t(name), ...numberOf(presets, name), ...also });
  const way = choice({
    label: t("knownBy"),
    options: WAYS.map((id) => ({ id, label: t(id) })),
    changed: (id) => set(structuredClone(FIRST[id])),
  });
  const fields = {
    mmi: choice({
      label: t("mmi"),
      options: MERCALLI.map((id) => ({ id: String(id), label: t(`mmi_${id}`) })),
      changed: (id) => set({ mmi: Number(id) }),
    }),
    pga: number("pga", { step: 0.05, unit: "gal", factor: 100, changed: (pga) => set({ pga }) }),
    pgv: number("pgv", { step: 0.01, unit: "cm/s", factor: 100, changed: (pgv) => set({ pgv }) }),
    saPeriod: number("saPeriod", { step: 0.05, changed: (period) => set({ sa: { ...spectral(), period } }) }),
    sa: number("sa", { step: 0.1, unit: "gal", factor: 100, changed: (value) => set({ sa: { ...spectral(), value } }) }),
    magnitude: number("magnitude", { step: 0.1, changed: (magnitude) => turn({ magnitude }) }),
    distance: number("distance", { step: 1, changed: (distance) => turn({ distance }) }),
    depth: number("depth", { step: 1, changed: (depth) => turn({ depth }) }),
    kind: choice({
      label: t("quakeKind"),
      options: wordsOf(presets, "quakeKind").map((id) => ({ id, label: t(`kind_${id}`) })),
      changed: (kind) => turn({ kind }),
    }),
    vs30: choice({
      label: t("groundKind"),
      options: GROUNDS.map((id) => ({ id: String(id), label: t(`ground_${id}`) })),
      changed: (vs30) => turn({ vs30: Number(vs30) }),
    }),
  };
  const amounts = el("p", { class: "meaning amounts", role: "status" }),
    source = el("p", { class: "hint" });
  let asked = null,
    waiting = null;

  const ask = settled(300, async () => {
    waiting?.abort();
    const own = (waiting = new AbortController());
    try {
      const said = await api.shaking({ scene: scene() }, own.signal);
      fill(amounts, both(said.sentence));
      fill(source, said.about ? both(said.about) : "");
    } catch (error) {
      if (error.name === "AbortError") return;
      asked = null; // the next change asks again, though it be of nothing that matters here
      fill(amounts, worded(error));
      fill(source);
    }
  });

  function update() {
    const entry = get(),
      now = wayOf(entry);
    way.set(now);
    for (const name of SINGLE) {
      fields[name].element.hidden = name !== now;
      if (name === now) fields[name].set(name === "mmi" ? String(entry.mmi) : entry[name]);
    }
    fields.saPeriod.element.hidden = fields.sa.element.hidden = now !== "sa";
    fields.saPeriod.set(spectral().period);
    fields.sa.set(spectral().value);
    for (const name of Object.keys(quake())) {
      fields[name].element.hidden = now !== "earthquake";
      fields[name].set(name === "vs30" ? String(quake().vs30) : quake()[name]);
    }
    amounts.hidden = source.hidden = !entry;
    const shaking = JSON.stringify(scene().shaking);
    if (!entry || shaking === asked) return;
    asked = shaking;
    fill(amounts, t("asking"));
    fill(source);
    ask();
  }

  fill(container, way.element, ...Object.values(fields).map((one) => one.element), amounts, source);
  return { update };
}

/** The names of an entry's values, as the server's presets have them: "mmi", or "sa.period" and "sa.value". */
const namesOf = (way) => {
  const [first] = Object.values(FIRST[way] ?? {});
  return typeof first === "object" ? Object.keys(first).map((key) => `${way}.${key}`) : [way];
};

/** An entry as text for a link: "mmi:8", "sa:0.3;8", "earthquake:7;20;10;crustal;300"; "" for an intensity. */
export function written(entry) {
  if (!entry) return "";
  const [[way, value]] = Object.entries(entry);
  return `${way}:${Object.values(typeof value === "object" ? value : [value]).join(";")}`;
}

/** The entry of a link's text; null, an intensity, where it makes no sense. */
export function fromText(text, presets) {
  const [way, rest = ""] = (text ?? "").split(":"),
    texts = rest.split(";"),
    names = namesOf(way);
  if (way === "intensity" || !WAYS.includes(way) || texts.length !== names.length) return null;
  const values = names.map((name, i) => valueOf(name, texts[i], presets));
  if (values.includes(null)) return null;
  const keys = Object.keys(Object.values(FIRST[way])[0]);
  return { [way]: keys.length ? Object.fromEntries(keys.map((key, i) => [key, values[i]])) : values[0] };
}

/** One of the values of a link's text within its range, or null. */
function valueOf(name, text, presets) {
  if (name === "earthquake.kind") return wordsOf(presets, "quakeKind").includes(text) ? text : null;
  if (text === "" || !Number.isFinite(Number(text))) return null;
  const { low, high } = presets.numbers[`shaking.${name}`],
    value = clamp(Number(text), [low, high]);
  if (name === "mmi") return clamp(Math.round(value), [MERCALLI[0], MERCALLI.at(-1)]);
  return name === "earthquake.vs30" && !GROUNDS.includes(value) ? FIRST.earthquake.earthquake.vs30 : value;
}
