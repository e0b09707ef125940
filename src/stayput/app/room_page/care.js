// How many runs a verdict is of: a part of the room's scenario.

import { el, fill, part } from "../dom.js";
import { number, t } from "../words.js";
import * as room from "./room.js";

const SAMPLES = { quick: 20, usual: 60, fine: 200 };

const samples = () => room.current().uncertainty?.samples ?? SAMPLES.usual;

/** Wires the choice. */
export function wire() {
  part("samples").addEventListener("change", ({ target }) => {
    const before = room.current();
    room.change({ ...before, uncertainty: { ...before.uncertainty, samples: Number(target.value) } });
  });
}

/** Builds the choice; called again for another language. */
export function build() {
  const usual = Object.entries(SAMPLES).map(([name, value]) => option(value, t(`care_${name}`))),
    own = Object.values(SAMPLES).includes(samples()) ? [] : [option(samples(), t("careOwn", { n: number(samples()) }))];
  fill(part("samples"), usual, own);
  part("samples").value = String(samples());
}

const option = (value, text) => el("option", { value: String(value), text });

/** Shows what the room says. */
export function update() {
  if (part("samples").value !== String(samples())) build();
}
