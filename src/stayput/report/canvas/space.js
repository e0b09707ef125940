// Draws a scene in space with WebGL 2: bodies with the shadows of one light, on a floor with a grid, between
// translucent walls. It knows nothing of the page around its canvas.

import { ink } from "./pen.js";
import { BODIES, DEPTHS, LINES, SURFACES } from "./shaders.js";
import { MAP, array, free, program, segments, shadowMap, triangles } from "./space_gl.js";
import { around, bodyMesh, ends, stillMesh } from "./space_mesh.js";
import { surfaces } from "./space_scene.js";
import { mat, mixed, parts, vec } from "./vectors.js";

const LIGHT = vec.unit([0.5, -0.3, 0.85]),
  EDGE = parts("#1f2933"), // lines on the bodies, whose colours are the same in both themes
  STILL = mat.moved([0, 0, 0]);

/** The light's view of all that a scene shows. */
function lightMatrix({ low, high, size }) {
  const right = vec.unit(vec.cross([0, 1, 0], LIGHT)),
    axes = [right, vec.cross(LIGHT, right), LIGHT];
  const view = mat.seenFrom(axes, [0, 0, 0]);
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) =>
    mat.image(view, [k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]]),
  );
  const margin = 0.05 * size,
    ends = (pick, sign) => [0, 1, 2].map((i) => pick(...corners.map((corner) => corner[i])) + sign * margin);
  const [from, to] = [ends(Math.min, -1), ends(Math.max, 1)];
  // depths grow away from the light, down to where its rays meet the floor
  return mat.product(mat.orthographic([from[0], from[1], to[2]], [to[0], to[1], from[2] - 2 * size]), view);
}

/**
 * What draws a scene of `spaceScene` on a canvas; null where the browser has no WebGL 2. `draw` takes the
 * time, a camera of `orbit`, the body that is chosen, and whether the room moves with the ground; `take` puts
 * another scene in the place of the first.
 */
