// What the server makes of the room: asked for anew after each change, the old question cancelled, the answer taken as
// it gets better.

import * as api from "../api.js";
import { settled } from "../dom.js";
import { line } from "../verification.js";
import * as room from "./room.js";
import { roomBefore } from "./tried.js";

/** A verdict as this page reads it: what happens in the room as it is in "whole" runs, and with each other option. */
export function ofRoom(reply) {
  const bare = reply.options.find((one) => one.overturned_change === null),
    pieces = [...bare.pieces].sort((a, b) => b.harm_J - a.harm_J || falls(b) - falls(a));
  return {
    ...reply,
    ...bare.people,
    pieces,
    whole: bare.runs,
    typical: { member: bare.typical.motion + 1, sample: bare.typical.sample },
    changes: reply.options.filter((one) => one !== bare).map(changeOf),
  };
}

const falls = (piece) => piece.probabilities.overturned.estimate;

/** An option that makes one change of the room, with what it brings; it names no one thing where it makes more. */
function changeOf({ rank, label, reason, people, pieces, changes, helps, better, worse, tags }) {
  const [change] = changes,
    piece = changes.length === 1 ? pieces.find(({ name }) => name === change.what) : null,
    { overturned } = piece?.probabilities ?? { overturned: null };
  const told = { rank, label, sentence: reason, helps, better, worse, tags };
  return { ...people, ...change, ...told, overturned, overturned_change: piece?.overturned_change ?? null };
}

const SETTLED = 600; // after the last change [ms]
const jobs = line(api.room);
let round = 0,
  asked = null, // the room that is asked about, or was last
  tell = () => {},
  now = { name: "waiting", job: null, result: null, old: true, error: null };

/** The state of the question: its name, the newest job, the newest result and whether that is of another room. */
export const state = () => now;

function become(next) {
  now = { ...now, ...next };
  tell(now);
}

/** Calls a function with each new state, and where the server goes away or is back. */
export function wire(told) {
  tell = told;
  addEventListener("connection", () => tell(now));
}

const soon = settled(SETTLED, () => work());

/** Asks about the room as it now is: the first one at once, others once they have settled; not about an empty one. */
export function changed() {
  if (room.current() === asked) return;
  const first = asked === null,
    same = !first && room.computed(room.current()) === room.computed(asked);
  asked = room.current();
  if (same && now.name !== "waiting") return;
  round += 1;
  jobs.stop();
  if (!asked.furniture.length) {
    soon.cancel();
    become({ name: "empty", job: null, result: null, old: false, error: null });
    return;
  }
  become({ name: "waiting", job: null, old: true, error: null });
  if (first) work();
  else soon();
}

/** Asks again at once. */
export function again() {
  asked = room.current();
  become({ old: true });
  work();
}

/** Ends the question; what is known of the answer stays, as far as it came. */
export function cancel() {
  round += 1;
  jobs.stop();
  become({ name: "cancelled", job: null });
}

async function work() {
  const mine = ++round;
  const take = (job) => {
    if (mine !== round) return;
    const better = job.result ? { result: ofRoom(job.result), old: false } : {};
    become({ name: job.state, job, error: null, ...better });
  };
  become({ name: "running", job: null, error: null });
  try {
    const job = await jobs.run({ scene: asked, before: roomBefore(asked), changes: true }, take);
    if (job) take(job);
  } catch (error) {
    if (mine === round) become({ name: "refused", job: null, error });
  }
}
