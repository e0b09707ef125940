// What a piece looks like from its side, drawn from its size: lines in metres, right of the middle of its
// base and up.

const box = (left, low, right, high) => [
  [left, low],
  [right, low],
  [right, high],
  [left, high],
];
const rows = (count, made) => Array.from({ length: count }, (_, i) => made(i));

function shelves(w, h, loads) {
  const count = loads.length,
    clear = h / count,
    most = Math.max(...loads, 1e-9),
    board = Math.min(0.02, h / 60);
  const lines = rows(count - 1, (i) => ({
    points: box(-w / 2, (i + 1) * clear - board, w / 2, (i + 1) * clear),
    tone: "solid",
  }));
  const books = loads.map((load, i) => {
    const tall = 0.82 * (clear - board) * Math.sqrt(Math.max(0, load) / most);
    return { points: box(-0.4 * w, i * clear, 0.36 * w, i * clear + tall), tone: "soft" };
  });
  return [...books.filter((_, i) => loads[i] > 0), ...lines];
}

const front = (w, h, from, to, handle) => {
  const door = w / 2 - Math.min(0.04, 0.1 * w);
  return [
    {
      points: [
        [door, from * h],
        [door, to * h],
      ],
      tone: "line",
    },
    { points: box(w / 2, (handle - 0.05) * h, w / 2 + 0.025, (handle + 0.05) * h), tone: "solid" },
  ];
};
const across = (w, h, at) => ({
  points: [
    [-w / 2, at * h],
    [w / 2, at * h],
  ],
  tone: "line",
});

const SHAPES = {
  bookcase: shelves,
  "empty bookcase": (w, h, loads) =>
    shelves(
      w,
      h,
      loads.map(() => 0),
    ),
  wardrobe: (w, h) => [
    ...front(w, h, 0, 1, 0.5),
    {
      points: [
        [-0.3 * w, 0.86 * h],
        [0.3 * w, 0.86 * h],
      ],
      tone: "line",
    },
    {
      points: [
        [0, 0.86 * h],
        [-0.24 * w, 0.78 * h],
        [-0.2 * w, 0.3 * h],
        [0.2 * w, 0.3 * h],
        [0.24 * w, 0.78 * h],
      ],
      tone: "soft",
    },
  ],
  cupboard: (w, h) => [
    ...front(w, h, 0, 0.45, 0.36),
    ...front(w, h, 0.5, 1, 0.6),
    across(w, h, 0.45),
    across(w, h, 0.5),
    ...rows(3, (i) => ({
      points: box(-0.36 * w, (0.5 + 0.16 * i) * h, 0.2 * w, (0.59 + 0.16 * i) * h),
      tone: "soft",
    })),
  ],
  chest: (w, h) =>
    rows(5, (i) => [
      ...(i ? [across(w, h, i / 5)] : []),
      { points: box(w / 2, ((i + 0.45) * h) / 5, w / 2 + 0.02, ((i + 0.6) * h) / 5), tone: "solid" },
    ]).flat(),
  refrigerator: (w, h) => [
    ...front(w, h, 0.38, 1, 0.55),
    ...front(w, h, 0, 0.38, 0.28),
    across(w, h, 0.38),
    { points: box(-0.42 * w, 0.03 * h, -0.2 * w, 0.14 * h), tone: "soft" },
  ],
  television: (w, h) => [
    { points: box(-0.1 * w, 0.14 * h, 0.1 * w, h), tone: "solid" },
    { points: box(-0.04 * w, 0.03 * h, 0.04 * w, 0.14 * h), tone: "soft" },
    { points: box(-w / 2, 0, w / 2, 0.03 * h), tone: "solid" },
  ],
  "vending machine": (w, h) => [
    {
      points: [
        [0.38 * w, 0],
        [0.38 * w, h],
      ],
      tone: "line",
    },
    ...rows(4, (i) =>
      rows(3, (j) => ({
        points: box(
          (-0.4 + 0.25 * j) * w,
          (0.36 + 0.15 * i) * h,
          (-0.22 + 0.25 * j) * w,
          (0.47 + 0.15 * i) * h,
        ),
        tone: "soft",
      })),
    ).flat(),
    { points: box(0.38 * w, 0.12 * h, 0.5 * w, 0.2 * h), tone: "solid" },
  ],
  "server rack": (w, h) =>
    rows(14, (i) => ({
      points: box(-0.42 * w, (0.05 + 0.065 * i) * h, 0.42 * w, (0.095 + 0.065 * i) * h),
      tone: i % 3 ? "soft" : "line",
    })),
  "upright piano": (w, h) => [
    {
      points: [
        [0.1 * w, 0.5 * h],
        [0.1 * w, h],
      ],
      tone: "line",
    },
    { points: box(0.1 * w, 0.5 * h, w / 2, 0.56 * h), tone: "solid" },
    {
      points: [
        [0.1 * w, 0],
        [0.1 * w, 0.5 * h],
      ],
      tone: "line",
    },
    { points: box(0.16 * w, 0, 0.44 * w, 0.05 * h), tone: "soft" },
  ],
};

/** The lines of a kind of piece: {points, tone "line" | "soft" | "solid"}; a plain box for any other kind. */
export function details(kind, width, height, loads) {
  const shape = SHAPES[kind] ?? (loads ? shelves : () => []);
  return shape(width, height, loads ?? [1, 1, 1, 1, 1]);
}

/** Points as an SVG path. */
export const pathOf = (points, place) =>
  points
    .map(
      ([u, v], i) =>
        (i ? "L" : "M") +
        place(u, v)
          .map((n) => n.toFixed(1))
          .join(" "),
    )
    .join("") + (points.length > 2 ? "Z" : "");
