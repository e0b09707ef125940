// Chances as bars.

import { svg } from "./dom.js";

/** A chance as a bar, with its interval as a line; dashed where it is not known. */
export function bar({ estimate, low, high }) {
  const at = (share) => (2 + 196 * share).toFixed(1);
  const known = estimate !== null;
  return svg(
    "svg",
    { viewBox: "0 0 200 18", class: "bar", preserveAspectRatio: "none", "aria-hidden": "true" },
    svg("rect", { class: known ? "all" : "all unknown", x: 2, y: 3, width: 196, height: 12 }),
    known ? svg("rect", { class: "part", x: 2, y: 3, width: Math.max(0.5, 196 * estimate), height: 12 }) : null,
    known
      ? svg("path", { class: "whisker", d: `M${at(low)} 9H${at(high)}M${at(low)} 4V14M${at(high)} 4V14` })
      : null,
  );
}
