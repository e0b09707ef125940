// A scene as it is read from its data, and where everything is at a time. What the data hold is said by
// stayput/report/film/scene.py.

import { numbers } from "./numbers.js";
import { between, mat, vec } from "./vectors.js";

/** A scene whose bodies and floor tell where they are at a time. */
export function spaceScene(data) {
  const { start_s: start, end_s: end, count } = data.poses;
  const times = Float64Array.from({ length: count }, (_, i) => start + ((end - start) * i) / (count - 1));

  /** The pose before a time, and what part of the way to the next has passed. */
  function sample(t) {
    const place = ((Math.min(end, Math.max(start, t)) - start) / (end - start)) * (count - 1),
      i = Math.min(count - 2, Math.floor(place));
    return [i, place - i];
  }
  const pick = (values, size, i) => Array.from(values.subarray(size * i, size * (i + 1)));
  const along = (values, size, t) => {
    const [i, share] = sample(t),
      from = pick(values, size, i);
    return vec.plus(from, vec.times(vec.minus(pick(values, size, i + 1), from), share));
  };

  const bodies = data.bodies.map((body) => {
    const place = numbers(body.place_m),
      attitude = numbers(body.attitude);
    const [tilt, slide, yaw] = [body.tilt_rad, body.slide_m, body.yaw_rad].map(numbers);
    const steps = body.stability,
      toCentre = mat.moved(vec.times(body.centre_of_gravity_m, -1));
    return {
      ...body,
      tilts: tilt,
      slides: slide,
      yaws: yaw,
      /** How firmly it stands at a time: the name of an ink. */
      stands: (t) => (steps.findLast(([from]) => from <= t) ?? steps[0])[1],
      /** From the body's frame into the room. */
      matrix(t) {
        const [i, share] = sample(t),
          turn = between(pick(attitude, 4, i), pick(attitude, 4, i + 1), share);
        return mat.product(mat.pose(turn, along(place, 3, t)), toCentre);
      },
      state: (t) => ({ tilt: along(tilt, 1, t)[0], slide: along(slide, 1, t)[0], yaw: along(yaw, 1, t)[0] }),
    };
  });
  const ends = data.ties.map(({ body, point_m: point, other, anchor_m: anchor, lost_s: lost }) => (matrices, t) => {
    const seen = (owner, place) => (owner === null ? place : mat.image(matrices[owner], place).slice(0, 3));
    return { from: seen(body, point), to: seen(other, anchor), lost: lost !== null && t >= lost };
  });
  const shift = numbers(data.floor.shift_m),
    dt = data.floor.dt_s;
  const accelerations = Object.entries(data.floor.acceleration_m_s2).map(([axis, text]) => {
    const values = numbers(text);
    return { axis, values, times: values.map((_, i) => i * dt) };
  });
  const { from, low_m: low, high_m: high, grid_m: grid, points_m: points } = data.view;
  return {
    start,
    end,
    times,
    bodies,
    accelerations,
    /** From where it is seen at first: one of VIEWS. */
    from,
    /** Both ends of all devices in the room, by the bodies' matrices, and whether each has failed. */
    ties: (matrices, t) => ends.map((tie) => tie(matrices, t)),
    shift: (t) => along(shift, 3, t),
    /** What does not move: {ink, shade, faces, lines}. */
    still: data.still.map(({ faces_m: faces, lines_m: lines, ...look }) => ({ ...look, faces, lines })),
    planes: data.planes.map(([x, y, z, offset]) => ({ normal: [x, y, z], offset })),
    low,
    high,
    points,
    grid,
    size: Math.hypot(...vec.minus(high, low)),
  };
}

/** The floor's corners and those of the walls and the ceiling: {corners, normal, offset}, the floor first. */
export function surfaces({ low, high, planes, size }) {
  const from = [low[0] - 2 * size, low[1] - 2 * size, 0],
    to = [high[0] + 2 * size, high[1] + 2 * size, high[2] + 0.6 * size];
  const level = planes.find(({ normal }) => normal[2] < -0.5);
  if (level) to[2] = -level.offset;
  for (const { normal, offset } of planes)
    for (const axis of [0, 1]) {
      if (normal[axis] > 0.5) from[axis] = offset;
      if (normal[axis] < -0.5) to[axis] = -offset;
    }
  const flat = { normal: [0, 0, 1], offset: 0 };
  return [flat, ...planes].map(({ normal, offset }) => {
    const axis = normal.findIndex((part) => Math.abs(part) > 0.5),
      [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const corner = (a, b) => {
      const point = [0, 0, 0];
      point[axis] = offset * normal[axis];
      point[u] = a;
      point[v] = b;
      return point;
    };
    const ends = [
      [from[u], from[v]],
      [to[u], from[v]],
      [to[u], to[v]],
      [from[u], to[v]],
    ];
    return { corners: ends.map(([a, b]) => corner(a, b)), normal, offset };
  });
}
