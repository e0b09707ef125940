// Plays one run: its scene, its histories below it, and the time that they share.

import { digits } from "./canvas/digits.js";
import { drawScene } from "./canvas/painter.js";
import { ink } from "./canvas/pen.js";
import { playBar } from "./canvas/play_bar.js";
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
      label: texts.tilt_shown.replace("{angle}", digits((peaks.tilt * 180) / Math.PI, 1)),
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
  part("tilt").textContent = `${digits((shown.tilt * 180) / Math.PI, 1)}°`;
  part("slide").textContent = `${digits(shown.slide * 100, 1)} cm`;
}

const bar = playBar(film, { start, end }, draw);
picked(part("strip"), { start, end }, (time) => bar.clock.seek(time));
bar.begin();
