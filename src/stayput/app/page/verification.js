// The verification as a job on the server: started, looked at, cancelled; the newest one counts.

import * as api from "./api.js";
import { patiently, pause } from "./connection.js";

const LOOK = 150,
  LONGEST = 1000;

/** The server ends a job that this page, asleep or lost, has not asked for in so many seconds. */
const LEASE = 20;

const all = new Set();
addEventListener("pagehide", () => {
  for (const jobs of all) jobs.stop();
});

/** One line of jobs that "start" begins, where a new one takes the place of the one before it. */
export function line(start = api.verify) {
  let id = null,
    turn = 0;

  async function stop() {
    turn += 1;
    const old = id;
    id = null;
    if (old) await api.cancel(old).catch(() => null);
  }

  /** Runs a job to its end; "onProgress" gets it as it goes. Returns it, or null where another took its place. */
  async function run(content, onProgress) {
    await stop();
    const mine = turn,
      wanted = () => mine === turn;
    let lost = true;
    while (lost && wanted()) {
      const begun = await patiently(() => start({ ...content, lease_s: LEASE }), wanted);
      if (begun === null) return null;
      if (!wanted()) {
        api.cancel(begun.id).catch(() => null);
        return null;
      }
      id = begun.id;
      try {
        const job = await ended(begun, onProgress, wanted);
        if (job?.state !== "cancelled") return job;
      } catch (error) {
        lost = error.status === 404; // the server has been started anew and knows nothing of the job
        if (!lost) throw error;
      }
    }
    return null;
  }

  /** Looks at a job until it has ended, and returns it; null where another took its place. */
  async function ended(begun, onProgress, wanted) {
    for (let job = begun, wait = LOOK; wanted(); wait = Math.min(LONGEST, wait * 1.2)) {
      if (job.state === "done" || job.state === "cancelled") return job;
      if (job.state === "failed") throw new api.Refused(job.error ?? {}, 422);
      onProgress(job);
      await pause(wait);
      if (wanted()) job = await patiently(() => api.job(begun.id), wanted);
    }
    return null;
  }
  const own = { run, stop };
  all.add(own);
  return own;
}
