// Vectors of three numbers, matrices of sixteen (columns one after the other, as in WebGL), and quaternions.

export const vec = {
  plus: (a, b) => a.map((value, i) => value + b[i]),
  minus: (a, b) => a.map((value, i) => value - b[i]),
  times: (a, s) => a.map((value) => value * s),
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  unit: (a) => vec.times(a, 1 / (Math.hypot(...a) || 1)),
};

export const mat = {
  product(a, b) {
    const out = new Array(16).fill(0);
    for (let c = 0; c < 4; c++)
      for (let r = 0; r < 4; r++) for (let k = 0; k < 4; k++) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    return out;
  },
  /** The image of a point: x, y, z, w. */
  image: (m, [x, y, z]) => [0, 1, 2, 3].map((r) => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]),
  moved: ([x, y, z]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1],
  perspective(height, aspect, near, far) {
    const f = 1 / Math.tan(height / 2),
      depth = near - far;
    const [scale, shift] = [(far + near) / depth, (2 * far * near) / depth];
    return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, scale, -1, 0, 0, shift, 0];
  },
  /** A box in front of an eye, along its axes, to the cube of WebGL. */
  orthographic([left, low, near], [right, high, far]) {
    const [w, h, d] = [right - left, high - low, far - near];
    const middle = [-(right + left) / w, -(high + low) / h, -(far + near) / d];
    return [2 / w, 0, 0, 0, 0, 2 / h, 0, 0, 0, 0, 2 / d, 0, ...middle, 1];
  },
  /** Into the axes of an eye (right, up, backwards) at a place. */
  seenFrom([right, up, back], eye) {
    const shift = [right, up, back].map((axis) => -vec.dot(axis, eye));
    return [0, 1, 2].flatMap((i) => [right[i], up[i], back[i], 0]).concat(shift, 1);
  },
  /** A turn by the unit quaternion w, x, y, z, and then a move. */
  pose([w, x, y, z], [px, py, pz]) {
    return [
      ...[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0],
      ...[2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0],
      ...[2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0],
      ...[px, py, pz, 1],
    ];
  },
};

/** The quaternion between two, which turns evenly from one to the other, the short way round. */
export function between(q, r, share) {
  const cosine = q.reduce((sum, value, i) => sum + value * r[i], 0),
    angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const sine = Math.sin(angle),
    part = (of) => (sine < 1e-6 ? of : Math.sin(of * angle) / sine);
  const sum = q.map((value, i) => part(1 - share) * value + (cosine < 0 ? -1 : 1) * part(share) * r[i]);
  return vec.times(sum, 1 / Math.hypot(...sum));
}

/** Red, green and blue, 0 to 1, of "#rrggbb". */
export const parts = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16) / 255);

/** A colour between two, as parts. */
export const mixed = (one, other, share) => one.map((value, i) => value + share * (other[i] - value));
