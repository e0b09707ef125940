// What a verdict says, on the plan: where each piece falls and comes to stand, who is hit, which door stays shut.

import { svg } from "../dom.js";
import { brief, t } from "../words.js";
import { DEFAULTS } from "./kinds.js";

/** What can be shown of a verdict. */
export const LAYERS = ["fell", "stood", "hit", "blocked"];

const STEPS = 10, // of the share of the runs
  TOLD = 0.005; // a share below is told of nobody

/** A verdict with pieces, places and doors in the order of the room's own; null for those that it does not know. */
export function inOrderOf(room, result) {
  if (!result) return null;
  const sorted = (table, judged) =>
    (room[table] ?? []).map((one) => {
      const name = one.name ?? one.kind ?? DEFAULTS[table].name ?? DEFAULTS[table].kind;
      return judged.find((other) => other.name === name) ?? null;
    });
  return {
    ...result,
    pieces: sorted("furniture", result.pieces),
    places: sorted("places", result.places),
    doors: sorted("doors", result.doors),
  };
}

/** The cells of the floor on which pieces come to lie, or to stand, darker where they do so more often. */
export function zones(sheet, result, shown) {
  if (!result) return [];
  return result.pieces.flatMap((piece) =>
    ["stood", "fell"]
      .filter((layer) => shown.includes(layer) && piece?.[layer])
      .flatMap((layer) => cells(sheet, piece[layer], result.cell_m, layer)),
  );
}

function cells(sheet, { nx, ny, shares }, cell, layer) {
  const bytes = Uint8Array.from(atob(shares), (letter) => letter.charCodeAt(0)),
    paths = Array.from({ length: STEPS + 1 }, () => "");
  const stepAt = (ix, iy) => (ix < nx ? Math.ceil((STEPS * bytes[ix * ny + iy]) / 255 - 1e-9) : 0);
  for (let iy = 0; iy < ny; iy++)
    for (let ix = 0, from = 0; ix < nx; ix++) {
      const step = stepAt(ix, iy);
      if (step === stepAt(ix + 1, iy)) continue;
      if (step) paths[step] += strip(sheet, [from * cell, iy * cell], [(ix + 1) * cell, (iy + 1) * cell]);
      from = ix + 1;
    }
  return paths.map((d, step) =>
    d ? svg("path", { class: `cover ${layer} step${step}`, d }) : null,
  );
}

function strip(sheet, [x0, y0], [x1, y1]) {
  const [left, low] = sheet.place([x0, y0]),
    [right, high] = sheet.place([Math.min(x1, sheet.plan.width), Math.min(y1, sheet.plan.length)]);
  return `M${left.toFixed(1)} ${low.toFixed(1)}H${right.toFixed(1)}V${high.toFixed(1)}H${left.toFixed(1)}Z`;
}

/** How often the person at a place is hit, or a door is blocked, where that is shown; else null. */
export function shareOf(result, shown, { table, index }) {
  if (table === "places" && shown.includes("hit")) return result?.places[index]?.hit ?? null;
  if (table === "doors" && shown.includes("blocked")) return result?.doors[index]?.blocked ?? null;
  return null;
}

/** What is told of a thing beside its name: of a person always, of pieces and doors where it happens. */
export function notes(result, shown, what) {
  const chance = shareOf(result, shown, what);
  if (what.table === "places") return chance?.estimate == null ? [] : [note("is_hit", chance)];
  if (telling(chance)) {
    const already = result.doors[what.index].blocked_at_rest;
    return [already ? { text: t("already"), share: t("already") } : note("is_blocked", chance)];
  }
  const piece = what.table === "furniture" && shown.includes("fell") ? result?.pieces[what.index] : null,
    falls = piece?.probabilities.overturned ?? null;
  return telling(falls) ? [note("overturns", falls)] : [];
}

function note(key, chance) {
  const text = brief(chance);
  return { text: t(key, { share: text }), share: text };
}

/** Whether a share is more than next to nothing. */
export const telling = (chance) => chance !== null && chance.estimate >= TOLD;
