// The server's runs as the pictures read them: typed arrays, and what of their time is shown.

const ARRAYS = ["time_s", "x_m", "z_m", "tilt_rad", "slide_m"];
const floats = (values) => Float64Array.from(values);

function prepared(run) {
  if (!run) return null;
  const made = { ...run };
  for (const name of ARRAYS) made[name] = floats(run[name]);
  made.devices = run.devices.map((one) => ({
    ...one,
    place: one.name,
    pull_n: floats(one.pull_n),
    shear_n: floats(one.shear_n),
  }));
  return made;
}

/** An answer of "simulate", ready to be drawn. */
export function shake(answer) {
  const floor = answer.floor,
    building = answer.building;
  return {
    motion: answer.motion,
    view: answer.view,
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
