// Two rooms side by side, under the same shaking and with the same random numbers; worked out one after the other.

import * as api from "../api.js";
import { el, fill, part, svg } from "../dom.js";
import { worded } from "../refusals.js";
import { both, chance, share, t } from "../words.js";
import { line } from "../verification.js";
import { basis, capital, points } from "./amounts.js";
import { ofRoom } from "./judging.js";
import { kindName } from "./kinds.js";
import { drawPlan } from "./plan.js";

const STACKED = "(max-width: 39.99rem)", // where the style sheet puts the rooms below each other
  TOLD = ["hit", "shut"]; // which rows are also said in a sentence
const jobs = line(api.room);
let sides = [],
  round = 0;

/** Compares two of the rooms that are kept: the second under what shakes the first. */
export async function compare(scenes) {
  const mine = ++round,
    { shaking, uncertainty, direction } = scenes[0].room;
  sides = scenes.map(({ name, room }) => ({
    name,
    room: { ...room, shaking, uncertainty, ...(direction === undefined ? {} : { direction }) },
    result: null,
    error: null,
  }));
  show();
  for (const side of sides) {
    const take = (job) => {
      if (mine !== round || !job.result) return;
      side.result = ofRoom(job.result);
      show();
    };
    try {
      const job = await jobs.run({ scene: side.room, changes: false }, take);
      if (mine !== round || !job) return;
      take(job);
    } catch (error) {
      if (mine !== round) return;
      side.error = error;
      show();
    }
  }
}

/** Writes the comparison; called again for another language. */
export function show() {
  part("comparison").hidden = !sides.length;
  if (!sides.length) return;
  fill(
    part("comparison"),
    el("h3", { text: t("compareTitle") }),
    el("p", { class: "hint", text: t("compareNote") }),
    el("div", { class: "pairs" }, ...sides.map(column)),
    ...numbers(),
    el("button", { type: "button", text: t("compareEnd"), onclick: end }),
  );
}

function end() {
  round += 1;
  jobs.stop();
  sides = [];
  show();
}

/** One room: its plan and its verdict. */
function column({ name, room, result, error }) {
  const picture = svg("svg"),
    own = part("comparison").clientWidth / (matchMedia(STACKED).matches ? 1 : 2);
  const { size } = drawPlan(picture, room, { result, readOnly: true, wide: Math.max(300, own - 48) });
  picture.style.maxWidth = `${size[0]}px`; // its letters grow no larger than they are
  picture.setAttribute("aria-label", t("planOf", { name }));
  return el(
    "section",
    { "aria-label": name },
    el("h4", { text: name }),
    picture,
    error
      ? el("p", { class: "refusal" }, ...worded(error))
      : el("p", result ? { text: both(result.verdict) } : { class: "hint", role: "status", text: t("thinking") }),
  );
}

/** Which is better in what, and all chances of both in rows, once both are known. */
function numbers() {
  const [first, second] = sides;
  if (!first.result || !second.result) return [];
  const rows = joined(chances(first.result), chances(second.result));
  const head = [t("compareWhat"), first.name, second.name, t("compareDifference")];
  const told = rows.filter(([key]) => TOLD.includes(key)).map(([, name, one, other]) => sentence(name, one, other));
  return [
    el("div", { id: "compared", role: "status" }, ...told.map((text) => el("p", { class: "lead", text }))),
    el("div", { class: "scrolled", tabindex: 0, role: "group", "aria-label": t("compareTitle") },
      el("table", {},
        el("thead", {}, el("tr", {}, ...head.map((text) => el("th", { scope: "col", text })))),
        el("tbody", {}, ...rows.map(([, name, one, other]) => row(name, one, other))),
      ),
    ),
    el("p", { class: "hint", text: t("compareUnpaired") }),
    ...sides.map(({ name, result }) => el("p", { class: "hint", text: t("basisOf", { name, basis: basis(result) }) })),
  ];
}

const row = (name, one, other) =>
  el("tr", {},
    el("th", { scope: "row", text: capital(name) }),
    el("td", { text: one ? chance(one) : t("notThere") }),
    el("td", { text: other ? chance(other) : t("notThere") }),
    el("td", { text: one && other && known(one, other) ? points(between(one, other)) : "" }),
  );

const known = (one, other) => one.estimate !== null && other.estimate !== null;

/** What happens in the second room beside the first, and how sure it is that they differ. */
function sentence(name, one, other) {
  const [a, b] = sides.map((side) => side.name);
  if (!known(one, other)) return "";
  const difference = between(one, other),
    clear = difference.low > 0 || difference.high < 0;
  if (!clear) return t("compareAlike", { what: name, a, b });
  return t("compareSaid", {
    what: name,
    b,
    first: share(one),
    second: share(other),
    by: points(difference),
  });
}

/** The chances of a verdict: key, name, chance. */
const chances = (result) => [
  ["hit", t("somebodyHit"), result.hit],
  ["shut", t("somebodyShutIn"), result.shut_in],
  ...result.places.map((one) => [`place ${one.name}`, t("hitAt", { place: kindName("places", one.name) }), one.hit]),
  ...result.doors.map((one) => [`door ${one.name}`, t("doorBlocked", { door: kindName("doors", one.name) }), one.blocked]),
  ...result.pieces.map((one) => [
    `piece ${one.name}`,
    t("pieceFalls", { piece: kindName("furniture", one.name) }),
    one.probabilities.overturned,
  ]),
];

/** Rows of both rooms, [key, name, chance in the first, chance in the second]; null where it is in one of them only. */
function joined(first, second) {
  const all = new Map(first.map(([key, name, share]) => [key, [key, name, share, null]]));
  for (const [key, name, share] of second) all.set(key, [key, name, all.get(key)?.[2] ?? null, share]);
  return [...all.values()];
}

/**
 * The second chance less the first with the 95 % interval of two chances that were counted apart, from the intervals of
 * both: R. G. Newcombe, Interval estimation for the difference between independent proportions, Statistics in Medicine
 * 17 (1998), 873-890, method 10.
 */
function between(one, other) {
  const estimate = other.estimate - one.estimate;
  return {
    estimate,
    low: estimate - Math.hypot(other.estimate - other.low, one.high - one.estimate),
    high: estimate + Math.hypot(other.high - other.estimate, one.estimate - one.low),
  };
}
