// The room as it is drawn: a scenario of a room as JSON, which is never mutated; its past and future; what is selected.

const MERGE = 1000, // changes with one key are one entry as long as they follow each other so fast [ms]
  MOST = 200; // entries of the past

let room = null,
  chosen = null,
  last = { key: null, at: -Infinity };
const past = [],
  future = [],
  listeners = new Set();

/** The room now; not to be written to. */
export const current = () => room;

/** Makes the next room: one entry for undo; changes with the same mergeKey within a second of each other are one. */
export function change(next, { mergeKey = null } = {}) {
  const now = performance.now(),
    merged = mergeKey !== null && mergeKey === last.key && now - last.at < MERGE;
  if (!merged) past.push({ room, chosen });
  if (past.length > MOST) past.shift();
  future.length = 0;
  last = { key: mergeKey, at: now };
  room = next;
  tell();
}

/** Takes another room altogether, from a file, a link or a scene: there is nothing to undo then. */
export function replace(next) {
  past.length = future.length = 0;
  last = { key: null, at: -Infinity };
  chosen = null;
  room = next;
  tell();
}

/** What is worked out of a room: all but which of its earthquakes is shown, and whether nothing may be drilled. */
export const computed = ({ home, ...one }) =>
  JSON.stringify({ ...one, shaking: { ...one.shaking, member: undefined } });

/** What can be undone and redone, the last step at the end of each: {past, future}. */
export const history = () => ({ past, future });

/** Goes on with the history of this very room, from before the page was loaded again. */
export function takeUp(earlier) {
  past.push(...earlier.past);
  future.push(...earlier.future);
  tell();
}

export const canUndo = () => past.length > 0;
export const canRedo = () => future.length > 0;

/** Takes the last change back. */
export function undo() {
  if (canUndo()) step(past, future);
}

/** Makes the change again that was taken back last. */
export function redo() {
  if (canRedo()) step(future, past);
}

function step(from, to) {
  to.push({ room, chosen });
  ({ room, chosen } = from.pop());
  last = { key: null, at: -Infinity };
  tell();
}

function tell() {
  if (chosen && !room[chosen.table]?.[chosen.index]) chosen = null;
  for (const listener of listeners) listener();
}

/** Calls a function after every change of the room or of what is selected; returns how to end that. */
export function watch(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** What is selected: {table: "furniture" | "places" | "doors" | "windows", index}, or null. */
export const selected = () => chosen;

/** Selects something, or nothing. */
export function select(what) {
  if (what?.table === chosen?.table && what?.index === chosen?.index) return;
  chosen = what ? { table: what.table, index: what.index } : null;
  tell();
}
