// What happens first, in words: the first event of each kind, which the animation jumps to.

import { el, fill, part } from "./dom.js";
import { both, deviceName, length, number, t } from "./words.js";

const TOLD = ["slip", "uplift", "wall impact", "ceiling impact", "overturned", "failed"];

/** The first event of each kind, in their order: {time, text}; "labels" are the server's names of the kinds. */
function story(run, labels) {
  const events = [];
  const seen = new Set(),
    names = run.pieces?.length > 1 ? run.pieces.map((one) => `${one.name}${t("colon")}`) : [];
  for (const { time_s: time, kind, piece } of run.events) {
    const what = `${kind} ${piece}`;
    if (!TOLD.includes(kind) || seen.has(what)) continue;
    seen.add(what);
    events.push({ time, text: `${names[piece] ?? ""}${both(labels[kind])}` });
  }
  for (const { label, place, failed, failure_time_s: time } of run.devices)
    if (failed && time !== null)
      events.push({ time, text: t("deviceFails", { device: deviceName(both(label), place) }) });
  return events.sort((a, b) => a.time - b.time);
}

/** Writes both runs' stories with the names of events; "seek" takes the time that the reader chose. */
export function tell(result, titles, events, seek) {
  const labels = Object.fromEntries(events.map((one) => [one.id, one.label]));
  fill(
    part("story"),
    result.runs.map((run, i) => {
      const events = story(run, labels);
      return el(
        "div",
        {},
        el("h4", { text: titles[i] }),
        events.length
          ? el(
              "ol",
              {},
              ...events.map(({ time, text }) =>
                el(
                  "li",
                  {},
                  el(
                    "button",
                    { type: "button", class: "jump", onclick: () => seek(time) },
                    el("span", { class: "when", text: `${number(time, 1)}\u00a0s` }),
                    ` ${text}`,
                  ),
                ),
              ),
            )
          : el("p", { text: t("nothing") }),
        el("p", { class: "hint", text: peaks(run) }),
      );
    }),
  );
}

function peaks(run) {
  const whose = run.pieces.length > 1 ? [] : run.pieces;
  const parts = whose
    .filter((one) => !one.overturned)
    .flatMap((one) => [
      t("peakTilt", { tilt: number((one.peak_tilt_rad * 180) / Math.PI, 1) }),
      t("peakSlide", { slide: length(one.peak_slide_m) }),
      ...(run.scene.from === "side"
        ? []
        : [t("turnedAtEnd", { yaw: number((Math.abs(one.residual_yaw_rad) * 180) / Math.PI, 1) })]),
    ]);
  for (const one of run.devices)
    parts.push(
      t(one.failed ? "deviceFailed" : one.utilisation ? "deviceLoad" : "deviceBore", {
        device: deviceName(both(one.label), one.place),
        force: number(Math.max(one.peak_pull_n, one.peak_push_n, one.peak_shear_n)),
        share: number(100 * one.utilisation),
        time: one.failed ? number(one.failure_time_s, 1) : "",
      }),
    );
  return parts.join(t("space"));
}

/** Colours the lines of a key, if it has any, by how firmly each piece of a scene stands at a time. */
export const colourFates = (key, { bodies }, now) =>
  key.querySelectorAll(".chip").forEach((chip, i) => (chip.style.background = `var(--${bodies[i].stands(now)})`));

/** A line of a key: a piece's name, what became of it and when, else "standing"; see `colourFates`. */
export function fate({ outcome, fall_time_s: fell, overturn_time_s: lay }, { name, outcomes, standing = null }) {
  const time = fell ?? lay,
    told = [outcomes[outcome], time === null ? standing : `${number(time, 1)}\u00a0s`].filter(Boolean);
  return el(
    "li",
    {},
    el("span", { class: "chip" }),
    el("span", { text: `${name}${t("colon")}${told.join(t("listed"))}` }),
  );
}
