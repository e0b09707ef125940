// Bodies as triangles with normals: flat on their faces, smooth around their round sides.

import { vec } from "./vectors.js";

const LIGHTER = 0.42,
  DARKER = -0.65; // by how much a mark is nearer to white or to black than the body

/** Numbers of each corner: place, normal, tone. */
export const STRIDE = 7;

/**
 * The triangles of a body and those of its marks, `STRIDE` numbers for each corner, and the ends of its sharp
 * edges, six numbers each.
 */
export function bodyMesh({ vertices_m: vertices, faces, normals, curved, edges, marks }) {
  const smooth = vertices.map(() => [0, 0, 0]);
  faces.forEach((face, k) => {
    if (curved[k]) for (const i of face) smooth[i] = vec.plus(smooth[i], normals[k]);
  });
  const faceCorners = (face, k) =>
    face.map((i) => [...vertices[i], ...(curved[k] ? vec.unit(smooth[i]) : normals[k]), 0]);
  const markCorners = (mark) =>
    mark.corners_m.map((corner) => [...corner, ...mark.normal, mark.light ? LIGHTER : DARKER]);
  return {
    body: new Float32Array(faces.flatMap((face, k) => fan(faceCorners(face, k))).flat()),
    marks: new Float32Array(marks.flatMap((mark) => fan(markCorners(mark))).flat()),
    edges: new Float32Array(edges.flatMap(([i, j]) => [...vertices[i], ...vertices[j]])),
  };
}

/** A convex polygon as triangles: three corners each. */
const fan = (corners) => corners.slice(2).flatMap((last, i) => [corners[0], corners[i + 1], last]);

/** The triangles of what stands still, three numbers a corner, and the ends of its lines, six numbers each. */
export const stillMesh = ({ faces, lines }) => ({
  faces: new Float32Array(faces.flatMap(fan).flat()),
  lines: new Float32Array(lines.flatMap((line) => line.slice(1).flatMap((end, i) => [...line[i], ...end]))),
});

/** The ends of a polygon's sides, six numbers each. */
export const around = (corners) =>
  new Float32Array(corners.flatMap((corner, i) => [...corner, ...corners[(i + 1) % corners.length]]));

/** Devices as thick lines: those that hold from end to end with a cross at both, the lost with one at the body. */
export function ends(ties, reach) {
  const held = { whole: [], lost: [] };
  const shifted = (place, axis, by) => place.map((x, i) => (i === axis ? x + by : x));
  for (const { from, to, lost } of ties) {
    const list = lost ? held.lost : held.whole;
    if (!lost) list.push(...from, ...to);
    for (const end of lost ? [from] : [from, to])
      for (const axis of [0, 1, 2]) list.push(...shifted(end, axis, -reach), ...shifted(end, axis, reach));
  }
  return held;
}
