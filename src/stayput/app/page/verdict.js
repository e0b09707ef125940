// The verdict in plain words with its probability, and ten small pieces that show it.

import { el, fill, part, svg } from "./dom.js";
import { measureOf } from "./panel_measures.js";
import { grade } from "./ranking.js";
import { both, chance, deviceName, length, number, share, t, within } from "./words.js";

const LIKELY = 0.02;

/** The options that the reader looks at: without a measure, and with those in place. */
export const without = (verdict) => verdict.options.find((one) => one.measures.length === 0);
export const yours = (verdict) => verdict.options.find((one) => one.yours && one.measures.length > 0) ?? null;

/** Writes the verdict. */
export function show(verdict) {
  const pair = [without(verdict), yours(verdict)].filter(Boolean);
  const single = verdict.motions === 1;
  const texts = pair.map((one, i) => {
    const p = one.probabilities.overturned;
    if (p.estimate === null) return t("chanceUnknown", { measures: t(i > 0 ? "with" : "without") });
    return t(i > 0 ? "chanceWith" : single ? "chanceOfRecord" : "chanceWithout", {
      share: chance(p),
      measures: within(one.label),
    });
  });
  fill(
    part("verdict"),
    ...texts.map((text, i) => el("span", { class: "sentence", text }, grade(pair[i]))),
    verdict.left_out ? el("span", { class: "sentence", text: both(verdict.left_out) }) : [],
  );
  fill(
    part("tens"),
    ...pair.map((one, i) => tens(one.probabilities.overturned, t(i === 0 ? "without" : "with"))).filter(Boolean),
  );
  fill(
    part("also"),
    ...pair.map((one, i) => also(one, t(i === 0 ? "without" : "with"), verdict)).filter(Boolean),
    ...verdict.notes.map((note) => el("li", { class: "hint", text: both(note) })),
  );
  part("basis").textContent = t(single ? "basisOfRecord" : "basis", {
    motions: number(Math.min(verdict.motions, Math.max(...verdict.options.map((one) => one.runs)))),
    runs: number(verdict.runs),
    seconds: number(verdict.seconds, 1),
  });
}

/** What else is likely: sliding far, a device that fails, things that come out, measures as people install them. */
function also(one, title, verdict) {
  const sentences = [],
    { slid } = one.probabilities;
  if (slid.estimate >= LIKELY)
    sentences.push(t("alsoSlides", { limit: length(verdict.slide_limit_m), share: share(slid) }));
  const worst = new Map(); // of devices of a kind that which fails most often
  for (const each of one.devices)
    if (!(worst.get(each.type)?.failed.estimate >= each.failed.estimate)) worst.set(each.type, each);
  for (const { type, name, failed } of worst.values())
    if (failed.estimate >= LIKELY) {
      const device = deviceName(within(measureOf(type).label), name.replace(type, "").trim());
      sentences.push(t("alsoFails", { device, share: share(failed) }));
    }
  sentences.push(...one.asides.map(both));
  return sentences.length ? el("li", { text: `${title}${t("colon")}${sentences.join(t("space"))}` }) : null;
}

/** Ten pieces: as many fallen, and as many standing, as the interval leaves no doubt of; the others pale. */
function tens(one, title) {
  if (one.estimate === null) return null;
  const fallen = Math.floor(10 * one.low),
    may = Math.ceil(10 * one.high),
    pieces = [];
  for (let i = 0; i < 10; i++) {
    const x = 4 + i * 26;
    pieces.push(
      i < may
        ? svg("path", { class: i < fallen ? "fell" : "fell unsure", d: `M${x} 30h22v8h-22z` })
        : svg("path", { class: "stood", d: `M${x + 7} 8h9v30h-9z` }),
    );
  }
  return el(
    "figure",
    { class: "tens" },
    svg(
      "svg",
      { viewBox: "0 0 264 44", role: "img", "aria-label": t("tens", { title, share: share(one) }) },
      ...pieces,
      svg("path", { class: "floorline", d: "M0 39.500H264" }),
    ),
    el("figcaption", { text: t("tens", { title, share: share(one) }) }),
  );
}
