// A camera that goes round a scene, and the ways to lead it: mouse, touch, keyboard.

import { mat, vec } from "./vectors.js";

const OPENING = (28 * Math.PI) / 180, // angle of the picture's height
  OPENING_TANGENT = Math.tan(OPENING / 2),
  STEEPEST = Math.PI / 2 - 1e-3,
  NEAREST = 0.15,
  FARTHEST = 6;

/** Directions from which a scene is seen: azimuth from x towards y, and height above the floor [rad]. */
export const VIEWS = {
  free: [-1.02, 0.33], // this and "side" as in the films: stayput/report/film/frames.py
  front: [0, 0.06],
  side: [-Math.PI / 2, 0.06],
  top: [-Math.PI / 2, STEEPEST],
};

/** A camera that sees all of the points; `look` gives its matrices and its place. */
export function orbit(points, size) {
  let [azimuth, height] = VIEWS.free,
    distance = 1, // in that from which all of the box is seen
    aside = [0, 0, 0], // from where the points are in the middle of the picture
    drawn = size; // height of the picture where the middle is [m]

  function axes() {
    const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
    const back = [c * Math.cos(height), s * Math.cos(height), Math.sin(height)],
      right = [-s, c, 0];
    return [right, vec.cross(back, right), back];
  }

  return {
    turn(by, up) {
      azimuth += by;
      height = Math.max(-0.2, Math.min(STEEPEST, height + up));
    },
    nearer(factor) {
      distance = Math.max(NEAREST, Math.min(FARTHEST, distance / factor));
    },
    /** Moves what is seen by parts of the picture's height. */
    move(across, up) {
      const [right, above] = axes();
      aside = vec.minus(aside, vec.plus(vec.times(right, across * drawn), vec.times(above, up * drawn)));
    },
    view(name) {
      [azimuth, height] = VIEWS[name];
      distance = 1;
      aside = [0, 0, 0];
    },
    get direction() {
      return [azimuth, height];
    },
    set direction(wanted) {
      [azimuth, height] = wanted;
    },
    look(aspect) {
      const [right, up, back] = axes(),
        tangents = [OPENING_TANGENT * aspect, OPENING_TANGENT];
      // The planes through the outermost points meet in the eye: a pair for the picture's width and one for its
      // height, and the eye as far back as the wider pair needs.
      const ends = [right, up].map((axis, i) =>
        [1, -1].map((side) =>
          Math.max(
            ...points.map((point) => side * vec.dot(point, axis) + tangents[i] * vec.dot(point, back)),
          ),
        ),
      );
      const depth = Math.max(...ends.map(([one, other], i) => (one + other) / (2 * tangents[i])));
      const nearest = Math.max(...points.map((point) => vec.dot(point, back)));
      const far = 1.13 * distance * (depth - nearest) + (distance - 1) * size * 0.5;
      const [across, above] = ends.map(([one, other]) => (one - other) / 2);
      drawn = 2 * (far + size / 2) * OPENING_TANGENT;
      const place = [
        [right, across],
        [up, above],
        [back, nearest + far],
      ].reduce((sum, [axis, along]) => vec.plus(sum, vec.times(axis, along)), aside);
      return {
        place,
        view: mat.seenFrom([right, up, back], place),
        projection: mat.perspective(OPENING, aspect, 0.02 * size, far + 12 * size),
      };
    },
  };
}

/** Lets a camera be led over a canvas; `changed` is called after each change. */
export function lead(canvas, camera, changed) {
  const held = new Map();
  const spread = () => {
    const [a, b] = [...held.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
  };
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => held.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const last = held.get(event.pointerId);
    if (!last) return;
    const { clientX: x, clientY: y } = event,
      tall = canvas.clientHeight;
    if (held.size === 2) {
      const before = spread();
      held.set(event.pointerId, { x, y });
      const now = spread();
      camera.nearer(now.apart / Math.max(1, before.apart));
      camera.move((now.x - before.x) / tall, (before.y - now.y) / tall);
    } else {
      held.set(event.pointerId, { x, y });
      if (event.buttons === 2 || event.shiftKey) camera.move((x - last.x) / tall, (last.y - y) / tall);
      else camera.turn((-3 * (x - last.x)) / tall, (3 * (y - last.y)) / tall);
    }
    changed();
  });
  canvas.addEventListener(
    "wheel",
    (event) => {
      if (frameElement && !event.ctrlKey) return; // in a report the page scrolls on
      event.preventDefault();
      camera.nearer(Math.exp(-0.0012 * event.deltaY * (event.deltaMode === 1 ? 30 : 1)));
      changed();
    },
    { passive: false },
  );
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  canvas.addEventListener("keydown", (event) => {
    const [across, up] = arrows[event.key] ?? [0, 0];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (across || up) {
      if (event.shiftKey) camera.move(0.05 * across, 0.05 * up);
      else camera.turn(0.1 * across, 0.1 * up);
    } else if (event.key === "+" || event.key === "=") camera.nearer(1.15);
    else if (event.key === "-") camera.nearer(1 / 1.15);
    else return;
    event.preventDefault();
    event.stopPropagation();
    changed();
  });
}
