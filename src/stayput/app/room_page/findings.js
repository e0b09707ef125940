// Who is hit and by what, which door stays shut, which piece does most harm: what the verdict rests on.

import { bar } from "../bars.js";
import { el, fill, part } from "../dom.js";
import { both, chance, number, perCent, share, t } from "../words.js";
import { capital, quantile } from "./amounts.js";
import { kindName } from "./kinds.js";

/** Writes all of them. */
export function show(result) {
  fill(part("who"), result.places.length ? result.places.map((one) => place(one, result)) : el("p", { text: t("noPlaces") }));
  fill(part("ways"), ways(result));
  fill(part("pieces"), pieces(result));
}

/** A line with a name, a bar and a chance. */
const row = (name, one, ...more) =>
  el(
    "li",
    { class: "finding" },
    el("strong", { text: capital(name) }),
    el("span", { class: "optionbar" }, bar(one), el("span", { class: "share", text: chance(one) })),
    ...more,
  );

const list = (rows) => el("ul", { class: "findings" }, ...rows);
const hint = (text) => el("p", { class: "hint", text });

function place(one, { crushed_from_J: energy }) {
  const harder = hint(
    t("crushedOrTouched", { energy: number(energy), crushed: chance(one.crushed), touched: chance(one.touched) }),
  );
  const when = hint(t("dayAndNight", { day: timed(one.hit, one.hit_by_day), night: timed(one.hit, one.hit_at_night) }));
  return el(
    "div",
    {},
    list([row(kindName("places", one.name), one.hit, harder, when)]),
    one.by.length ? list(one.by.map(hitBy)) : hint(t("hitByNothing")),
  );
}

/** A chance of being hit times the part of the time that somebody is there. */
function timed({ estimate, low, high }, hit) {
  const part = estimate ? hit / estimate : 1;
  return chance({ estimate: hit, low: part * low, high: part * high });
}

const hitBy = ({ piece, probability, by_falling: falling, mass_kg: mass, speed_m_s: speed, energy_J: energy }) =>
  row(
    t(falling ? "fallsOn" : "touches", { piece: kindName("furniture", piece) }),
    probability,
    hint(
      t("impact", {
        mass: number(mass),
        speed: quantile(speed, "m/s", 1),
        energy: quantile(energy, "J", 0),
      }),
    ),
  );

function ways(result) {
  const doors = result.doors.map((one) =>
    one.blocked_at_rest
      ? el("li", { class: "finding" }, el("strong", { text: capital(kindName("doors", one.name)) }),
          el("span", { class: "hint alarm", text: t("already") }))
      : row(t("doorBlocked", { door: kindName("doors", one.name) }), one.blocked),
  );
  const shut = result.places.map((one) => row(t("shutInAt", { place: kindName("places", one.name) }), one.shut_in));
  return result.doors.length ? [list([...doors, ...shut])] : [el("p", { text: t("noDoors") })];
}

function pieces(result) {
  const all = result.pieces.reduce((sum, one) => sum + one.harm_J, 0);
  const told = ({ name, harm_J: harm, probabilities: p }) =>
    row(
      kindName("furniture", name),
      p.overturned,
      hint(
        [
          harm > 0 ? t("contributes", { share: t("about", { share: perCent(10 * Math.round((10 * harm) / all)) }) }) : "",
          inTheWay(result, name),
          t("pieceSlides", { share: chance(p.slid) }),
          p.device_failed?.estimate > 0 ? t("pieceFails", { share: chance(p.device_failed) }) : "",
        ]
          .filter(Boolean)
          .join(t("space")),
      ),
    );
  return [hint(t("piecesOrder")), list(result.pieces.map(told))];
}

/** That a piece is in the way out, where a change of it clearly frees that. */
function inTheWay({ changes, shut_in: now }, name) {
  const freed = changes.find((one) => one.what === name && one.better.includes("shut_in"));
  if (!freed) return "";
  return t("inTheWay", { now: share(now), then: share(freed.shut_in), change: both(freed.label) });
}

/** The pieces that overturn often without hitting anybody, with how often. */
export function fallingAlone({ pieces, places }) {
  const hitting = new Set(places.flatMap((one) => one.by.filter((hit) => hit.by_falling).map(({ piece }) => piece)));
  return pieces
    .filter(({ name, falls }) => falls && !hitting.has(name))
    .map(({ name, probabilities: { overturned } }) =>
      t("fallsOften", { piece: kindName("furniture", name), share: share(overturned) }),
    );
}
