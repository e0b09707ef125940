// Devices between body and room: whole ones stretch and thicken with their force, broken ones hang and
// flash once.

import { ink, line } from "./inks.js";
import { at } from "./runs.js";

const FLASH = 0.5;

/** Draws the shapes of a run's measures at a time. */
export function drawDevices(pen, scale, place, run, now, shift, t) {
  const [gx, gz] = run.body.centre_of_gravity_m,
    c = Math.cos(now.tilt),
    s = Math.sin(now.tilt);
  const spot = ([frame, x, z]) => {
    if (frame === "room") return place(x + shift, z);
    const u = x - gx,
      v = z - gz;
    return place(now.x + u * c + v * s + shift, now.z - u * s + v * c);
  };
  pen.lineCap = "round";
  for (const shape of run.shapes) {
    const device = shape.device === null ? null : run.devices[shape.device],
      failed = gone(run, shape, t);
    if (shape.when !== "always" && (shape.when === "broken") !== failed) continue;
    const points = shape.points.map(spot);
    if (shape.kind === "polygon") polygon(pen, points, ink[shape.role] ?? ink.metal);
    else strand(pen, points, shape, device, run, t, failed);
  }
  for (const shape of run.shapes)
    if (shape.kind === "line" && shape.when === "whole" && !gone(run, shape, t))
      knot(pen, spot(shape.points[0]));
  for (const device of run.devices) {
    const since = device.failure_time_s === null ? -1 : t - device.failure_time_s;
    const shape = run.shapes.find(
      (one) => one.device === run.devices.indexOf(device) && one.when === "whole",
    );
    if (since >= 0 && since < FLASH && shape) flash(pen, spot(shape.points[0]), since / FLASH);
  }
  pen.lineCap = "butt";
}

/** Whether the device that a shape shows has failed by then. */
function gone(run, { device }, t) {
  const failure = device === null ? null : run.devices[device].failure_time_s;
  return failure !== null && t >= failure;
}

function polygon(pen, points, colour) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  pen.closePath();
  pen.fillStyle = colour;
  pen.fill();
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 1;
  pen.stroke();
}

function strand(pen, points, shape, device, run, t, failed) {
  const most = device ? Math.max(device.peak_pull_n, device.peak_push_n, device.peak_shear_n, 1) : 1;
  const now = device
    ? Math.hypot(at(run.time_s, device.pull_n, t), at(run.time_s, device.shear_n, t)) / most
    : 0;
  const width = failed ? 2.5 : 3 + 3 * Math.min(1, now);
  line(pen, ink.paper, width + 2.5, points);
  if (failed) pen.setLineDash([3, 4]);
  line(pen, failed ? ink.alarm : (ink[shape.role] ?? ink.metal), width, points);
  pen.setLineDash([]);
}

function knot(pen, [x, y]) {
  pen.beginPath();
  pen.arc(x, y, 4.5, 0, 2 * Math.PI);
  pen.fillStyle = ink.tie;
  pen.fill();
  pen.strokeStyle = ink.card;
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
