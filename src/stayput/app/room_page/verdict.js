// The verdict on the room in one sentence, with how far it has come, of how many runs, and the best single change.

import { isAway } from "../connection.js";
import { el, fill, part } from "../dom.js";
import { worded } from "../refusals.js";
import { both, number, perCent, share, t } from "../words.js";
import { mayBe } from "./action_plan.js";
import { basis } from "./amounts.js";
import { apply } from "./changes.js";
import { fallingAlone } from "./findings.js";
import * as room from "./room.js";

const ENDED = ["done", "cancelled", "refused", "empty"],
  BETWEEN = " · ";
const CARE = { quick: "0.25", usual: "", fine: "0.08" }, // half-widths of chances; the server has a usual one
  OWN = "own";

/** How precise the verdict is to be; "own" where the room states what is none of the choices. */
function precision() {
  const { samples, precision: stated = "" } = room.current().uncertainty ?? {};
  return samples === undefined && Object.values(CARE).includes(String(stated)) ? String(stated) : OWN;
}

/** Wires the choice of how precise the verdict is to be, a part of the room's scenario. */
export function wire() {
  part("precision").addEventListener("change", ({ target }) => {
    const before = room.current(),
      { samples, precision: _, ...others } = before.uncertainty ?? {},
      chosen = target.value ? { precision: Number(target.value) } : {};
    if (target.value !== OWN) room.change({ ...before, uncertainty: { ...others, ...chosen } });
  });
}

/** Builds the choice of how precise the verdict is to be; called again for another language. */
export function build() {
  const usual = Object.entries(CARE).map(([name, value]) => option(value, t(`care_${name}`))),
    chosen = precision();
  fill(part("precision"), usual, chosen === OWN ? [option(OWN, t("careOwn"))] : []);
  part("precision").value = chosen;
}

const option = (value, text) => el("option", { value, text });

/** Shows how precise a verdict the room asks for. */
export function update() {
  if (part("precision").value !== precision()) build();
}

/** Writes the state of the question, and the newest result as far as there is one. */
export function show({ name, job, result, old, error }) {
  const here = part("answer");
  here.dataset.state = name;
  here.dataset.old = String(old && !error); // a refusal is of the room as it is
  part("understand").dataset.old = String(old);
  here.classList.toggle("empty", !result && !error);
  if (job?.state === "done") here.dataset.job = job.id;
  else delete here.dataset.job;
  write(error ? worded(error) : result ? [both(result.verdict)] : []);
  part("rough").hidden = !result || old || !isRough(result);
  part("rough").textContent = result ? t("rough", { runs: number(result.whole) }) : "";
  falls(error ? null : result);
  best(old || error ? null : result);
  part("basis").textContent = result ? basis(result) : "";
  progress(name, job);
  brief(name, result, old);
}

/** Whether a result is of the room alone, which still runs; then changes of it run beside it. */
const isRough = ({ complete, options }) => !complete && options.length === 1;

/** Says it in one line beside the steps, for where the verdict is on another screen. */
function brief(name, result, old) {
  const refused = name === "refused",
    counting = ENDED.includes(name) ? [] : [t(isAway() ? "serverAway" : "counting")],
    chances = result ? inBrief(result).join(BETWEEN) : t(`state_${name}`);
  const said = refused ? t("briefRefused") : result && old ? t("briefOld", { said: chances }) : chances;
  part("brief").dataset.old = String(Boolean(result) && old);
  part("brief").dataset.state = name;
  part("in-brief").textContent = (result ? [said, ...counting] : [said]).join(BETWEEN);
}

function inBrief(result) {
  const { hit, shut_in: shut } = result;
  if (hit.estimate === null) return [both(result.verdict)];
  const told = [t("briefHit", { share: share(hit) })];
  return shut.estimate > 0 ? [...told, t("briefShutIn", { share: share(shut) })] : told;
}

/** Says the verdict; the same sentence is not said again. */
function write(content) {
  const said = el("span", {}, ...content).textContent;
  if (part("verdict").textContent !== said) fill(part("verdict"), content);
}

/** Names the pieces that overturn often and are not in the sentence, as they hit nobody. */
function falls(result) {
  const names = result ? fallingAlone(result) : [];
  part("falls").hidden = !names.length;
  part("falls").textContent = t("fallsToo", { pieces: names.join(t("listed")) });
}

function best(result) {
  const helping = result?.changes.filter((one) => mayBe(one) && one.helps) ?? [],
    change = helping[0],
    count = helping.filter((one) => one.rank === change.rank).length - 1,
    key = count > 0 ? "amongBest" : "bestChange",
    none = result?.complete && result.changes.length ? t("noBest") : "";
  fill(
    part("best"),
    el("span", { text: change ? t(key, { sentence: both(change.sentence), count: number(count) }) : none }),
    ...(change ? [" ", el("button", { type: "button", class: "primary", text: t("makeBest"), onclick: () => apply(change) })] : []),
  );
}

function progress(name, job) {
  const busy = !ENDED.includes(name),
    bar = part("progress"),
    share = job?.progress ?? 0;
  bar.hidden = !busy;
  part("cancel").hidden = !busy || !job;
  part("verify").hidden = busy || name === "empty";
  bar.value = share;
  bar.setAttribute("aria-valuetext", perCent(number(100 * share)));
  part("state").textContent = said(name, job);
}

/** How far the question is, in words. */
function said(name, job) {
  if (isAway() && !ENDED.includes(name)) return t("serverAway");
  if (job?.position) return t("before", { n: number(job.position) });
  if (name === "running" && job?.result) return t(isRough(job.result) ? "roomBetter" : "changesWait");
  return name === "done" ? "" : t(`state_${name}`);
}
