// What can be put into the room: dragged into the plan, or with a press to a free spot.

import { el, fill, svg } from "../dom.js";
import { t } from "../words.js";
import { described } from "./described.js";
import { newThing, withNew } from "./edits.js";
import { added } from "./free_spot.js";
import { thing } from "./geometry.js";
import { furnitureKinds, kindName, labelOf, placeKinds } from "./kinds.js";
import { change, current, select } from "./room.js";
import { shapes } from "./plan.js";
import { dragged } from "./snap.js";
import { focusOn, plan, pointOf, say, show, showCurrent, shownRoom } from "./view.js";

const STARTS = 8, // how far the pointer goes until it drags [px]
  PICTURE = 40; // [px]

/** Lets the ends of the palette fade where there is more of it beyond them. */
export function wire(element) {
  const update = () => {
    const { scrollLeft: x, scrollTop: y, scrollWidth, scrollHeight, clientWidth, clientHeight } = element;
    const more = {
      before: x + y > 1,
      after: scrollWidth - clientWidth - x > 1 || scrollHeight - clientHeight - y > 1,
    };
    element.dataset.more = Object.keys(more)
      .filter((end) => more[end])
      .join(" ");
  };
  element.addEventListener("scroll", update, { passive: true });
  new ResizeObserver(update).observe(element);
}

/** Builds the palette; called again for another language. */
export function build(element) {
  const group = (title, ...buttons) =>
    el("div", { class: "kinds", role: "group", "aria-label": title }, el("h3", { text: title }), ...buttons);
  fill(
    element,
    group(t("paletteFurniture"), ...furnitureKinds().map((one) => button("furniture", one.id, labelOf(one)))),
    group(t("palettePlaces"), ...placeKinds().map((one) => button("places", one.id, labelOf(one)))),
    group(
      t("paletteOpenings"),
      ...["doors", "windows"].map((table) => button(table, "door", kindName(table, "door"))),
    ),
  );
}

function button(table, id, label) {
  const element = el(
    "button",
    { type: "button", class: "kind", "data-kind": id, "data-table": table },
    picture(table, id),
    el("span", { text: label }),
  );
  let drag = null,
    done = false;
  const stop = () => {
    drag = null;
    showCurrent();
  };
  element.addEventListener("pointerdown", (event) => {
    done = false;
    if (event.button !== 0) return;
    drag = { id: event.pointerId, x: event.clientX, y: event.clientY, moved: false };
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointermove", (event) => {
    if (drag?.id !== event.pointerId) return;
    if (!drag.moved && Math.hypot(event.clientX - drag.x, event.clientY - drag.y) < STARTS) return;
    drag.moved = done = true;
    over(event) ? tryAt(drag, table, id, event) : showCurrent();
  });
  element.addEventListener("pointerup", (event) => {
    if (drag?.id !== event.pointerId) return;
    const { moved, what } = drag,
      room = shownRoom();
    stop();
    if (moved && over(event) && what && room !== current()) put(room, what);
  });
  element.addEventListener("pointercancel", stop);
  element.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && drag) stop();
  });
  element.addEventListener("click", () => {
    if (!done) put(...added(current(), table, id));
    done = false;
  });
  return element;
}

function over(event) {
  const box = plan().getBoundingClientRect();
  return (
    event.clientX > box.left &&
    event.clientX < box.right &&
    event.clientY > box.top &&
    event.clientY < box.bottom
  );
}

/** Shows the room with the new thing under the pointer. */
function tryAt(drag, table, id, event) {
  if (shownRoom() === current())
    [drag.room, drag.what] = withNew(current(), table, newThing(current(), table, id));
  else drag.room = shownRoom();
  const { room, guides } = dragged(drag.room, drag.what, pointOf(event), event.altKey);
  show(room, guides);
}

function put(room, what) {
  change(room);
  select(what);
  focusOn(what);
  say(t("added", { what: described(room, what) }));
}

/** A small plan of a kind, to its own scale. */
function picture(table, id) {
  const wall = "far_side_wall",
    room = { plan: { width: 2, length: 2 }, furniture: [], places: [], doors: [], windows: [] };
  const made = { ...newThing(room, table, id), wall, start: 0.2, at: [1, 1] },
    [one] = withNew(room, table, made);
  const what = { table, index: 0 },
    at = thing(one, what);
  const size = Math.max(at.length ?? 0, at.width, 1);
  const scale = (PICTURE - 8) / size,
    opens = at.wall !== undefined;
  const middle = opens ? [0.2 + at.width / 2, 2 - (table === "doors" ? at.width / 2 : 0)] : [1, 1];
  const place = ([x, y]) => [PICTURE / 2 + scale * (x - middle[0]), PICTURE / 2 - scale * (y - middle[1])];
  const sheet = { scale, place, atWall: (_, along, into = 0) => place([along, 2 - into]) };
  const box = { viewBox: `0 0 ${PICTURE} ${PICTURE}`, width: PICTURE, height: PICTURE };
  return svg("svg", { class: "plan-room", "aria-hidden": "true", ...box }, ...shapes(sheet, one, what));
}
