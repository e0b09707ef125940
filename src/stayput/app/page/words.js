// The page's language: one table of words for each, chosen at the start and switched at any time.

import { TABLES } from "./words_table.js"; // made by the server from its catalogue

let language = "en";

/** The languages there are. */
export const LANGUAGES = Object.keys(TABLES);

/** The language now: "en" or "ja". */
export const spoken = () => language;

/** Chooses a language and puts its words into the page. */
export function speak(wanted) {
  language = LANGUAGES.includes(wanted) ? wanted : "en";
  document.documentElement.lang = language;
  document.title = t("title");
  translate(document);
}

/** The language that the reader's browser asks for, of those there are. */
export const preferredLanguage = () =>
  (navigator.languages ?? []).map((tag) => tag.slice(0, 2)).find((tag) => LANGUAGES.includes(tag)) ?? "en";

/** The words for a key; "{name}" in them is replaced by the value of that name. */
export function t(key, values = {}) {
  const text = TABLES[language][key] ?? TABLES.en[key] ?? key;
  return text.replace(/\{(\w+)\}/g, (whole, name) => (name in values ? values[name] : whole));
}

/** Whether there are words for a key. */
export const known = (key) => key in TABLES[language];

/** Of a text in both languages, as the server sends them, the one that is spoken. */
export const both = (pair) => (typeof pair === "string" ? pair : (pair?.[language] ?? pair?.en ?? ""));

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
  value.toLocaleString(language, { minimumFractionDigits: decimals, maximumFractionDigits: decimals });

/** A length in the unit that people use for it. */
export const length = (metres) =>
  Math.abs(metres) >= 1
    ? `${number(metres, 2)}\u00a0m`
    : `${number(100 * metres, Math.abs(metres) < 0.1 ? 1 : 0)}\u00a0cm`;

/** A share as a whole percentage, never 0 or 100 where it is not quite that; words where it is not known. */
export function percent(share) {
  if (share === null || share === undefined) return t("notKnown");
  if (share > 0 && share < 0.01) return language === "ja" ? "1%未満" : "under 1\u00a0%";
  if (share < 1 && share > 0.99) return language === "ja" ? "99%超" : "over 99\u00a0%";
  return language === "ja" ? `${Math.round(100 * share)}%` : `${Math.round(100 * share)}\u00a0%`;
}
