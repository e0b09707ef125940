// What stands along an axis: round numbers, classes of the scale, titles.

import { svg } from "./dom.js";

/** Round values between two ends, about so many of them. */
export function ticks(low, high, wanted) {
  if (!(high > low)) return [low];
  const rough = (high - low) / wanted,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((one) => one * power >= rough - 1e-12);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
    ticks.push(Number((k * step).toPrecision(10)));
  return ticks;
}

/** A class of the JMA scale, as short as the room for it asks. */
export const shortClass = (name, narrow) => {
  const short = name.replace(/^震度/, "");
  return narrow ? short.replace("-lower", "\u2212").replace("-upper", "+") : short;
};

/** A tick's number, as short as it can be. */
export const label = (value) => String(Number(value.toPrecision(6))).replace("-", "\u2212");

/** The titles of a picture's axes: about `middle` at its foot, `height` down, and about `centre` at its left. */
export const titles = (middle, height, centre, across, up) => [
  svg("text", { x: middle, y: height - 6, "text-anchor": "middle", text: across }),
  svg("text", {
    x: 14,
    y: centre,
    "text-anchor": "middle",
    transform: `rotate(-90 14 ${centre})`,
    text: up,
  }),
];
