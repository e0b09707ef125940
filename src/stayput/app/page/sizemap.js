// The map of size against intensity: how often such a piece turns over, and the user's own on it.

import { label, shortClass, ticks, titles } from "./axes.js";
import { el, fill, part, svg, widthFor } from "./dom.js";
import { classesKnown } from "./panel_shaking.js";
import { both, length, number, perCent, percent, spoken, t, within } from "./words.js";

let W = 560;
const H = 320,
  LEFT = 60,
  RIGHT = 14,
  TOP = 30,
  FOOT = 48;
const STEPS = 5;

/** Draws the map that the server answered; what is not possible or not known is marked as such. */
export function show(map) {
  W = widthFor(part("map"));
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
        `${number(map.intensity[i], 2)}${t("listed")}${length(sizes[j])}${t("colon")}${shareText(share, map.refused[j])}`,
        map.refused[j] !== null,
      ),
    ),
  );
  const size = map.axis === "width" ? map.here.width_m : map.here.height_m;
  const somewhere = map.here.intensity !== null,
    at = Math.min(xs.at(-1), Math.max(xs[0], map.here.intensity ?? xs[0])),
    hx = x(at),
    hy = y(size);
  const nearest = (list, value) =>
    list.reduce((best, one, i) => (Math.abs(one - value) < Math.abs(list[best] - value) ? i : best), 0);
  const row = nearest(sizes, size),
    own = somewhere ? map.overturned[row][nearest(map.intensity, at)] : null;
  const impossible = map.refused.find((one) => one !== null) ?? null,
    unknown = map.overturned.some((shares, j) => map.refused[j] === null && shares.includes(null));
  const picture = svg(
    "svg",
    {
      viewBox: `0 0 ${W} ${H}`,
      class: "chart",
      role: "img",
      "aria-label": t("mapAlt", {
        size: length(size),
        at: somewhere ? number(map.here.intensity, 2) : t("notKnown"),
        share: shareText(own, map.refused[row]),
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
    ...(somewhere ? mark(hx, hy) : []),
    ...titles(
      (LEFT + W - RIGHT) / 2,
      H,
      (TOP + H - FOOT) / 2,
      t("intensityAxis"),
      t(map.axis === "width" ? "depthAxis" : "heightAxis"),
    ),
  );
  fill(
    part("map"),
    picture,
    key(impossible !== null, unknown),
    impossible ? el("p", { class: "hint", text: notPossible(impossible) }) : [],
    el("p", { class: "hint", text: t("mapNote", { motions: number(map.motions), runs: number(map.runs) }) }),
  );
}

const mark = (x, y) => [
  svg("path", { class: "youline", d: `M${x} ${y - 10}V${y + 10}M${x - 10} ${y}H${x + 10}` }),
  svg("circle", { class: "you", cx: x, cy: y, r: 7 }),
  svg("text", {
    class: "youtext",
    x: x + (x > W / 2 ? -12 : 12),
    y: y - 10,
    "text-anchor": x > W / 2 ? "end" : "start",
    text: t("yourPiece"),
  }),
];

/** Why a piece of a size is not possible, in the reader's language as far as the server has it. */
const reason = ({ message, message_ja: japanese }) =>
  spoken() === "ja" ? (japanese ?? t("doesNotFit")) : within(message);

const notPossible = (refused) => `${t("not_possible")}${t("colon")}${reason(refused)}`;

/** What a cell stands for: a share, or why there is none. */
const shareText = (share, refused) =>
  refused ? notPossible(refused) : percent(share);

function edges(values) {
  const middles = values.slice(1).map((value, i) => (value + values[i]) / 2);
  const first = values[0] - (middles[0] - values[0]),
    last = values.at(-1) + (values.at(-1) - middles.at(-1));
  return [first, ...middles, last];
}

/** A share as one of five steps: darker, and hatched more closely, the more often it turns over. */
const step = (share) =>
  share <= 0.005 ? 0 : Math.min(STEPS - 1, 1 + Math.floor(share * (STEPS - 1) - 1e-9));

function cell(share, x, y, width, height, title, impossible) {
  const place = {
    x: x.toFixed(1),
    y: y.toFixed(1),
    width: (width + 0.5).toFixed(1),
    height: (height + 0.5).toFixed(1),
  };
  const kind = impossible ? "impossible" : share === null ? "unknown" : step(share),
    over = pattern(kind);
  return svg(
    "g",
    {},
    svg("rect", { ...place, class: `cell s${kind}` }, svg("title", { text: title })),
    over ? svg("rect", { ...place, fill: over, "pointer-events": "none" }) : null,
  );
}

/** What is drawn over a cell: stripes one way for a share, crossed ones for "impossible", dots for "unknown". */
const pattern = (kind) => (kind === 0 ? null : `url(#hatch${kind})`);

const hatching = () =>
  svg(
    "defs",
    {},
    svg(
      "pattern",
      { id: "hatchimpossible", width: 9, height: 9, patternUnits: "userSpaceOnUse" },
      svg("path", { class: "cross", d: "M0 0L9 9M9 0L0 9" }),
    ),
    svg(
      "pattern",
      { id: "hatchunknown", width: 7, height: 7, patternUnits: "userSpaceOnUse" },
      svg("circle", { class: "speck", cx: 3, cy: 3, r: 1.1 }),
    ),
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

function key(impossible, unknown) {
  const kinds = ["0", "1–25", "26–50", "51–75", "76–100"].map((text, n) => [n, perCent(text)]);
  if (impossible) kinds.push(["impossible", t("not_possible")]);
  if (unknown) kinds.push(["unknown", t("notKnown")]);
  return el(
    "ul",
    { class: "key" },
    ...kinds.map(([kind, text]) =>
      el(
        "li",
        {},
        svg(
          "svg",
          { viewBox: "0 0 24 16", "aria-hidden": "true" },
          svg("rect", { class: `cell s${kind}`, width: 24, height: 16 }),
          kind ? svg("rect", { width: 24, height: 16, fill: pattern(kind) }) : null,
        ),
        el("span", { text }),
      ),
    ),
  );
}
