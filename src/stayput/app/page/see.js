// "See it": the stages, the building, the clock's buttons, and the histories that go with them.

import { el, fill, part, svg } from "./dom.js";
import { drawBuilding } from "./building.js";
import { deviceKey, drawHistories, piecesKey, setHistories, timeAt } from "./histories.js";
import { shownSpan, telling } from "./runs.js";
import { drawScene } from "./canvas/painter.js";
import * as stages from "./stages.js";
import * as transport from "./transport.js";
import { both, length, number, t } from "./words.js";

let result = null,
  look = null,
  modes = {};

export const clock = transport.clock;

function draw(now) {
  if (!result) return;
  if (result.inSpace) drawInSpace(now);
  else drawInPlane(now);
  if (result.building && part("tower").clientWidth)
    drawBuilding(part("tower"), result.building, result.floor, now);
  drawHistories(part("histories"), now);
}

function drawInSpace(now) {
  result.runs.forEach((run, i) => {
    stages.draw(i, now);
    const states = run.scene.bodies.map((body) => body.state(now)),
      most = states.reduce((one, other) => (other.tilt > one.tilt ? other : one));
    part(i ? "now-with" : "now-without").textContent = t(states.length > 1 ? "nowMost" : "nowInSpace", {
      tilt: number(degrees(most.tilt), 1),
      slide: length(most.slide),
      yaw: number(Math.abs(degrees(most.yaw))),
    });
  });
}

function drawInPlane(now) {
  result.runs.forEach((run, i) => {
    const canvas = part(i ? "stage-with" : "stage-without");
    if (!canvas.clientWidth) return;
    const pose = drawScene(canvas, result, run, now, {
      kind: look.piece,
      loads: look.shelves,
      colours: modes.colours,
    });
    part(i ? "now-with" : "now-without").textContent =
      `${modes.labels[pose.mode] ?? pose.mode} · ${number(degrees(Math.abs(pose.tilt)), 1)}°`;
    part(i ? "chip-with" : "chip-without").style.background = modes.colours[pose.mode];
  });
}

const degrees = (angle) => (angle * 180) / Math.PI;

/** Reads what the server calls the modes, and their colours. */
export function name(presets) {
  modes = {
    colours: Object.fromEntries(presets.modes.map((one) => [one.id, one.colour])),
    labels: Object.fromEntries(presets.modes.map((one) => [one.id, both(one.label)])),
  };
  clock.redraw();
}

/** Shows a result: runs, floor and building of one simulation, for a scene. */
export function show(shaken, scene) {
  result = shaken;
  look = scene;
  const { start, end } = shownSpan(shaken);
  chooseStages(shaken);
  part("figure-with").hidden = part("key-with").hidden = shaken.runs.length < 2;
  part("stages").dataset.count = String(shaken.runs.length);
  part("tower-box").hidden = !shaken.building;
  part("says-without").textContent = both(shaken.runs[0].sentence);
  part("says-with").textContent = shaken.runs[1] ? both(shaken.runs[1].sentence) : "";
  shaken.runs.forEach((run, i) => {
    const which = i ? "with" : "without";
    for (const kind of ["stage", "space"])
      part(`${kind}-${which}`).setAttribute("aria-label", `${t(which)}${t("colon")}${both(run.sentence)}`);
  });
  setHistories(part("histories"), shaken, end);
  showKeys(deviceKey(shaken), piecesKey(shaken));
  part("histories").setAttribute(
    "aria-label",
    t("historiesAlt", {
      pga: number(shaken.motion.pga_m_s2, 1),
      tilt: number(degrees(Math.max(...peaks(shaken.runs[0]))), 1),
    }),
  );
  clock.span(start, end, telling(shaken.runs[0]));
  clock.redraw();
}

const peaks = (run) => run.pieces.map((one) => one.peak_tilt_rad);

/** Shows the pictures of the plane or of space, and what belongs to them. */
function chooseStages({ inSpace, runs }) {
  for (const which of ["without", "with"]) {
    part(`stage-${which}`).hidden = part(`chip-${which}`).hidden = inSpace;
    part(`space-${which}`).hidden = !inSpace;
  }
  part("views").hidden = part("turning").hidden = !inSpace;
  part("in-plane-note").hidden = inSpace;
  if (inSpace) stages.show(runs.map((run) => run.scene));
  else part("flat").hidden = true;
}

/** Says which line of the forces is of which device, and which of the others of which piece. */
function showKeys({ lines, more }, pieces) {
  part("device-title").hidden = !lines.length;
  fill(
    part("device-key"),
    lines.map(entry),
    more > 0 ? el("li", { text: t("moreDevices", { n: more }) }) : [],
  );
  fill(part("pieces-key"), pieces.map(entry));
}

/** A line of a key: what it looks like and its name. */
function entry({ name, dash, colour = null }) {
  const path = svg("path", { class: "line-device", d: "M0 6H40", "stroke-dasharray": dash });
  if (colour) path.style.stroke = colour;
  const swatch = svg("svg", { viewBox: "0 0 40 12", "aria-hidden": "true" }, path);
  return el("li", {}, swatch, el("span", { text: name }));
}

/** Brings the picture into sight, where something elsewhere has chosen its time. */
export const lookAt = () => part("stages").scrollIntoView({ block: "nearest" });

/** Writes the words again, for another language or theme. */
export function again(presets) {
  name(presets);
  transport.again();
  stages.build();
  if (result) show(result, look);
}

/** Wires the buttons, the keys and the pictures that the time is chosen on. */
export function wire() {
  transport.wire(draw);
  stages.wire(() => clock.redraw());
  stages.build();
  const strip = part("histories");
  const pick = (event) => clock.seek(timeAt(strip, event.clientX - strip.getBoundingClientRect().left));
  strip.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") strip.setPointerCapture(event.pointerId);
    pick(event);
  });
  strip.addEventListener("pointermove", (event) => {
    if (event.buttons) pick(event);
  });
}
