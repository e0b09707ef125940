// A canvas's pen, and the colours of the style sheet for what is drawn with it.

const INKS = "paper card ink muted faint room mark record alarm calm halo tie pad stays moves may_fall falls".split(" ");

/** The colours, from the style sheet; see `readInks`. */
export const ink = {};

/** Reads the colours anew; after the theme changed. */
export function readInks() {
  const style = getComputedStyle(document.documentElement);
  for (const name of INKS) ink[name] = style.getPropertyValue(`--${name}`).trim();
}

/** A cleared canvas, sharp on every screen: its pen, width and height in CSS pixels. */
export function prepared(canvas) {
  const width = canvas.clientWidth,
    height = canvas.clientHeight,
    ratio = devicePixelRatio || 1;
  const w = Math.round(width * ratio),
    h = Math.round(height * ratio);
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return [pen, width, height];
}

/** A line through points. */
export function line(pen, colour, width, points) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  pen.stroke();
}
