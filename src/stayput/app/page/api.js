// The server's answers. Nothing else on this page speaks to it.

const BASE = new URL("api/v1/", document.baseURI);

/** A refusal by the server: its sentence, the field it is about, and the HTTP status (0: no answer). */
export class Refused extends Error {
  constructor(message, field, status) {
    super(message);
    Object.assign(this, { field, status });
  }
}

async function ask(path, options = {}) {
  let answer;
  try {
    answer = await fetch(new URL(path, BASE), options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused("", null, 0);
  }
  if (answer.ok) return answer;
  const { message, field } = await answer.json().catch(() => ({ message: answer.statusText }));
  throw new Refused(message, field ?? null, answer.status);
}

const json = async (path, options) => (await ask(path, options)).json();
const sent = (content, signal) => ({
  method: "POST",
  headers: { "content-type": "application/json" },
  body: JSON.stringify(content),
  signal,
});

export const presets = () => json("presets");
export const simulate = (content, signal) => json("simulate", sent(content, signal));
export const sizeMap = (content, signal) => json("size-map", sent(content, signal));
export const verify = (content, signal) => json("verify", sent(content, signal));
export const job = (id, signal) => json(`jobs/${id}`, { signal });
export const cancel = (id) => ask(`jobs/${id}`, { method: "DELETE", keepalive: true });
export const toml = async (content) => (await ask("scenario/toml", sent(content))).text();
export const runAsCsv = async (content, which) =>
  (await ask(`simulate/csv?which=${which}`, sent(content))).text();
export const motion = (id) => json(`motions/${id}`);
export const motionPreview = (id) => json(`motions/${id}/preview`);

/** Sends a record; unit and step [s] only where its file does not say them. */
export function upload(file, { unit, dt }, signal) {
  const form = new FormData();
  form.set("file", file);
  if (unit) form.set("unit", unit);
  if (dt) form.set("dt", String(dt));
  return json("motions", { method: "POST", body: form, signal });
}

/** Where a job's report or table is fetched. */
export const reportAddress = (id, language) => new URL(`jobs/${id}/report?lang=${language}`, BASE).href;
export const tableAddress = (id) => new URL(`jobs/${id}/csv`, BASE).href;
