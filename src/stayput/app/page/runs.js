// The server's runs as the pictures read them: typed arrays, and what of their time is shown.

import { numbers } from "./canvas/numbers.js";
import { spaceScene } from "./canvas/space_scene.js";

const ARRAYS = ["time_s", "x_m", "z_m", "tilt_rad", "slide_m"];
const LYING = 1; // what has overturned in space is shown so long as it comes to lie [s]

function prepared(run) {
  if (!run) return null;
  const made = { ...run, devices: devices(run) };
  for (const name of ARRAYS) made[name] = numbers(run[name]);
  made.done_s = run.overturned ? made.time_s.at(-1) : 0;
  return made;
}

const devices = (run) =>
  run.devices.map((one) => ({
    ...one,
    place: one.name,
    pull_n: numbers(one.pull_n),
    shear_n: numbers(one.shear_n),
  }));

/** A run in space: what happens to a piece after it overturned is no longer told. */
function preparedInSpace(run, floor) {
  if (!run) return null;
  const scene = spaceScene({ ...run.scene, floor });
  const { bodies, times } = scene,
    ends = run.pieces.map((one) => one.overturn_time_s ?? Infinity);
  return {
    ...run,
    scene,
    devices: devices(run),
    events: run.events.filter(({ time_s, piece }) => time_s <= ends[piece]),
    time_s: times,
    tilt_rad: times.map((_, k) => Math.max(...bodies.map(({ tilts }) => tilts[k]))),
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
  if (answer.dimensions === 3) return shakeInSpace(answer);
  const floor = answer.floor,
    values = numbers(floor.acceleration_m_s2),
    times = numbers(floor.time_s);
  return {
    inSpace: false,
    motion: answer.motion,
    view: answer.view,
    floor: {
      time_s: times,
      x_m: numbers(floor.x_m),
      accelerations: [{ axis: "", times, values }],
      scale: floor.scale_shown,
    },
    building: building(answer.building),
    runs: [prepared(answer.without), prepared(answer.with)].filter(Boolean),
    end: times.at(-1),
  };
}

function shakeInSpace(answer) {
  const runs = [answer.without, answer.with].map((run) => preparedInSpace(run, answer.floor)).filter(Boolean);
  const { scene } = runs[0];
  return {
    inSpace: true,
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
  if (run.overturned) return Math.max(0, (run.overturn_time_s ?? run.time_s.at(-1)) - 0.25);
  let most = 0;
  run.tilt_rad.forEach((tilt, i) => {
    if (Math.abs(tilt) > Math.abs(run.tilt_rad[most])) most = i;
  });
  return run.time_s[most];
}
