// What holds a piece of the room: measures that fit it, with their numbers.

import { toggle } from "../controls.js";
import { el, fill } from "../dom.js";
import { measureField } from "../measure_fields.js";
import { both, t } from "../words.js";
import { given } from "./edits.js";
import { thing } from "./geometry.js";
import { measureKinds, pieceSizes } from "./kinds.js";
import { change, current } from "./room.js";

/** The row of the inspector with a piece's measures. */
export function measuresOf(what) {
  const kinds = measureKinds(),
    lines = kinds.map((kind) => line(what, kind)),
    of = (usual) => lines.filter((one) => one.kind.usual === usual).map((one) => one.element);
  const element = el(
    "div",
    { class: "holding" },
    el("h4", { text: t("whatHolds") }),
    ...of(true),
    el("details", {}, el("summary", { text: t("moreMeasures") }), ...of(false)),
  );
  return {
    element,
    update: (room) => {
      element.hidden = !pieceSizes(room.furniture[what.index]).box;
      for (const one of lines) one.update(room);
    },
  };
}

const measuresIn = (room, what) => room.furniture[what.index].measures ?? [];

function line(what, kind) {
  const box = toggle({ label: both(kind.label), changed: (on) => set(what, kind, on) }),
    settings = el("details", { class: "settings" }, el("summary", { text: t("adjust") }));
  settings.addEventListener("toggle", () => {
    if (settings.open) fill(settings, settings.firstChild, ...fields(what, kind));
  });
  return {
    kind,
    element: el("div", { class: "measure" }, box.element, settings),
    update: (room) => {
      const on = measuresIn(room, what).some((one) => one.type === kind.type),
        lacks = lacking(room, what, kind);
      box.set(on);
      box.input.disabled = Boolean(lacks) && !on;
      box.note(lacks ? t(lacks) : null);
      settings.hidden = !on || kind.parameters.length === 0;
    },
  };
}

/** Why a measure cannot hold a piece where it stands, as a key of the words; or null. */
function lacking(room, what, kind) {
  const { height, up } = thing(room, what);
  if (kind.needs.includes("wall") && !room.furniture[what.index].against) return "needs_wall";
  if (kind.needs.includes("ceiling") && !(room.room?.ceiling?.height > up + height)) return "needs_ceiling";
  return null;
}

/** Puts a measure in place or takes it away; what was in the same place goes. */
function set(what, kind, on) {
  const others = measuresIn(current(), what).filter(({ type }) => {
    const place = measureKinds().find((one) => one.type === type)?.place;
    return type !== kind.type && !(on && place && place === kind.place);
  });
  const measures = on ? [...others, { type: kind.type }] : others;
  change(given(current(), what, { measures: measures.length ? measures : undefined }));
}

function fields(what, kind) {
  const now = measuresIn(current(), what).find((one) => one.type === kind.type);
  return kind.parameters
    .map((about) => measureField(about, now?.[about.name], (value) => give(what, kind, about.name, value)))
    .filter(Boolean);
}

function give(what, kind, name, value) {
  const measures = measuresIn(current(), what).map((one) =>
    one.type === kind.type ? { ...one, [name]: value } : one,
  );
  change(given(current(), what, { measures }), { mergeKey: `${kind.type} ${name} ${what.index}` });
}
