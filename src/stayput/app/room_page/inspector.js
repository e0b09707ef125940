// Beside the plan: the numbers and words of what is selected, to be typed and chosen; of the room where nothing is.

import { choice, oneOf, toggle } from "../controls.js";
import { el, fill } from "../dom.js";
import { choiceLabel, spoken, t } from "../words.js";
import { where } from "./described.js";
import { atWall, given, inWall, placed, renamed, sized, turned, withSides } from "./edits.js";
import { amount, naming } from "./fields.js";
import { WALLS, carrier, fromWall, opening, thing, wallLength } from "./geometry.js";
import { measuresOf } from "./inspector_measures.js";
import { double } from "./keys.js";
import { DEFAULTS, HINGES, OPENS, baseOf, choicesOf, fillings, kindName, limitsOf, nameOf, pieceSizes } from "./kinds.js";
import { change, current, selected } from "./room.js";

const METRES = { unit: "m", decimals: 2 },
  CENTIMETRES = { unit: "cm", factor: 100, decimals: 1 },
  DEGREES = { unit: "°", factor: 180 / Math.PI },
  PER_CENT = { unit: "%", factor: 100 };

let element = null,
  shown = "",
  rows = [];

/** Builds into an element. */
export function buildInto(aside) {
  element = aside;
  shown = "";
  if (current()) update();
}

/** Shows what is selected now; fields stay while they are of the same thing. */
export function update() {
  const what = selected(),
    room = current(),
    now = `${spoken()} ${what?.table} ${what?.index} ${what && (room[what.table][what.index].kind ?? "")}`;
  if (now !== shown) {
    shown = now;
    rows = what ? rowsOf(what) : roomRows();
    const title = el("h3", { id: "inspector-title", class: "inspected" });
    fill(
      element,
      title,
      what ? el("p", { class: "hint whereabouts" }) : el("p", { class: "hint", text: t("selectHint") }),
      ...rows.map((row) => row.element),
    );
  }
  element.querySelector(".inspected").textContent = what ? nameOf(room, what) : t("roomSize");
  if (what) element.querySelector(".whereabouts").textContent = where(room, what).join(t("comma"));
  for (const row of rows) row.update(room);
}

/** A row of a field: what it shows of the room, and whether it is there. */
const row = (field, value, there = () => true) => ({
  element: field.element,
  update: (room) => {
    field.element.hidden = !there(room);
    if (!field.element.hidden) field.set(value(room));
  },
});

/** A row of a number: "value" reads it from a room, "set" makes the room with another one. */
const numberRow = (label, as, limits, value, set, there) =>
  row(
    amount({ label: t(label), ...as, limits, changed: (next) => change(set(current(), next)) }),
    value,
    there,
  );

/** A row of a choice of words; "set" makes the room with another one. */
const choiceRow = (label, options, value, set, there) =>
  row(choice({ label: t(label), options, changed: (id) => change(set(current(), id)) }), value, there);

const wallOptions = () => WALLS.map((id) => ({ id, label: t(id) }));

function roomRows() {
  const side = (key, label, set) =>
    numberRow(label, METRES, () => limitsOf(`plan.${key}`), (room) => room.plan[key], set);
  return [
    side("width", "roomWidth", (room, value) => withSides(room, value, room.plan.length)),
    side("length", "roomLength", (room, value) => withSides(room, room.plan.width, value)),
  ];
}

function rowsOf(what) {
  if (what.table === "furniture") return [name(what), ...pieceRows(what), another()];
  if (what.table === "places") return [name(what), ...placeRows(what), another()];
  return [...(what.table === "doors" ? [name(what)] : []), ...openingRows(what), another()];
}

function name(what) {
  const taken = (text) =>
    current()[what.table].some(
      (_, index) => index !== what.index && nameOf(current(), { ...what, index }) === kindName(what.table, text),
    );
  const refuse = (text) => (!text ? t("nameEmpty") : taken(text) ? t("nameTaken", { name: text }) : null);
  const changed = (text) => change(renamed(current(), what, text));
  return row(naming({ label: t("name"), refuse, changed }), (room) => nameOf(room, what));
}

/** The place of something that stands free: from the left and the near wall, and which way it faces. */
function freeRows(what, there) {
  const at = (axis, label, side) =>
    numberRow(
      label,
      METRES,
      () => [0, current().plan[side]],
      (room) => thing(room, what).at[axis],
      (room, value) => placed(room, what, thing(room, what).at.with(axis, value), thing(room, what).heading),
      there,
    );
  return [
    at(0, "fromLeft", "width"),
    at(1, "fromNear", "length"),
    numberRow(
      "turnedDegrees",
      DEGREES,
      () => [-Math.PI, Math.PI],
      (room) => thing(room, what).heading,
      (room, value) => turned(room, what, value),
      there,
    ),
  ];
}

