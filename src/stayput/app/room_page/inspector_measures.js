// What holds a piece of the room: measures that fit it, with their numbers.

import { el } from "../dom.js";
import { measureList, measureRow, replaces } from "../measure_fields.js";
import { t } from "../words.js";
import { given } from "./edits.js";
import { thing } from "./geometry.js";
import { measureKinds, pieceSizes } from "./kinds.js";
import { change, current } from "./room.js";

/** The row of the inspector with a piece's measures. */
export function measuresOf(what) {
  const rows = measureKinds().map((kind) =>
    measureRow(kind, {
      values: () => measuresIn(current(), what).find((one) => one.type === kind.type),
      set: (on) => set(what, kind, on),
      give: (name, value) => give(what, kind, name, value),
    }),
  );
  const element = el("div", { class: "holding" }, el("h4", { text: t("whatHolds") }), ...measureList(rows));
  return {
    element,
    update: (room) => {
      element.hidden = !pieceSizes(room.furniture[what.index]).box;
      for (const { kind, update } of rows) {
        const lacks = lacking(room, what, kind);
        update(measuresIn(room, what).some((one) => one.type === kind.type), lacks && t(lacks));
      }
    },
  };
}

const measuresIn = (room, what) => room.furniture[what.index].measures ?? [];

/** Why a measure cannot hold a piece where it stands, as a key of the words; or null. */
function lacking(room, what, kind) {
  const { height, up } = thing(room, what);
  if (kind.needs.includes("wall") && !room.furniture[what.index].against) return "needs_wall";
  if (kind.needs.includes("ceiling") && !(room.room?.ceiling?.height > up + height)) return "needs_ceiling";
  return null;
}

/** Puts a measure in place or takes it away; what was in the same place goes. */
function set(what, kind, on) {
  const kindOf = (type) => measureKinds().find((one) => one.type === type);
  const others = measuresIn(current(), what).filter(
    ({ type }) => type !== kind.type && !(on && replaces(kind, kindOf(type))),
  );
  const measures = on ? [...others, { type: kind.type }] : others;
  change(given(current(), what, { measures: measures.length ? measures : undefined }));
}

function give(what, kind, name, value) {
  const measures = measuresIn(current(), what).map((one) =>
    one.type === kind.type ? { ...one, [name]: value } : one,
  );
  change(given(current(), what, { measures }), { mergeKey: `${kind.type} ${name} ${what.index}` });
}
