// How strong the earthquake is, by what people know of it, and what that amounts to; for any page with a scene.

import * as api from "./api.js";
import { choice, slider } from "./controls.js";
import { el, fill, settled } from "./dom.js";
import { worded } from "./refusals.js";
import { clamp, numberOf, wordsOf } from "./scene.js";
import { both, t } from "./words.js";

const WAYS = ["intensity", "mmi", "pga", "pgv", "sa", "earthquake"];
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
    for (const name of ["mmi", "pga", "pgv"]) {
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

/** An entry as text for a link: "mmi:8", "sa:0.3;8", "earthquake:7;20;10;crustal;300"; "" for an intensity. */
export const written = (entry) =>
  entry
    ? `${wayOf(entry)}:${Object.values(entry).flatMap((one) => (typeof one === "object" ? Object.values(one) : [one])).join(";")}`
    : "";

/** The entry of a link's text; null, an intensity, where it makes no sense. */
export function fromText(text, presets) {
  const [way, rest = ""] = (text ?? "").split(":"),
    values = rest.split(";");
  const within = (name, value) => {
    const { low, high } = presets.numbers[`shaking.${name}`];
    return value !== "" && Number.isFinite(Number(value)) ? clamp(Number(value), [low, high]) : null;
  };
  if (way === "mmi") {
    const mmi = within("mmi", values[0]);
    return mmi === null ? null : { mmi: clamp(Math.round(mmi), [MERCALLI[0], MERCALLI.at(-1)]) };
  }
  if (way === "pga" || way === "pgv") {
    const peak = within(way, values[0]);
    return peak === null ? null : { [way]: peak };
  }
  if (way === "sa") {
    const [period, value] = [within("sa.period", values[0]), within("sa.value", values[1] ?? "")];
    return period === null || value === null ? null : { sa: { period, value } };
  }
  if (way !== "earthquake" || values.length !== 5) return null;
  const [magnitude, distance, depth, , vs30] = ["magnitude", "distance", "depth", "kind", "vs30"].map((name, i) =>
    name === "kind" ? null : within(`earthquake.${name}`, values[i]),
  );
  if ([magnitude, distance, depth].includes(null) || !wordsOf(presets, "quakeKind").includes(values[3])) return null;
  const ground = GROUNDS.includes(vs30) ? vs30 : FIRST.earthquake.earthquake.vs30;
  return { earthquake: { magnitude, distance, depth, kind: values[3], vs30: ground } };
}