/** A number of its own of something. */
function own(what, key, label, as, { set, limits, there } = {}) {
  return numberRow(
    label,
    as,
    limits ?? (() => limitsOf(`${what.table}.${key}`)),
    (room) => thing(room, what)[key],
    set ?? ((room, value) => given(room, what, { [key]: value })),
    there,
  );
}

/** A side of something, which stays where it stands. */
const side = (what, key, label, there) =>
  own(what, key, label, CENTIMETRES, { set: (room, value) => sized(room, what, { [key]: value }), there });

function pieceRows(what) {
  const pieceOf = (room) => room.furniture[what.index],
    against = (room) => Boolean(pieceOf(room).against),
    free = (room) => !against(room),
    box = (room) => pieceSizes(pieceOf(room)).box;
  const toWall = (room, id) => {
    const { at, heading } = thing(room, what);
    return id ? atWall(room, what, id, fromWall(room.plan, id, at)[0]) : placed(room, what, at, heading);
  };
  const alongLimits = () => {
    const { against: wall } = pieceOf(current());
    return [0, wall ? wallLength(current().plan, wall) : 0];
  };
  const filling = oneOf({
    label: t("filling"),
    options: ["full", "empty"].map((id) => ({ id, label: t(`filling_${id}`) })),
    changed: (id) => change(given(current(), what, { mass: fillings(pieceOf(current()))[id] })),
  });
  const filled = (room) => {
    const masses = fillings(pieceOf(room));
    return Object.keys(masses).find((id) => masses[id] === thing(room, what).mass) ?? null;
  };
  return [
    choiceRow(
      "standsAt",
      [{ id: "", label: t("freely") }, ...wallOptions()],
      (room) => pieceOf(room).against ?? "",
      toWall,
      (room) => carrier(room, what.index) === null,
    ),
    numberRow(
      "alongWall",
      METRES,
      alongLimits,
      (room) => pieceOf(room).along,
      (room, value) => atWall(room, what, pieceOf(room).against, value),
      against,
    ),
    numberRow(
      "gap",
      CENTIMETRES,
      () => [0, Math.max(current().plan.width, current().plan.length)],
      (room) => pieceOf(room).gap ?? DEFAULTS.furniture.gap,
      (room, value) => given(room, what, { gap: value }),
      against,
    ),
    ...freeRows(what, free),
    side(what, "height", "height", box),
    side(what, "width", "pieceDepth", box),
    side(what, "length", "pieceLength", box),
    own(what, "mass", "mass", { unit: "kg", decimals: 1 }, { there: box }),
    choiceRow(
      "base",
      choicesOf("furniture.base").map((id) => ({ id, label: choiceLabel(id) })),
      (room) => baseOf(pieceOf(room)),
      (room, id) => given(room, what, { base: id }),
    ),
    row(filling, filled, (room) => fillings(pieceOf(room)) !== null),
    measuresOf(what),
  ];
}

function placeRows(what) {
  const low = () => [limitsOf("places.low")[0], thing(current(), what).high - 0.01],
    high = () => [thing(current(), what).low + 0.01, limitsOf("places.high")[1]];
  return [
    ...freeRows(what),
    side(what, "width", "placeWidth"),
    side(what, "length", "placeLength"),
    own(what, "low", "personLow", CENTIMETRES, { limits: low }),
    own(what, "high", "personHigh", CENTIMETRES, { limits: high }),
    own(what, "day", "byDay", PER_CENT),
    own(what, "night", "atNight", PER_CENT),
  ];
}

function openingRows(what) {
  const of = (room) => opening(room, what),
    space = () => wallLength(current().plan, of(current()).wall);
  const select = (label, key, ids, there) =>
    choiceRow(
      label,
      ids.map((id) => ({ id, label: t(`${key}_${id}`) })),
      (room) => of(room)[key],
      (room, id) => given(room, what, { [key]: id }),
      there,
    );
  const widths = () => {
    const [low, high] = limitsOf(`${what.table}.width`);
    return [low, Math.min(high, space() - of(current()).start)];
  };
  const rest = [
    choiceRow("inWhichWall", wallOptions(), (room) => of(room).wall, (room, id) => inWall(room, what, id, of(room).start)),
    own(what, "start", "startsAt", METRES, {
      set: (room, value) => inWall(room, what, of(room).wall, value),
      limits: () => [0, Math.max(0, space() - of(current()).width)],
    }),
    own(what, "width", "clearWidth", CENTIMETRES, { limits: widths }),
  ];
  if (what.table === "windows") return [...rest, own(what, "sill", "sill", CENTIMETRES)];
  const out = toggle({ label: t("wayOut"), changed: (on) => change(given(current(), what, { way_out: on })) });
  return [
    ...rest,
    select("howOpens", "opens", OPENS),
    select("hingeAt", "hinge", HINGES, (room) => of(room).opens !== "sliding"),
    row(out, (room) => of(room).way_out),
  ];
}

function another() {
  const button = el("button", { type: "button", text: t("doubleIt"), onclick: () => double() });
  return { element: el("div", { class: "row" }, button), update: () => {} };
}
