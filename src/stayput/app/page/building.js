// The building from outside, swaying: the ground, the storey of the furniture, the roof. Not to scale across.

import { ink, line, prepared } from "./canvas/pen.js";

/** A value of a history between its evenly spaced times. */
function at(times, values, t) {
  const place = ((t - times[0]) / (times[1] - times[0])) || 0,
    i = Math.max(0, Math.min(times.length - 2, Math.floor(place)));
  return values[i] + Math.min(1, place - i) * (values[i + 1] - values[i]);
}

/** Draws the building at a time; its sway is drawn larger than it is. */
export function drawBuilding(canvas, building, floor, t) {
  const [pen, width, height] = prepared(canvas);
  const n = building.storeys,
    ground = height - 16,
    storey = Math.min(26, (ground - 10) / n),
    wide = Math.min(width * 0.5, Math.max(26, 5 * storey));
  const here = at(floor.time_s, floor.x_m, t),
    share = Math.max(0, (building.storey - 1) / n);
  const base = at(floor.time_s, building.ground_x_m, t),
    roof = at(floor.time_s, building.roof_x_m, t);
  const most = largest(building, floor),
    scale = (0.2 * width) / most;
  const sway = (level) => {
    const up = level / n;
    const bent =
      share > 0 && share < 1
        ? up <= share
          ? base + ((here - base) * up) / share
          : here + ((roof - here) * (up - share)) / (1 - share)
        : base + (roof - base) * up;
    return width / 2 + bent * scale;
  };
  for (let level = 0; level < n; level++) {
    const low = ground - level * storey,
      high = low - storey,
      a = sway(level),
      b = sway(level + 1),
      own = level + 1 === building.storey;
    filled(pen, own ? ink.record : ink.card, [
      [a - wide / 2, low],
      [a + wide / 2, low],
      [b + wide / 2, high],
      [b - wide / 2, high],
    ]);
    pen.strokeStyle = ink.ink;
    pen.lineWidth = own ? 2 : 1;
    pen.stroke();
    if (own) marker(pen, (a + b) / 2 + wide / 2 + 4, (low + high) / 2);
  }
  const x = width / 2 + base * scale;
  line(pen, ink.ink, 2, [
    [0, ground],
    [width, ground],
  ]);
  for (let k = -6; k <= 6; k++)
    line(pen, ink.mark, 1, [
      [x + k * 14, ground + 2],
      [x + k * 14 - 6, ground + 12],
    ]);
}

const known = new WeakMap();

function largest(building, floor) {
  if (!known.has(floor)) {
    const series = [floor.x_m, building.ground_x_m, building.roof_x_m];
    const most = series.map((values) => values.reduce((most, one) => Math.max(most, Math.abs(one)), 0));
    known.set(floor, Math.max(1e-3, ...most));
  }
  return known.get(floor);
}

const marker = (pen, x, y) =>
  filled(pen, ink.alarm, [
    [x, y],
    [x + 9, y - 6],
    [x + 9, y + 6],
  ]);

function filled(pen, colour, points) {
  pen.beginPath();
  points.forEach(([x, y]) => pen.lineTo(x, y));
  pen.closePath();
  pen.fillStyle = colour;
  pen.fill();
}
