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
        ),
        el("p", { class: "hint", text: both(one.reason) }),
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
  );
}

function bar({ estimate, low, high }) {
  const at = (share) => (2 + 196 * share).toFixed(1);
  return svg(
    "svg",
    { viewBox: "0 0 200 18", class: "bar", preserveAspectRatio: "none", "aria-hidden": "true" },
    svg("rect", { class: "all", x: 2, y: 3, width: 196, height: 12 }),
    svg("rect", { class: "part", x: 2, y: 3, width: Math.max(0.5, 196 * estimate), height: 12 }),
    svg("path", { class: "whisker", d: `M${at(low)} 9H${at(high)}M${at(low)} 4V14M${at(high)} 4V14` }),
  );
}
