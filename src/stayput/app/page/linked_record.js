// A record in a link: its file in letters, which is sent to the server again where that has it no more.

import * as api from "./api.js";
import { patiently } from "./connection.js";
import { packed, unpackedBytes } from "./packing.js";
import { FURTHER } from "./scene.js";

export const LONGEST = 4096; // letters of a record in a link, with those of its further components
const sent = new Map(); // the ids of the records in links that were sent to the server again, by their letters

/** What a link holds of a record: its file in letters, or null where that is too long. */
export async function lettersOf(file, most = LONGEST) {
  if (file.size > 16 * most) return null; // which no file of numbers is made smaller by
  const letters = await packed(await file.arrayBuffer());
  return letters.length <= most ? letters : null;
}

/** Something of each further component that a record has, by its name. */
export const ofFurther = (record, made) =>
  Object.fromEntries(FURTHER.filter((part) => record[part]).map((part) => [part, made(record[part])]));

/** A record as a link has it. */
export const linkedOf = ({ id, name, shaking: { component, unit, dt, remove_mean }, letters }) => ({
  id,
  name,
  said: { component, unit, dt, remove_mean },
  letters,
});

/** Whether a record of a link is neither on the server nor in the link. */
export const isLost = (error, { letters }) => error instanceof api.Refused || Boolean(letters);

/** A motion on the server as the scene has it, as a record or as a further component; "letters" are what a link holds of it. */
export const whole = (motion, letters) => ({ id: motion.id, name: motion.name, shaking: motion.shaking, motion, letters });

/** The record of a link as the server knows it; one that it has no more is sent again, if the link holds it. */
export async function motionOf({ id, name, said, letters }) {
  const on = (which) => patiently(() => api.motion(which, said.component));
  const known = await on(letters && sent.has(letters) ? sent.get(letters) : id).catch((error) => {
    if (error.status !== 404 || !letters) throw error;
  });
  if (known) return known;
  const file = new File([await unpackedBytes(letters)], name ?? ""),
    motion = await patiently(() => api.upload(file, said));
  sent.set(letters, motion.id);
  return motion;
}

/** A record whose first horizontal component by its file's name shakes the piece, in whichever order they came. */
export function firstByName(record) {
  const { across, vertical: up, others, ...along } = record;
  if (!across || (along.file ?? along.name) <= (across.file ?? across.name)) return record;
  return { ...across, across: along, vertical: up, others };
}
