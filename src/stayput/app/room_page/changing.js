// A change that the server proposes, made in the room.

import { FACING } from "./geometry.js";
import { DEFAULTS } from "./kinds.js";
import * as room from "./room.js";

const apart = (one, other) => Math.abs(Math.atan2(Math.sin(one - other), Math.cos(one - other)));

/** Makes a change of a verdict in the room: one entry for undo. */
export function apply({ table, what, measures, at_m: at, heading_rad: heading }) {
  const before = room.current();
  const index = before[table].findIndex((one) => (one.name ?? one.kind ?? DEFAULTS.places.kind) === what);
  if (index < 0) return;
  const changed = { ...before[table][index] };
  if (measures) changed.measures = [...(changed.measures ?? []), ...[measures].flat()];
  else if (table === "places") Object.assign(changed, { at, heading });
  else toWall(changed, at, heading);
  room.change({ ...before, [table]: before[table].with(index, changed) });
  room.select({ table, index });
}

/** Puts a piece with its back to the wall that it faces away from; the gap is the usual one. */
function toWall(piece, [x, y], heading) {
  const [wall] = Object.entries(FACING).find(([, facing]) => apart(facing, heading) < 1e-3);
  for (const key of ["at", "heading", "gap"]) delete piece[key];
  Object.assign(piece, { against: wall, along: wall.endsWith("side_wall") ? x : y });
}
