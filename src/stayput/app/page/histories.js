// Time histories under the animation: floor acceleration, tilt, slide, forces of devices; one time line
// for all.

import { label, ticks } from "./axes.js";
import { ink, line, prepared } from "./canvas/pen.js";
import { both, deviceName, number, t as say } from "./words.js";

const LEFT = 58,
  RIGHT = 12,
  BAND = 92,
  GAP = 26,
  FOOT = 34;
const DEGREES = 180 / Math.PI;
const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]];

/** The devices whose forces are drawn, those that used most of their strength, in their own order. */
function drawn(run) {
  const most = [...run.devices].sort((a, b) => (b.utilisation ?? 0) - (a.utilisation ?? 0));
  const chosen = new Set(most.slice(0, DASHES.length));
  return run.devices.filter((one) => chosen.has(one));
}

/** What the lines of the devices' forces are: {name, dash} for each, and how many devices have none. */
export function deviceKey({ runs }) {
  const run = runs.at(-1),
    lines = drawn(run);
  return {
    lines: lines.map(({ label, place }, i) => ({
      name: deviceName(both(label), place),
      dash: DASHES[i].join(" "),
    })),
    more: run.devices.length - lines.length,
  };
}

const AXES = {
  x: { dash: [], colour: "record" },
  y: { dash: [7, 4], colour: "calm" },
  z: { dash: [2, 3], colour: "pad" },
};

/** What a run's lines look like: the second run's are dashed. */
const lookOf = (i) => ({ dash: i === 0 ? [] : [7, 4], colour: i === 0 ? ink.alarm : ink.record });

const dashOf = (k) => DASHES[k % DASHES.length];

/** What the lines of several pieces are: {name, colour, dash} for each; none of one piece. */
export const piecesKey = ({ runs }) =>
  runs[0].scene.bodies.length > 1
    ? runs[0].scene.bodies.map(({ name, line: colour }, k) => ({ name, colour, dash: dashOf(k).join(" ") }))
    : [];

/** The lines of a history: of each run, or of each piece where there are several, with when it falls. */
function series({ runs }, key, factor) {
  const several = runs[0].scene.bodies.length > 1;
  return runs.flatMap(({ time_s: times, fallen_s, scene }, i) =>
    scene.bodies.map(({ line: colour, ...body }, k) => {
      const look = several ? { dash: dashOf(k), colour } : lookOf(i);
      return { times, values: body[key], factor, falls: fallen_s[k], ...look };
    }),
  );
}

/** The slenderness of a piece, by the smaller side of its base [rad]; there is none of several. */
function slenderness(bodies) {
  if (bodies.length > 1) return Infinity;
  const [wide, long, high] = [0, 1, 2].map((axis) => {
    const places = bodies[0].shape.vertices_m.map((corner) => corner[axis]);
    return Math.max(...places) - Math.min(...places);
  });
  return Math.atan2(Math.min(wide, long), high);
}

/** The histories of a piece: in the plane along its depth, in space in any direction. */
function moved(result) {
  const { inPlane, runs } = result,
    most = 3 * slenderness(runs[0].scene.bodies) * DEGREES;
  const panel = (key, unit, of, factor) => ({ title: say(key), unit, lines: series(result, of, factor), floor: 0.5 });
  return [
    { ...panel(inPlane ? "tilt" : "tiltInSpace", "°", "tilts", DEGREES), most },
    panel(inPlane ? "slide" : "slideInSpace", "cm", "slides", 100),
    ...(inPlane ? [] : [panel("yawTitle", "°", "yaws", DEGREES)]),
  ];
}

/** The panels of a result: titles, units and lines. */
function panels(result, end) {
  const { floor, runs, inRoom } = result;
  const acceleration = floor.accelerations.map(({ axis, times, values }) => {
    const { dash, colour } = AXES[axis];
    return { times, values, factor: 1, dash, colour: ink[colour], name: say(inRoom && axis !== "z" ? `roomAxis_${axis}` : `axis_${axis}`) };
  });
  const made = [{ title: say("acceleration"), unit: "m/s²", lines: acceleration }, ...moved(result)];
  const devices = drawn(runs.at(-1));
  if (devices.length)
    made.push({
      title: say("force"),
      unit: "N",
      floor: 1,
      lines: devices.map((one, i) => ({
        times: runs.at(-1).time_s,
        factor: 1,
        colour: ink.record,
        dash: DASHES[i],
        values: one.pull_n.map((pull, k) => Math.hypot(pull, one.shear_n[k])),
      })),
    });
  for (const panel of made) Object.assign(panel, reach(panel, end));
  return made;
}

/** The values that a panel shows, and the largest one beyond them where it shows less than there is. */
function reach({ lines, floor = 0.01, most = Infinity }, end) {
  let low = 0,
    high = 0;
  for (const { times, values, factor } of lines)
    values.forEach((value, i) => {
      if (times[i] > end) return;
      low = Math.min(low, value * factor);
      high = Math.max(high, value * factor);
    });
  const wide = Math.max(floor, high, -low);
  return {
    span: [
      Math.max(-most, low < 0 ? Math.min(low, -0.15 * wide) : 0),
      Math.min(most, Math.max(high, 0.15 * wide)),
    ],
    beyond: { above: high > most ? high : null, below: low < -most ? low : null },
  };
}

