// The clock of an animation and what leads it: play, from the beginning, time, speed, keys.

import { icon } from "./icons.js";
import { player } from "./canvas/clock.js";
import { fill, part } from "./dom.js";
import { recalled, remember } from "./memory.js";
import { number, t } from "./words.js";

let drawing = () => {};

const mark = (playing) => {
  fill(part("play"), icon(playing ? "pause" : "play"));
  part("play").setAttribute("aria-label", t(playing ? "pause" : "play"));
};
export const clock = player(drawAll, mark);

function drawAll(now) {
  drawing(now);
  if (!clock.end) return;
  part("time").value = String(Math.round((1000 * now) / clock.end));
  part("time").setAttribute(
    "aria-valuetext",
    t("timeText", { now: number(now, 1), end: number(clock.end, 0) }),
  );
  part("clock").textContent = `${number(now, 1)} / ${number(clock.end, 0)}\u00a0s`;
}

/** Writes the words again, for another language or theme. */
export const again = () => mark(clock.playing);

/** Wires the buttons and the keys; "draw" is called with each time that is shown. */
export function wire(draw) {
  drawing = draw;
  mark(false);
  fill(part("again"), icon("again"));
  part("play").addEventListener("click", () => clock.toggle());
  part("again").addEventListener("click", () => {
    clock.seek(clock.start);
    clock.play(true);
  });
  part("time").addEventListener("input", (event) =>
    clock.seek((clock.end * Number(event.target.value)) / 1000),
  );
  const speed = part("speed"),
    usual = speed.value;
  speed.value = recalled("speed") ?? usual;
  if (!speed.value) speed.value = usual;
  clock.faster(Number(speed.value));
  speed.addEventListener("change", () => {
    remember("speed", speed.value);
    clock.faster(Number(speed.value));
  });
  addEventListener("keydown", (event) => {
    if (
      event.target.closest("button, select, input, textarea, summary, a, svg") ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey
    )
      return;
    if (event.key === " ") {
      clock.toggle();
      event.preventDefault();
    }
    if (event.key === "ArrowRight") clock.step(0.05);
    if (event.key === "ArrowLeft") clock.step(-0.05);
  });
  for (const name of ["resize", "shown"]) addEventListener(name, () => clock.redraw());
}
