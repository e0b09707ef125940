// What the user has set: one plain object, who wants to know of changes, and the scene that the server reads.

/** A scene that is complete, whatever the server proposes. */
export const plain = {
  piece: "bookcase",
  width: 0.3,
  length: 0.9,
  height: 1.8,
  inSpace: true,
  base: "edges",
  mass: 35,
  shelves: [33, 33, 33, 33, 33],
  centre: 0.5,
  contents: "nothing",
  doors: "none",
  floor: "wood flooring",
  wall: true,
  gap: 0.02,
  wallConstruction: "stud",
  ceiling: 2.4,
  ceilingConstruction: "joist",
  storeys: 0,
  structure: "RC",
  storey: 1,
  intensity: 6.25,
  entry: null,
  family: "mixed",
  member: 3,
  record: null,
  gone: null,
  scaled: false,
  onFloor: false,
  measures: {},
  installed: false,
  drawers: 0,
  drawerLoad: 27.2,
  pull: 45,
};

/** How far the sliders reach: lengths in m, masses in kg, forces in N, angles in degrees. */
const REACH = {
  width: [0.15, 1.2],
  length: [0.15, 2.4],
  height: [0.3, 2.6],
  mass: [1, 800],
  load: [0, 80],
  centre: [0.2, 0.8],
  gap: [0, 0.5],
  ceiling: [1.8, 3.5],
  intensity: [3.5, 7],
  pga: [0.5, 12],
  pgv: [0.05, 1.5],
  saPeriod: [0.1, 3],
  sa: [0.5, 30],
  drawers: [0, 10],
  drawerLoad: [0, 100],
  pull: [0, 300],
};

/** What the server calls the numbers and words of which it knows more. */
const NAMES = {
  width: "furniture.width",
  height: "furniture.height",
  length: "furniture.length",
  mass: "furniture.mass",
  base: "furniture.base",
  load: "furniture.shelves",
  gap: "room.left_wall.gap",
  wallConstruction: "room.left_wall.construction",
  ceiling: "room.ceiling.height",
  ceilingConstruction: "room.ceiling.construction",
  drawers: "everyday.drawers",
  drawerLoad: "everyday.load",
  pull: "everyday.pull",
  pga: "shaking.pga",
  pgv: "shaking.pgv",
  saPeriod: "shaking.sa.period",
  sa: "shaking.sa.value",
  magnitude: "shaking.earthquake.magnitude",
  distance: "shaking.earthquake.distance",
  depth: "shaking.earthquake.depth",
  quakeKind: "shaking.earthquake.kind",
};

/** The smallest and the largest value of a number of the scene. */
export function limitsOf(presets, name) {
  if (name === "storeys") return [0, presets.limits.storeys];
  if (name === "storey") return [1, presets.limits.storeys];
  if (name === "member") return [1, presets.numbers["shaking.suite.count"].default];
  const about = presets.numbers[NAMES[name]];
  return about ? [about.low, about.high] : REACH[name];
}

/** What the slider of a number of the scene is made with; lengths are shown in cm. */
export function numberOf(presets, name) {
  const limits = limitsOf(presets, name),
    unit = presets.numbers[NAMES[name]]?.unit ?? "";
  return { range: REACH[name] ?? limits, limits, ...(unit === "m" ? { unit: "cm", factor: 100 } : { unit }) };
}

/** The words that one of the scene may be. */
export const wordsOf = (presets, name) => presets.numbers[NAMES[name]].choices;

/** A value within a range. */
export const clamp = (value, [low, high]) => Math.min(high, Math.max(low, value));

let scene = structuredClone(plain);
const listeners = new Set();

/** The scene now; not to be written to. */
export const current = () => scene;

/** Changes some of the scene and tells everybody which keys. */
export function change(part) {
  scene = { ...scene, ...part };
  if (scene.storeys > 0) scene.storey = Math.min(Math.max(1, scene.storey), scene.storeys);
  for (const listener of listeners) listener(Object.keys(part));
}

