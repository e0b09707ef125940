// What a piece looks like from its side, drawn from its size: lines in metres, right of the middle of its
// base and up.

const box = (tone, left, low, right, high) => ({
  tone,
  points: [[left, low], [right, low], [right, high], [left, high]],
});
const solid = (...ends) => box("solid", ...ends);
const soft = (...ends) => box("soft", ...ends);
const line = (...points) => ({ tone: "line", points });
const rows = (count, made) => Array.from({ length: count }, (_, i) => made(i));

function shelves(w, h, loads) {
  const count = loads.length,
    clear = h / count,
    most = Math.max(...loads, 1e-9),
    board = Math.min(0.02, h / 60);
  const boards = rows(count - 1, (i) => solid(-w / 2, (i + 1) * clear - board, w / 2, (i + 1) * clear));
  const books = loads.map((load, i) => {
    const tall = 0.82 * (clear - board) * Math.sqrt(Math.max(0, load) / most);
    return soft(-0.4 * w, i * clear, 0.36 * w, i * clear + tall);
  });
  return [...books.filter((_, i) => loads[i] > 0), ...boards];
}

const front = (w, h, from, to, handle) => {
  const door = w / 2 - Math.min(0.04, 0.1 * w);
  return [
    line([door, from * h], [door, to * h]),
    solid(w / 2, (handle - 0.05) * h, w / 2 + 0.025, (handle + 0.05) * h),
  ];
};
const across = (w, h, at) => line([-w / 2, at * h], [w / 2, at * h]);

const SHAPES = {
  bookcase: shelves,
  "empty bookcase": (w, h, loads) => shelves(w, h, Array(loads.length).fill(0)),
  wardrobe: (w, h) => [
    ...front(w, h, 0, 1, 0.5),
    line([-0.3 * w, 0.86 * h], [0.3 * w, 0.86 * h]),
    {
      tone: "soft",
      points: [[0, 0.86], [-0.24, 0.78], [-0.2, 0.3], [0.2, 0.3], [0.24, 0.78]].map(([x, y]) => [x * w, y * h]),
    },
  ],
  cupboard: (w, h) => [
    ...front(w, h, 0, 0.45, 0.36),
    ...front(w, h, 0.5, 1, 0.6),
    across(w, h, 0.45),
    across(w, h, 0.5),
    ...rows(3, (i) => soft(-0.36 * w, (0.5 + 0.16 * i) * h, 0.2 * w, (0.59 + 0.16 * i) * h)),
  ],
  chest: (w, h) =>
    rows(5, (i) => [
      ...(i ? [across(w, h, i / 5)] : []),
      solid(w / 2, ((i + 0.45) * h) / 5, w / 2 + 0.02, ((i + 0.6) * h) / 5),
    ]).flat(),
  refrigerator: (w, h) => [
    ...front(w, h, 0.38, 1, 0.55),
    ...front(w, h, 0, 0.38, 0.28),
    across(w, h, 0.38),
    soft(-0.42 * w, 0.03 * h, -0.2 * w, 0.14 * h),
  ],
  television: (w, h) => [
    solid(-0.1 * w, 0.14 * h, 0.1 * w, h),
    soft(-0.04 * w, 0.03 * h, 0.04 * w, 0.14 * h),
    solid(-w / 2, 0, w / 2, 0.03 * h),
  ],
  "vending machine": (w, h) => [
    line([0.38 * w, 0], [0.38 * w, h]),
    ...rows(12, (k) => {
      const [left, low] = [-0.4 + 0.25 * (k % 3), 0.36 + 0.15 * Math.floor(k / 3)];
      return soft(left * w, low * h, (left + 0.18) * w, (low + 0.11) * h);
    }),
    solid(0.38 * w, 0.12 * h, 0.5 * w, 0.2 * h),
  ],
  "server rack": (w, h) =>
    rows(14, (i) => box(i % 3 ? "soft" : "line", -0.42 * w, (0.05 + 0.065 * i) * h, 0.42 * w, (0.095 + 0.065 * i) * h)),
  "upright piano": (w, h) => [
    line([0.1 * w, 0.5 * h], [0.1 * w, h]),
    solid(0.1 * w, 0.5 * h, w / 2, 0.56 * h),
    line([0.1 * w, 0], [0.1 * w, 0.5 * h]),
    soft(0.16 * w, 0, 0.44 * w, 0.05 * h),
  ],
};

/** The lines of a kind of piece: {points, tone "line" | "soft" | "solid"}; a plain box for any other kind. */
export function details(kind, width, height, loads) {
  const shape = SHAPES[kind] ?? (loads ? shelves : () => []);
  return shape(width, height, loads ?? [1, 1, 1, 1, 1]);
}

/** Points as an SVG path. */
export const pathOf = (points, place) => {
  const corners = points.map(([u, v]) => place(u, v).map((n) => n.toFixed(1)).join(" "));
  return `M${corners.join("L")}${points.length > 2 ? "Z" : ""}`;
};
