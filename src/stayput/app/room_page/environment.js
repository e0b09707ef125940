// Shaking, floor, walls, ceiling and building. Their fields are those of the page of one piece, with a scene of its
// own: what the room says goes into that scene, and what is set there into the room.

import * as api from "../api.js";
import * as fields from "../scene.js";
import { motionOf, whole } from "../linked_record.js";
import * as upload from "../upload.js";
import * as room from "./room.js";

const READING = ["component", "unit", "dt", "columns", "skip_lines", "decimal_comma", "location", "remove_mean"],
  FILES = ["record", ...fields.FURTHER],
  MOTIONS = [...FILES, ...READING, "sine", "builtin", "suite", "member"],
  WAYS = ["pga", "pgv", "sa", "mmi", "earthquake"],
  STRENGTHS = ["intensity", "scale", ...WAYS];
let presets = null,
  wanted = null, // the record that the server is being asked for
  reading = false, // the room goes into the fields, which is no change of the room
  computedSuite = {}, // the suite of computed earthquakes, which comes again after a record
  whenLost = () => {};
const waves = new Map(); // the records that links hold, {name, letters} by their ids

/** Begins with a room that is there; "lost" is called where the server does not have its record. */
export function wire(known, lost) {
  presets = known;
  whenLost = lost;
  fields.watch((keys) => {
    if (!reading) room.change(written(room.current(), keys), { mergeKey: keys.join() });
  });
  take();
}

/** Puts what the room says into the fields. */
export function take() {
  const shaking = room.current().shaking ?? {},
    { record, suite } = shaking;
  if (typeof suite === "object") computedSuite = suite;
  put({ ...told(room.current()), record: kept(record) });
  if (record && record !== fields.current().record?.id && record !== wanted) fetchRecord(shaking);
}

function put(part) {
  reading = true;
  try {
    fields.change(part);
  } finally {
    reading = false;
  }
}

/** The record in the fields, where it is the room's. */
const kept = (id) => (fields.current().record?.id === id ? fields.current().record : null);

/** The ids of a room's record and of its further components by their names, as far as files hold them. */
const recordsIn = (shaking = {}) =>
  Object.fromEntries(FILES.map((key) => [key, shaking[key]]).filter(([, id]) => typeof id === "string"));

/** Notes what a link holds of a room's records: {name, letters} of each. */
export function noteRecords(found, linked) {
  for (const [key, id] of Object.entries(recordsIn(found?.shaking))) if (linked[key]) waves.set(id, linked[key]);
}

/** What a link is to hold of the records of a room, {key, name, letters} of each; "letters" is null where one is too large. */
export const recordsOf = ({ shaking }) =>
  Object.entries(recordsIn(shaking)).map(([key, id]) => ({ key, ...waveOf(id) }));

function waveOf(id) {
  const { record } = fields.current(),
    now = [record, ...fields.FURTHER.map((part) => record?.[part])].find((one) => one?.id === id);
  if (now?.letters) waves.set(id, { name: now.name, letters: now.letters });
  return waves.get(id) ?? { name: now?.name ?? "", letters: null };
}

async function fetchRecord(shaking) {
  const { component, unit, dt, remove_mean } = shaking,
    { record: id, ...ids } = recordsIn(shaking),
    linked = Object.entries(ids).map(([part, one]) => [part, { id: one, said: { unit, dt, remove_mean }, ...waveOf(one) }]),
    wave = waveOf(id);
  wanted = id;
  try {
    const motion = await motionOf({ id, said: { component, unit, dt, remove_mean }, ...wave }),
      further = {};
    for (const [part, one] of linked) {
      const known = await motionOf(one);
      further[part] = whole(known, one.letters);
    }
    if (room.current().shaking?.record !== id) return;
    const now = { record: motion.id, ...fields.furtherOf(further) };
    if (FILES.some((key) => now[key] !== (key === "record" ? id : ids[key]))) {
      for (const key of Object.keys(now)) waves.set(now[key], key === "record" ? wave : waveOf(ids[key]));
      const { shaking: before, ...rest } = room.current();
      room.replace({ ...rest, shaking: { ...before, ...now } });
      return;
    }
    const about = linked.length ? await api.motion(id, component, ids) : motion;
    put({ record: { ...whole(motion, wave.letters), motion: about, ...further } });
    upload.update();
  } catch (error) {
    const held = wave.letters || linked.some(([, one]) => one.letters);
    if (!(error instanceof api.Refused || held)) throw error;
    if (room.current().shaking?.record === id) whenLost();
  } finally {
    wanted = null;
  }
}

