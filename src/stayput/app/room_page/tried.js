// Changes of the room that are tried: what a thing was before is noted with it, under "was", until the change is taken
// back or said to be made. Where it stood is one note, what held it another.

import { el, fill, part } from "../dom.js";
import { t, within } from "../words.js";
import { given } from "./edits.js";
import { measureKinds, nameOf } from "./kinds.js";
import * as room from "./room.js";

const PLACE = ["at", "heading", "against", "along", "gap"],
  TABLES = ["furniture", "places"],
  OF = { place: PLACE, measures: ["measures"] };

const only = (thing, keys) => Object.fromEntries(keys.filter((key) => key in thing).map((key) => [key, thing[key]]));
const without = (thing, keys) => Object.fromEntries(Object.entries(thing).filter(([key]) => !keys.includes(key)));

const isTable = (one) => one !== null && typeof one === "object" && !Array.isArray(one);
const areMeasures = (list) => Array.isArray(list) && list.every((one) => isTable(one) && typeof one.type === "string");
const CAN_BE = {
  place: (note) => isTable(note) && (note.at === undefined || (Array.isArray(note.at) && note.at.every(Number.isFinite))),
  measures: (note) => isTable(note) && (note.measures === undefined || areMeasures(note.measures)),
};

/** A room of a link without measures and notes that can be none. */
export const legible = (here) => ({
  ...here,
  ...Object.fromEntries(TABLES.filter((table) => here[table]).map((table) => [table, here[table].map(readable)])),
});

function readable(thing) {
  const next = { ...thing };
  if ("measures" in next && !areMeasures(next.measures)) delete next.measures;
  if (!("was" in next)) return next;
  const notes = Object.entries(next.was ?? {}).filter(([note, old]) => Object.hasOwn(CAN_BE, note) && CAN_BE[note](old));
  if (notes.length) next.was = Object.fromEntries(notes);
  else delete next.was;
  return next;
}

/** A thing that is about to be tried at another place, or with other measures, with what it was noted. */
export const noted = (thing, note) => ({ ...thing, was: { [note]: only(thing, OF[note]), ...thing.was } });

/** A thing as it was before something was tried with it. */
const asBefore = ({ was, ...thing }) =>
  Object.keys(was ?? {}).reduce((one, note) => ({ ...without(one, OF[note]), ...was[note] }), thing);

/** What is tried in a room: the thing, the note, and the thing as it was. */
const triedIn = (here) =>
  TABLES.flatMap((table) =>
    (here[table] ?? []).flatMap((thing, index) =>
      Object.keys(OF)
        .filter((note) => thing.was?.[note])
        .filter((note) => JSON.stringify(only(thing, OF[note])) !== JSON.stringify(thing.was[note]))
        .map((note) => ({ what: { table, index }, note, thing, was: thing.was[note] })),
    ),
  );

/** The room before what is tried in it; null where nothing is. */
export function roomBefore(here) {
  if (!triedIn(here).length) return null;
  return { ...here, ...Object.fromEntries(TABLES.filter((table) => here[table]).map((table) => [table, here[table].map(asBefore)])) };
}

/** What is tried, in words: "the desk moved". */
function said({ what, note, thing, was }) {
  const name = nameOf(room.current(), what);
  if (note === "place") return t("triedMoved", { what: name });
  const had = (was.measures ?? []).map(({ type }) => type),
    more = (thing.measures ?? []).filter(({ type }) => !had.includes(type));
  const labels = more.map(({ type }) => within(measureKinds().find((one) => one.type === type)?.label ?? type));
  return t("triedMeasures", { what: name, measures: labels.join(t("listed")) || t("triedNone") });
}

/** Lists what is tried, each with what may become of it; called after each change, and for another language. */
export function show() {
  const all = triedIn(room.current());
  part("tried").hidden = !all.length;
  fill(part("tried-list"), all.map(entry));
}

/** Says above the verdict with what it is, where it is of the room as it now is. */
export function tell(ofThis) {
  const all = ofThis ? triedIn(room.current()) : [];
  part("with-tried").hidden = !all.length;
  part("with-tried").textContent = all.length ? t("withTried", { changes: all.map(said).join(t("listed")) }) : "";
}

function entry(one) {
  const label = said(one),
    { was, ...left } = one.thing,
    others = without(was, [one.note]),
    kept = Object.keys(others).length ? { was: others } : { was: undefined };
  const back = () => become(one.what, { ...nothing(left, OF[one.note]), ...one.was, ...kept });
  return el(
    "li",
    { class: "row" },
    el("span", { text: label }),
    button("takeBack", label, back),
    button("isMade", label, () => become(one.what, kept)),
  );
}

const nothing = (thing, keys) => Object.fromEntries(keys.filter((key) => key in thing).map((key) => [key, undefined]));

const become = (what, values) => room.change(given(room.current(), what, values));

const button = (key, label, onclick) =>
  el("button", { type: "button", text: t(key), "aria-label": `${t(key)}${t("colon")}${label}`, onclick });
