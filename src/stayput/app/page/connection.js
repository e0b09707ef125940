// Whether the server answers: where it does not, it is asked again and again until it is back.

import * as api from "./api.js";
import { part } from "./dom.js";

const EVERY = 1000,
  LONGEST = 8000,
  BUSY = 1500;
let back = null;

/** Whether the server does not answer; "connection" is sent to the window where that changes. */
export const isAway = () => back !== null;

/** Why there is no picture yet, as the key of a sentence: the server still compiles, or it computes. */
export async function whyLong() {
  const answer = await api.ping().catch(() => null);
  return answer?.ready === false ? "warming" : "computing";
}

/** Lets some time pass [ms]. */
export const pause = (milliseconds) =>
  new Promise((done) => {
    setTimeout(done, milliseconds);
  });

/** Waits until the server answers; however many wait, it is asked once at a time. */
export function untilBack() {
  back ??= answered().finally(() => tell(null));
  return tell(back);
}

function tell(waiting) {
  const changed = part("away").hidden === Boolean(waiting);
  back = waiting;
  part("away").hidden = !waiting;
  if (changed) dispatchEvent(new Event("connection"));
  return waiting;
}

async function answered() {
  for (let wait = EVERY; ; wait = Math.min(LONGEST, 1.5 * wait)) {
    await pause(wait);
    if (await api.ping().catch(() => null)) return;
  }
}

/** Asks again where the server is busy, and once it is back where it does not answer; null: no longer wanted. */
export async function patiently(ask, wanted = () => true) {
  while (wanted()) {
    try {
      return await ask();
    } catch (error) {
      if (error.status === 0) await untilBack();
      else if (error.status === 429 || error.status === 503) await pause(BUSY);
      else throw error;
    }
  }
  return null;
}
