// Programs of the graphics processor for a scene in space.

const SHADOW = `
uniform highp sampler2DShadow shadows;
float lit(vec3 place) {
  float sum = 0.0;
  vec2 step = 2.2 / vec2(textureSize(shadows, 0));
  for (int i = -2; i <= 2; i++)
    for (int j = -2; j <= 2; j++)
      sum += texture(shadows, vec3(place.xy + step * vec2(i, j), place.z));
  return sum / 25.0;
}`;

/** What the light sees: depths alone. */
export const DEPTHS = [
  `#version 300 es
layout(location = 0) in vec3 place;
uniform mat4 model, light;
void main() { gl_Position = light * model * vec4(place, 1.0); }`,
  `#version 300 es
precision mediump float;
void main() {}`,
];

/** Bodies: one light and its shadows, and the sky's and the floor's. */
export const BODIES = [
  `#version 300 es
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in float tone;
uniform mat4 model, eye, light;
out vec3 n, shadowPlace;
out float shade;
void main() {
  vec4 world = model * vec4(place, 1.0);
  n = mat3(model) * normal;
  shadowPlace = (light * world).xyz * 0.5 + 0.5;
  shade = tone;
  gl_Position = eye * world;
}`,
  `#version 300 es
precision highp float;
in vec3 n, shadowPlace;
in float shade;
uniform vec3 colour, towardsLight;
out vec4 seen;
${SHADOW}
void main() {
  vec3 up = normalize(n);
  vec3 own = pow(mix(colour, vec3(step(0.0, shade)), abs(shade)), vec3(2.2));
  float sky = mix(0.34, 0.58, 0.5 + 0.5 * up.z);
  float sun = 0.7 * max(dot(up, towardsLight), 0.0) * lit(shadowPlace);
  seen = vec4(pow(own * (sky + sun), vec3(1.0 / 2.2)), 1.0);
}`,
];

/** Floor, walls and ceiling: a grid, shadows, and an end that fades. */
export const SURFACES = [
  `#version 300 es
layout(location = 0) in vec3 place;
uniform mat4 eye, light;
out vec3 at, shadowPlace;
void main() {
  at = place;
  shadowPlace = (light * vec4(place, 1.0)).xyz * 0.5 + 0.5;
  gl_Position = eye * vec4(place, 1.0);
}`,
  `#version 300 es
precision highp float;
in vec3 at, shadowPlace;
uniform vec3 colour, lines, normal, middle;
uniform float grid, alpha, lineAlpha, reach, dark;
out vec4 seen;
${SHADOW}
void main() {
  vec3 place = at / grid;
  vec3 width = fwidth(place);
  vec3 near = abs(fract(place - 0.5) - 0.5) / max(width, vec3(1e-5));
  vec3 drawn = (1.0 - smoothstep(0.2, 1.2, near)) * (1.0 - smoothstep(0.15, 0.5, width));
  drawn *= vec3(lessThan(abs(normal), vec3(0.5)));
  float line = max(drawn.x, max(drawn.y, drawn.z));
  vec3 shown = mix(colour, lines, line);
  shown *= mix(1.0 - dark, 1.0, lit(shadowPlace));
  float fade = 1.0 - smoothstep(0.45 * reach, reach, distance(at, middle));
  seen = vec4(shown, fade * mix(alpha, lineAlpha, line));
}`,
];

/** Lines of a width in pixels: each instance is one line, a little nearer to the eye than it is. */
export const LINES = [
  `#version 300 es
layout(location = 0) in vec2 corner;
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
uniform mat4 model, view, projection;
uniform vec2 canvas;
uniform float width;
vec4 clipped(vec3 place) {
  vec4 seen = view * model * vec4(place, 1.0);
  return projection * vec4(seen.xyz * 0.997, 1.0);
}
void main() {
  vec4 a = clipped(from), b = clipped(to);
  vec2 along = (b.xy / b.w - a.xy / a.w) * canvas;
  vec2 way = along / max(length(along), 1e-6);
  vec4 end = corner.x < 0.5 ? a : b;
  vec2 aside = width * (corner.y * vec2(-way.y, way.x) + (corner.x - 0.5) * way);
  gl_Position = end + vec4(aside / canvas * end.w, 0.0, 0.0);
}`,
  `#version 300 es
precision mediump float;
uniform vec4 colour;
out vec4 seen;
void main() { seen = colour; }`,
];