/** Calls a function with the keys that changed, after every change. */
export const watch = (listener) => listeners.add(listener);

/** What a preset stands with: its size, base and drawers, and shelves loaded evenly where it has any. */
export function fromPreset(preset) {
  const { id: piece, width_m: width, height_m: height, length_m: length, drawers, base } = preset;
  const size = { piece, width, height, length, centre: 0.5, drawers, base };
  if (!preset.shelves || !preset.carcass_mass_kg) return { ...size, mass: preset.mass_kg, shelves: null };
  const each = Math.round((preset.mass_kg - preset.carcass_mass_kg) / preset.shelves);
  return { ...size, mass: preset.carcass_mass_kg, shelves: Array(preset.shelves).fill(each) };
}

/** What the user sees first, from the scene that the server proposes. */
export function fromServer(presets) {
  const { furniture, room, shaking } = presets.scene;
  return {
    ...structuredClone(plain),
    ...fromPreset(presets.furniture.find((one) => one.id === furniture.preset)),
    floor: room.floor,
    gap: room.left_wall.gap,
    ceiling: room.ceiling.height,
    intensity: presets.intensities.find((one) => one.id === shaking.intensity).middle,
    member: shaking.member,
    measures: Object.fromEntries(presets.measures_shown.map(({ type, ...values }) => [type, values])),
  };
}

/**
 * Mass and height of G above the floor as a part of the height, by the parts' masses (parallel to the
 * server's).
 */
export function balance({ mass, height, shelves, centre }) {
  if (!shelves) return { mass, centre, up: centre * height };
  const total = shelves.reduce((sum, load) => sum + load, mass);
  const clear = height / shelves.length;
  const moment = shelves.reduce((sum, load, i) => sum + load * (i + 0.5) * clear, (mass * height) / 2);
  return { mass: total, centre: moment / total / height, up: moment / total };
}

/** Whether the motion goes through a building: one that was measured on a floor does not. */
export const throughBuilding = (s) => s.storeys > 0 && !(s.record && s.onFloor);

/** Components of a record that files of their own hold, by their names in a scene. */
export const FURTHER = ["across", "vertical"];

/** The ids of the files that hold further components of a record. */
export const furtherOf = (record) =>
  Object.fromEntries(FURTHER.filter((part) => record[part]).map((part) => [part, record[part].id]));

/** A record as the shaking of a scene names it. */
export const shakingOf = (record) => ({ ...record.shaking, ...furtherOf(record) });

/** The scene as the server's simulations read it. */
export function forServer(s) {
  const furniture = { preset: s.piece, width: s.width, height: s.height, length: s.length, mass: s.mass };
  if (s.inSpace) furniture.base = s.base;
  if (s.shelves) furniture.shelves = s.shelves;
  else if (s.centre !== 0.5) furniture.cg_offset = [0, (s.centre - 0.5) * s.height];
  const room = { floor: s.floor };
  if (s.wall) room.left_wall = { gap: s.gap, construction: s.wallConstruction };
  if (s.ceiling > s.height) room.ceiling = { height: s.ceiling, construction: s.ceilingConstruction };
  const shaking = s.record ? shakingOf(s.record) : { suite: { family: s.family }, member: s.member };
  if (!s.record || s.scaled) Object.assign(shaking, s.entry ?? { intensity: s.intensity });
  if (throughBuilding(s))
    Object.assign(shaking, { building: { storeys: s.storeys, structure: s.structure }, storey: s.storey });
  const everyday = { drawers: s.drawers, load: s.drawerLoad, pull: s.pull };
  const read = { furniture, room, shaking, everyday };
  if (!s.inSpace) read.dimensions = 2;
  if (s.contents !== "nothing") read.contents = { kind: s.contents, doors: s.doors };
  if (s.installed) read.uncertainty = { installation: "as people install it" };
  return read;
}

/** The same as a verification asks for it: to within a half-width of chances, or the server's usual one for 0. */
export const precisely = (read, precision) =>
  precision ? { ...read, uncertainty: { ...read.uncertainty, precision } } : read;
