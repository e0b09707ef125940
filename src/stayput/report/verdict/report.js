"use strict";
// Draws the pairs of runs: two scenes of one clock, and the time in the histories below them.
const SMALL = "12px system-ui, sans-serif";

function whole(steps, unit) {          // sums of the steps, in the unit
  let sum = 0;
  return Float64Array.from(steps, (step) => (sum += step) * unit);
}

function unpacked(pair) {
  const sides = pair.sides.map((side) => ({
    ...side,
    x: whole(side.x, pair.length), z: whole(side.z, pair.length),
    tilt: whole(side.tilt, pair.angle), slide: whole(side.slide, pair.length),
  }));
  return { ...pair, sides, shift: whole(pair.shift, pair.length),
    end: pair.start + pair.step * (pair.count - 1) };
}

function at(pair, values, time) {      // linear between the samples
  const place = Math.min(Math.max((time - pair.start) / pair.step, 0), pair.count - 1);
  const first = Math.min(Math.floor(place), Math.max(pair.count - 2, 0));
  const next = Math.min(first + 1, pair.count - 1);
  return values[first] + (place - first) * (values[next] - values[first]);
}

function modeAt(side, time) {
  let found = side.modes[0][1];
  for (const [start, mode] of side.modes) if (start <= time) found = mode;
  return found;
}

function inks() {
  const style = getComputedStyle(document.documentElement), found = {};
  for (const name of ["paper", "card", "ink", "muted", "faint", "room", "mark", "alarm", "tie", "pad", "rubber",
    "metal", "wheel", "mass"]) found[name] = style.getPropertyValue("--" + name).trim();
  return found;
}

function prepared(canvas) {
  const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return [pen, width, height];
}

function trace(pen, points, closed) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  if (closed) pen.closePath();
}

function line(pen, colour, width, points) {
  pen.strokeStyle = colour; pen.lineWidth = width; trace(pen, points, false); pen.stroke();
}

function drawRoom(pen, side, shift, place, size, step, ink) {
  const [width, height] = size, floor = place(0, 0)[1];
  const top = side.ceiling === null ? 0 : place(0, side.ceiling)[1];
  const a = side.left === null ? 0 : place(side.left + shift, 0)[0];
  const b = side.right === null ? width : place(side.right + shift, 0)[0];
  pen.fillStyle = ink.room;
  pen.fillRect(0, floor, width, height - floor);
  pen.fillRect(0, 0, a, floor);
  pen.fillRect(b, 0, width - b, floor);
  pen.fillRect(0, 0, width, top);
  const mark = Math.max(step / 4, 8), origin = ((place(shift, 0)[0] % mark) + mark) % mark;
  for (let x = origin - mark; x < width + mark; x += mark)
    line(pen, ink.mark, 1, [[x, floor + 3], [x - mark / 2, height]]);
  line(pen, ink.ink, 2, [[a, floor], [b, floor]]);
  if (side.left !== null) line(pen, ink.ink, 2, [[a, top], [a, floor]]);
  if (side.right !== null) line(pen, ink.ink, 2, [[b, top], [b, floor]]);
  if (side.ceiling !== null) line(pen, ink.ink, 2, [[a, top], [b, top]]);
}

function drawShapes(pen, side, time, placed, ink) {
  for (const shape of side.shapes) {
    const failure = shape.element === null ? null : side.failures[shape.element];
    const broken = failure !== null && failure <= time;
    if (shape.when !== "always" && (shape.when === "broken") !== broken) continue;
    pen.strokeStyle = pen.fillStyle = shape.when === "broken" ? ink.alarm : ink[shape.role];
    trace(pen, shape.points.map(placed), shape.kind === "polygon");
    if (shape.kind === "polygon") { pen.lineWidth = 1.5; pen.fill(); } else pen.lineWidth = 3;
    pen.lineCap = pen.lineJoin = "round";
    pen.stroke();
  }
}

