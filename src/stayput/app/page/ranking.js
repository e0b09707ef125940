// What helps most: every option with its chance of overturning, the interval, and why it stands there.

import { el, fill, part, svg } from "./dom.js";
import { both, percent, t } from "./words.js";

/** Lists the options, the best first; "take" puts an option's measures in place. */
export function show(verdict, take) {
  fill(
    part("ranking"),
    verdict.options.map((one) =>
      el(
        "li",
        { class: one.yours ? "option yours" : "option" },
        el(
          "div",
          { class: "optionhead" },
          el("strong", { text: one.measures.length ? both(one.label) : t("without") }),
          one.yours ? el("span", { class: "tag", text: t("inPlace") }) : null,
        ),
        el(
          "div",
          { class: "optionbar" },
          bar(one.overturned),
          el("span", { class: "share", text: percent(one.overturned.estimate) }),
          grade(one, one.grade),
        ),
        el("p", { class: "hint", text: both(one.reason) }),
        one.as_installed ? el("p", { class: "hint", text: installed(one.as_installed) }) : null,
        one.yours
          ? null
          : el("button", {
              type: "button",
              "aria-label": t("tryThis", { name: one.measures.length ? both(one.label) : t("without") }),
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

/** How often it overturns as people install it, and what is wrong where it is badly done. */
const installed = ({ usual, badly_share: badly, how }) =>
  t("asInstalled", {
    share: percent(usual.overturned),
    badly: percent(badly),
    how: how.map(both).join(t("listed")),
  });

function bar({ estimate, low, high }) {
  const at = (share) => (2 + 196 * share).toFixed(1);
  const known = estimate !== null;
  return svg(
    "svg",
    { viewBox: "0 0 200 18", class: "bar", preserveAspectRatio: "none", "aria-hidden": "true" },
    svg("rect", { class: known ? "all" : "all unknown", x: 2, y: 3, width: 196, height: 12 }),
    known ? svg("rect", { class: "part", x: 2, y: 3, width: Math.max(0.5, 196 * estimate), height: 12 }) : null,
    known
      ? svg("path", { class: "whisker", d: `M${at(low)} 9H${at(high)}M${at(low)} 4V14M${at(high)} 4V14` })
      : null,
  );
}
