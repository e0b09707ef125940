// Names on a plan: where each stands so that they overlap as little as can be and are not taken for those of others.

import { svg } from "../dom.js";

const USUAL = { font: 13, line: 16 },
  SMALL = { font: 11, line: 13 },
  WITHIN = { font: 10, line: 11 }, // on its thing, as long as that
  LOOKS = [USUAL, SMALL, WITHIN], // the first is taken in which a name finds a free spot
  LONGEST = 11, // longest line, in widths of a full-width letter
  SHORTEST = 3, // to what a name on its thing is cut, in the same
  NARROW = 0.6, // width of a letter that is not full-width, in the same
  FREE = 0.4, // cost up to which a spot is free
  AGAIN = 3, // how often each name is placed, the others being where they are
  COST = { name: 40, outside: 20, hidden: 6, thing: 40, mistaken: 20, farther: 0.01, look: 0.5 },
  MARGIN = 4, // beside the letters, both sides together [px]
  NEAR = 3, // from a thing to a name beside it [px]
  OFF = 18; // the same where there is no room beside it; a line then leads to the thing

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
  return kept.map((line) => cut(line, LONGEST));
}

function cut(line, longest) {
  let letters = line;
  while (widthOf(letters) > longest) letters = letters.replace(/….*$/, "").slice(0, -1) + "…";
  return letters;
}

/** A name cut before its number, by which things of one kind differ. */
function shortened(name, longest) {
  const [, kind, number] = /^(.*?)(\s*\d{0,3})$/s.exec(name);
  return widthOf(name) > longest ? cut(kind, Math.max(1, longest - widthOf(number))) + number : name;
}

const shared = (one, other) =>
  Math.max(0, Math.min(one[2], other[2]) - Math.max(one[0], other[0])) *
  Math.max(0, Math.min(one[3], other[3]) - Math.max(one[1], other[1]));

const apart = (one, other) =>
  Math.hypot(...[0, 1].map((i) => Math.max(0, one[i] - other[i + 2], other[i] - one[i + 2])));

/** Whether a name at a spot beside its thing is as near to another one. */
function mistaken(spot, box, others) {
  const own = apart(spot, box);
  return own > 0 && others.some((one) => apart(spot, one) <= own);
}

/** What share of a thing is hidden by its own name, unless that is within it. */
const hidden = (thing, name) =>
  [0, 1].every((i) => thing[i] <= name[i] && thing[i + 2] >= name[i + 2])
    ? 0
    : shared(thing, name) / ((thing[2] - thing[0]) * (thing[3] - thing[1]));

/**
 * Names as texts, and where they stand: labels are {name, notes, box}, a note {text, share}; they stand in or beside their own things and, as
 * far as can be, on no other, on no other name, and not beyond the floor [px].
 */
export function nameTexts(labels, things, floor) {
  const placed = labels.map(() => null);
  for (let round = 0; round < AGAIN; round++)
    labels.forEach((label, i) => {
      const names = placed.filter((one, j) => one && j !== i).map(({ spot }) => spot);
      placed[i] = best(label, names, things, floor);
    });
  return { texts: placed.flatMap(texts), spots: placed.map(({ spot }) => spot) };
}

/** Where a name stands best, {cost, spot, lines, look, box}, in the first look in which it is free there. */
function best({ name, notes, box }, names, things, floor) {
  const others = things.filter((one) => one !== box);
  let least = null;
  for (const [step, look] of LOOKS.entries()) {
    const within = look === WITHIN && Math.max(SHORTEST, (box[2] - box[0] - MARGIN) / look.font),
      lines = [
        ...(within ? [shortened(name, Math.min(within, LONGEST))] : wrapped(name)).map((text) => ({ text, kind: "name" })),
        ...notes.map(({ text, share }) => ({ text: within ? share : text, kind: "note" })),
      ];
    const spots = candidates(lines, look, box).filter((spot) => !within || apart(spot, box) === 0);
    for (const [place, spot] of spots.entries()) {
      const on =
          cost(spot, names, others, floor) +
          (within ? 0 : COST.hidden * hidden(box, spot)) +
          COST.mistaken * mistaken(spot, box, others),
        all = on + COST.farther * place + COST.look * step;
      if (!least || all < least.cost) least = { cost: all, on, spot, lines, look, box };
    }
    if (least.on <= FREE) break;
  }
  return least;
}

function texts({ spot, lines, look: { font, line }, box }) {
  const own = lines.map(({ text, kind }, row) =>
    svg("text", {
      class: `${kind} halo`,
      "text-anchor": "middle",
      style: font === USUAL.font ? null : `font-size: ${font}px`,
      x: ((spot[0] + spot[2]) / 2).toFixed(1),
      y: (spot[1] + line * (row + 0.78)).toFixed(1),
      text,
    }),
  );
  return [leader(spot, box), plate(spot), ...own].filter(Boolean);
}

/** A line from a name to its thing, where it does not stand beside that. */
function leader(spot, box) {
  const nearest = ([low, high], value) => Math.max(low, Math.min(high, value));
  const [x, y] = [(spot[0] + spot[2]) / 2, (spot[1] + spot[3]) / 2],
    to = [nearest([box[0], box[2]], x), nearest([box[1], box[3]], y)],
    from = [nearest([spot[0], spot[2]], to[0]), nearest([spot[1], spot[3]], to[1])];
  if (Math.hypot(to[0] - from[0], to[1] - from[1]) < OFF / 2) return null;
  return svg("path", { class: "leader", d: `M${from.map((one) => one.toFixed(1)).join(" ")}L${to.map((one) => one.toFixed(1)).join(" ")}` });
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

const ALONG = [0.5, 0, 1, 0.25, 0.75]; // where a name stands along a side, beginning with its middle

/** Rectangles for a name: within what it names, then beside it, then off its corners. */
function candidates(lines, { font, line }, [x0, y0, x1, y1]) {
  const dx = (font * Math.max(...lines.map(({ text }) => widthOf(text))) + MARGIN) / 2,
    dy = (line * lines.length) / 2;
  const between = (low, high, share) => low + share * (high - low);
  const inside = ALONG.flatMap((v) => ALONG.map((u) => [between(x0 + dx, x1 - dx, u), between(y0 + dy, y1 - dy, v)])),
    fits = x1 - x0 >= 2 * dx && y1 - y0 >= 2 * dy;
  const middles = fits ? inside : [[(x0 + x1) / 2, (y0 + y1) / 2]];
  for (const gap of [NEAR, OFF]) {
    const [right, left] = [x1 + dx + gap, x0 - dx - gap],
      [below, above] = [y1 + dy + gap, y0 - dy - gap];
    for (const share of ALONG) {
      const [x, y] = [between(x0 + dx, x1 - dx, share), between(y0 + dy, y1 - dy, share)];
      middles.push([right, y], [left, y], [x, below], [x, above]);
    }
    for (const across of [right, left]) middles.push([across, y0 - dy], [across, y1 + dy]);
  }
  return middles.map(([a, b]) => [a - dx, b - dy, a + dx, b + dy]);
}

function cost(box, taken, others, floor) {
  const area = (box[2] - box[0]) * (box[3] - box[1]);
  const on = (boxes) => boxes.reduce((sum, one) => sum + shared(box, one), 0);
  return (
    (COST.name * on(taken) + COST.thing * on(others) + COST.outside * (area - shared(box, floor))) / area
  );
}
