// The map of size against intensity: what share of the motions turns such a piece over, and the user's
// own on it.

import { label, shortClass, ticks, titles } from "./axes.js";
import { el, fill, part, svg, widthFor } from "./dom.js";
import { classesKnown } from "./panel_shaking.js";
import { both, length, number, percent, t } from "./words.js";

let W = 560;
const H = 320,
  LEFT = 60,
  RIGHT = 14,
  TOP = 30,
  FOOT = 48;
const STEPS = 5;

/** Draws the map that the server answered; pieces that do not fit under the ceiling are left out. */
export function show(answer, ceiling) {
  W = widthFor(part("map"));
  const fits = (_, i) => answer.height_m[i] < ceiling;
  const map = {
    ...answer,
    width_m: answer.width_m.filter(fits),
    height_m: answer.height_m.filter(fits),
    overturned: answer.overturned.filter(fits),
  };
  const xs = edges(map.intensity),
    sizes = map.axis === "width" ? map.width_m : map.height_m,
    ys = edges(sizes);
  const x = (value) => LEFT + ((W - LEFT - RIGHT) * (value - xs[0])) / (xs.at(-1) - xs[0]);
  const y = (value) => H - FOOT - ((H - FOOT - TOP) * (value - ys[0])) / (ys.at(-1) - ys[0]);
  const cells = map.overturned.flatMap((row, j) =>
    row.map((share, i) =>
      cell(
        share,
        x(xs[i]),
        y(ys[j + 1]),
        x(xs[i + 1]) - x(xs[i]),
        y(ys[j]) - y(ys[j + 1]),
        `${number(map.intensity[i], 2)}, ${length(sizes[j])}: ${percent(share)}`,
      ),
    ),
  );
  const size = map.axis === "width" ? map.here.width_m : map.here.height_m;
  const hx = x(Math.min(xs.at(-1), Math.max(xs[0], map.here.intensity))),
    hy = y(size);
  const nearest = (list, value) =>
    list.reduce((best, one, i) => (Math.abs(one - value) < Math.abs(list[best] - value) ? i : best), 0);
  const own = map.overturned[nearest(sizes, size)][nearest(map.intensity, map.here.intensity)];
  const picture = svg(
    "svg",
    {
      viewBox: `0 0 ${W} ${H}`,
      class: "chart",
      role: "img",
      "aria-label": t("mapAlt", {
        size: length(size),
        at: number(map.here.intensity, 2),
        share: percent(own),
      }),
    },
    hatching(),
    ...cells,
    ...classNames(x, xs),
    ...ticks(xs[0], xs.at(-1), 6).map((value) =>
      svg("text", { x: x(value), y: H - FOOT + 16, "text-anchor": "middle", text: label(value) }),
    ),
    ...ticks(ys[0], ys.at(-1), 6).map((value) =>
      svg("text", { x: LEFT - 6, y: y(value) + 4, "text-anchor": "end", text: label(100 * value) }),
    ),
    svg("path", { class: "youline", d: `M${hx} ${hy - 10}V${hy + 10}M${hx - 10} ${hy}H${hx + 10}` }),
    svg("circle", { class: "you", cx: hx, cy: hy, r: 7 }),
    svg("text", {
      class: "youtext",
      x: hx + (hx > W / 2 ? -12 : 12),
      y: hy - 10,
      "text-anchor": hx > W / 2 ? "end" : "start",
      text: t("yourPiece"),
    }),
    ...titles((LEFT + W - RIGHT) / 2, H, (TOP + H - FOOT) / 2, t("intensityAxis"), t(map.axis === "width" ? "depthAxis" : "heightAxis")),
  );
  fill(
    part("map"),
    picture,
    key(),
    el("p", { class: "hint", text: t("mapNote", { motions: number(map.motions) }) }),
  );
}

function edges(values) {
  const middles = values.slice(1).map((value, i) => (value + values[i]) / 2);
  const first = values[0] - (middles[0] - values[0]),
    last = values.at(-1) + (values.at(-1) - middles.at(-1));
  return [first, ...middles, last];
}

/** A share as one of five steps: darker, and hatched more closely, the more of the motions turn it over. */
const step = (share) =>
  share <= 0.005 ? 0 : Math.min(STEPS - 1, 1 + Math.floor(share * (STEPS - 1) - 1e-9));

function cell(share, x, y, width, height, title) {
  const place = {
    x: x.toFixed(1),
    y: y.toFixed(1),
    width: (width + 0.5).toFixed(1),
    height: (height + 0.5).toFixed(1),
  };
  const n = step(share);
  return svg(
    "g",
    {},
    svg("rect", { ...place, class: `cell s${n}` }, svg("title", { text: title })),
    n ? svg("rect", { ...place, fill: `url(#hatch${n})`, "pointer-events": "none" }) : null,
  );
}

const hatching = () =>
  svg(
    "defs",
    {},
    ...[1, 2, 3, 4].map((n) =>
      svg(
        "pattern",
        {
          id: `hatch${n}`,
          width: 14 - 2.5 * n,
          height: 14 - 2.5 * n,
          patternUnits: "userSpaceOnUse",
          patternTransform: "rotate(45)",
        },
        svg("path", { class: "hatch", d: "M0 0V20" }),
      ),
    ),
  );

function classNames(x, xs) {
  const known = classesKnown().filter((one) => one.from >= 3.5);
  return known
    .map((one, i) => {
      const from = Math.max(xs[0], one.from),
        to = Math.min(xs.at(-1), known[i + 1]?.from ?? xs.at(-1));
      return to - from < 0.15
        ? null
        : svg("text", {
            class: "classname",
            x: (x(from) + x(to)) / 2,
            y: TOP - 8,
            "text-anchor": "middle",
            text: shortClass(both(one.label), W < 480),
          });
    })
    .filter(Boolean);
}

const key = () =>
  el(
    "ul",
    { class: "key" },
    ...["0", "1–25", "26–50", "51–75", "76–100"].map((text, n) =>
      el(
        "li",
        {},
        svg(
          "svg",
          { viewBox: "0 0 24 16", "aria-hidden": "true" },
          svg("rect", { class: `cell s${n}`, width: 24, height: 16 }),
          n ? svg("rect", { width: 24, height: 16, fill: `url(#hatch${n})` }) : null,
        ),
        el("span", { text: `${text} %` }),
      ),
    ),
  );
