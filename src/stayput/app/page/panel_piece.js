// "Set the scene": the piece of furniture, its size, and how it is loaded.

import { oneOf } from "./controls.js";
import { el, fill, part, svg } from "./dom.js";
import { details, pathOf } from "./furniture.js";
import { balance, change, current, fromPreset } from "./scene.js";
import { choiceField, named, numberField, wordField } from "./scene_fields.js";
import { both, length, number, t } from "./words.js";

let fields = {},
  cards = {},
  sketch = null,
  known = [];

const LOADINGS = {
  low: (n, total) => share(n, total, (i) => n - i),
  even: (n, total) => share(n, total, () => 1),
  high: (n, total) => share(n, total, (i) => i + 1),
  empty: (n) => Array(n).fill(0),
};

function share(n, total, weight) {
  const all = Array.from({ length: n }, (_, i) => weight(i) ** 2),
    sum = all.reduce((a, b) => a + b);
  return all.map((one) => Math.round((total * one) / sum));
}

/** Builds the panel; called again for another language. */
export function build(presets) {
  known = presets.furniture;
  cards = {};
  fill(part("presets"), known.map(card));
  const scene = current();
  fields = {
    height: size(presets, "height"),
    width: size(presets, "width"),
    length: size(presets, "length"),
    mass: numberField(presets, "mass", { label: t(scene.shelves ? "carcass" : "mass"), step: 1 }),
  };
  const loads = scene.shelves ? shelves(presets, scene) : [centre(presets)];
  const sizes = ["height", "width", "length", "mass"].map((name) => fields[name].element);
  fill(part("sizes"), ...sizes, ...loads, ...inside(presets));
  fill(part("engine"), ...engine(presets));
  update();
}

const size = (presets, key) =>
  numberField(presets, key, { step: 0.01, hint: key === "width" ? t("widthHint") : null });

/** Whether the piece is shaken in the plane of its depth or in space, and on what it stands then. */
function engine(presets) {
  fields.engine = oneOf({
    label: t("engine"),
    hint: t("engineHint"),
    options: ["space", "plane"].map((id) => ({ id, label: t(`engine_${id}`) })),
    changed: (id) => change({ inSpace: id === "space" }),
  });
  fields.base = wordField(presets, "base");
  return [fields.engine.element, fields.base.element];
}

function centre(presets) {
  fields.centre = numberField(presets, "centre", { unit: "%", step: 0.01, factor: 100, hint: t("centreHint") });
  return fields.centre.element;
}

/** What is inside, and the doors before it: what comes out is told with the measures. */
function inside(presets) {
  const nothing = { id: "nothing", label: t("noContents") };
  fields.contents = choiceField("contents", [nothing, ...named(presets.contents)]);
  fields.doors = choiceField("doors", named(presets.doors));
  return [fields.contents.element, fields.doors.element];
}

function shelves(presets, scene) {
  const n = scene.shelves.length;
  fields.shelves = scene.shelves.map((_, i) =>
    numberField(presets, "load", {
      label: t("shelf", { n: i + 1 }),
      step: 1,
      changed: (load) => change({ shelves: current().shelves.map((old, j) => (i === j ? load : old)) }),
    }),
  );
  const quick = el(
    "div",
    { class: "row", role: "group", "aria-label": t("loading") },
    ...Object.entries(LOADINGS).map(([name, loaded]) =>
      el("button", {
        type: "button",
        text: t(`load_${name}`),
        onclick: () => {
          const total = current().shelves.reduce((a, b) => a + b, 0) || 33 * n;
          change({ shelves: loaded(n, total) });
        },
      }),
    ),
  );
  const each = el(
    "details",
    {},
    el("summary", { text: t("eachShelf") }),
    ...fields.shelves.map((field) => field.element).reverse(),
  );
  return [el("h3", { text: t("loading") }), quick, each];
}

// somebody 1.6 m tall, in metres, up from the floor
const PERSON =
  "M-.1 1.5a.1 .1 0 1 0 .2 0a.1 .1 0 1 0 -.2 0z" +
  "M-.2 1.33Q0 1.42 .2 1.33L.17 .71H.11L.09 0H-.09L-.11 .71H-.17z";