function drawScene(canvas, pair, side, time, ink) {
  const [pen, width, height] = prepared(canvas);
  const [left, right, low, high] = pair.view;
  const scale = Math.min(width / (right - left), height / (high - low));
  const half = width / 2 / scale, one = (side.left !== null) !== (side.right !== null);
  const middle = !one ? (left + right) / 2 : side.right === null ? left + half : right - half;
  const place = (x, z) => [width / 2 + (x - middle) * scale, height - (z - low) * scale];
  const shift = at(pair, pair.shift, time);
  pen.setLineDash([3, 6]);
  for (let k = Math.ceil((middle - half) / pair.grid); k * pair.grid < middle + half; k++)
    line(pen, ink.faint, 1, [[place(k * pair.grid, 0)[0], 0], [place(k * pair.grid, 0)[0], height]]);
  pen.setLineDash([]);
  drawRoom(pen, side, shift, place, [width, height], pair.grid * scale, ink);
  const x = at(pair, side.x, time), z = at(pair, side.z, time), tilt = at(pair, side.tilt, time);
  const cos = Math.cos(tilt), sin = Math.sin(tilt);
  const placed = ([body, u, v]) =>
    body ? place(x + u * cos + v * sin + shift, z - u * sin + v * cos) : place(u + shift, v);
  trace(pen, side.corners.map(([u, v]) => placed([1, u, v])), true);
  pen.fillStyle = pair.colours[modeAt(side, time)]; pen.fill();
  pen.strokeStyle = ink.ink; pen.lineWidth = 2; pen.lineJoin = "round"; pen.stroke();
  drawShapes(pen, side, time, placed, ink);
  const [u, v] = place(x + shift, z);
  pen.beginPath(); pen.arc(u, v, 5, 0, 2 * Math.PI); pen.fillStyle = "#ffffff"; pen.fill();
  pen.strokeStyle = pen.fillStyle = "#1f2933"; pen.lineWidth = 1; pen.stroke();
  for (const turn of [0, Math.PI]) {
    pen.beginPath(); pen.moveTo(u, v); pen.arc(u, v, 5, turn, turn + Math.PI / 2); pen.fill();
  }
}

function shown(value) {                // with one digit; nothing is not negative
  return value.toFixed(1).replace(/^-(?=0\.0$)/, "").replace("-", "−");
}

function show(article, pair) {
  const part = (name) => article.querySelector(name);
  const canvases = [...article.querySelectorAll("canvas")], states = [...article.querySelectorAll(".state")];
  const cursor = part(".now"), edges = [62, 890];       // the histories' left and right edge
  const play = part(".play"), slider = part(".time"), clock = part(".clock"), speed = part(".speed");
  let time = Math.min(Math.max(pair.telling, pair.start), pair.end), playing = false, last = null, ink = inks();
  let poster = true;                   // the most telling moment is shown until it is played

  function draw() {
    pair.sides.forEach((side, i) => {
      drawScene(canvases[i], pair, side, time, ink);
      const degrees = shown(at(pair, side.tilt, time) * 180 / Math.PI);
      const slide = shown(at(pair, side.slide, time) * 100);
      states[i].textContent = `${pair.modes[modeAt(side, time)]} · ${degrees}° · ${slide} cm`;
    });
    const across = edges[0] + (edges[1] - edges[0]) * (time - pair.start) / (pair.end - pair.start || 1);
    cursor.setAttribute("x1", across); cursor.setAttribute("x2", across);
    slider.value = 1000 * (time - pair.start) / (pair.end - pair.start || 1);
    slider.setAttribute("aria-valuetext", time.toFixed(1) + " s");
    clock.textContent = time.toFixed(2) + " s";
  }
  function set(on) { playing = on; last = null; play.textContent = on ? play.dataset.pause : play.dataset.play;
    if (on) requestAnimationFrame(frame); }
  function frame(stamp) {
    if (!playing) return;
    time += last === null ? 0 : (stamp - last) / 1000 * Number(speed.value);
    last = stamp;
    if (time >= pair.end) { time = pair.end; set(false); }
    draw();
    if (playing) requestAnimationFrame(frame);
  }
  play.onclick = () => {
    if (!playing && (poster || time >= pair.end)) time = pair.start;
    poster = false;
    set(!playing);
  };
  slider.oninput = () => { set(false); poster = false; time = pair.start + slider.value / 1000 * (pair.end - pair.start); draw(); };
  const again = () => { ink = inks(); draw(); };
  addEventListener("resize", draw);
  addEventListener("beforeprint", again);
  addEventListener("afterprint", again);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
  matchMedia("print").addEventListener("change", again);
  draw();
}

const pairs = JSON.parse(document.getElementById("scenes").textContent).map(unpacked);
document.querySelectorAll(".pair").forEach((article) => show(article, pairs[Number(article.dataset.pair)]));
addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((one) => { one.open = true; }));
