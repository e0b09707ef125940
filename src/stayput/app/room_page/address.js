// The room in the page's address, so that a link, "back" and loading the page again show it.

import { settled } from "../dom.js";
import { tab } from "../memory.js";
import { packed, unpacked } from "../packing.js";
import { FURTHER } from "../scene.js";
import * as environment from "./environment.js";
import * as room from "./room.js";
import { legible } from "./tried.js";

const LONGEST = 8000, // letters of a room in a link: longer ones are cut by much that links are sent with
  PAUSE = 1500, // what follows a change sooner has no place of its own in the browser's history [ms]
  HERE = "room", // the room that this tab had last
  KEYS = {
    record: ["name", "wave"],
    ...Object.fromEntries(FURTHER.map((part) => [part, [`${part}Name`, `${part}Wave`]])),
  }; // of the record in a link, and of its further components
let told = () => {},
  writing = null, // the room that is in the address, or on its way there
  at = -Infinity;

/** Writes the room into the address after each change; "changed" is called with whether it is too long for that, and with the name of a record that is not in it, or null. */
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
  const { held, missing } = heldOf(environment.recordsOf(mine), LONGEST - letters.length);
  const long = letters.length > LONGEST,
    hash = long ? "" : `#room=${letters}${held}`,
    state = { screen: document.body.dataset.screen };
  if (hash !== location.hash) {
    const now = performance.now(),
      address = hash || location.pathname;
    if (location.hash && now - at > PAUSE) history.pushState(state, "", address);
    else history.replaceState(history.state ?? state, "", address);
    at = now;
  }
  told(long, missing);
});

/** What of the records of a room a link has place for, and the name of the first that it has not, or null. */
function heldOf(records, place) {
  let held = "",
    missing = null;
  records.forEach(({ key, name, letters }) => {
    place -= letters?.length ?? Infinity;
    const [called, wave] = KEYS[key];
    if (place >= 0) held += `&${new URLSearchParams({ [called]: name, [wave]: letters })}`;
    else missing ??= name;
  });
  return { held, missing };
}

/** The room of an address, or that which this tab had; {room, damaged, records}: they may be missing. */
export async function read(hash) {
  const pairs = new URLSearchParams(hash.replace(/^#/, "")),
    letters = pairs.get("room"),
    linked = Object.entries(KEYS).filter(([, [, wave]]) => pairs.has(wave)),
    records = Object.fromEntries(
      linked.map(([key, [name, wave]]) => [key, { name: pairs.get(name) ?? "", letters: pairs.get(wave) }]),
    );
  if (!letters) return { room: parsed(tab.recalled(HERE)), damaged: false, records };
  const text = await unpacked(letters).catch(() => null),
    found = parsed(text);
  return { room: found, damaged: found === null, records };
}

/** Whether a room is that which this tab had last, and is not another one, of a link. */
export const isOwn = (found) => JSON.stringify(found) === tab.recalled(HERE);

/** Notes that the address already has the room. */
export function settle() {
  writing = room.current();
  told(false, environment.recordsOf(writing).find((one) => !one.letters)?.name ?? null);
}

/** A room of a text; null where it is none that could be drawn. */
function parsed(text) {
  try {
    const made = JSON.parse(text);
    return isWhole(made) ? legible(made) : null;
  } catch {
    return null;
  }
}

/** Whether a value is a room that could be drawn. */
export function isWhole(made) {
  const tables = ["furniture", "places", "doors", "windows"].map((name) => made?.[name] ?? []);
  return (
    [made?.plan?.width, made?.plan?.length].every((side) => side > 0) &&
    tables.every((table) => Array.isArray(table) && table.every((one) => one !== null && typeof one === "object"))
  );
}
