// Single changes of the room, the best one first, each with its effect, its interval, and the button that makes it.

import { bar } from "../bars.js";
import { el, fill, part } from "../dom.js";
import { both, t } from "../words.js";
import { capital, chance, points } from "./amounts.js";

/** Lists the changes of a result; "apply" makes one in the room. */
export function show(result, apply) {
  part("changes-wait").hidden = result.complete;
  fill(
    part("ranking"),
    result.changes.map((one) => option(one, apply)),
  );
}

function option(one, apply) {
  const label = both(one.label),
    tag = one.helps ? t("helps") : t("unclear");
  return el(
    "li",
    { class: "option" },
    el(
      "div",
      { class: "optionhead" },
      el("strong", { text: capital(label) }),
      el("span", { class: one.helps ? "tag" : "tag gradeC", text: tag }),
    ),
    el("div", { class: "optionbar" }, bar(one.hit), el("span", { class: "share", text: chance(one.hit) })),
    el("p", {
      class: "hint",
      text: [
        t("hitChange", { by: points(one.hit_change) }),
        one.shut_in.estimate > 0 || one.shut_in_change.estimate !== 0
          ? t("shutChange", { share: chance(one.shut_in), by: points(one.shut_in_change) })
          : "",
      ]
        .filter(Boolean)
        .join(t("space")),
    }),
    el("button", {
      type: "button",
      "aria-label": t("makeThis", { change: label }),
      text: t("make"),
      onclick: () => apply(one),
    }),
  );
}
