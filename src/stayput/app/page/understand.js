// "Understand it": verdict, curve and ranking, asked for once the scene has settled.

import * as api from "./api.js";
import { patiently } from "./connection.js";
import { fill, part, settled } from "./dom.js";
import * as estimates from "./estimates.js";
import * as everyday from "./everyday.js";
import * as fragility from "./fragility.js";
import * as keep from "./keep.js";
import * as ranking from "./ranking.js";
import { recalled, remember } from "./memory.js";
import { worded } from "./refusals.js";
import { change, precisely } from "./scene.js";
import { line } from "./verification.js";
import * as verdict from "./verdict.js";
import { number, perCent, t } from "./words.js";

const SETTLED = 900,
  SOON = 150,
  MARGINS = ["everyday", "everyday-cases"],
  PARTS = [...MARGINS, "estimates", "ranking"];
const jobs = line();
let question = null,
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
  part("precision").value = recalled("care") ?? "";
  if (part("precision").selectedIndex < 0) part("precision").value = ""; // of another version of this page
  part("precision").addEventListener("change", () => {
    remember("care", part("precision").value);
    work();
  });
  addEventListener("pageshow", (event) => {
    if (event.persisted) soon(); // its jobs ended when it was left
  });
  const charts = settled(120, () => {
    if (result?.complete) fragility.show(result);
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
}

/** Asks for the verdict; what is known of it is shown as it gets better. */
async function work() {
  stop();
  const mine = round,
    { scene, measures } = question();
  if (Array.isArray(scene.furniture)) {
    state("pieces");
    return;
  }
  const content = { scene: precisely(scene, Number(part("precision").value)), measures, curves: true };
  state("running");
  progress(0);
  try {
    const job = await jobs.run(content, (running) => {
      progress(running.progress);
      if (running.result && mine === round) look(running.result);
    });
    if (!job || mine !== round) return;
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
  date(["estimates", "fragility"], !known.complete);
  part("ranking-rough").hidden = known.complete;
  part("ranking-rough").textContent = t("rankingRough", { runs: eachRan(known) });
  display();
}

/** The fewest and the most runs that an option has had. */
function eachRan({ options }) {
  const runs = options.map((one) => one.runs),
    [low, high] = [Math.min(...runs), Math.max(...runs)].map((count) => number(count));
  return low === high ? low : t("shareBetween", { low, high });
}

const takeMeasures = (chosen) =>
  change({ measures: Object.fromEntries(chosen.map(({ type, ...values }) => [type, values])) });

function display() {
  verdict.show(result);
  everyday.show(result);
  ranking.show(result, takeMeasures);
  if (!result.complete) return;
  estimates.show(result);
  fragility.show(result);
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
