// A scenario file of several pieces: read by the server, shaken and shown as it is, until the scene changes.

import * as api from "./api.js";
import { patiently } from "./connection.js";
import { el, fill, part } from "./dom.js";
import { packed, unpacked, utf8 } from "./packing.js";
import { wordedOfScenario } from "./refusals.js";
import { fate } from "./story.js";
import { refusal, tell } from "./upload.js";
import { both, t } from "./words.js";

const LONGEST = 8000; // letters of a file in a link: longer ones are cut by much that links are sent with

let file = null, // {name, text, letters, asked, answer}
  newest = 0;

/** The file that is shown, as the server is asked about it; null: the page's own scene is. */
export const asked = () => file?.asked ?? null;

/** What the server answered about the file that is shown, or null. */
export const answer = () => file?.answer ?? null;

/** What the file is called. */
export const shownName = () => file?.name ?? null;

/** The file that is shown, as it came. */
export const shownText = () => file?.text ?? null;

/** What a link holds of the file that is shown: {name, letters}, or null where there is none or it is too long. */
export const linked = () => (file && !tooLong() ? { name: file.name, letters: file.letters } : null);

/** Whether the file that is shown is too long for a link. */
export const tooLong = () => file !== null && file.letters.length > LONGEST;

/**
 * Reads a scenario file and shakes what stands there; where it is of several pieces, it is shown from now on. Returns
 * whether it is; null where something else has been asked for since. What is refused changes nothing.
 */
export async function take(name, text) {
  const mine = ++newest,
    wanted = () => mine === newest;
  const read = await patiently(() => api.readScenario(text, name), wanted);
  if (!wanted()) return null;
  if (!read.pieces.length) return false;
  const given = { scene: read.scene, measures: [] };
  const simulated = await patiently(() => api.simulate(given), wanted);
  const letters = await packed(text);
  if (!wanted()) return null;
  file = { name, text, letters, asked: given, answer: simulated };
  return true;
}

/** Takes a file that was dropped, and says beside the drop place what becomes of it; "shake" is called where it is shown. */
export async function open(dropped, shake) {
  const content = await dropped.arrayBuffer().then(utf8).catch(() => null);
  if (content === null) return tell(() => [refusal([t("notText")])]);
  tell(() => [el("p", { role: "status", text: t("shaking") })]);
  try {
    const several = await take(dropped.name, content);
    if (several === null) return;
    tell(several ? null : () => [refusal([t("onePieceFile")])]);
    if (several) shake();
  } catch (error) {
    tell(() => [refusal(wordedOfScenario(error))]);
  }
}

/** Shows the file of a link; returns false where the link does not hold all of one. */
export async function takeLinked({ name, letters }) {
  if (file?.letters === letters) return true;
  const text = await unpacked(letters).catch(() => null);
  return text !== null && (await take(name, text)) !== false;
}

/** Shows the page's own scene again. */
export function leave() {
  file = null;
  newest++;
}

/** Lists the pieces and what became of each, with the button that leaves the file; no run of a file: none. */
export function list(run, outcomes, back) {
  const labels = Object.fromEntries(outcomes.map((one) => [one.id, both(one.label)]));
  const here = Boolean(file && run);
  part("pieces").hidden = !here;
  document.body.dataset.pieces = String(here);
  if (!here) return fill(part("pieces"));
  fill(
    part("pieces"),
    el("h3", { text: t("piecesTitle", { name: file.name }) }),
    el(
      "ul",
      { class: "key" },
      ...run.pieces.map((one) => fate(one, { name: one.name, outcomes: labels })),
    ),
    el("p", { class: "hint", text: t("piecesNote") }),
    el("button", { type: "button", text: t("ownPiece"), onclick: back }),
  );
}
