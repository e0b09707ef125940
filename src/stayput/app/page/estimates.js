// "What do formulas and standards say?": each beside the simulation of the piece without measures.

import { el, fill, part } from "./dom.js";
import { both } from "./words.js";

/** Writes what each says. */
export function show({ estimates }) {
  fill(
    part("estimates"),
    estimates.rows.flatMap((row) => [
      el("dt", { text: both(row.formula) }),
      el("dd", {}, el("p", { text: both(row.says) }), el("p", { class: "hint", text: both(row.beside) })),
    ]),
  );
}
