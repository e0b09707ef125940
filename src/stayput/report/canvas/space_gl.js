// What WebGL 2 holds of a scene: programs, numbers, a map of shadows.

import { STRIDE } from "./space_mesh.js";

export const MAP = 1024; // pixels of the shadow map's sides

/** A program and the places of its uniforms. */
export function program(gl, [vertex, fragment]) {
  const made = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(gl.getProgramInfoLog(made));
  const uniforms = {};
  for (let i = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) - 1; i >= 0; i--) {
    const { name } = gl.getActiveUniform(made, i);
    uniforms[name] = gl.getUniformLocation(made, name);
  }
  return { made, uniforms };
}

/** Numbers on the graphics processor: attributes are [place, how many numbers each, once an instance]. */
export function array(gl, buffers) {
  const made = gl.createVertexArray(),
    held = buffers.map(() => gl.createBuffer());
  gl.bindVertexArray(made);
  buffers.forEach(({ values, stride, attributes, instanced = false }, k) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, held[k]);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    let offset = 0;
    for (const [place, size] of attributes) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 4 * stride, 4 * offset);
      if (instanced) gl.vertexAttribDivisor(place, 1);
      offset += size;
    }
  });
  return { made, held };
}

/** Frees the numbers of `array`. */
export function free(gl, { made, held }) {
  gl.deleteVertexArray(made);
  for (const buffer of held) gl.deleteBuffer(buffer);
}

const CORNERS = new Float32Array([0, -1, 1, -1, 0, 1, 1, 1]);

export function triangles(gl, values) {
  const attributes = [
    [0, 3],
    [1, 3],
    [2, 1],
  ];
  return { array: array(gl, [{ values, stride: STRIDE, attributes }]), count: values.length / STRIDE };
}

/** Thick lines between pairs of points: six numbers each. */
export function segments(gl, values) {
  const ends = [
    [1, 3],
    [2, 3],
  ];
  const buffers = [
    { values: CORNERS, stride: 2, attributes: [[0, 2]] },
    { values, stride: 6, attributes: ends, instanced: true },
  ];
  return { array: array(gl, buffers), count: values.length / 6 };
}

/** A depth texture and what draws into it. */
export function shadowMap(gl) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, MAP, MAP);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return frame;
}
