// "What if I live on the 20th floor?": the same verification once more, in a building that is tall enough.

import { el, fill, part } from "./dom.js";
import { recalled, remember } from "./memory.js";
import { worded } from "./refusals.js";
import { change, current, forServer, sampled } from "./scene.js";
import { line } from "./verification.js";
import { without, yours } from "./verdict.js";
import { number, percent, t, within } from "./words.js";

const jobs = line();
let storey = Number(recalled("whatif")) || 20,
  most = 1,
  answer = null,
  failed = null,
  asking = false;

/** Builds the question; "again" is called with each new floor. */
export function build(presets, again) {
  most = presets.limits.storeys;
  storey = Math.round(Math.min(most, Math.max(1, storey)));
  const field = el("input", {
    type: "number",
    id: "whatif-floor",
    min: 1,
    max: most,
    step: 1,
    value: String(storey),
    inputmode: "numeric",
  });
  field.addEventListener("change", () => {
    storey = Math.round(Math.min(most, Math.max(1, Number(field.value) || 20)));
    field.value = String(storey);
    remember("whatif", field.value);
    again();
  });
  const take = el("button", {
    type: "button",
    text: t("goThere"),
    onclick: () => change({ storeys: tall(current()), storey }),
  });
  fill(
    part("whatif-ask"),
    el("label", { for: "whatif-floor", text: t("whatIf") }),
    field,
    el("span", { text: t("whatIfFloor") }),
    take,
  );
  say();
}

const tall = (scene) => Math.min(most, Math.max(scene.storeys, Math.round(storey * 1.25), storey));

/** Asks the server, for the scene now; "base" is the verdict that it is compared to. */
export async function ask(base, measures, samples) {
  const scene = current(),
    storeys = tall(scene);
  answer = failed = null;
  asking = true;
  say();
  const elsewhere = forServer({ ...scene, storeys, storey });
  const content = {
    scene: sampled(elsewhere, samples),
    measures,
    compare_usual: false,
    curves: false,
  };
  try {
    const job = await jobs.run(content, () => {});
    if (!job) return;
    answer = { there: job.result, here: base, storey, storeys };
  } catch (error) {
    failed = error;
  }
  asking = false;
  say();
}

export const stop = () => {
  answer = failed = null;
  asking = false;
  part("whatif").textContent = "";
  return jobs.stop();
};

function say() {
  if (asking) part("whatif").textContent = t("thinking");
  if (asking || failed || answer) part("whatif").dataset.state = asking ? "running" : "done";
  if (failed) fill(part("whatif"), worded(failed));
  if (!answer) return;
  const { there, here, storey, storeys } = answer;
  const before = without(here).overturned.estimate,
    after = without(there).overturned.estimate;
  const unknown = after === null || before === null;
  const key = unknown || Math.abs(after - before) < 0.05 ? "whatIfSame" : after > before ? "whatIfMore" : "whatIfLess";
  const first = t(key, {
    storey: number(storey),
    storeys: number(storeys),
    after: percent(after),
    before: percent(before),
  });
  const held = yours(there);
  const second = held
    ? t("space") + t("whatIfHeld", { measures: within(held.label), share: percent(held.overturned.estimate) })
    : "";
  part("whatif").textContent = first + second;
}
