// Draws a scene without WebGL: the faces that look at the eye, outlined, between floor, walls and ceiling of lines.

import { ink, line, prepared } from "./pen.js";
import { surfaces } from "./space_scene.js";
import { mat, vec } from "./vectors.js";

const STROKE = 1.5; // width of the lines [pixels]

const middle = (points) => vec.times(points.reduce(vec.plus), 1 / points.length);

/** Draws the floor, a wall or the ceiling: shaded, with its grid. */
function drawFace(pen, seen, corners, grid) {
  pen.globalAlpha = 0.12;
  pen.fillStyle = ink.room;
  pen.beginPath();
  for (const corner of corners) pen.lineTo(...seen(corner));
  pen.fill();
  pen.globalAlpha = 1;
  const [one, , other] = corners;
  for (const axis of [0, 1, 2].filter((i) => one[i] !== other[i]))
    for (let k = Math.ceil(one[axis] / grid); k * grid <= other[axis]; k++) {
      const ends = [one, other].map((end) => end.map((x, i) => (i === axis ? k * grid : x)));
      line(pen, ink.faint, 1, ends.map(seen));
    }
}

/** Draws what does not move: shaded faces, and lines. */
function drawStill(pen, seen, { ink: name, shade, faces, lines }) {
  pen.globalAlpha = shade;
  pen.fillStyle = ink[name];
  for (const face of faces) {
    pen.beginPath();
    for (const corner of face) pen.lineTo(...seen(corner));
    pen.fill();
  }
  pen.globalAlpha = 1;
  for (const points of lines) line(pen, ink[name], STROKE, points.map(seen));
}

/** What draws a scene on a canvas, with the same `draw` and `take` as `spacePainter`. */
export function flatPainter(canvas, first) {
  let scene = first;

  function draw(t, camera, { chosen = null, shaken = false } = {}) {
    const [pen, width, height] = prepared(canvas);
    const { view: still, projection, place: eye } = camera.look(width / height),
      shift = shaken ? scene.shift(t) : [0, 0, 0];
    const whole = mat.product(projection, mat.product(still, mat.moved(shift))),
      from = vec.minus(eye, shift);
    const seen = (point) => {
      const [x, y, , w] = mat.image(whole, point);
      return [(0.5 + (0.5 * x) / w) * width, (0.5 - (0.5 * y) / w) * height];
    };
    for (const { corners, normal, offset } of surfaces({ ...scene, size: 0.5 * scene.grid }))
      if (vec.dot(normal, from) > offset) drawFace(pen, seen, corners, scene.grid);
    const bodies = scene.bodies.map((body, b) => {
      const matrix = body.matrix(t),
        corners = body.shape.vertices_m.map((corner) => mat.image(matrix, corner).slice(0, 3));
      return { ...body, b, corners, apart: Math.hypot(...vec.minus(matrix.slice(12, 15), from)) };
    });
    const unmoved = scene.still.map((one) => ({ ...one, apart: Math.hypot(...vec.minus(middle(one.lines[0]), from)) }));
    for (const { b, shape, corners, stands, ...one } of [...bodies, ...unmoved].sort((p, q) => q.apart - p.apart)) {
      if (!shape) drawStill(pen, seen, one);
      for (const face of shape?.faces ?? []) {
        const [p, q, r] = face.map((i) => corners[i]);
        if (vec.dot(vec.cross(vec.minus(q, p), vec.minus(r, p)), vec.minus(from, p)) <= 0) continue;
        pen.beginPath();
        for (const i of face) pen.lineTo(...seen(corners[i]));
        pen.closePath();
        pen.fillStyle = ink[stands(t)];
        pen.fill();
        pen.strokeStyle = "#1f2933";
        pen.lineWidth = b === chosen ? 2 * STROKE : STROKE;
        pen.stroke();
      }
    }
    const matrices = scene.bodies.map((body) => body.matrix(t));
    for (const { from: end, to, lost } of scene.ties(matrices, t)) {
      const points = [seen(end), seen(lost ? end : to)];
      if (!lost) line(pen, ink.tie, 2 * STROKE, points);
      for (const [x, y] of points) {
        pen.fillStyle = lost ? ink.alarm : ink.tie;
        pen.fillRect(x - 2 * STROKE, y - 2 * STROKE, 4 * STROKE, 4 * STROKE);
      }
    }
  }
  const take = (next) => (scene = next);
  return { draw, take };
}
