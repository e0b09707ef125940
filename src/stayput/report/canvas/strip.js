// Histories over time below a scene, one row above the other, with the present time across them.

import { ink, line, prepared } from "./pen.js";

const LEFT = 46,
  RIGHT = 8;

/** The largest size of values, 1 where all are zero. */
export const most = (values) => values.reduce((peak, value) => Math.max(peak, Math.abs(value)), 0) || 1;

/**
 * Draws rows {label, unit, peak, positive, series: [{times, values, colour, width, name}]} of a time span;
 * names of series stand beside the label, and what is positive rises from the row's foot. `below` is the
 * height that is left free. Returns the pen, where a time is, and the height.
 */
export function drawRows(canvas, rows, { start, end, now, below = 0 }) {
  const [pen, width, height] = prepared(canvas),
    each = (height - below) / rows.length;
  const along = (t) => LEFT + ((width - LEFT - RIGHT) * (t - start)) / (end - start);
  rows.forEach(({ label, unit, peak, series, positive = false }, k) => {
    const top = k * each + 16,
      tall = each - 20,
      zero = positive ? top + tall : top + tall / 2,
      scale = (positive ? tall : tall / 2) / peak;
    line(pen, ink.faint, 1, [
      [LEFT, zero],
      [width - RIGHT, zero],
    ]);
    pen.save();
    pen.beginPath();
    pen.rect(LEFT, k * each, width - LEFT - RIGHT, each);
    pen.clip();
    for (const { times, values, colour, width: wide = 1.2 } of series)
      line(
        pen,
        colour,
        wide,
        Array.from(times, (t, i) => [along(t), zero - scale * values[i]]),
      );
    pen.restore();
    pen.fillStyle = ink.muted;
    pen.font = "12px system-ui, sans-serif";
    pen.textAlign = "right";
    pen.fillText(unit, LEFT - 4, top + tall / 2 + 4);
    let right = width - RIGHT;
    for (const { name, colour } of [...series].reverse()) {
      if (!name) continue;
      pen.fillStyle = colour;
      pen.fillText(name, right, k * each + 11);
      right -= pen.measureText(name).width + 10;
    }
    pen.fillStyle = ink.muted;
    pen.textAlign = "left";
    pen.fillText(label, LEFT, k * each + 11, right - LEFT - 8);
  });
  line(pen, ink.alarm, 2, [
    [along(now), 0],
    [along(now), height],
  ]);
  return { pen, along, height };
}

/** Calls `pick` with the time that a pointer points to on the canvas of the rows. */
export function picked(canvas, { start, end }, pick) {
  const from = (event) => {
    const box = canvas.getBoundingClientRect();
    pick(start + ((event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT)) * (end - start));
  };
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    from(event);
  };
  canvas.onpointermove = (event) => event.buttons && from(event);
}
