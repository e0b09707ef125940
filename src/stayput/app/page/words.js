// The page's language: one table of words for each, chosen at the start and switched at any time.

import { rounded } from "./canvas/digits.js";
import { TABLES } from "./words_table.js"; // made by the server from its catalogue

let language = "en";

/** The language now: "en" or "ja". */
export const spoken = () => language;

/** Chooses a language, and puts its words into the page. */
export function speak(wanted) {
  language = wanted in TABLES ? wanted : "en";
  document.documentElement.lang = language;
  translate(document);
}

/** The language that the reader's browser asks for, of those there are. */
export const preferredLanguage = () =>
  (navigator.languages ?? []).map((tag) => tag.slice(0, 2)).find((tag) => tag in TABLES);

/** The words for a key; "{name}" in them is replaced by the value of that name. */
export function t(key, values = {}) {
  const text = TABLES[language][key] ?? key;
  return tight(text.replace(/\{(\w+)\}/g, (whole, name) => (name in values ? values[name] : whole)));
}

/** Whether there are words for a key. */
const known = (key) => key in TABLES[language];

/** The words of a kind for an id; itself where there are none. */
const labelled = (kind, id) => (known(`${kind}_${id}`) ? t(`${kind}_${id}`) : id);

/** The words for one of the choices that a field has. */
export const choiceLabel = (id) => labelled("choice", id);

/** The words for where a device is: "front left"; of many of a kind each has a number, "front 3". */
const placeLabel = (place) => {
  if (known(`place_${place}`)) return t(`place_${place}`);
  const words = place.split(" ");
  // that of a joint is the names of two pieces, which are the user's own
  const ours = words.every((word) => known(`place_${word}`) || /^\d+$/.test(word));
  return ours ? words.map((word) => labelled("place", word)).join(t("space")) : place;
};

/** What a device is called, and where it is. */
export const deviceName = (label, place) => [label, placeLabel(place)].filter(Boolean).join(t("comma"));

/** Of a text in both languages, as the server sends them, the one that is spoken. */
export const both = (pair) => tight(typeof pair === "string" ? pair : (pair?.[language] ?? pair?.en ?? ""));

/** A text whose lines do not end between a number and its unit. */
const tight = (text) => text.replace(/(\d) (?=(?:%|[ck]?m|kg|k?N|Hz|s|m\/s²|cm\/s)(?![\w/]))/g, "$1\u00a0");

/** The same of a measure's label as it stands within a sentence: English begins it small, "L-brackets" apart. */
export const within = (pair) =>
  language === "en"
    ? both(pair).replace(/(^| \+ )([A-Z])(?=[a-z])/g, (_, joint, first) => joint + first.toLowerCase())
    : both(pair);

/** Puts words into the elements marked with data-t, and into the labels marked with data-t-label. */
export function translate(root) {
  for (const element of root.querySelectorAll("[data-t]")) element.textContent = t(element.dataset.t);
  for (const element of root.querySelectorAll("[data-t-label]"))
    element.setAttribute("aria-label", t(element.dataset.tLabel));
}

/** A number so many decimals long, as the language writes it. */
export const number = (value, decimals = 0) =>
  rounded(value, decimals).toLocaleString(language, {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
  });

/** A length in the unit that people use for it. */
export const length = (metres) =>
  Math.abs(metres) >= 1
    ? `${number(metres, 2)}\u00a0m`
    : `${number(100 * metres, Math.abs(metres) < 0.1 ? 1 : 0)}\u00a0cm`;

/** A number as a percentage. */
export const perCent = (text) => (language === "ja" ? `${text}%` : `${text}\u00a0%`);

/** A share in per cent, without the last digits of a difference: 0.8 − 0.025 is 77.5, to be rounded as the server does. */
export const inPercent = (share) => Math.round(1e9 * share) / 1e7;

/**
 * A share as a percentage, finer below 1 and above 99 as in the server's sentences; never 0 or 100 where it is not
 * quite that; words where it is not known.
 */
export function percent(share) {
  if (share === null || share === undefined) return t("notKnown");
  const value = inPercent(share);
  if (value > 0 && value < 0.05) return t("under", { share: perCent("0.1") });
  if (value > 99.95 && value < 100) return t("over", { share: perCent("99.9") });
  const fine = (value > 0 && value < 0.95) || (value > 99.05 && value < 100);
  return perCent(number(value, fine ? 1 : 0));
}

const UNITS = [1, 5, 10]; // of rounded chances, in per cent
const WIDE = 25; // half-width of an interval above which its ends are told, in per cent

/** A share rounded up to whole per cent, or to tenths below 1 %. */
const upwards = (value) => (value > 1 ? Math.ceil(value) : Math.ceil(Math.round(1e7 * value) / 1e6) / 10);

/** How finely a chance may be told for its interval, by the rule of the server's sentences (`Probability.brief`). */
function told({ estimate: share, low: least, high: most }) {
  const [estimate, low, high] = [share, least, most].map(inPercent),
    width = inPercent((most - least) / 2);
  if (width === 0) return ["exactly", percent(share)];
  if (width > WIDE && estimate > 0 && estimate < 100) return ["between"];
  for (const unit of UNITS.filter((_, i) => !(UNITS[i - 1] >= width)).reverse()) {
    const near = unit * Math.floor(Math.round((1e7 * estimate) / unit) / 1e7 + 0.5);
    if ([0, 100].includes(near) || Math.abs(near - estimate) > Math.min(estimate, 100 - estimate) / 2) break;
    if (low <= near && near <= high) return ["about", perCent(near)];
  }
  if (estimate < 50) return ["under", perCent(upwards(high))];
  return ["over", perCent(Math.round(1000 - 10 * upwards(100 - low)) / 10)];
}

const isKnown = ({ estimate, low }) => ![estimate ?? null, low ?? null].includes(null);

/** An interval: "61 to 88 %". */
const ends = ({ low, high }) =>
  t("shareBetween", { low: percent(low).replace(/\u00a0?%/, ""), high: percent(high) });

/** A chance in words, as finely as its interval allows: "about 80 %", "under 9 %", "8 to 75 %". */
export function share(one) {
  if (!isKnown(one)) return percent(one.estimate);
  const [kind, text] = told(one);
  return kind === "between" ? ends(one) : kind === "exactly" ? text : t(kind, { share: text });
}

/** The same in few letters: "75 %", "<9 %", "8–75 %". */
export function brief(one) {
  if (!isKnown(one)) return percent(one.estimate);
  const [kind, text] = told(one);
  return kind === "between" ? ends(one).replace(/ to |～/, "–") : `${{ under: "<", over: ">" }[kind] ?? ""}${text}`;
}

/** The same in words with its interval, where that tells more: "about 80 % (61 to 88 %)". */
export const chance = (one) =>
  isKnown(one) && told(one)[0] === "about" ? t("chanceBetween", { share: share(one), ends: ends(one) }) : share(one);
