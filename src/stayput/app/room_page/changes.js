// Single changes of the room, the best one first, each with its effect, its interval, and the button that makes it.

import { bar } from "../bars.js";
import { mayBe } from "./action_plan.js";
import { el, fill, part } from "../dom.js";
import { both, chance, number, t } from "../words.js";
import { capital, points } from "./amounts.js";
import { upright, wallBehind } from "./geometry.js";
import { DEFAULTS } from "./kinds.js";
import * as room from "./room.js";
import { noted } from "./tried.js";

const NEXT = 3; // so many follow those that help; the others are listed when they are asked for
let allShown = false;

/** Lists the changes of a result: those that help and the next few, or all where they have been asked for. */
export function show(result) {
  part("changes-wait").hidden = result.complete;
  const shown = shownOf(result),
    possible = result.changes.filter(mayBe),
    first = possible.findLastIndex(({ helps }) => helps) + 1 + NEXT,
    cut = !allShown && possible.length > first + 1;
  const options = possible.slice(0, cut ? first : undefined).map((one) => option(one, shown));
  fill(part("ranking"), options);
  part("all-changes").hidden = !cut;
  part("all-changes").textContent = t("allChanges", { n: number(possible.length) });
  part("all-changes").onclick = () => {
    allShown = true;
    show(result);
    part("ranking").children[first].querySelector("button").focus();
  };
}

/** Whether a change is seen in one of its chances at all. */
const seen = (share, change) => share !== null && (share.estimate > 0 || change.estimate !== 0);

const tag = ({ better, worse, tags }) =>
  el("span", {
    class: worse.length ? "tag gradeC" : better.length ? "tag" : "tag unclear",
    text: tags.map(both).join(t("listed")),
  });

/** What the bars of all changes show, so that they can be compared: the worst that happens in the room as it is. */
function shownOf({ hit, shut_in: shut }) {
  if (hit.estimate > 0) return (one) => [t("somebodyHit"), one.hit];
  if (shut.estimate > 0) return (one) => [t("somebodyShutIn"), one.shut_in];
  return (one) => (one.overturned ? [t("itOverturns"), one.overturned] : [t("somebodyHit"), one.hit]);
}

function option(one, shown) {
  const label = both(one.label),
    { overturned, overturned_change: rarer, shut_in: shut, shut_in_change: freed } = one,
    [what, share] = shown(one);
  const effects = [
    t("hitChange", { share: chance(one.hit), by: points(one.hit_change) }),
    seen(shut, freed) ? t("shutChange", { share: chance(shut), by: points(freed) }) : "",
    seen(overturned, rarer)
      ? t("fallChange", { share: chance(overturned), by: points(rarer) })
      : "",
  ];
  return el(
    "li",
    { class: "option", "data-rank": one.rank },
    el("div", { class: "optionhead" }, el("strong", { text: `${number(one.rank)}. ${capital(label)}` }), tag(one)),
    el("span", { class: "barname", text: what }),
    el("div", { class: "optionbar" }, bar(share), el("span", { class: "share", text: chance(share) })),
    el("p", { class: "hint", text: effects.filter(Boolean).join(t("space")) }),
    el("button", {
      type: "button",
      "aria-label": t("tryThis", { name: label }),
      text: t("try"),
      onclick: () => apply(one),
    }),
  );
}

/** Makes a change of a verdict in the room: one entry for undo. */
export function apply({ table, what, measures, at_m: at, heading_rad: heading }) {
  const before = room.current();
  const index = before[table].findIndex((one) => (one.name ?? one.kind ?? DEFAULTS.places.kind) === what);
  if (index < 0) return;
  const changed = noted(before[table][index], measures ? "measures" : "place");
  if (measures) changed.measures = [...(changed.measures ?? []), ...[measures].flat()];
  else if (table === "places") Object.assign(changed, { at, heading });
  else toWall(changed, at, heading);
  room.change({ ...before, [table]: before[table].with(index, changed) });
  room.select({ table, index });
}

/** Puts a piece with its back to the wall that it faces away from; the gap is the usual one. */
function toWall(piece, [x, y], heading) {
  const wall = wallBehind(heading);
  for (const key of ["at", "heading", "gap"]) delete piece[key];
  Object.assign(piece, { against: wall, along: upright(wall) ? y : x });
}
