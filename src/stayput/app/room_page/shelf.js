// Rooms that are kept on this device, each under a name and in a place of its own, so that two tabs of the page do not
// write over each other's.

import { isWhole } from "./address.js";

const PREFIX = "stayput-room-";

/** Why a room could not be kept: "full", or "closed" where the browser keeps nothing, as in private windows. */
export class NotKept extends Error {
  constructor(reason) {
    super(reason);
    this.reason = reason;
  }
}

/** All rooms that are kept: {id, name, room, revision}, by their names. */
export function all() {
  let keys = [];
  try {
    keys = Object.keys(localStorage).filter((key) => key.startsWith(PREFIX));
  } catch {
    return []; // the browser keeps nothing
  }
  return keys
    .map((key) => get(key.slice(PREFIX.length)))
    .filter(Boolean)
    .sort((one, other) => one.name.localeCompare(other.name));
}

/** A room that is kept, or null; another program or version may have written something else there. */
export function get(id) {
  try {
    const { name, room, revision } = JSON.parse(localStorage.getItem(PREFIX + id));
    return typeof name === "string" && isWhole(room) ? { id, name, room, revision } : null;
  } catch {
    return null;
  }
}

/**
 * Keeps a room; in the place of one that is kept where "over" is that, unless another tab has changed it since or has
 * removed it. Returns what is kept; its name has a number where there is another of that name.
 */
export function keep(name, room, over = null) {
  const before = over && get(over.id),
    mine = before?.revision === over?.revision ? before : null,
    names = all().flatMap((one) => (one.id === mine?.id ? [] : [one.name]));
  return put({ id: mine?.id ?? `${Date.now()}-${Math.random()}`, name: free(name, names), room });
}

/** Gives a room that is kept another name. */
export function rename({ id, name: before, room }, name) {
  const names = all().flatMap((one) => (one.id === id ? [] : [one.name]));
  return name && name !== before ? put({ id, name: free(name, names), room }) : get(id);
}

/** Removes a room. */
export function remove(id) {
  localStorage.removeItem(PREFIX + id);
}

/** Calls a function when another tab has kept, changed or removed a room. */
export function watch(listener) {
  addEventListener("storage", ({ key }) => (key === null || key.startsWith(PREFIX)) && listener());
}

function free(name, taken) {
  if (!taken.includes(name)) return name;
  for (let n = 2; ; n++) if (!taken.includes(`${name} (${n})`)) return `${name} (${n})`;
}

function put({ id, name, room }) {
  const made = { name, room, revision: Math.random() };
  try {
    localStorage.setItem(PREFIX + id, JSON.stringify(made));
  } catch (error) {
    throw new NotKept(error.name === "QuotaExceededError" && localStorage.length ? "full" : "closed");
  }
  return { id, ...made };
}
