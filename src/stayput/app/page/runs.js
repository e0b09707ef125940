// The server's runs as the pictures read them: typed arrays, and what of their time is shown.

import { numbers } from "./canvas/numbers.js";
import { spaceScene } from "./canvas/space_scene.js";

const ROUNDED = 1e-4; // by how much times of events are rounded [s]
const LYING = 1; // what has overturned is shown so long as it comes to lie [s]

const devices = (run) =>
  run.devices.map((one) => ({
    ...one,
    place: one.name,
    pull_n: numbers(one.pull_n),
    shear_n: numbers(one.shear_n),
  }));

/** A run: what happens to a piece after it overturned is no longer told. */
function prepared(run, floor) {
  const scene = spaceScene({ ...run.scene, floor });
  const { bodies, times } = scene,
    ends = run.pieces.map((one) => one.overturn_time_s ?? Infinity);
  return {
    ...run,
    scene,
    devices: devices(run),
    events: run.events.filter(({ time_s, piece }) => time_s <= ends[piece] + ROUNDED),
    time_s: times,
    fallen_s: run.pieces.map((one) => Math.min(one.overturn_time_s ?? Infinity, one.fall_time_s ?? Infinity)),
    tilt_rad: times.map((_, k) => Math.max(...bodies.map(({ tilts }) => Math.abs(tilts[k])))),
    done_s: run.overturned ? Math.max(...ends.filter(Number.isFinite)) + LYING : 0,
  };
}

const building = (told) =>
  told && {
    ...told,
    ground_x_m: numbers(told.ground_x_m),
    roof_x_m: numbers(told.roof_x_m),
  };

/** An answer of "simulate", ready to be drawn. */
export function shake(answer) {
  const runs = [answer.without, answer.with].filter(Boolean).map((run) => prepared(run, answer.floor));
  const { scene } = runs[0];
  return {
    inPlane: answer.engine === "plane",
    inRoom: Boolean(answer.in_room),
    motion: answer.motion,
    floor: {
      time_s: scene.times,
      x_m: scene.times.map((time) => scene.shift(time)[0]),
      accelerations: scene.accelerations,
    },
    building: building(answer.building),
    runs,
    end: scene.end,
  };
}

/**
 * What of the shaking is shown: until a little after the last thing happened; and from where it is worth
 * looking.
 */
export function shownSpan({ runs, floor, end }) {
  const times = runs.flatMap((run) => run.events.map((one) => one.time_s));
  const strong = strongest(floor);
  const first = times.length ? Math.min(...times) : strong - 2,
    last = times.length ? Math.max(...times) : strong + 5;
  const done = Math.max(last, ...runs.map((run) => run.done_s));
  return {
    start: Math.max(0, Math.min(first, strong) - 1.5),
    end: Math.min(end, Math.max(done, strong) + 3),
  };
}

/** When a component of the floor's acceleration has its peak. */
function strongest({ accelerations }) {
  let most = 0,
    when = 0;
  for (const { times, values } of accelerations)
    values.forEach((value, i) => {
      if (Math.abs(value) > most) [most, when] = [Math.abs(value), times[i]];
    });
  return when;
}

/** The instant that says most about a run: just before the body lies, or where it leans most. */
export function telling(run) {
  if (run.overturned) return Math.max(0, run.overturn_time_s - 0.25);
  let most = 0;
  run.tilt_rad.forEach((tilt, i) => {
    if (tilt > run.tilt_rad[most]) most = i;
  });
  return run.time_s[most];
}
