// Plays the pairs of runs: two scenes of one clock, and the time in the histories below them.

import { player } from "./canvas/clock.js";
import { digits } from "./canvas/digits.js";
import { drawScene } from "./canvas/painter.js";
import { readInks } from "./canvas/pen.js";

const EDGES = [62, 890]; // left and right edge of the histories, in their own units
const { modes: looks, pairs } = JSON.parse(document.getElementById("scenes").textContent);
const modeColours = Object.fromEntries(Object.entries(looks).map(([mode, { colour }]) => [mode, colour]));

function show(article, pair) {
  const find = (name) => article.querySelector(name);
  const canvases = [...article.querySelectorAll("canvas")],
    states = [...article.querySelectorAll(".state")];
  const play = find(".play"),
    slider = find(".time"),
    speed = find(".speed"),
    span = pair.end_s - pair.start_s || 1;
  let poster = true; // the most telling moment is shown until it is played

  function draw(now) {
    const time = Math.max(pair.start_s, now);
    pair.runs.forEach((run, i) => {
      const look = { kind: pair.kind, loads: pair.loads_kg, colours: modeColours };
      const shown = drawScene(canvases[i], pair, run, time, look);
      const degrees = digits((shown.tilt * 180) / Math.PI, 1);
      states[i].textContent = `${looks[shown.mode].label} · ${degrees}° · ${digits(100 * shown.slide, 1)} cm`;
    });
    const share = (time - pair.start_s) / span;
    for (const end of ["x1", "x2"])
      find(".now").setAttribute(end, EDGES[0] + (EDGES[1] - EDGES[0]) * share);
    slider.value = 1000 * share;
    slider.setAttribute("aria-valuetext", `${digits(time, 1)} s`);
    find(".clock").textContent = `${digits(time, 2)} s`;
  }
  const label = (playing) => (play.textContent = playing ? play.dataset.pause : play.dataset.play);
  const clock = player(draw, label, Infinity);
  clock.span(pair.start_s, pair.end_s, pair.telling_s, true);
  play.onclick = () => {
    if (poster) clock.seek(pair.start_s);
    poster = false;
    clock.toggle();
  };
  slider.oninput = () => {
    poster = false;
    clock.seek(pair.start_s + (slider.value / 1000) * span);
  };
  speed.onchange = () => clock.faster(Number(speed.value));
  return () => draw(clock.now);
}

readInks();
const drawings = [...document.querySelectorAll(".pair")].map((article) =>
  show(article, pairs[Number(article.dataset.pair)]),
);
const redraw = () => {
  readInks();
  drawings.forEach((draw) => draw());
};
redraw();
for (const name of ["resize", "beforeprint", "afterprint"]) addEventListener(name, redraw);
for (const query of ["(prefers-color-scheme: dark)", "print"])
  matchMedia(query).addEventListener("change", redraw);
addEventListener("beforeprint", () =>
  document.querySelectorAll("details").forEach((one) => {
    one.open = true;
  }),
);
