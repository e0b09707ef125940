// The stages of runs: their pictures, and the camera that is led round all of them at once.

import { VIEWS, lead, orbit } from "./canvas/camera.js";
import { prefersReducedMotion } from "./canvas/clock.js";
import { spacePainter } from "./canvas/space.js";
import { flatPainter } from "./canvas/space_flat.js";
import { oneOf, toggle } from "./controls.js";
import { fill, part } from "./dom.js";
import { t } from "./words.js";

const stages = [...document.querySelectorAll("canvas.round-about")].map((canvas) => ({
  canvas,
  painter: null,
  camera: null,
  solid: true,
  inSight: true,
}));
let again = () => {},
  views = null,
  view = null,
  chosen = false, // whether the reader has chosen from where it is seen
  shaken = null; // whether the room moves with the ground

/** Lets the cameras be led over the pictures; "changed" is called after each change. */
export function wire(changed) {
  again = changed;
  const seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) stages.find(({ canvas }) => canvas === target).inSight = isIntersecting;
    again();
  });
  for (const { canvas } of stages) seen.observe(canvas);
  const led = {};
  for (const name of ["turn", "nearer", "move"])
    led[name] = (...by) => stages.forEach(({ camera }) => camera?.[name](...by));
  for (const { canvas } of stages) {
    // the wheel scrolls the page; with Ctrl, as a pinch of two fingers says it, the picture comes nearer
    canvas.parentElement.addEventListener("wheel", (event) => event.ctrlKey || event.stopPropagation(), {
      capture: true,
    });
    lead(canvas, led, () => {
      look(null);
      again();
    });
    canvas.addEventListener("webglcontextrestored", () => again());
  }
}

/** Builds the choice of a view; called again for another language. */
export function build() {
  shaken ??= !prefersReducedMotion();
  views = oneOf({
    label: t("view"),
    options: Object.keys(VIEWS).map((id) => ({ id, label: t(`view_${id}`) })),
    changed: (id) => {
      look(id);
      again();
    },
  });
  views.set(view);
  const moving = toggle({
    label: t("shaken"),
    changed: (on) => {
      shaken = on;
      again();
    },
  });
  moving.set(shaken);
  fill(part("views"), views.element, moving.element);
}

/** Looks from one of VIEWS, or by null from where the reader has led the cameras. */
function look(from) {
  chosen = true;
  turn(from);
}

function turn(from) {
  view = from;
  views?.set(from);
  if (from) for (const { camera } of stages) camera?.view(from);
}

/** Takes the scenes of runs; they are seen from where the reader has chosen, else as each kind best is. */
export function show(scenes) {
  scenes.forEach((scene, i) => {
    const stage = stages[i],
      camera = orbit(scene.points, scene.size);
    if (stage.camera) camera.direction = stage.camera.direction;
    stage.camera = camera;
    if (stage.painter) stage.painter.take(scene);
    else {
      const painter = spacePainter(stage.canvas, scene);
      stage.solid = painter !== null;
      stage.painter = painter ?? flatPainter(stage.canvas, scene);
    }
  });
  if (!chosen) turn(scenes[0].from);
  part("flat").hidden = stages[0].solid;
}

/** Draws one of the runs at a time, where its picture is in sight and the one before it is finished. */
export function draw(i, now) {
  const { canvas, painter, camera, inSight } = stages[i];
  if (!canvas.clientWidth || !inSight) return;
  if (painter.busy?.()) requestAnimationFrame(again); // of a film the next picture comes by itself
  else painter.draw(now, camera, { shaken });
}
