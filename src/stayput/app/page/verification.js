// The verification as a job on the server: started, looked at, cancelled; the newest one counts.

import * as api from "./api.js";

const LOOK = 150,
  LONGEST = 1000,
  RETRY = 1500;
const pause = (milliseconds) =>
  new Promise((done) => {
    setTimeout(done, milliseconds);
  });

/** One line of jobs, where a new one takes the place of the one before it. */
export function line() {
  let id = null,
    turn = 0;

  async function stop() {
    turn += 1;
    const old = id;
    id = null;
    if (old) await api.cancel(old).catch(() => null);
  }

  /** Runs a job to its end; "told" gets its progress. Returns it, or null where another took its place. */
  async function run(content, told) {
    await stop();
    const mine = turn;
    const begun = await accepted(content, () => mine === turn);
    if (begun === null) return null;
    if (mine !== turn) {
      api.cancel(begun.id).catch(() => null);
      return null;
    }
    id = begun.id;
    for (let job = begun, wait = LOOK; ; job = await api.job(id), wait = Math.min(LONGEST, wait * 1.2)) {
      if (mine !== turn) return null;
      if (job.state === "done") return job;
      if (job.state === "failed") throw new api.Refused(job.error ?? {}, 422);
      if (job.state === "cancelled") return null;
      told(job);
      await pause(wait);
      if (mine !== turn) return null;
    }
  }
  return { run, stop };
}

async function accepted(content, wanted) {
  while (wanted()) {
    try {
      return await api.verify(content);
    } catch (error) {
      if (error.status !== 429 && error.status !== 503) throw error;
      await pause(RETRY);
    }
  }
  return null;
}
