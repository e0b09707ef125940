// Draws a scene on a canvas, in section and to scale: floor and walls shake, the body slides, rocks, hits and
// falls, devices stretch and break. What a scene holds is said by stayput/report/scene.py. The page imports
// this module; HTML files that stand alone hold its text.

import { details, trace } from "./furniture.js";
import { ink, line, prepared } from "./pen.js";

const FLASH = 0.5; // a device that fails flashes so long [s]
const DARK = "#1f2933"; // lines on the body, whose colours are the same in both themes

/** Index of the last time that is not after t. */
export function before(times, t) {
  let low = 0,
    high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** A value of a series between its samples; the last one after its end. */
export function at(times, values, t) {
  const i = Math.max(0, Math.min(before(times, t), times.length - 2));
  if (times.length < 2) return values[0] ?? 0;
  const share = Math.min(1, Math.max(0, (t - times[i]) / (times[i + 1] - times[i])));
  return values[i] + share * (values[i + 1] - values[i]);
}

/** Where a body is at a time, and how it moves; `turn` is that of the section, which a wedge tilts at rest. */
export function pose(run, t) {
  const tilt = at(run.time_s, run.tilt_rad, t);
  return {
    x: at(run.time_s, run.x_m, t),
    z: at(run.time_s, run.z_m, t),
    tilt,
    turn: tilt + run.body.resting_tilt_rad,
    slide: at(run.time_s, run.slide_m, t),
    mode: modeAt(run, t),
  };
}

function modeAt({ modes }, t) {
  let current = modes[0]?.[1] ?? "rest";
  for (const [start, mode] of modes) if (start <= t) current = mode;
  return current;
}

/**
 * Draws one run of a scene at a time and returns its pose. The look says what the piece is (kind, loads) and
 * what colour each mode has.
 */
export function drawScene(canvas, scene, run, t, { kind = null, loads = null, colours }) {
  const [pen, width, height] = prepared(canvas);
  const { left_m: left, right_m: right, low_m: low, high_m: high, grid_m: grid } = scene.view;
  const scale = Math.min(width / (right - left), height / (high - low));
  const origin = edge(run.room, scene.view, width / scale);
  const place = (x, z) => [(x - origin) * scale, height - (z - low) * scale];
  const shift = at(scene.floor.time_s, scene.floor.x_m, t);
  pen.setLineDash([3, 6]);
  for (let k = Math.ceil(origin / grid); k * grid < origin + width / scale; k++) {
    const x = place(k * grid, 0)[0];
    line(pen, ink.faint, 1, [
      [x, 0],
      [x, height],
    ]);
  }
  pen.setLineDash([]);
  outline(pen, place, run.body, pose(run, run.time_s[0]), shift);
  pen.strokeStyle = ink.faint;
  pen.lineWidth = 1;
  pen.stroke();
  drawRoom(pen, width, height, place, run.room, shift, Math.max(6, (grid * scale) / 4));
  const now = pose(run, t);
  drawBody(pen, scale, place, run.body, now, shift, colours[now.mode] ?? ink.faint, kind, loads);
  drawDevices(pen, place, run, now, shift, t);
  drawCentre(pen, place(now.x + shift, now.z));
  drawRuler(pen, width, grid, scale, Math.max(0, place(0, run.room.ceiling_z_m ?? Infinity)[1]));
  return now;
}

/** The place of the canvas's left edge [m]: a single wall in view stays at its edge. */
function edge({ left_wall_x_m: one, right_wall_x_m: other }, { left_m: left, right_m: right }, wide) {
  const onLeft = one !== null && one >= left,
    onRight = other !== null && other <= right;
  if (onLeft === onRight) return (left + right - wide) / 2;
  return onLeft ? left : right - wide;
}

function drawRoom(pen, width, height, place, room, shift, mark) {
  const floor = place(0, 0)[1];
  const top = room.ceiling_z_m === null ? -2 : place(0, room.ceiling_z_m)[1];
  const left = room.left_wall_x_m === null ? -2 : place(room.left_wall_x_m + shift, 0)[0];
  const right = room.right_wall_x_m === null ? width + 2 : place(room.right_wall_x_m + shift, 0)[0];
  pen.fillStyle = ink.room;
  pen.fillRect(0, floor, width, height - floor);
  if (left > 0) pen.fillRect(0, 0, left, floor);
  if (right < width) pen.fillRect(right, 0, width - right, floor);
  if (top > 0) pen.fillRect(0, 0, width, top);
  const start = ((place(shift, 0)[0] % mark) + mark) % mark;
  for (let x = start - mark; x < width + mark; x += mark)
    line(pen, ink.mark, 1, [
      [x, floor + 4],
      [x - mark / 2, height],
    ]);
  const upper = Math.max(0, top);
  for (const [x, side] of [
    [left, 1],
    [right, -1],
  ]) {
    if (x <= 0 || x >= width) continue;
    for (let z = floor - mark; z > upper; z -= mark)
      line(pen, ink.mark, 1, [
        [x - side * 3, z],
        [x - side * mark, z + mark / 2],
      ]);
    line(pen, ink.ink, 2, [
      [x, upper],
      [x, floor],
    ]);
  }
  const from = Math.max(left, 0),
    to = Math.min(right, width);
  for (const z of [floor, top])
    if (z > 0)
      line(pen, ink.ink, 2, [
        [from, z],
        [to, z],
      ]);
}

/** Where a point from the centre of gravity lies on the canvas. */
function onBody(place, now, shift, u, v) {
  const c = Math.cos(now.turn),
    s = Math.sin(now.turn);
  return place(now.x + u * c + v * s + shift, now.z - u * s + v * c);
}

function outline(pen, place, body, now, shift) {
  pen.beginPath();
  for (const [u, v] of body.corners_m) pen.lineTo(...onBody(place, now, shift, u, v));
  pen.closePath();
}

function drawBody(pen, scale, place, body, now, shift, colour, kind, loads) {
  const [gx, gz] = body.centre_of_gravity_m;
  outline(pen, place, body, now, shift);
  pen.fillStyle = colour;
  pen.fill();
  pen.strokeStyle = pen.fillStyle = DARK;
  pen.lineWidth = 1;
  for (const { points, tone } of details(kind, body.width_m, body.height_m, loads)) {
    pen.beginPath();
    trace(pen, points, (u, v) => onBody(place, now, shift, u - gx, v - gz));
    pen.globalAlpha = tone === "soft" ? 0.28 : 0.75;
    if (tone === "line") pen.stroke();
    else pen.fill();
  }
  pen.globalAlpha = 1;
  outline(pen, place, body, now, shift);
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 2;
  pen.lineJoin = "round";
  pen.stroke();
}

function drawCentre(pen, [x, y]) {
  pen.beginPath();
  pen.arc(x, y, 5, 0, 2 * Math.PI);
  pen.fillStyle = "#ffffff";
  pen.fill();
  pen.strokeStyle = pen.fillStyle = DARK;
  pen.lineWidth = 1;
  pen.stroke();
  for (const turn of [0, Math.PI]) {
    pen.beginPath();
    pen.moveTo(x, y);
    pen.arc(x, y, 5, turn, turn + Math.PI / 2);
    pen.fill();
  }
}

function drawDevices(pen, place, run, now, shift, t) {
  const [gx, gz] = run.body.centre_of_gravity_m;
  const spot = ([frame, x, z]) =>
    frame === "room" ? place(x + shift, z) : onBody(place, now, shift, x - gx, z - gz);
  const failure = ({ device }) => (device === null ? null : run.devices[device].failure_time_s);
  const gone = (shape) => failure(shape) !== null && t >= failure(shape);
  pen.lineCap = "round";
  for (const shape of run.shapes) {
    const broken = gone(shape);
    if (shape.when !== "always" && (shape.when === "broken") !== broken) continue;
    const points = shape.points.map(spot);
    if (shape.kind === "polygon") polygon(pen, points, ink[shape.role] ?? ink.metal);
    else strand(pen, points, shape, run, t, broken);
  }
  const strands = run.shapes.filter(
    ({ kind, when, points }) =>
      kind === "line" && when === "whole" && points[0][0] === "body" && points.at(-1)[0] === "room",
  );
  for (const shape of strands) {
    if (!gone(shape)) knot(pen, spot(shape.points[0]));
    else if (t - failure(shape) < FLASH) flash(pen, spot(shape.points[0]), (t - failure(shape)) / FLASH);
  }
  pen.lineCap = "butt";
}

function polygon(pen, points, colour) {
  pen.beginPath();
  trace(pen, points, (x, y) => [x, y]);
  pen.fillStyle = colour;
  pen.fill();
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 1;
  pen.stroke();
}

/** A line of a device, the wider the larger its force is; dashed where it is broken. */
function strand(pen, points, { device, role }, run, t, broken) {
  const { pull_n: pull, shear_n: shear, ...one } = device === null ? {} : run.devices[device];
  const most = Math.max(one.peak_pull_n ?? 0, one.peak_push_n ?? 0, one.peak_shear_n ?? 0, 1);
  const force = pull ? Math.hypot(at(run.time_s, pull, t), at(run.time_s, shear, t)) : 0;
  const width = broken ? 2.5 : 3 + 3 * Math.min(1, force / most);
  line(pen, ink.halo, width + 2.5, points);
  if (broken) pen.setLineDash([3, 4]);
  line(pen, broken ? ink.alarm : (ink[role] ?? ink.metal), width, points);
  pen.setLineDash([]);
}

function knot(pen, [x, y]) {
  pen.beginPath();
  pen.arc(x, y, 4.5, 0, 2 * Math.PI);
  pen.fillStyle = ink.tie;
  pen.fill();
  pen.strokeStyle = ink.halo;
  pen.lineWidth = 1.5;
  pen.stroke();
}

function flash(pen, [x, y], share) {
  pen.globalAlpha = 1 - share;
  for (let i = 0; i < 8; i++) {
    const turn = (i * Math.PI) / 4,
      inner = 5 + 14 * share,
      outer = inner + 9;
    line(pen, ink.alarm, 3, [
      [x + inner * Math.cos(turn), y + inner * Math.sin(turn)],
      [x + outer * Math.cos(turn), y + outer * Math.sin(turn)],
    ]);
  }
  pen.globalAlpha = 1;
}

function drawRuler(pen, width, grid, scale, top) {
  const end = width - 10,
    start = end - grid * scale,
    y = top + 10;
  line(pen, ink.muted, 1.5, [
    [start, y],
    [start, y + 6],
    [end, y + 6],
    [end, y],
  ]);
  pen.fillStyle = ink.muted;
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "center";
  const cm = Number((100 * grid).toPrecision(3));
  pen.fillText(cm < 100 ? `${cm} cm` : `${cm / 100} m`, (start + end) / 2, y + 20);
}
