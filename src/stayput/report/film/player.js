// Plays one run: its scene, its histories below it, and the time that they share.

import { VIEWS, lead, orbit } from "./canvas/camera.js";
import { beforeNextFrame, prefersReducedMotion } from "./canvas/clock.js";
import { digits } from "./canvas/digits.js";
import { ink } from "./canvas/pen.js";
import { playBar } from "./canvas/play_bar.js";
import { spacePainter } from "./canvas/space.js";
import { flatPainter } from "./canvas/space_flat.js";
import { spaceScene } from "./canvas/space_scene.js";
import { drawRows, most, picked } from "./canvas/strip.js";

const film = JSON.parse(document.getElementById("run").textContent);
const scene = spaceScene(film),
  { looks, texts } = film,
  { bodies } = scene;
const part = (id) => document.getElementById(id);
const degrees = (angle) => (angle * 180) / Math.PI;
const several = bodies.length > 1;
const camera = orbit(scene.points, scene.size);
const solid = spacePainter(part("scene"), scene);
const painter = solid ?? flatPainter(part("scene"), scene);
part("flat").hidden = solid !== null;
part("turned").hidden = scene.from === "side"; // in the plane nothing turns
let chosen = 0;

const peaks = {
  acceleration: Math.max(...scene.accelerations.map(({ values }) => most(values))),
  tilts: bodies.map(({ tilts }) => tilts.reduce((peak, value) => Math.max(peak, Math.abs(value)), 0)),
};
const AXES = { x: "record", y: "calm", z: "pad" };
const BAND = 8; // height of the colours of how firmly the piece stands

function drawStrip(now) {
  const { tilts, name } = bodies[chosen];
  const rows = [
    {
      label: film.strip_title,
      unit: "m/s²",
      peak: peaks.acceleration,
      series: scene.accelerations.map(({ axis, times, values }) => ({
        ...{ times, values, name: axis, colour: ink[AXES[axis]] },
      })),
    },
    {
      label: texts.tilt_of
        .replace("{name}", () => name)
        .replace("{angle}", digits(degrees(peaks.tilts[chosen]), 1)),
      unit: texts.tilt,
      peak: Math.max(0.001, peaks.tilts[chosen]), // what is rounding is drawn as nothing
      positive: tilts.every((tilt) => tilt >= 0),
      series: [{ times: scene.times, values: tilts, colour: ink.ink, width: 1.5 }],
    },
  ];
  const { start, end } = scene;
  const { pen, along, height } = drawRows(part("strip"), rows, { start, end, now, below: BAND + 4 });
  const { stability: steps } = bodies[chosen];
  steps.forEach(([from, step], i) => {
    const until = steps[i + 1]?.[0] ?? end;
    pen.fillStyle = ink[step];
    pen.fillRect(along(from), height - BAND, along(until) - along(from), BAND);
  });
}

function drawPicture(now) {
  painter.draw(now, camera, { chosen: several ? chosen : null, shaken: part("shaken").checked });
}

function draw(now) {
  drawPicture(now);
  drawStrip(now);
  const { tilt, slide, yaw } = bodies[chosen].state(now);
  part("tilt").textContent = `${digits(degrees(tilt), 1)}°`;
  part("slide").textContent = `${digits(100 * slide, 1)} cm`;
  part("yaw").textContent = `${digits(degrees(yaw), 1)}°`;
  part("stands").textContent = looks[bodies[chosen].stands(now)];
  bodies.forEach(({ stands }, b) => (chips[b].style.background = `var(--${stands(now)})`));
}

const bar = playBar(film, scene, draw),
  { clock } = bar;
const turned = beforeNextFrame(() => drawPicture(clock.now));

/** A span that shows a colour of the style sheet, or is yet to show it. */
function chipOf(ink = null) {
  const chip = document.createElement("span");
  chip.className = "chip";
  if (ink) chip.style.background = `var(--${ink})`;
  return chip;
}
for (const [step, name] of Object.entries(looks)) {
  const entry = document.createElement("span");
  entry.append(chipOf(step), ` ${name}`);
  part("scale").append(entry);
}
const chips = bodies.map(({ name }, b) => {
  const label = document.createElement("label"),
    choice = document.createElement("input"),
    chip = chipOf();
  Object.assign(choice, { type: "radio", name: "body", value: b, checked: b === chosen });
  choice.onchange = () => {
    chosen = b;
    draw(clock.now);
  };
  label.append(choice, chip, name);
  part("bodies").append(label);
  return chip;
});

/** Goes to a view, along an arc unless the reader wants less motion. */
function go(name) {
  const from = camera.direction,
    began = performance.now();
  camera.view(name);
  const to = VIEWS[name];
  const way = ((to[0] - from[0] + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  const step = (stamp) => {
    const share = prefersReducedMotion() ? 1 : Math.min(1, Math.max(0, (stamp - began) / 400)),
      eased = share * share * (3 - 2 * share);
    camera.direction = [to[0] - way * (1 - eased), to[1] + (from[1] - to[1]) * (1 - eased)];
    drawPicture(clock.now);
    if (share < 1) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}
const views = [...part("views").querySelectorAll("input")];
for (const choice of views) {
  choice.checked = choice.value === scene.from;
  choice.onchange = () => go(choice.value);
}
camera.view(scene.from);
lead(part("scene"), camera, () => {
  for (const choice of views) choice.checked = false;
  turned();
});
part("shaken").checked = !prefersReducedMotion();
part("shaken").onchange = turned;

picked(part("strip"), scene, (time) => clock.seek(time));
addEventListener("keydown", (event) => {
  const place = Number(event.key) - 1;
  if (event.ctrlKey || event.altKey || event.metaKey || !views[place]) return;
  if (event.target.closest("select")) return;
  views[place].checked = true;
  go(views[place].value);
});
part("scene").addEventListener("webglcontextrestored", bar.again);
if (frameElement) {
  // in a report: the frame is as high as what is in it, so that nothing is cut
  document.documentElement.dataset.framed = "";
  new ResizeObserver(() => (frameElement.style.height = `${document.body.offsetHeight + 2}px`)).observe(document.body);
}
bar.begin();
