// What can stand in a room: its kinds with their sizes, what each is called, and the ranges of its numbers.

import { both, t } from "../words.js";

let furniture = [],
  places = [],
  measures = [],
  numbers = {};

/** What is in a table of a room where nothing else is said; a test compares it with the server's. */
export const DEFAULTS = {
  furniture: { at: [0, 0], heading: 0, gap: 0.02 },
  places: { kind: "bed", heading: 0 },
  doors: { name: "door", width: 0.8, hinge: "start", opens: "inwards", way_out: true },
  windows: { width: 1.6, sill: 0.8 },
};

/** The tables of a room whose items stand on its plan. */
export const TABLES = ["places", "furniture", "windows", "doors"];

export const HINGES = ["start", "end"];
export const OPENS = ["inwards", "outwards", "sliding"];

/** Takes what the server knows; to be called before anything is drawn. */
export function learn(presets) {
  ({ furniture, measures, numbers, places } = presets);
}

export const furnitureKinds = () => furniture;
export const placeKinds = () => places;

const pieceKind = (id) => furniture.find((one) => one.id === id);
const placeKind = (id) => places.find((one) => one.id === id) ?? places[0];

/** The measures that may hold a piece; what changes its distance to the wall is done on the plan itself. */
export const measureKinds = () =>
  measures.filter((one) => !["against_wall", "away_from_wall"].includes(one.type));

/** The smallest and the largest value of a number, by the name that the server gives it. */
export const limitsOf = (name) => [numbers[name].low, numbers[name].high];

/** The words of which the server takes one, by the name that it gives the choice. */
export const choicesOf = (name) => numbers[name].choices;

/** What of a piece bears on the floor. */
export const baseOf = (piece) => piece.base ?? pieceKind(piece.preset)?.base ?? numbers["furniture.base"].default;

/** Depth, length, height [m] and mass [kg] of a piece; whether it is round, and may be resized and held. */
export function pieceSizes(piece) {
  const kind = pieceKind(piece.preset);
  if (kind) {
    const { width_m: width, length_m: length, height_m: height, mass_kg: mass } = kind;
    return { width, length, height, mass: piece.mass ?? mass, round: false, box: true };
  }
  const across = piece.diameter ?? Math.max(piece.bottom ?? 0, piece.top ?? 0);
  const { height = 1, mass } = piece;
  if (across) return { width: across, length: across, height, mass, round: true, box: false };
  const { width = 0.4, length = 0.4 } = piece; // of a mesh nothing is known here
  return { width, length, height, mass, round: false, box: !piece.mesh };
}

/** The masses of a piece full and empty [kg], where its kind has shelves; else null. */
export function fillings(piece) {
  const kind = pieceKind(piece.preset);
  if (!kind?.carcass_mass_kg) return null;
  const full = Math.max(...furniture.filter((one) => sameSize(one, kind)).map((one) => one.mass_kg));
  return { full, empty: kind.carcass_mass_kg };
}

const sameSize = (one, other) =>
  ["width_m", "length_m", "height_m", "carcass_mass_kg"].every((key) => one[key] === other[key]);

/** All numbers of a person's place: those of its kind, and those that it says itself. */
export function placeValues(place) {
  const kind = placeKind(place.kind ?? DEFAULTS.places.kind);
  const { width_m: width, length_m: length, low_m: low, high_m: high, day, night, blocks } = kind;
  return { width, length, low, high, day, night, blocks, ...given(place) };
}

const given = (place) =>
  Object.fromEntries(
    ["width", "length", "low", "high", "day", "night"]
      .filter((key) => place[key] != null)
      .map((key) => [key, place[key]]),
  );

/** An opening with all its values. */
export const openingValues = (table, opening) => ({ ...DEFAULTS[table], ...opening });

/** The label of a kind, as it begins a line. */
export const labelOf = (kind) => both(kind.label).replace(/^[a-z]/, (letter) => letter.toUpperCase());

const short = (label) => label.split(/[,（(]/)[0].trim();

/** What is said of the kinds of a table; openings have but one. */
const kindsOf = (table) => ({ furniture, places })[table] ?? [{ id: "door", label: t(table === "doors" ? "door" : "window") }];

/** The kind that a name with a number begins with: by its id, or as it is called in either language. */
const kindBefore = (table, text) =>
  kindsOf(table).find(({ id, label }) => [id, ...(typeof label === "string" ? [label] : Object.values(label)).map(short)].some((one) => one.toLowerCase() === text));

/** What something of a table is called whose name is its kind, as "desk", or that with a number, as "desk 2". */
export function kindName(table, name) {
  const plain = kindsOf(table).find(({ id }) => id === name);
  if (plain) return short(labelOf(plain));
  const [, before, number] = /^(.+) (\d+)$/.exec(name) ?? [],
    kind = before && kindBefore(table, before.toLowerCase());
  return kind ? t("numbered", { name: short(labelOf(kind)), number }) : name;
}

/** What a thing is called: by its kind where it has no name of its own. */
export function nameOf(room, { table, index }) {
  const thing = room[table][index];
  if (table === "windows") return t("window");
  return kindName(table, thing.name ?? thing.kind ?? DEFAULTS[table].kind ?? DEFAULTS[table].name);
}

/** A name for another of a kind that is not called as anything of its table is: the kind's id, then with a number. */
export function freeName(room, table, id) {
  const taken = new Set((room[table] ?? []).map((_, index) => nameOf(room, { table, index })));
  for (let number = 1; ; number++) {
    const name = number === 1 ? id : `${id} ${number}`;
    if (!taken.has(kindName(table, name))) return name;
  }
}
