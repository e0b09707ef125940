// What helps most: every option with its chance of overturning, the interval, and why it stands there.

import { bar } from "./bars.js";
import { el, fill, part } from "./dom.js";
import { both, brief, t } from "./words.js";

/** What an option is called. */
export const nameOf = (one) => (one.measures.length ? both(one.label) : t("without"));

/** Lists the options, the best first; "take" puts an option's measures in place. */
export function show(verdict, take) {
  fill(
    part("ranking"),
    verdict.options.map((one) =>
      el(
        "li",
        { class: one.yours ? "option yours" : "option", "data-rank": one.rank },
        el(
          "div",
          { class: "optionhead" },
          el("strong", { text: nameOf(one) }),
          one.yours ? el("span", { class: "tag", text: t("inPlace") }) : null,
        ),
        el(
          "div",
          { class: "optionbar" },
          bar(one.probabilities.overturned),
          el("span", { class: "share", text: brief(one.probabilities.overturned) }),
          grade(one, one.grade),
        ),
        el("p", { class: "hint", text: both(one.reason) }),
        one.yours
          ? null
          : el("button", {
              type: "button",
              "aria-label": t("tryThis", { name: nameOf(one) }),
              text: t("try"),
              onclick: () => take(one.measures),
            }),
      ),
    ),
    verdict.not_possible.map((one) =>
      el(
        "li",
        { class: "option impossible" },
        el(
          "div",
          { class: "optionhead" },
          el("strong", { text: both(one.label) }),
          el("span", { class: "tag", text: t("not_possible") }),
        ),
        el("p", { class: "hint", text: both(one.reason) }),
      ),
    ),
  );
  part("grades").textContent = Object.entries(verdict.grades)
    .map(([letter, meaning]) => `${letter}${t("colon")}${both(meaning)}`)
    .join(t("listed"));
}

/** How well founded an option's number is: the grade of its weakest inputs, which are named where one points. */
export function grade(one, text = t("grade", { grade: one.grade })) {
  const weakest = one.weakest.map(both).join(t("listed"));
  const meaning = t("gradeOf", { grade: one.grade, inputs: weakest });
  return el("span", { class: `tag grade${one.grade}`, title: meaning, text });
}
