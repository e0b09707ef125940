// The verdict on the room in one sentence, with how far it has come, and the best single change.

import { el, fill, part } from "../dom.js";
import { worded } from "../refusals.js";
import { both, number, perCent, t } from "../words.js";

const ENDED = ["done", "cancelled", "refused"];
let take = () => {};

/** Wires the button of the best change: "apply" makes a change in the room. */
export function wire(apply) {
  take = apply;
}

/** Writes the state of the question, and the newest result as far as there is one. */
export function show({ name, job, result, old, error }) {
  const here = part("answer");
  here.dataset.state = name;
  here.dataset.old = part("understand").dataset.old = String(old);
  here.classList.toggle("empty", !result && !error);
  if (job?.state === "done") here.dataset.job = job.id;
  else delete here.dataset.job;
  write(error ? worded(error) : result ? [both(result.verdict)] : []);
  part("rough").hidden = !result || old || result.complete;
  part("rough").textContent = result ? t("rough", { runs: number(result.runs) }) : "";
  best(old || error ? null : result);
  part("basis").textContent = result
    ? t("basisOfRoom", {
        motions: number(result.motions),
        runs: number(result.runs),
        seed: String(result.seed),
        seconds: number(result.seconds, 1),
      })
    : "";
  progress(name, job);
}

/** Says the verdict; the same sentence is not said again. */
function write(content) {
  const said = el("span", {}, ...content).textContent;
  if (part("verdict").textContent !== said) fill(part("verdict"), content);
}

function best(result) {
  const change = result?.changes.find((one) => one.helps);
  fill(
    part("best"),
    ...(result?.changes.length ? [el("span", { text: both(result.best) })] : []),
    ...(change ? [" ", el("button", { type: "button", class: "primary", text: t("makeBest"), onclick: () => take(change) })] : []),
  );
}

function progress(name, job) {
  const busy = !ENDED.includes(name),
    bar = part("progress"),
    share = job?.progress ?? 0;
  bar.hidden = !busy;
  part("cancel").hidden = !busy || !job;
  part("verify").hidden = busy;
  bar.value = share;
  bar.setAttribute("aria-valuetext", perCent(number(100 * share)));
  part("state").textContent = said(name, job);
}

/** How far the question is, in words. */
function said(name, job) {
  if (job?.position) return t("before", { n: number(job.position) });
  if (name === "running" && job?.result) return t("roomBetter");
  return name === "done" ? "" : t(`state_${name}`);
}