/** A piece as it is seen from its side: its outline, and what it is of. */
const front = (kind, w, h, loads, place) => [
  svg("path", { class: "outline", d: pathOf([[-w / 2, 0], [w / 2, 0], [w / 2, h], [-w / 2, h]], place) }),
  ...details(kind, w, h, loads).map(({ tone, points }) =>
    svg("path", { class: `detail ${tone}`, d: pathOf(points, place) }),
  ),
];

const TALL = 2.1,
  CARD = 64;

function card(preset) {
  const scale = CARD / TALL,
    w = preset.width_m,
    h = preset.height_m;
  const place = (u, v) => [36 + u * scale, CARD + 4 - v * scale];
  const loads = preset.shelves ? Array(preset.shelves).fill(1) : null;
  const drawing = svg(
    "svg",
    { viewBox: `0 0 72 ${CARD + 8}`, "aria-hidden": "true" },
    svg("path", { class: "floorline", d: `M4 ${CARD + 4.5}H68` }),
    ...front(preset.id, w, h, loads, place),
  );
  const button = el(
    "button",
    {
      type: "button",
      class: "card",
      "aria-pressed": "false",
      onclick: () => {
        const had = current().shelves !== null,
          next = fromPreset(preset);
        change(next);
        if (had !== (next.shelves !== null)) part("sizes").dispatchEvent(new Event("rebuild"));
      },
    },
    drawing,
    el("span", { text: both(preset.label) }),
  );
  cards[preset.id] = button;
  return button;
}

/** Puts the scene's values into the fields, and draws the piece with G. */
export function update() {
  const scene = current();
  for (const [id, button] of Object.entries(cards))
    button.setAttribute("aria-pressed", String(id === scene.piece));
  for (const key of ["width", "height", "length", "mass", "centre", "base"]) fields[key]?.set(scene[key]);
  fields.engine.set(scene.inSpace ? "space" : "plane");
  fields.base.element.hidden = !scene.inSpace;
  fields.contents.set(scene.contents);
  fields.doors.set(scene.doors);
  fields.doors.element.hidden = scene.contents === "nothing";
  fields.shelves?.forEach((field, i) => field.set(scene.shelves?.[i] ?? 0));
  drawSketch(scene);
}

function drawSketch(scene) {
  const { mass, up } = balance(scene),
    { width: w, height: h } = scene;
  const tall = Math.max(h, 1.7) + 0.12,
    wide = 2.4,
    ground = 0.08,
    unit = 200 / (tall + ground);
  const place = (x, z) => [(x + 0.75) * unit, (tall - z) * unit];
  const [gx, gz] = place(0, up),
    [edge, floor] = place(w / 2, 0);
  const back = -w / 2 - scene.gap,
    left = place(back, 0)[0];
  sketch = svg(
    "svg",
    {
      viewBox: `0 0 ${(wide * unit).toFixed(0)} 200`,
      role: "img",
      "aria-label": t("sketchAlt", { up: length(up), mass: number(mass) }),
    },
    svg("path", {
      class: "person",
      d: PERSON,
      transform: `translate(${place(1.1, 0)}) scale(${unit} ${-unit})`,
    }),
    svg("path", {
      class: "room",
      d:
        `M0 ${floor}H${wide * unit}V200H0Z` +
        (scene.wall && left > 0 ? `M0 0H${left.toFixed(1)}V${floor}H0Z` : ""),
    }),
    ...front(scene.piece, w, h, scene.shelves, place),
    svg("path", { class: "lean", d: `M${gx} ${gz}L${edge} ${floor}` }),
    svg("circle", { class: "g", cx: gx, cy: gz, r: 6 }),
    svg("path", { class: "gmark", d: `M${gx} ${gz}v-6a6 6 0 0 1 6 6zM${gx} ${gz}v6a6 6 0 0 1-6-6z` }),
    svg("text", { x: edge + 12, y: gz + 4, text: `G ${length(up)}` }),
  );
  fill(part("sketch"), sketch);
  part("balance").textContent = t("balance", {
    mass: number(mass),
    up: length(up),
    angle: number((Math.atan2(w / 2, up) * 180) / Math.PI, 1),
  });
}
