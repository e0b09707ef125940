// Plays one run, or some side by side: their scenes, their histories below, and the time that they share.

import { VIEWS, lead, orbit } from "./canvas/camera.js";
import { beforeNextFrame, prefersReducedMotion } from "./canvas/clock.js";
import { digits } from "./canvas/digits.js";
import { ink } from "./canvas/pen.js";
import { playBar } from "./canvas/play_bar.js";
import { spacePainter } from "./canvas/space.js";
import { flatPainter } from "./canvas/space_flat.js";
import { spaceScene } from "./canvas/space_scene.js";
import { drawRows, most, picked } from "./canvas/strip.js";

const page = JSON.parse(document.getElementById("run").textContent);
const { looks, texts } = page;
const part = (id) => document.getElementById(id);
const degrees = (angle) => (angle * 180) / Math.PI;
const AXES = { x: "record", y: "calm", z: "pad" };
const BAND = 8; // height of the colours of how firmly the piece stands

/** A span that shows a colour of the style sheet, or is yet to show it. */
function chipOf(ink = null) {
  const chip = document.createElement("span");
  chip.className = "chip";
  if (ink) chip.style.background = `var(--${ink})`;
  return chip;
}
const scenes = page.films.map(spaceScene);
const [{ start, end, from }] = scenes; // all are of one time, and seen alike
const camera = orbit(
  scenes.flatMap(({ points }) => points),
  Math.max(...scenes.map(({ size }) => size)),
);

/** One run: its scene and what is said of it in one place, its histories in another. */
function sideOf(film, number) {
  const scene = scenes[number],
    { bodies } = scene;
  const several = bodies.length > 1;
  const [above, below] = ["scene", "strip"].map((name) => {
    const made = part(`${name}-of-run`).content.cloneNode(true).firstElementChild;
    part(`${name}s`).append(made);
    return made;
  });
  const of = (name) => above.querySelector(`.${name}`);
  const strip = below.querySelector(".strip");
  const solid = spacePainter(of("scene"), scene);
  const painter = solid ?? flatPainter(of("scene"), scene);
  if (solid === null) part("flat").hidden = false;
  of("label").textContent = film.label;
  of("turned").hidden = from === "side"; // in the plane nothing turns
  let chosen = 0;
  const peaks = {
    acceleration: Math.max(...scene.accelerations.map(({ values }) => most(values))),
    tilts: bodies.map(({ tilts }) => tilts.reduce((peak, value) => Math.max(peak, Math.abs(value)), 0)),
  };
  const chips = bodies.map(({ name }, b) => {
    const label = document.createElement("label"),
      choice = document.createElement("input"),
      chip = chipOf();
    Object.assign(choice, { type: "radio", name: `body-of-${number}`, value: b, checked: b === chosen });
    choice.onchange = () => {
      chosen = b;
      side.draw(clock.now);
    };
    label.append(choice, chip, name);
    of("bodies").append(label);
    return chip;
  });

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
    const { pen, along, height } = drawRows(strip, rows, { start, end, now, below: BAND + 4 });
    const { stability: steps } = bodies[chosen];
    steps.forEach(([from, step], i) => {
      const until = steps[i + 1]?.[0] ?? end;
      pen.fillStyle = ink[step];
      pen.fillRect(along(from), height - BAND, along(until) - along(from), BAND);
    });
  }

  const side = {
    ...{ strip, canvas: of("scene") },
    drawPicture(now) {
      painter.draw(now, camera, { chosen: several ? chosen : null, shaken: part("shaken").checked });
    },
    draw(now) {
      side.drawPicture(now);
      drawStrip(now);
      const { tilt, slide, yaw } = bodies[chosen].state(now);
      of("tilt").textContent = `${digits(degrees(tilt), 1)}°`;
      of("slide").textContent = `${digits(100 * slide, 1)} cm`;
      of("yaw").textContent = `${digits(degrees(yaw), 1)}°`;
      of("stands").textContent = looks[bodies[chosen].stands(now)];
      bodies.forEach(({ stands }, b) => (chips[b].style.background = `var(--${stands(now)})`));
    },
  };
  return side;
}

const sides = page.films.map(sideOf);
const drawPictures = (now) => sides.forEach((side) => side.drawPicture(now));
const bar = playBar(page, scenes[0], (now) => sides.forEach((side) => side.draw(now))),
  { clock } = bar;
const turned = beforeNextFrame(() => drawPictures(clock.now));

for (const [step, name] of Object.entries(looks)) {
  const entry = document.createElement("span");
  entry.append(chipOf(step), ` ${name}`);
  part("scale").append(entry);
}

/** Goes to a view, along an arc unless the reader wants less motion. */
function go(name) {
  const before = camera.direction,
    began = performance.now();
  camera.view(name);
  const to = VIEWS[name];
  const way = ((to[0] - before[0] + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  const step = (stamp) => {
    const share = prefersReducedMotion() ? 1 : Math.min(1, Math.max(0, (stamp - began) / 400)),
      eased = share * share * (3 - 2 * share);
    camera.direction = [to[0] - way * (1 - eased), to[1] + (before[1] - to[1]) * (1 - eased)];
    drawPictures(clock.now);
    if (share < 1) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}
const views = [...part("views").querySelectorAll("input")];
for (const choice of views) {
  choice.checked = choice.value === from;
  choice.onchange = () => go(choice.value);
}
camera.view(from);
for (const { canvas, strip } of sides) {
  lead(canvas, camera, () => {
    for (const choice of views) choice.checked = false;
    turned();
  });
  picked(strip, scenes[0], (time) => clock.seek(time));
  canvas.addEventListener("webglcontextrestored", bar.again);
}
part("shaken").checked = !prefersReducedMotion();
part("shaken").onchange = turned;

addEventListener("keydown", (event) => {
  const place = Number(event.key) - 1;
  if (event.ctrlKey || event.altKey || event.metaKey || !views[place]) return;
  if (event.target.closest("select")) return;
  views[place].checked = true;
  go(views[place].value);
});
if (frameElement) {
  // in a report: the frame is as high as what is in it, so that nothing is cut
  document.documentElement.dataset.framed = "";
  new ResizeObserver(() => (frameElement.style.height = `${document.body.offsetHeight + 2}px`)).observe(document.body);
}
bar.begin();
