// "Understand it": verdict, curve and ranking, asked for once the scene has settled.

import * as api from "./api.js";
import { patiently } from "./connection.js";
import { el, fill, part, settled } from "./dom.js";
import * as estimates from "./estimates.js";
import * as everyday from "./everyday.js";
import * as fragility from "./fragility.js";
import * as keep from "./keep.js";
import * as ranking from "./ranking.js";
import { recalled, remember } from "./memory.js";
import { worded } from "./refusals.js";
import { change, sampled } from "./scene.js";
import { line } from "./verification.js";
import * as verdict from "./verdict.js";
import { number, perCent, t } from "./words.js";

const SETTLED = 900,
  SOON = 150,
  MARGINS = ["everyday", "everyday-cases"],
  PARTS = [...MARGINS, "estimates", "ranking"];
const jobs = line(),
  curving = line();
let question = null,
  curved = null, // a verdict with curves, where they were asked for by themselves
  problem = null,
  result = null, // the verdict that is shown: its headline and its ranking are of the same runs
  asking = null,
  round = 0;

/** Builds the questions; "request" gives the scene and its measures. */
export function build(request) {
  question = request;
  part("cancel").addEventListener("click", () => {
    stop();
    state("cancelled");
  });
  part("verify").addEventListener("click", () => work());
  part("samples").value = recalled("care") ?? part("samples").value;
  if (!part("samples").value) part("samples").value = "120";
  part("samples").addEventListener("change", () => {
    remember("care", part("samples").value);
    work();
  });
  addEventListener("pageshow", (event) => {
    if (event.persisted) soon(); // its jobs ended when it was left
  });
  const charts = settled(120, () => {
    if (result?.complete) showCurves();
  });
  for (const name of ["resize", "shown"]) addEventListener(name, charts);
}

/** What is shown no longer belongs to the scene; the answer is asked for when it has settled. */
export function outdated() {
  part("understand").dataset.old = "true";
  part("ranking-rough").hidden = true;
  date([...PARTS, "fragility"], true);
  stop();
  keep.point(null);
  state("waiting");
  soon();
}

/** What people do to the piece has changed: returns whether the verdict at hand only needs that told anew. */
export function everydayChanged() {
  if (part("understand").dataset.state !== "done") return false;
  date(MARGINS, true);
  margins();
  return true;
}

const margins = settled(SOON, async () => {
  const mine = round;
  asking?.abort();
  const own = (asking = new AbortController()),
    wanted = () => mine === round && own === asking;
  if (part("understand").dataset.state !== "done") return;
  try {
    const { scene } = question(),
      said = await patiently(() => api.everyday(part("understand").dataset.job, scene, own.signal), wanted);
    if (!said || !wanted()) return;
    result.everyday = said;
    everyday.show(result);
    date(MARGINS, false);
  } catch (error) {
    if (error.name !== "AbortError" && wanted()) outdated(); // the server has forgotten the job
  }
});

/** Marks what is shown as of the scene before, or as of this one. */
const date = (ids, old) => ids.forEach((id) => (part(id).dataset.old = String(old)));
const soon = settled(SETTLED, () => work());

function stop() {
  round += 1;
  jobs.stop();
  curving.stop();
}

const samples = () => Number(part("samples").value);

/** Asks for the verdict; what is known of it is shown as it gets better. */
async function work() {
  stop();
  const mine = round,
    { scene, measures } = question();
  if (Array.isArray(scene.furniture)) {
    state("pieces");
    return;
  }
  const content = { scene: sampled(scene, samples()), measures, curves: scene.dimensions === 2 };
  state("running");
  progress(0);
  try {
    const job = await jobs.run(content, (running) => {
      progress(running.progress);
      if (running.result && mine === round) look(running.result);
    });
    if (!job || mine !== round) return;
    curved = null;
    part("understand").dataset.job = job.id;
    state("done");
    keep.point(job.id);
    look(job.result);
  } catch (error) {
    if (mine !== round) return;
    problem = error;
    state("refused");
  }
}

/** Shows a verdict; one that is not complete yet is marked as what may still change. */
function look(known) {
  result = known;
  part("understand").dataset.old = "false";
  date(PARTS, false);
  date(["fragility"], !known.complete);
  part("ranking-rough").hidden = known.complete;
  part("ranking-rough").textContent = t("rankingRough", { runs: number(known.motions * known.samples) });
  display();
}

const showCurves = () => fragility.show(curved ?? result, askCurves);

/** Works out the curves of what is looked at, which a verification in space leaves out. */
async function askCurves() {
  const mine = round,
    { scene, measures } = question(),
    content = { scene: sampled(scene, samples()), measures, compare_usual: false };
  const bar = el("progress", { max: 1, value: 0, "aria-label": t("progress") });
  fill(part("fragility"), el("p", { class: "hint", role: "status", text: t("thinking") }), bar);
  try {
    const job = await curving.run(content, (running) => (bar.value = running.progress));
    if (!job || mine !== round) return;
    curved = { ...job.result, job: job.id };
    showCurves();
  } catch (error) {
    if (mine === round) fill(part("fragility"), worded(error));
  }
}

const takeMeasures = (chosen) =>
  change({ measures: Object.fromEntries(chosen.map(({ type, ...values }) => [type, values])) });

function display() {
  verdict.show(result);
  everyday.show(result);
  estimates.show(result);
  ranking.show(result, takeMeasures);
  if (result.complete) showCurves();
}

/** Writes the words again, for another language. */
export function again() {
  if (result) display();
  state(part("understand").dataset.state);
  if (part("understand").dataset.state === "done") keep.point(part("understand").dataset.job);
}

function state(name) {
  part("understand").dataset.state = name;
  part("progress").hidden = part("cancel").hidden = name !== "running";
  part("verify").hidden = name === "running" || name === "pieces";
  part("state").textContent = name === "done" ? "" : t(`state_${name}`);
  if (name === "refused") fill(part("verdict"), worded(problem));
}

function progress(share) {
  part("progress").value = share;
  part("progress").setAttribute("aria-valuetext", perCent(number(100 * share)));
}