const still = document.createElement("canvas");
let shown = null,
  size = "";

/** Takes a result; its pictures are drawn with the next call of drawHistories. */
export function setHistories(canvas, result, end) {
  shown = { panels: panels(result, end), end };
  canvas.style.height = `${shown.panels.length * (BAND + GAP) + FOOT}px`;
  size = "";
}

/** Draws the histories and the time now. */
export function drawHistories(canvas, t) {
  if (!shown || !canvas.clientWidth) return;
  const [pen, width, height] = prepared(canvas);
  if (size !== `${canvas.width} ${canvas.height}`) {
    size = `${canvas.width} ${canvas.height}`;
    drawStill(width, height);
  }
  pen.drawImage(still, 0, 0, width, height);
  const x = LEFT + ((width - LEFT - RIGHT) * t) / shown.end;
  line(pen, ink.alarm, 2, [
    [x, GAP - 8],
    [x, height - FOOT],
  ]);
}

/** The time at a place across the picture. */
export const timeAt = (canvas, x) =>
  shown && shown.end * Math.min(1, Math.max(0, (x - LEFT) / (canvas.clientWidth - LEFT - RIGHT)));

function drawStill(width, height) {
  const ratio = devicePixelRatio || 1,
    pen = still.getContext("2d");
  still.width = Math.round(width * ratio);
  still.height = Math.round(height * ratio);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.font = "12px system-ui, sans-serif";
  const across = (t) => LEFT + ((width - LEFT - RIGHT) * t) / shown.end;
  const bottom = height - FOOT;
  for (const t of ticks(0, shown.end, Math.max(3, Math.round(width / 110)))) {
    line(pen, ink.faint, 1, [
      [across(t), GAP],
      [across(t), bottom],
    ]);
    pen.fillStyle = ink.muted;
    pen.textAlign = "center";
    pen.fillText(label(t), across(t), bottom + 14);
  }
  pen.textAlign = "right";
  pen.fillText(say("seconds"), width - RIGHT, bottom + 29);
  shown.panels.forEach((panel, i) => drawPanel(pen, panel, i * (BAND + GAP) + GAP, width, across));
}

function drawPanel(pen, { title, unit, lines, span: [low, high], beyond }, top, width, across) {
  const up = (value) => top + BAND - (BAND * (value - low)) / (high - low);
  pen.fillStyle = ink.ink;
  pen.textAlign = "left";
  const heading = `${title} [${unit}]`;
  pen.fillText(heading, LEFT, top - 8);
  pen.fillStyle = ink.muted;
  pen.textAlign = "right";
  for (const value of ticks(low, high, 4)) {
    line(pen, ink.faint, 1, [
      [LEFT, up(value)],
      [width - RIGHT, up(value)],
    ]);
    pen.fillText(label(value), LEFT - 6, up(value) + 4);
  }
  line(pen, ink.muted, 1, [
    [LEFT, up(0)],
    [width - RIGHT, up(0)],
  ]);
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, top - 1, width - LEFT - RIGHT, BAND + 2);
  pen.clip();
  for (const { times, values, factor, falls = Infinity, dash, colour } of lines) {
    pen.setLineDash(dash);
    const upright = [],
      fallen = []; // grey, as in the figures of the command line: peaks are those until then
    for (let k = 0; k < times.length && times[k] <= shown.end; k++)
      (times[k] <= falls ? upright : fallen).push([across(times[k]), up(values[k] * factor)]);
    line(pen, ink.room, 1.6, fallen);
    line(pen, colour, 1.6, upright);
  }
  pen.restore();
  drawNames(pen, heading, lines, top, width);
  drawBeyond(pen, beyond, unit, top, width);
}

/** Writes the names of lines at the panel's right end: beside its title, or below that where there is no room. */
function drawNames(pen, title, lines, top, width) {
  const names = lines
    .filter((one) => one.name)
    .map(({ name, colour }) => ({ name, colour, wide: pen.measureText(name).width + 10 }));
  const room = width - LEFT - RIGHT - pen.measureText(title).width;
  let left = width - RIGHT + 10 - names.reduce((sum, { wide }) => sum + wide, 0);
  const up = width - RIGHT - left < room ? top - 8 : top + 8;
  pen.textAlign = "left";
  for (const { name, colour, wide } of names) {
    pen.fillStyle = colour;
    pen.fillText(name, left, up);
    left += wide;
  }
}

/** Says at the edge of a panel that a line goes on beyond it, and how far. */
function drawBeyond(pen, { above, below }, unit, top, width) {
  pen.fillStyle = ink.alarm;
  pen.font = "bold 12px system-ui, sans-serif";
  pen.textAlign = "right";
  const beyond = (arrow, value) => `${arrow} ${say("beyond", { value: number(value), unit })}`;
  if (above !== null) pen.fillText(beyond("▲", above), width - RIGHT, top - 8);
  if (below !== null) pen.fillText(beyond("▼", below), width - RIGHT, top + BAND + 13);
  pen.font = "12px system-ui, sans-serif";
}
