// The chance of overturning against intensity: curves with bands, what was observed, and "you are here".

import { label, shortClass, titles } from "./axes.js";
import { el, fill, part, svg, widthFor } from "./dom.js";
import { classesKnown } from "./panel_shaking.js";
import { nameOf } from "./ranking.js";
import { without, yours } from "./verdict.js";
import { both, number, share, t } from "./words.js";

let W = 560;
const H = 300,
  LEFT = 50,
  RIGHT = 14,
  TOP = 40,
  FOOT = 44,
  LOW = 4,
  HIGH = 7;
const x = (intensity) => LEFT + ((W - LEFT - RIGHT) * (intensity - LOW)) / (HIGH - LOW);
const y = (share) => TOP + (H - TOP - FOOT) * (1 - share);
const path = (values, ups) =>
  values.map((value, i) => `${i ? "L" : "M"}${x(value).toFixed(1)} ${y(ups[i]).toFixed(1)}`).join("");
const MARKS = [
  (a, b) => `M${a - 4} ${b}a4 4 0 1 0 8 0a4 4 0 1 0-8 0z`,
  (a, b) => `M${a - 4} ${b - 4}h8v8h-8z`,
  (a, b) => `M${a} ${b - 5}l5 9h-10z`,
];

/** Draws the curves of no measure, of those in place, and of the best. */
export function show(verdict) {
  const chosen = [...new Set([without(verdict), yours(verdict), verdict.options[0]])].filter(Boolean);
  W = widthFor(part("fragility"));
  const known = verdict.jma_intensity !== null,
    here = Math.min(HIGH, Math.max(LOW, verdict.jma_intensity ?? LOW));
  const picture = svg(
    "svg",
    {
      viewBox: `0 0 ${W} ${H}`,
      class: "chart",
      role: "img",
      "aria-label": t("fragilityAlt", { here: known ? number(verdict.jma_intensity, 2) : t("notKnown") }),
    },
    ...classes(),
    ...grid(),
    ...chosen.map(band),
    ...chosen.map(curve),
    ...(known ? [svg("path", { class: "here", d: `M${x(here)} ${TOP}V${y(0)}` }), hereText(x(here))] : []),
    ...titles((LEFT + W - RIGHT) / 2, H, (TOP + H - FOOT) / 2, t("intensityAxis"), t("chanceAxis")),
  );
  const key = el(
    "ul",
    { class: "key" },
    ...chosen.map((one, i) =>
      el(
        "li",
        {},
        svg(
          "svg",
          { viewBox: "0 0 40 12", "aria-hidden": "true" },
          svg("path", { class: `curve c${i}`, d: "M0 6H40" }),
          svg("path", { class: `dot c${i}`, d: MARKS[i](20, 6) }),
        ),
        el("span", {
          text: `${nameOf(one)}${t("colon")}${t("half", { at: capacity(one.capacities.find(({ share }) => share === 0.5)) })}`,
        }),
      ),
    ),
  );
  fill(part("fragility"), picture, key, el("p", { class: "hint", text: t("fragilityNote") }));
}

/** Above the names of the classes, where no curve comes; it leans inwards at the edges. */
const hereText = (at) =>
  svg("text", {
    class: "heretext",
    x: at,
    y: 14,
    "text-anchor": at > W - 60 ? "end" : at < LEFT + 40 ? "start" : "middle",
    text: t("here"),
  });

/** An intensity with its interval, as far as both lie on the curve. */
function capacity({ jma_intensity: estimate, low, high }) {
  const [at, from, to] = [estimate, low, high].map((value) => value !== null && number(value, 2));
  if (at && from && to) return t("between", { at, low: from, high: to });
  if (at) return at;
  if (from) return t("above", { at: from });
  return to ? t("below", { at: to }) : t("unknown");
}

function classes() {
  const known = classesKnown().filter((one) => one.from >= 3.5);
  return known.flatMap((one, i) => {
    const from = Math.max(LOW, one.from),
      to = Math.min(HIGH, known[i + 1]?.from ?? HIGH);
    if (to <= from) return [];
    return [
      svg("rect", {
        class: i % 2 ? "class odd" : "class",
        x: x(from),
        y: TOP,
        width: x(to) - x(from),
        height: y(0) - TOP,
      }),
      svg("text", {
        class: "classname",
        x: (x(from) + x(to)) / 2,
        y: TOP - 8,
        "text-anchor": "middle",
        text: shortClass(both(one.label), W < 480),
      }),
    ];
  });
}

function grid() {
  const ups = [0, 0.25, 0.5, 0.75, 1].flatMap((share) => [
    svg("path", { class: "grid", d: `M${LEFT} ${y(share)}H${W - RIGHT}` }),
    svg("text", { x: LEFT - 6, y: y(share) + 4, "text-anchor": "end", text: `${100 * share}` }),
  ]);
  const along = [4, 4.5, 5, 5.5, 6, 6.5, 7].map((value) =>
    svg("text", { x: x(value), y: y(0) + 16, "text-anchor": "middle", text: label(value) }),
  );
  return [...ups, ...along];
}

function band({ curve: { intensity, low, high } }, i) {
  return svg("path", {
    class: `band c${i}`,
    d: `${path(intensity, high)}${path([...intensity].reverse(), [...low].reverse()).replace("M", "L")}Z`,
  });
}

function curve({ curve: { intensity, probability, observed } }, i) {
  const dots = observed
    .filter((one) => one.estimate !== null && one.im >= LOW && one.im <= HIGH)
    .map((one) =>
      svg(
        "path",
        { class: `dot c${i}`, d: MARKS[i](x(one.im), y(one.estimate)) },
        svg("title", { text: `${number(one.im, 2)}${t("colon")}${share(one)}` }),
      ),
    );
  return svg(
    "g",
    {},
    svg("path", { class: `curve c${i}`, d: path(intensity, probability) }),
    ...dots,
  );
}
