// Single changes of the room, the best one first, each with its effect, its interval, and the button that makes it.

import { bar } from "../bars.js";
import { el, fill, part } from "../dom.js";
import { both, t } from "../words.js";
import { capital, chance, points } from "./amounts.js";
import { FACING } from "./geometry.js";
import { DEFAULTS } from "./kinds.js";
import * as room from "./room.js";


/** Lists the changes of a result. */
export function show(result) {
  part("changes-wait").hidden = result.complete;
  fill(
    part("ranking"),
    result.changes.map(option),
  );
}

function option(one) {
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

const apart = (one, other) => Math.abs(Math.atan2(Math.sin(one - other), Math.cos(one - other)));

/** Makes a change of a verdict in the room: one entry for undo. */
export function apply({ table, what, measures, at_m: at, heading_rad: heading }) {
  const before = room.current();
  const index = before[table].findIndex((one) => (one.name ?? one.kind ?? DEFAULTS.places.kind) === what);
  if (index < 0) return;
  const changed = { ...before[table][index] };
  if (measures) changed.measures = [...(changed.measures ?? []), ...[measures].flat()];
  else if (table === "places") Object.assign(changed, { at, heading });
  else toWall(changed, at, heading);
  room.change({ ...before, [table]: before[table].with(index, changed) });
  room.select({ table, index });
}

/** Puts a piece with its back to the wall that it faces away from; the gap is the usual one. */
function toWall(piece, [x, y], heading) {
  const [wall] = Object.entries(FACING).find(([, facing]) => apart(facing, heading) < 1e-3);
  for (const key of ["at", "heading", "gap"]) delete piece[key];
  Object.assign(piece, { against: wall, along: wall.endsWith("side_wall") ? x : y });
}