/** The room under a computed earthquake in the place of a record that is gone. */
export function withoutRecord(before) {
  const shaking = { ...before.shaking };
  for (const key of MOTIONS) delete shaking[key];
  shaking.suite = { family: fields.plain.family };
  shaking.intensity ??= fields.plain.intensity;
  return { ...before, shaking };
}

/** What a room says, as the fields have it. */
function told({ shaking = {}, room: surfaces = {} }) {
  const { record, suite, intensity, building, storey, member } = shaking,
    { plain } = fields,
    computed = record ? fields.current() : plain, // a record leaves the fields of computed earthquakes as they are
    way = WAYS.find((one) => shaking[one] !== undefined),
    middle = presets.intensities.find((one) => one.id === intensity)?.middle;
  return {
    floor: typeof surfaces.floor === "string" ? surfaces.floor : plain.floor,
    wallConstruction: surfaces.walls ?? plain.wallConstruction,
    ceilingThere: Boolean(surfaces.ceiling),
    ceiling: surfaces.ceiling?.height ?? plain.ceiling,
    ceilingConstruction: surfaces.ceiling?.construction ?? plain.ceilingConstruction,
    intensity: middle ?? (Number(intensity) || fields.current().intensity),
    entry: way ? { [way]: shaking[way] } : null,
    scaled: intensity !== undefined || way !== undefined,
    family: suite?.family ?? computed.family,
    member: member ?? (record ? computed.member : 1),
    storeys: building?.storeys ?? 0,
    storey: storey ?? 1,
    structure: building?.structure ?? plain.structure,
  };
}

const has = (keys, ...some) => some.some((one) => keys.includes(one));

/** A room with what has been set in some of the fields. */
function written(before, keys) {
  const scene = fields.current(),
    surfaces = { ...before.room },
    shaking = { ...before.shaking };
  if (has(keys, "floor")) surfaces.floor = scene.floor;
  if (has(keys, "wallConstruction")) surfaces.walls = scene.wallConstruction;
  if (has(keys, "ceilingThere", "ceiling", "ceilingConstruction")) {
    const { ceiling: height, ceilingConstruction: construction } = scene;
    if (scene.ceilingThere) surfaces.ceiling = { ...surfaces.ceiling, height, construction };
    else delete surfaces.ceiling;
  }
  if (has(keys, "record", "family", "member")) {
    const suite = { ...computedSuite, family: scene.family };
    for (const key of MOTIONS) delete shaking[key];
    Object.assign(shaking, scene.record ? fields.shakingOf(scene.record) : { suite, member: scene.member });
  }
  if (has(keys, "intensity", "entry", "scaled", "record")) {
    for (const key of STRENGTHS) delete shaking[key];
    if (!scene.record || scene.scaled) Object.assign(shaking, scene.entry ?? { intensity: scene.intensity });
  }
  if (has(keys, "storeys", "storey", "structure", "onFloor", "record")) {
    const { storeys, structure, storey } = scene;
    if (fields.throughBuilding(scene)) Object.assign(shaking, { building: { ...shaking.building, storeys, structure }, storey });
    else for (const key of ["building", "storey"]) delete shaking[key];
  }
  return { ...before, room: surfaces, shaking };
}
