// Names on a plan: where each stands so that they overlap as little as can be; as in the reports.

import { svg } from "../dom.js";

const FONT = 13,
  LINE = 16, // height of a line [px]
  LONGEST = 11, // longest line, in widths of a full-width letter
  NARROW = 0.56, // width of a letter that is not full-width, in the same
  COST = { name: 30, outside: 20, hidden: 6, thing: 2, farther: 0.15 };

const widthOf = (text) => [...text].reduce((sum, letter) => sum + (letter > "\u2e7f" ? 1 : NARROW), 0);

/** A name as at most two lines, cut where it is longer. */
function wrapped(name) {
  const lines = [""];
  for (const word of name.split(/\s+/)) {
    const joined = `${lines.at(-1)} ${word}`.trim();
    if (lines.at(-1) && widthOf(joined) > LONGEST) lines.push(word);
    else lines[lines.length - 1] = joined;
  }
  const kept = lines.slice(0, 2);
  if (lines.length > 2) kept[1] += "…";
  return kept.map(cut);
}

function cut(line) {
  let letters = line;
  while (widthOf(letters) > LONGEST) letters = letters.replace(/….*$/, "").slice(0, -1) + "…";
  return letters;
}

const shared = (one, other) =>
  Math.max(0, Math.min(one[2], other[2]) - Math.max(one[0], other[0])) *
  Math.max(0, Math.min(one[3], other[3]) - Math.max(one[1], other[1]));

/** What share of a thing is hidden by its own name, unless that is within it. */
const hidden = (thing, name) =>
  [0, 1].every((i) => thing[i] <= name[i] && thing[i + 2] >= name[i + 2])
    ? 0
    : shared(thing, name) / ((thing[2] - thing[0]) * (thing[3] - thing[1]));

/**
 * Names as texts, the first placed first: labels are {name, notes, box}; they rather do not stand on things, but in
 * their own where they fit there, nor beyond the floor [px].
 */
export function nameTexts(labels, things, floor) {
  const taken = [];
  return labels.flatMap(({ name, notes, box }) => {
    const lines = [
      ...wrapped(name).map((text) => ({ text, name: "name halo" })),
      ...notes.map((text) => ({ text, name: "note halo" })),
    ];
    const others = things.filter((one) => one !== box);
    const costs = candidates(lines, box).map((one, place) => ({
      one,
      cost: cost(one, taken, others, floor) + COST.hidden * hidden(box, one) + COST.farther * place,
    }));
    const spot = costs.reduce((least, next) => (next.cost < least.cost ? next : least)).one;
    taken.push(spot);
    const texts = lines.map(({ text, name: look }, row) =>
      svg("text", {
        class: look,
        "text-anchor": "middle",
        x: ((spot[0] + spot[2]) / 2).toFixed(1),
        y: (spot[1] + LINE * (row + 0.78)).toFixed(1),
        text,
      }),
    );
    return [plate(spot), ...texts];
  });
}

/** What a name stands on, so that it can be read over hatched cells. */
const plate = ([x0, y0, x1, y1]) =>
  svg("rect", {
    class: "plate",
    x: x0.toFixed(1),
    y: y0.toFixed(1),
    width: (x1 - x0).toFixed(1),
    height: (y1 - y0).toFixed(1),
    rx: 4,
  });

/** Rectangles for a name: in the middle of what it names, then at its sides. */
function candidates(lines, [x0, y0, x1, y1]) {
  const dx = (FONT * Math.max(...lines.map(({ text }) => widthOf(text))) + 4) / 2,
    dy = (LINE * lines.length) / 2,
    gap = 3,
    [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const [right, left] = [x1 + dx + gap, x0 - dx - gap],
    [below, above] = [y1 + dy + gap, y0 - dy - gap],
    [low, high] = [y0 + dy, y1 - dy],
    [near, far] = [x0 + dx, x1 - dx];
  const middles = [
    [x, y],
    [x, low],
    [x, high],
    [right, y],
    [left, y],
    [near, y],
    [far, y],
    [x, below],
    [x, above],
  ];
  for (const across of [right, left]) middles.push([across, low], [across, high]);
  for (const across of [near, far]) middles.push([across, below], [across, above]);
  return middles.map(([a, b]) => [a - dx, b - dy, a + dx, b + dy]);
}

function cost(box, taken, others, floor) {
  const area = (box[2] - box[0]) * (box[3] - box[1]);
  const on = (boxes) => boxes.reduce((sum, one) => sum + shared(box, one), 0);
  return (
    (COST.name * on(taken) + COST.thing * on(others) + COST.outside * (area - shared(box, floor))) / area
  );
}
