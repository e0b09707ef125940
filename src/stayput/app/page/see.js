// "See it": the stages, the building, the clock's buttons, and the histories that go with them.

import { el, fill, part, svg } from "./dom.js";
import { drawBuilding } from "./building.js";
import { deviceKey, drawHistories, piecesKey, setHistories, timeAt } from "./histories.js";
import { shownSpan, telling } from "./runs.js";
import * as stages from "./stages.js";
import { colourFates } from "./story.js";
import * as transport from "./transport.js";
import { both, length, number, t } from "./words.js";

let result = null;

export const clock = transport.clock;

function draw(now) {
  if (!result) return;
  result.runs.forEach(({ scene }, i) => {
    stages.draw(i, now);
    tellNow(i ? "with" : "without", scene, now);
  });
  if (result.building && part("tower").clientWidth)
    drawBuilding(part("tower"), result.building, result.floor, now);
  colourFates(part("pieces"), result.runs[0].scene, now);
  drawHistories(part("histories"), now);
}

/** Says how what stands there stands now: of several pieces that which is tilted most. */
function tellNow(which, scene, now) {
  const states = scene.bodies.map((body) => body.state(now)),
    most = states.reduce((one, other) => (other.tilt > one.tilt ? other : one)),
    stands = scene.bodies[states.indexOf(most)].stands(now);
  const key = states.length > 1 ? "nowMost" : result.inPlane ? "nowInPlane" : "nowInSpace";
  part(`now-${which}`).textContent = t(key, {
    stands: t(`scale_${stands}`),
    tilt: number(Math.abs(degrees(most.tilt)), 1),
    slide: length(Math.abs(most.slide)),
    yaw: number(Math.abs(degrees(most.yaw))),
  });
  part(`chip-${which}`).style.background = `var(--${stands})`;
}

const degrees = (angle) => (angle * 180) / Math.PI;

/** Shows a result: runs, floor and building of one simulation. */
export function show(shaken) {
  result = shaken;
  const { start, end } = shownSpan(shaken);
  stages.show(shaken.runs.map((run) => run.scene));
  part("in-plane-note").hidden = !shaken.inPlane;
  part("figure-with").hidden = part("key-with").hidden = shaken.runs.length < 2;
  part("stages").dataset.count = String(shaken.runs.length);
  part("tower-box").hidden = !shaken.building;
  part("says-without").textContent = both(shaken.runs[0].sentence);
  part("says-with").textContent = shaken.runs[1] ? both(shaken.runs[1].sentence) : "";
  shaken.runs.forEach((run, i) => {
    const which = i ? "with" : "without";
    part(`stage-${which}`).setAttribute("aria-label", `${t(which)}${t("colon")}${both(run.sentence)}`);
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
export function again() {
  transport.again();
  stages.build();
  if (result) show(result);
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
