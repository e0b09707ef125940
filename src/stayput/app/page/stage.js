// The room in section, to scale: floor and walls shake, the body slides, rocks, hits and falls, devices
// stretch and break.

import { drawDevices } from "./devices.js";
import { details, trace } from "./furniture.js";
import { ink, line, prepared } from "./inks.js";
import { at, pose } from "./runs.js";

const GRID = 0.5;

/** What of the room is shown [m]: the same for both runs, so that they are to one scale. */
export function viewOf({ runs, floor, end }, shownUntil) {
  const span = [Infinity, -Infinity, 0];
  for (const run of runs) {
    const { corners_m: corners, height_m: tall } = run.body;
    for (let i = 0; i < run.time_s.length; i += 2) {
      if (run.time_s[i] > shownUntil) break;
      const c = Math.cos(run.tilt_rad[i]),
        s = Math.sin(run.tilt_rad[i]),
        shift = at(floor.time_s, floor.x_m, run.time_s[i]);
      for (const [u, v] of corners) {
        const x = run.x_m[i] + u * c + v * s + shift;
        span[0] = Math.min(span[0], x);
        span[1] = Math.max(span[1], x);
        span[2] = Math.max(span[2], run.z_m[i] - u * s + v * c);
      }
    }
    const { left_wall_x_m: left, ceiling_z_m: ceiling } = run.room;
    if (left !== null && left > -1.5)
      span[0] = Math.min(
        span[0],
        left + Math.min(...floor.x_m.filter((_, i) => floor.time_s[i] <= shownUntil)) - 0.12,
      );
    if (ceiling !== null && ceiling < tall + 1.2) span[2] = Math.max(span[2], ceiling);
    span[1] = Math.max(span[1], 0.9);
  }
  return { left: span[0] - 0.08, right: span[1] + 0.15, low: -0.16, high: span[2] + 0.1, end };
}

/** Draws one run at a time; kind and loads say what the piece looks like, colours what a mode looks like. */
export function drawStage(canvas, run, floor, view, t, { kind, loads, colours }) {
  const [pen, width, height] = prepared(canvas);
  const scale = Math.min(width / (view.right - view.left), height / (view.high - view.low));
  const wall = run.room.left_wall_x_m,
    spare = width / scale - (view.right - view.left);
  const origin = view.left - (wall === null ? spare / 2 : Math.min(spare / 2, 0.3));
  const place = (x, z) => [(x - origin) * scale, height - (z - view.low) * scale];
  const shift = at(floor.time_s, floor.x_m, t);

  pen.setLineDash([2, 6]);
  for (let k = Math.ceil(origin / GRID); k * GRID < origin + width / scale; k++) {
    const x = place(k * GRID, 0)[0];
    line(pen, ink.faint, 1, [
      [x, 0],
      [x, height],
    ]);
  }
  pen.setLineDash([]);
  drawRoom(pen, width, height, scale, place, run.room, shift);
  const now = pose(run, t);
  drawBody(
    pen,
    scale,
    place(now.x + shift, now.z),
    now.tilt,
    run.body,
    colours[now.mode] ?? ink.faint,
    kind,
    loads,
  );
  drawDevices(pen, scale, place, run, now, shift, t);
  drawRuler(pen, width, scale, Math.max(0, place(0, run.room.ceiling_z_m ?? Infinity)[1]));
  return now;
}

function drawRoom(pen, width, height, scale, place, room, shift) {
  const floor = place(0, 0)[1],
    mark = Math.max(6, 0.12 * scale);
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
  if (left > 0)
    for (let z = floor - mark; z > top; z -= mark)
      line(pen, ink.mark, 1, [
        [left - 3, z],
        [left - mark, z + mark / 2],
      ]);
  const edge = [
    [Math.max(left, 0), floor],
    [Math.min(right, width), floor],
  ];
  line(pen, ink.ink, 2, edge);
  if (left > 0)
    line(pen, ink.ink, 2, [
      [left, Math.max(0, top)],
      [left, floor],
    ]);
  if (right < width)
    line(pen, ink.ink, 2, [
      [right, Math.max(0, top)],
      [right, floor],
    ]);
  if (top > 0)
    line(pen, ink.ink, 2, [
      [Math.max(left, 0), top],
      [Math.min(right, width), top],
    ]);
}

function drawBody(pen, scale, [x, y], tilt, body, colour, kind, loads) {
  const [gx, gz] = body.centre_of_gravity_m,
    place = (u, v) => [(u - gx) * scale, (gz - v) * scale];
  pen.save();
  pen.translate(x, y);
  pen.rotate(tilt);
  pen.lineJoin = "round";
  pen.beginPath();
  body.corners_m.forEach(([u, v], i) =>
    i ? pen.lineTo(u * scale, -v * scale) : pen.moveTo(u * scale, -v * scale),
  );
  pen.closePath();
  pen.fillStyle = colour;
  pen.fill();
  pen.strokeStyle = pen.fillStyle = "#1f2933";
  for (const { points, tone } of details(kind, body.width_m, body.height_m, loads)) {
    pen.beginPath();
    trace(pen, points, place);
    pen.globalAlpha = tone === "soft" ? 0.28 : 0.75;
    pen.lineWidth = 1;
    if (tone === "line") pen.stroke();
    else pen.fill();
  }
  pen.globalAlpha = 1;
  pen.strokeStyle = ink.ink;
  pen.lineWidth = 2;
  pen.beginPath();
  body.corners_m.forEach(([u, v], i) =>
    i ? pen.lineTo(u * scale, -v * scale) : pen.moveTo(u * scale, -v * scale),
  );
  pen.closePath();
  pen.stroke();
  pen.beginPath();
  pen.arc(0, 0, 5, 0, 2 * Math.PI);
  pen.fillStyle = "#ffffff";
  pen.fill();
  pen.strokeStyle = pen.fillStyle = "#1f2933";
  pen.lineWidth = 1;
  pen.stroke();
  for (const turn of [0, Math.PI]) {
    pen.beginPath();
    pen.moveTo(0, 0);
    pen.arc(0, 0, 5, turn, turn + Math.PI / 2);
    pen.fill();
  }
  pen.restore();
}

function drawRuler(pen, width, scale, top) {
  const right = width - 10,
    left = right - GRID * scale,
    y = top + 10;
  pen.strokeStyle = pen.fillStyle = ink.muted;
  line(pen, ink.muted, 1.5, [
    [left, y],
    [left, y + 6],
    [right, y + 6],
    [right, y],
  ]);
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.fillText("50 cm", (left + right) / 2, y + 20);
}
