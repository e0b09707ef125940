// What a thing is called and where it is, in words: "Bookcase, at the left wall, 1.90 m from the near wall".

import { carrier, isOpening, lying, nextWall, opening, standing, tidyAngle, upright, wallBehind } from "./geometry.js";
import { DEFAULTS, nameOf } from "./kinds.js";
import { number, t } from "../words.js";

const metres = (value) => t("metresLong", { value: number(value, 2) });

/** What a thing is and where. */
export const described = (room, what) => [nameOf(room, what), ...where(room, what)].join(t("comma"));

/** Where a thing is: parts of a sentence. */
export function where(room, what) {
  if (isOpening(what)) return openingWhere(room, what);
  if (what.table === "places") {
    const { at, heading } = lying(room, what.index),
      kind = room.places[what.index].kind ?? DEFAULTS.places.kind;
    const lies = ["bed", "futon", "cot"].includes(kind);
    return [...free(at), direction(lies ? heading - Math.PI / 2 : heading, lies ? "headTo" : "facesTo")];
  }
  const piece = room.furniture[what.index],
    below = carrier(room, what.index),
    { at, heading } = standing(room, what.index);
  if (below !== null) return [t("standsOn", { name: nameOf(room, { table: "furniture", index: below }) })];
  if (piece.against) return [t("atWall", { wall: t(piece.against) }), along(piece.against, piece.along)];
  return [...free(at), direction(heading, "facesTo")];
}

const free = ([x, y]) => [
  t("fromWall", { distance: metres(x), wall: t("left_wall") }),
  t("fromWall", { distance: metres(y), wall: t("near_side_wall") }),
];

const along = (wall, distance) =>
  t("fromWall", { distance: metres(distance), wall: t(upright(wall) ? "near_side_wall" : "left_wall") });

function direction(heading, key) {
  const behind = wallBehind(heading);
  if (behind) return t(key, { wall: t(nextWall(behind, 2)) });
  return t("turnedBy", { angle: number((tidyAngle(heading) * 180) / Math.PI) });
}

function openingWhere(room, what) {
  const { wall, start, width, opens } = opening(room, what);
  const place = [
    t("inTheWall", { wall: t(wall) }),
    t("fromTo", { start: metres(start), end: metres(start + width) }),
  ];
  return opens ? [...place, t(`opens_${opens}`)] : place;
}
