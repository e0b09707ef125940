// Mouse and finger on the plan: things and handles are dragged; the room changes when they are let go.

import { described } from "./described.js";
import { onWall, thing, upright } from "./geometry.js";
import { handles } from "./handles.js";
import { ofKey } from "./plan.js";
import { change, current, select, selected } from "./room.js";
import { dragged } from "./snap.js";
import { focusOn, hold, plan, pointOf, release, say, show, showCurrent, shownRoom } from "./view.js";

const STARTS = 4; // how far the pointer goes until it drags [px]

let drag = null;

/** Wires the plan. */
export function wire() {
  const element = plan();
  element.addEventListener("pointerdown", begin);
  // a finger on a thing drags it, beside it scrolls the page; within an <svg> no style can say so
  element.addEventListener("touchstart", (event) => taken(event.target) && event.preventDefault(), {
    passive: false,
  });
  element.addEventListener("pointermove", go);
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", giveUp);
  addEventListener(
    "keydown",
    (event) => {
      if (event.key === "Escape" && drag) {
        event.stopImmediatePropagation();
        giveUp();
      }
    },
    true,
  );
}

const taken = (target) => target.closest("[data-thing], [data-handle], [data-felt]")?.dataset;

function begin(event) {
  if (event.button !== 0 || drag) return;
  const { handle, felt, thing: key = felt } = taken(event.target) ?? {};
  if (!handle && !key) {
    select(null);
    return;
  }
  hold();
  const from = pointOf(event);
  drag = { id: event.pointerId, x: event.clientX, y: event.clientY, room: current(), moved: false };
  if (handle) {
    event.preventDefault(); // what has the focus keeps it
    drag.pull = handles().find((one) => one.name === handle).pull;
    drag.what = selected();
  } else {
    drag.what = ofKey(key);
    drag.offset = away(drag.what, from);
  }
  plan().setPointerCapture(event.pointerId);
}

/** Selects what the pointer took; later than it was pressed, as what is drawn anew gets no more events of a finger. */
function choose({ what, pull }) {
  if (pull) return;
  select(what);
  focusOn(what);
}

/** From the pointer to the middle of what it takes. */
function away(what, [x, y]) {
  const one = thing(current(), what);
  const [mx, my] = one.wall ? onWall(current().plan, one.wall, one.start + one.width / 2) : one.at;
  return one.wall ? along(one, [mx - x, my - y]) : [mx - x, my - y];
}

/** An opening goes with the pointer across the room, so only its distance along the wall is kept. */
const along = ({ wall }, [dx, dy]) => (upright(wall) ? [0, dy] : [dx, 0]);

function go(event) {
  if (!drag || event.pointerId !== drag.id) return;
  if (!drag.moved && Math.hypot(event.clientX - drag.x, event.clientY - drag.y) < STARTS) return;
  if (!drag.moved) choose(drag);
  drag.moved = true;
  const [x, y] = pointOf(event);
  const { room, guides, origin } = drag.pull
    ? drag.pull(drag.room, [x, y], event.altKey)
    : dragged(shownRoom(), drag.what, [x + drag.offset[0], y + drag.offset[1]], event.altKey);
  show(room, guides, origin);
}

function end(event) {
  if (!drag || event.pointerId !== drag.id) return;
  const { moved, what, room: before } = drag,
    after = shownRoom();
  if (!moved) choose(drag);
  giveUp();
  if (!moved || after === before) return;
  change(after);
  if (what) say(described(after, what));
}

function giveUp() {
  drag = null;
  release();
  showCurrent();
}
