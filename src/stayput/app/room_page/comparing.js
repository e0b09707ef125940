// Two rooms side by side, under the same shaking and with the same random numbers; worked out one after the other.

import * as api from "../api.js";
import { el, fill, part, svg } from "../dom.js";
import { worded } from "../refusals.js";
import { both, t } from "../words.js";
import { line } from "../verification.js";
import { basis, capital, chance } from "./amounts.js";
import { kindName } from "./kinds.js";
import { drawPlan } from "./plan.js";

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
      side.result = job.result;
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
    el("button", { type: "button", text: t("compareEnd"), onclick: end }),
  );
}

function end() {
  round += 1;
  jobs.stop();
  sides = [];
  show();
}

function column({ name, room, result, error }) {
  const picture = svg("svg");
  drawPlan(picture, room, { result, readOnly: true });
  picture.setAttribute("aria-label", t("planOf", { name }));
  return el(
    "section",
    { "aria-label": name },
    el("h4", { text: name }),
    picture,
    ...(error ? [el("p", { class: "refusal" }, ...worded(error))] : result ? numbers(result) : [waiting()]),
  );
}

const waiting = () => el("p", { class: "hint", role: "status", text: t("thinking") });

function numbers(result) {
  const rows = [
    [t("somebodyHit"), result.hit],
    ...result.places.map((one) => [t("hitAt", { place: kindName("places", one.name) }), one.hit]),
    [t("somebodyShutIn"), result.shut_in],
    ...result.doors.map((one) => [t("doorBlocked", { door: kindName("doors", one.name) }), one.blocked]),
  ];
  return [
    el("p", { text: both(result.verdict) }),
    el("dl", {}, ...rows.flatMap(([name, share]) => [el("dt", { text: capital(name) }), el("dd", { text: chance(share) })])),
    el("p", { class: "hint", text: basis(result) }),
  ];
}
