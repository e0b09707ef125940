// Plays one run: its scene, its histories below it, and the time that they share.

import { player, prefersReducedMotion } from "./canvas/clock.js";
import { drawScene } from "./canvas/painter.js";
import { ink, readInks } from "./canvas/pen.js";
import { drawRows, most, picked } from "./canvas/strip.js";

const film = JSON.parse(document.getElementById("run").textContent);
const { floor, modes: looks, texts } = film,
  [run] = film.runs;
const part = (id) => document.getElementById(id);
const start = run.time_s[0],
  end = run.time_s.at(-1);
const modeColours = Object.fromEntries(Object.entries(looks).map(([mode, { colour }]) => [mode, colour]));
const BAND = 8; // height of the modes' colours

const peaks = {
  acceleration: most(floor.acceleration_m_s2),
  // no more than three critical angles, so that the rocking before a fall is seen
  tilt: Math.min(most(run.tilt_rad), 3 * run.body.slenderness_rad),
};

function drawStrip(now) {
  const rows = [
    {
      label: film.strip_title,
      unit: "m/s²",
      peak: peaks.acceleration,
      series: [{ times: floor.time_s, values: floor.acceleration_m_s2, colour: ink.record }],
    },
    {
      label: texts.tilt_shown.replace("{angle}", ((peaks.tilt * 180) / Math.PI).toFixed(1)),
      unit: texts.tilt,
      peak: peaks.tilt,
      series: [{ times: run.time_s, values: run.tilt_rad, colour: ink.ink }],
    },
  ];
  const { pen, along, height } = drawRows(part("strip"), rows, { start, end, now, below: BAND + 4 });
  run.modes.forEach(([t, mode], i) => {
    const next = run.modes[i + 1]?.[0] ?? end;
    pen.fillStyle = modeColours[mode];
    pen.fillRect(along(t), height - BAND, along(next) - along(t), BAND);
  });
}

function draw(now) {
  const shown = drawScene(part("scene"), film, run, now, { colours: modeColours });
  drawStrip(now);
  part("chip").style.background = modeColours[shown.mode];
  part("mode").textContent = looks[shown.mode].label;
  part("tilt").textContent = `${((shown.tilt * 180) / Math.PI).toFixed(1)}°`;
  part("slide").textContent = `${(shown.slide * 100).toFixed(1)} cm`;
  part("clock").textContent = `${now.toFixed(2)} s`;
  part("time").value = (1000 * (now - start)) / (end - start);
}

const clock = player(
  draw,
  (playing) => (part("play").textContent = playing ? texts.pause : texts.play),
  film.hold_s,
);

for (const value of [...new Set([0.1, 0.25, 0.5, 1, 2, 4, film.speed])].sort((p, q) => p - q))
  part("speed").add(new Option(`${value} ×`, value, false, value === film.speed));
clock.faster(film.speed);
part("speed").onchange = (event) => clock.faster(Number(event.target.value));
part("caption").textContent = film.caption;
part("play").onclick = () => clock.toggle();
part("time").oninput = (event) => clock.seek(start + (event.target.value / 1000) * (end - start));
const again = () => {
  readInks();
  draw(clock.now);
};
part("theme").onclick = () => {
  const dark = getComputedStyle(document.documentElement).getPropertyValue("--paper").trim() === "#14181d";
  document.documentElement.dataset.theme = dark ? "light" : "dark";
  again();
};
picked(part("strip"), { start, end }, (time) => clock.seek(time));
addEventListener("keydown", (event) => {
  if (event.target.closest("button, select, input")) return;
  if (event.key === " ") {
    clock.toggle();
    event.preventDefault();
  }
  if (event.key === "ArrowRight") clock.step(0.02);
  if (event.key === "ArrowLeft") clock.step(-0.02);
});
addEventListener("resize", again);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
const wanted = Number(location.hash.slice(1)); // "#6.3" opens the page at 6.3 s, paused
const chosen = location.hash && Number.isFinite(wanted);
readInks();
clock.span(start, end, chosen ? wanted : start, chosen || prefersReducedMotion());
again();
