// What can be undone and redone, kept over a reload of this tab.

import { tab } from "../memory.js";
import { isWhole } from "./address.js";
import * as room from "./room.js";

const NAME = "history",
  LONGEST = 1e6; // letters of all that is kept; the oldest is left out first

/** Takes the history of the room up again where this tab kept one, and keeps it whenever the page is left or hidden. */
export function wire() {
  const kept = read();
  if (kept?.now === JSON.stringify(room.current())) room.takeUp(kept);
  document.addEventListener("visibilitychange", () => document.hidden && write());
}

function read() {
  try {
    const { now, past, future } = JSON.parse(tab.recalled(NAME));
    return [...past, ...future].every((one) => isWhole(one.room)) ? { now, past, future } : null;
  } catch {
    return null;
  }
}

function write() {
  const { past, future } = room.history();
  let left = LONGEST;
  const newest = (entries) => {
    const first = entries.findLastIndex((one) => (left -= JSON.stringify(one).length) < 0);
    return entries.slice(first + 1);
  };
  tab.remember(NAME, JSON.stringify({ now: JSON.stringify(room.current()), past: newest(past), future: newest(future) }));
}
