// The server's runs as the pictures read them: typed arrays, and values between the samples.

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

const ARRAYS = ["time_s", "x_m", "z_m", "tilt_rad", "slide_m"];
const floats = (values) => Float64Array.from(values);

function prepared(run) {
  if (!run) return null;
  const made = { ...run };
  for (const name of ARRAYS) made[name] = floats(run[name]);
  made.devices = run.devices.map((one) => ({
    ...one,
    pull_n: floats(one.pull_n),
    shear_n: floats(one.shear_n),
  }));
  made.starts = run.modes.map(([time]) => time);
  return made;
}

/** An answer of "simulate", ready to be drawn. */
export function shake(answer) {
  const floor = answer.floor,
    building = answer.building;
  return {
    motion: answer.motion,
    floor: {
      time_s: floats(floor.time_s),
      x_m: floats(floor.x_m),
      acceleration_m_s2: floats(floor.acceleration_m_s2),
      scale: floor.scale_shown,
    },
    building: building && {
      ...building,
      ground_x_m: building.ground_x_m && floats(building.ground_x_m),
      roof_x_m: building.roof_x_m && floats(building.roof_x_m),
    },
    runs: [prepared(answer.without), prepared(answer.with)].filter(Boolean),
    end: floor.time_s.at(-1),
  };
}

/** Where a body is at a time, and how it moves. */
export const pose = (run, t) => ({
  x: at(run.time_s, run.x_m, t),
  z: at(run.time_s, run.z_m, t),
  tilt: at(run.time_s, run.tilt_rad, t),
  mode: run.modes.length ? run.modes[before(run.starts, t)][1] : "rest",
});

/**
 * What of the shaking is shown: until a little after the last thing happened; and from where it is worth
 * looking.
 */
export function shownSpan({ runs, floor, end }) {
  const times = runs.flatMap((run) => run.events.map((one) => one.time_s));
  const strong = strongest(floor);
  const first = times.length ? Math.min(...times) : strong - 2,
    last = times.length ? Math.max(...times) : strong + 5;
  const done = Math.max(last, ...runs.map((run) => (run.overturned ? run.time_s.at(-1) : 0)));
  return {
    start: Math.max(0, Math.min(first, strong) - 1.5),
    end: Math.min(end, Math.max(done, strong) + 3),
  };
}

function strongest({ time_s: times, acceleration_m_s2: values }) {
  let most = 0;
  values.forEach((value, i) => {
    if (Math.abs(value) > Math.abs(values[most])) most = i;
  });
  return times[most];
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
