// Plays one run: its scene, its histories below it, and the time that they share.

import { player, prefersReducedMotion } from "./canvas/clock.js";
import { drawScene } from "./canvas/painter.js";
import { ink, line, prepared, readInks } from "./canvas/pen.js";

const film = JSON.parse(document.getElementById("run").textContent);
const { floor, modes: looks, texts } = film,
  [run] = film.runs;
const part = (id) => document.getElementById(id);
const start = run.time_s[0],
  end = run.time_s.at(-1);
const modeColours = Object.fromEntries(Object.entries(looks).map(([mode, { colour }]) => [mode, colour]));
const LEFT = 46,
  RIGHT = 8,
  BAND = 8;

const along = (width, t) => LEFT + ((width - LEFT - RIGHT) * (t - start)) / (end - start);
const most = (values) => values.reduce((peak, value) => Math.max(peak, Math.abs(value)), 0) || 1;
const peaks = {
  acceleration: most(floor.acceleration_m_s2),
  // no more than three critical angles, so that the rocking before a fall is seen
  tilt: Math.min(most(run.tilt_rad), 3 * run.body.slenderness_rad),
};

function drawHistory(pen, width, top, height, { times, values, peak, colour, label, unit }) {
  const middle = top + 16 + (height - 16) / 2,
    half = (height - 20) / 2;
  line(pen, ink.faint, 1, [
    [LEFT, middle],
    [width - RIGHT, middle],
  ]);
  pen.save();
  pen.beginPath();
  pen.rect(0, top, width, height);
  pen.clip();
  line(
    pen,
    colour,
    1.2,
    times.map((t, i) => [along(width, t), middle - (half * values[i]) / peak]),
  );
  pen.restore();
  pen.fillStyle = ink.muted;
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "left";
  pen.fillText(label, LEFT, top + 11);
  pen.textAlign = "right";
  pen.fillText(unit, LEFT - 4, middle + 4);
}

function drawStrip(now) {
  const [pen, width, height] = prepared(part("strip")),
    each = (height - BAND - 4) / 2;
  drawHistory(pen, width, 0, each, {
    times: floor.time_s,
    values: floor.acceleration_m_s2,
    peak: peaks.acceleration,
    colour: ink.record,
    label: film.strip_title,
    unit: "m/s²",
  });
  drawHistory(pen, width, each, each, {
    times: run.time_s,
    values: run.tilt_rad,
    peak: peaks.tilt,
    colour: ink.ink,
    label: texts.tilt_shown.replace("{angle}", ((peaks.tilt * 180) / Math.PI).toFixed(1)),
    unit: texts.tilt,
  });
  run.modes.forEach(([t, mode], i) => {
    const next = run.modes[i + 1]?.[0] ?? end;
    pen.fillStyle = modeColours[mode];
    pen.fillRect(along(width, t), height - BAND, along(width, next) - along(width, t), BAND);
  });
  line(pen, ink.alarm, 2, [
    [along(width, now), 0],
    [along(width, now), height],
  ]);
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
const pick = (event) => {
  const box = part("strip").getBoundingClientRect();
  clock.seek(start + ((event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT)) * (end - start));
};
part("strip").onpointerdown = (event) => {
  part("strip").setPointerCapture(event.pointerId);
  pick(event);
};
part("strip").onpointermove = (event) => event.buttons && pick(event);
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
