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

function roomRows() {
  const side = (key, label, next) =>
    row(
      amount({
        label: t(label),
        ...METRES,
        limits: () => limitsOf(`plan.${key}`),
        changed: (value) => change(next(current(), value)),
      }),
      (room) => room.plan[key],
    );
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
    ["furniture", "places", "doors"].includes(what.table) &&
    current()[what.table].some(
      (_, index) => index !== what.index && nameOf(current(), { ...what, index }) === kindName(what.table, text),
    );
  const refuse = (text) => (!text ? t("nameEmpty") : taken(text) ? t("nameTaken", { name: text }) : null);
  const field = naming({
    label: t("name"),
    refuse,
    changed: (text) => change(renamed(current(), what, text)),
  });
  return row(field, (room) => nameOf(room, what));
}

const standsFree = (what) => (room) => !room[what.table][what.index].against;

/** The place of something that stands free: from the left and the near wall, and which way it faces. */
function freeRows(what, there = () => true) {
  const moved = (axis) => (value) => {
    const { at, heading } = thing(current(), what);
    change(
      placed(
        current(),
        what,
        at.map((old, i) => (i === axis ? value : old)),
        heading,
      ),
    );
  };
  const at = (axis, label) =>
    row(
      amount({
        label: t(label),
        ...METRES,
        limits: () => [0, axis ? current().plan.length : current().plan.width],
        changed: moved(axis),
      }),
      (room) => thing(room, what).at[axis],
      there,
    );
  const heading = amount({
    label: t("turnedDegrees"),
    ...DEGREES,
    limits: () => [-Math.PI, Math.PI],
    changed: (value) => change(turned(current(), what, value)),
  });
  return [at(0, "fromLeft"), at(1, "fromNear"), row(heading, (room) => thing(room, what).heading, there)];
}

/** A number of its own of something, which is set by a function. */
function own(
  what,
  key,
  label,
  as,
  set = (room, value) => sized(room, what, { [key]: value }),
  limits = () => limitsOf(`${what.table}.${key}`),
) {
  return (there) =>
    row(
      amount({ label: t(label), ...as, limits, changed: (value) => change(set(current(), value)) }),
      (room) => thing(room, what)[key],
      there,
    );
}

function pieceRows(what) {
  const piece = () => current().furniture[what.index],
    alone = (room) => carrier(room, what.index) === null,
    against = (room) => Boolean(room.furniture[what.index].against),
    box = (room) => pieceSizes(room.furniture[what.index]).box;
  const wall = choice({
    label: t("standsAt"),
    options: [{ id: "", label: t("freely") }, ...WALLS.map((id) => ({ id, label: t(id) }))],
    changed: (id) => {
      const { at, heading } = thing(current(), what);
      change(
        id
          ? atWall(current(), what, id, fromWall(current().plan, id, at)[0])
          : placed(current(), what, at, heading),
      );
    },
  });
  const along = amount({
    label: t("alongWall"),
    ...METRES,
    limits: () => (piece().against ? [0, wallLength(current().plan, piece().against)] : [0, 0]),
    changed: (value) => change(atWall(current(), what, piece().against, value)),
  });
  const gap = amount({
    label: t("gap"),
    ...CENTIMETRES,
    limits: () => [0, Math.max(current().plan.width, current().plan.length)],
    changed: (value) => change(given(current(), what, { gap: value })),
  });
  const filling = oneOf({
    label: t("filling"),
    options: ["full", "empty"].map((id) => ({ id, label: t(`filling_${id}`) })),
    changed: (id) => change(given(current(), what, { mass: fillings(piece())[id] })),
  });
  const filled = (room) => {
    const masses = fillings(room.furniture[what.index]);
    return Object.keys(masses).find((id) => masses[id] === thing(room, what).mass) ?? null;
  };
  const base = choice({
    label: t("base"),
    options: choicesOf("furniture.base").map((id) => ({ id, label: choiceLabel(id) })),
    changed: (id) => change(given(current(), what, { base: id })),
  });
  const size = (key, label) => own(what, key, label, CENTIMETRES)(box);
  return [
    row(wall, (room) => room.furniture[what.index].against ?? "", alone),
    row(along, (room) => room.furniture[what.index].along, against),
    row(gap, (room) => room.furniture[what.index].gap ?? DEFAULTS.furniture.gap, against),
    ...freeRows(what, standsFree(what)),
    size("height", "height"),
    size("width", "pieceDepth"),
    size("length", "pieceLength"),
    own(what, "mass", "mass", { unit: "kg", decimals: 1 }, (room, value) =>
      given(room, what, { mass: value }),
    )(box),
    row(base, (room) => baseOf(room.furniture[what.index])),
    row(filling, filled, (room) => fillings(room.furniture[what.index]) !== null),
    measuresOf(what),
  ];
}

function placeRows(what) {
  const heights = {
    low: () => [limitsOf("places.low")[0], thing(current(), what).high - 0.01],
    high: () => [thing(current(), what).low + 0.01, limitsOf("places.high")[1]],
  };
  const set = (key) => (room, value) => given(room, what, { [key]: value });
  return [
    ...freeRows(what),
    own(what, "width", "placeWidth", CENTIMETRES)(),
    own(what, "length", "placeLength", CENTIMETRES)(),
    own(what, "low", "personLow", CENTIMETRES, set("low"), heights.low)(),
    own(what, "high", "personHigh", CENTIMETRES, set("high"), heights.high)(),
    own(what, "day", "byDay", PER_CENT, set("day"))(),
    own(what, "night", "atNight", PER_CENT, set("night"))(),
  ];
}

function openingRows(what) {
  const set = (key) => (value) => change(given(current(), what, { [key]: value }));
  const select = (key, ids, label) =>
    choice({
      label: t(label),
      options: ids.map((id) => ({ id, label: t(key === "wall" ? id : `${key}_${id}`) })),
      changed: set(key),
    });
  const wall = choice({
    label: t("inWhichWall"),
    options: WALLS.map((id) => ({ id, label: t(id) })),
    changed: (id) => change(inWall(current(), what, id, opening(current(), what).start)),
  });
  const of = (key) => (room) => opening(room, what)[key],
    swings = (room) => opening(room, what).opens !== "sliding",
    side = () => wallLength(current().plan, opening(current(), what).wall);
  const start = (room, value) => inWall(room, what, opening(room, what).wall, value);
  const rest = [
    row(wall, of("wall")),
    own(what, "start", "startsAt", METRES, start, () => [
      0,
      Math.max(0, side() - opening(current(), what).width),
    ])(),
    own(
      what,
      "width",
      "clearWidth",
      CENTIMETRES,
      (room, value) => given(room, what, { width: value }),
      () => {
        const [low, high] = limitsOf(`${what.table}.width`);
        return [low, Math.min(high, side() - opening(current(), what).start)];
      },
    )(),
  ];
  if (what.table === "windows")
    return [
      ...rest,
      own(what, "sill", "sill", CENTIMETRES, (room, value) => given(room, what, { sill: value }))(),
    ];
  const out = toggle({ label: t("wayOut"), changed: set("way_out") });
  return [
    ...rest,
    row(select("opens", OPENS, "howOpens"), of("opens")),
    row(select("hinge", HINGES, "hingeAt"), of("hinge"), swings),
    row(out, of("way_out")),
  ];
}

function another() {
  const button = el("button", { type: "button", text: t("doubleIt"), onclick: () => double() });
  return { element: el("div", { class: "row" }, button), update: () => {} };
}
