// The room in the page's address, so that a link, "back" and loading the page again show it.

import { settled } from "../dom.js";
import { tab } from "../memory.js";
import { packed, unpacked } from "../packing.js";
import * as room from "./room.js";

const LONGEST = 8000, // letters of a room in a link: longer ones are cut by much that links are sent with
  PAUSE = 1500, // what follows a change sooner has no place of its own in the browser's history [ms]
  HERE = "room"; // the room that this tab had last
let told = () => {},
  writing = null, // the room that is in the address, or on its way there
  at = -Infinity;

/** Writes the room into the address after each change; "changed" is called with whether it is too long for that. */
export function wire(changed) {
  told = changed;
  writing = room.current();
  write();
}

/** Notes a change of the room. */
export function changed() {
  if (room.current() === writing) return;
  writing = room.current();
  write();
}

const write = settled(250, async () => {
  const mine = writing,
    text = JSON.stringify(mine),
    letters = await packed(text);
  if (mine !== writing) return;
  tab.remember(HERE, text);
  const long = letters.length > LONGEST,
    hash = long ? "" : `#room=${letters}`,
    state = { screen: document.body.dataset.screen };
  if (hash !== location.hash) {
    const now = performance.now(),
      address = hash || location.pathname;
    if (location.hash && now - at > PAUSE) history.pushState(state, "", address);
    else history.replaceState(history.state ?? state, "", address);
    at = now;
  }
  told(long);
});

/** The room of an address, or that which this tab had; {room, damaged}: both may be missing. */
export async function read(hash) {
  const letters = new URLSearchParams(hash.replace(/^#/, "")).get("room");
  if (!letters) return { room: parsed(tab.recalled(HERE)), damaged: false };
  const text = await unpacked(letters).catch(() => null),
    found = parsed(text);
  return { room: found, damaged: found === null };
}

/** Whether a room is that which this tab had last, and is not another one, of a link. */
export const isOwn = (found) => JSON.stringify(found) === tab.recalled(HERE);

/** Notes that the address already has the room. */
export function settle() {
  writing = room.current();
  told(false);
}

/** A room of a text; null where it is none that could be drawn. */
function parsed(text) {
  try {
    const made = JSON.parse(text),
      tables = ["furniture", "places", "doors", "windows"].map((name) => made[name] ?? []);
    const whole =
      [made.plan.width, made.plan.length].every((side) => side > 0) &&
      tables.every((table) => Array.isArray(table) && table.every((one) => one !== null && typeof one === "object"));
    return whole ? made : null;
  } catch {
    return null;
  }
}
