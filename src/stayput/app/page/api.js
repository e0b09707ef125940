// The server's answers. Nothing else on this page speaks to it.

// "data-home" says where the server's root is, seen from a page that is not there itself
const HOME = new URL(document.documentElement.dataset.home ?? ".", document.baseURI),
  BASE = new URL("api/v1/", HOME);

/** A refusal by the server: its sentence in English, in Japanese if it has one, the field, the HTTP status (0: no answer). */
export class Refused extends Error {
  constructor({ message = "", message_ja = null, field = null, perhaps = null, also = [] }, status) {
    super(message);
    Object.assign(this, { japanese: message_ja, field, perhaps, also, status });
  }
}

// which page at this address asks: the server lets pages take turns
const CLIENT = { "x-stayput-client": `${Date.now()}-${Math.random()}` };

async function ask(path, options = {}) {
  let answer;
  try {
    answer = await fetch(new URL(path, BASE), { ...options, headers: { ...CLIENT, ...options.headers } });
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refused({}, 0);
  }
  if (answer.ok) return answer;
  throw new Refused(await answer.json().catch(() => ({ message: answer.statusText })), answer.status);
}

const json = async (path, options) => (await ask(path, options)).json();
// what the page notes in a room, of things that are tried and of the home: it is no part of a scene
const NOTED = ["was", "home"];
const sent = (content, signal) => ({
  method: "POST",
  headers: { "content-type": "application/json" },
  body: JSON.stringify(content, (key, value) => (NOTED.includes(key) ? undefined : value)),
  signal,
});

const blob = async (path, query, content) =>
  (await ask(`${path}?${new URLSearchParams(query)}`, content && sent(content))).blob();

export const ping = () => json("ping");
export const presets = () => json("presets");
export const simulate = (content, signal) => json("simulate", sent(content, signal));
export const shaking = (content, signal) => json("shaking", sent(content, signal));
export const verify = (content, signal) => json("verify", sent(content, signal));
export const room = (content, signal) => json("room", sent(content, signal));
export const job = (id, signal) => json(`jobs/${id}`, { signal });
export const everyday = (id, scene, signal) =>
  json(`jobs/${id}/everyday`, { ...sent({ scene }, signal), method: "PUT" });
export const cancel = (id) => ask(`jobs/${id}`, { method: "DELETE", keepalive: true });
export const toml = async (content) => (await ask("scenario/toml", sent(content))).text();
export const runAsCsv = async (content, which) =>
  (await ask(`simulate/csv?which=${which}`, sent(content))).text();
export const film = (content, query) => blob("simulate/film", query, content);
export const readScenario = (toml, name) => json("scenario/read", sent({ toml, name }));
const chosen = (component, further = {}) =>
  new URLSearchParams({ ...(component && { component }), ...further }).toString().replace(/^(?=.)/, "?");
export const motion = (id, component, further) => json(`motions/${id}${chosen(component, further)}`);
export const motionPreview = (id, component) => json(`motions/${id}/preview${chosen(component)}`);

/** Sends a record; unit, time step dt [s] and the component only where its file does not say them. */
export function upload(file, said, signal) {
  const form = new FormData();
  form.set("file", file);
  for (const [name, value] of Object.entries(said)) if (value) form.set(name, value);
  return json("motions", { method: "POST", body: form, signal });
}

/** Where a job's report or table is fetched. */
export const reportAddress = (id, language) => new URL(`jobs/${id}/report?lang=${language}`, BASE).href;
export const tableAddress = (id) => new URL(`jobs/${id}/csv`, BASE).href;
export const planAddress = (id, query) => new URL(`jobs/${id}/plan?${new URLSearchParams(query)}`, BASE).href;

/** Waits until the plan to buy and do of a job's room is made; the server then has it. */
export const plan = async (id, query, signal) => (await ask(planAddress(id, query), { signal })).text();
export const planProgress = (id, query, signal) =>
  json(`jobs/${id}/plan/progress?${new URLSearchParams(query)}`, { signal });
