// A scenario file of several pieces: read by the server, shaken and shown as it is, until the scene changes.

import * as api from "./api.js";
import { el, fill, part } from "./dom.js";
import { both, number, t } from "./words.js";

let file = null; // {name, scene}

/** Whether a dropped file is a scenario, by its name. */
export const isScenario = ({ name }) => /\.toml$/i.test(name);

/** The file that is shown, as the server is asked about it; null: the page's own scene is. */
export const asked = () => file && { scene: file.scene, measures: [] };

/** What the file is called. */
export const shownName = () => file?.name ?? null;

/** Reads a scenario file; where it is one of several pieces, it is shown from now on. Returns whether it is. */
export async function take(given) {
  const { scene, pieces } = await api.readScenario(await given.text());
  if (pieces.length) file = { name: given.name, scene };
  return pieces.length > 0;
}

/** Shows the page's own scene again. */
export const leave = () => (file = null);

/** Lists the pieces and what became of each, with the button that leaves the file. */
export function list(run, outcomes, back) {
  const labels = Object.fromEntries(outcomes.map((one) => [one.id, both(one.label)]));
  part("pieces").hidden = !file;
  document.body.dataset.pieces = String(Boolean(file));
  if (!file) return fill(part("pieces"));
  const what = ({ outcome, overturn_time_s: time }) =>
    `${labels[outcome]}${time === null ? "" : `${t("listed")}${number(time, 1)}\u00a0s`}`;
  fill(
    part("pieces"),
    el("h3", { text: t("piecesTitle", { name: file.name }) }),
    el(
      "ul",
      { class: "key" },
      ...run.pieces.map((one, i) =>
        el(
          "li",
          {},
          chip(run.scene.bodies[i].colour),
          el("span", { text: `${one.name}${t("colon")}${what(one)}` }),
        ),
      ),
    ),
    el("p", { class: "hint", text: t("piecesNote") }),
    el("button", { type: "button", text: t("ownPiece"), onclick: back }),
  );
}

function chip(colour) {
  const made = el("span", { class: "chip" });
  made.style.background = colour;
  return made;
}