export function spacePainter(canvas, first) {
  let scene = first;
  const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
  if (!gl) return null;
  let tools = prepareTools(),
    made = prepare(),
    pending = null; // until what was drawn last is finished
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => {
    pending = null;
    tools = prepareTools();
    made = prepare();
  });

  function prepareTools() {
    const programs = Object.fromEntries(
      Object.entries({ DEPTHS, BODIES, SURFACES, LINES }).map(([name, texts]) => [name, program(gl, texts)]),
    );
    return { programs, frame: shadowMap(gl) };
  }

  function prepare() {
    const meshes = scene.bodies.map(({ shape, footprint_m: footprint }) => {
      const mesh = bodyMesh(shape);
      return {
        body: triangles(gl, mesh.body),
        marks: triangles(gl, mesh.marks),
        edges: segments(gl, mesh.edges),
        footprint: segments(gl, around(footprint)),
      };
    });
    const faces = surfaces(scene).map(({ corners, normal, offset }) => {
      const values = new Float32Array([0, 1, 3, 2].flatMap((i) => corners[i]));
      return { array: array(gl, [{ values, stride: 3, attributes: [[0, 3]] }]), normal, offset };
    });
    const still = scene.still.map((one) => {
      const mesh = stillMesh(one),
        buffer = { values: mesh.faces, stride: 3, attributes: [[0, 3]] };
      return {
        ...{ ink: one.ink, shade: one.shade, lines: segments(gl, mesh.lines) },
        faces: { array: array(gl, [buffer]), count: mesh.faces.length / 3 },
      };
    });
    return { meshes, faces, still, ties: segments(gl, new Float32Array(0)), light: lightMatrix(scene) };
  }

  function take(next) {
    for (const { body, marks, edges, footprint } of made.meshes)
      for (const { array: which } of [body, marks, edges, footprint]) free(gl, which);
    for (const { faces, lines } of made.still) for (const { array: which } of [faces, lines]) free(gl, which);
    for (const { array: which } of [...made.faces, made.ties]) free(gl, which);
    scene = next;
    made = prepare();
  }

  /** Uses a program with values for its uniforms; those that it lacks are left out. */
  function use({ made: which, uniforms }, values) {
    gl.useProgram(which);
    for (const [name, value] of Object.entries(values)) {
      const place = uniforms[name];
      if (place === undefined) continue;
      if (typeof value === "number") gl.uniform1f(place, value);
      else if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
      else gl[`uniform${value.length}fv`](place, value);
    }
  }

  function strip({ array: which, count }) {
    gl.bindVertexArray(which.made);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }
  function fill({ array: which, count }) {
    gl.bindVertexArray(which.made);
    gl.drawArrays(gl.TRIANGLES, 0, count);
  }

  function castShadows(models) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, tools.frame);
    gl.viewport(0, 0, MAP, MAP);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(2, 4);
    made.meshes.forEach(({ body }, b) => {
      use(tools.programs.DEPTHS, { model: models[b], light: made.light });
      fill(body);
    });
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  function drawSurface({ array: which, normal }, look, eye) {
    const middle = [0, 1, 2].map((i) => (scene.low[i] + scene.high[i]) / 2);
    use(tools.programs.SURFACES, {
      ...{ eye, light: made.light, normal, middle, grid: scene.grid, reach: 1.9 * scene.size },
      ...look,
    });
    gl.bindVertexArray(which.made);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  /** Sizes the drawing to the canvas; returns CSS pixels of its sides and how sharp the screen is. */
  function fitted() {
    const sharp = devicePixelRatio || 1,
      [wide, high] = [canvas.clientWidth, canvas.clientHeight];
    const [w, h] = [Math.max(1, Math.round(wide * sharp)), Math.max(1, Math.round(high * sharp))];
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
    return [w, h, sharp];
  }

  /** Whether the picture before is still being drawn: pictures that are asked for faster than that queue up. */
  function busy() {
    return pending !== null && gl.getSyncParameter(pending, gl.SYNC_STATUS) === gl.UNSIGNALED;
  }

  /** Notes when all that has been asked for so far is drawn. */
  function mark() {
    if (pending) gl.deleteSync(pending);
    pending = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  function draw(t, camera, { chosen = null, shaken = false } = {}) {
    if (gl.isContextLost()) return;
    const [width, height, sharp] = fitted(),
      paper = parts(ink.paper),
      models = scene.bodies.map((body) => body.matrix(t));
    const { view: still, projection, place } = camera.look(width / height),
      shift = shaken ? scene.shift(t) : [0, 0, 0];
    const view = mat.product(still, mat.moved(shift)),
      eye = mat.product(projection, view);
    gl.enable(gl.DEPTH_TEST);
    castShadows(models);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    const [floor, ...faces] = made.faces,
      room = parts(ink.room),
      fromAbove = place[2] - shift[2] > 0;
    const ground = { colour: mixed(paper, room, 0.16), lines: mixed(paper, room, 0.42), dark: 0.26 };
    drawSurface(floor, { ...ground, alpha: fromAbove ? 1 : 0.3, lineAlpha: fromAbove ? 1 : 0.4 }, eye);
    const lines = { view, projection, canvas: [width, height] };
    made.meshes.forEach(({ footprint }) => {
      const outline = [...parts(ink.muted), 0.9];
      use(tools.programs.LINES, { ...lines, model: STILL, width: 2.2 * sharp, colour: outline });
      strip(footprint);
    });
    made.meshes.forEach(({ body, marks, edges }, b) => {
      const colour = parts(ink[scene.bodies[b].stands(t)]),
        look = { model: models[b], eye, light: made.light, colour, towardsLight: LIGHT };
      use(tools.programs.BODIES, look);
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(1, 2);
      fill(body);
      gl.polygonOffset(0, 0);
      fill(marks);
      gl.disable(gl.POLYGON_OFFSET_FILL);
      const outline = b === chosen ? [...parts(ink.ink), 1] : [...EDGE, 0.85];
      const thick = (b === chosen ? 3.4 : 1.7) * sharp;
      use(tools.programs.LINES, { ...lines, model: models[b], width: thick, colour: outline });
      strip(edges);
    });
    gl.depthMask(false);
    const wall = { colour: mixed(paper, room, 0.45), lines: mixed(paper, room, 0.8), dark: 0.25 };
    for (const face of faces) {
      const inside = vec.dot(face.normal, vec.minus(place, shift)) > face.offset;
      drawSurface(face, { ...wall, alpha: inside ? 0.45 : 0.05, lineAlpha: inside ? 0.8 : 0.12 }, eye);
    }
    drawStill(eye, { ...lines, model: STILL }, sharp);
    gl.depthMask(true);
    drawTies(models, t, { ...lines, model: STILL }, sharp);
    mark();
  }

  /** Draws the places of people, the doors and the windows: the pieces shine through them. */
  function drawStill(eye, lines, sharp) {
    for (const { ink: name, shade, faces, lines: edges } of made.still) {
      const colour = parts(ink[name]),
        plain = { colour, lines: colour, alpha: shade, lineAlpha: shade, dark: 0, normal: [0, 0, 1], grid: 1 };
      use(tools.programs.SURFACES, { eye, light: made.light, middle: [0, 0, 0], reach: 1e6, ...plain });
      fill(faces);
      use(tools.programs.LINES, { ...lines, width: 1.6 * sharp, colour: [...colour, 0.9] });
      strip(edges);
    }
  }

  /** Draws the devices over all else, as they are mostly behind or below a body; a cross where one has failed. */
  function drawTies(models, t, lines, sharp) {
    const held = ends(scene.ties(models, t), 0.012 * scene.size);
    gl.disable(gl.DEPTH_TEST);
    for (const [name, values] of Object.entries(held)) {
      if (!values.length) continue;
      gl.bindBuffer(gl.ARRAY_BUFFER, made.ties.array.held[1]);
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(values), gl.DYNAMIC_DRAW);
      const colour = parts(name === "lost" ? ink.alarm : ink.tie);
      for (const [width, look] of [
        [6 * sharp, [...parts(ink.halo), 0.8]],
        [2.6 * sharp, [...colour, 1]],
      ]) {
        use(tools.programs.LINES, { ...lines, width, colour: look });
        strip({ array: made.ties.array, count: values.length / 6 });
      }
    }
    gl.enable(gl.DEPTH_TEST);
  }
  return { busy, draw, take };
}
