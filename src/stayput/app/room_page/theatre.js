// The room in space, shaken: asked for after each change, played beside the plan.

import * as api from "../api.js";
import { patiently } from "../connection.js";
import { el, fill, part, settled } from "../dom.js";
import { worded } from "../refusals.js";
import { shake, shownSpan, telling } from "../runs.js";
import { strengthOf } from "../panel_shaking.js";
import * as stages from "../stages.js";
import * as transport from "../transport.js";
import { both, length, number, t } from "../words.js";
import { kindName } from "./kinds.js";
import * as room from "./room.js";
import * as sound from "./sound.js";

const SETTLED = 600, // after the last change [ms]
  SLOW = 400;
const { clock } = transport;
let outcomes = {},
  shown = null, // {result, room}
  asked = null,
  flight = null,
  problem = null,
  late = false, // whether the answer is long in coming
  resume = false;

/** Wires the picture and its buttons. */
export function wire() {
  transport.wire(draw);
  stages.wire(() => clock.redraw());
}

/** Writes the words again, for another language or theme. */
export function again(presets) {
  outcomes = Object.fromEntries(presets.outcomes.map((one) => [one.id, both(one.label)]));
  transport.again();
  stages.build();
  sound.build();
  if (shown) display();
  tell();
}

function draw(now) {
  if (!shown) return;
  stages.draw(0, now);
  sound.follow(now, clock.playing);
}

const soon = settled(SETTLED, () => work());

/** Shakes the room as it now is: the first one at once, others once they have settled. */
export function changed() {
  if (room.current() === asked) return;
  const first = asked === null;
  asked = room.current();
  flight?.abort();
  problem = null;
  late = false;
  tell();
  if (first) work();
  else soon();
}

async function work() {
  const mine = room.current(),
    own = (flight = new AbortController()),
    wanted = () => own === flight && mine === asked;
  const slow = setTimeout(() => {
    late = wanted();
    tell();
  }, SLOW);
  part("see").setAttribute("aria-busy", "true");
  try {
    const content = { scene: mine, measures: [] };
    const answer = await patiently(() => api.simulate(content, own.signal), wanted);
    if (!answer || !wanted()) return;
    shown = { result: shake(answer), room: mine };
    display();
    document.documentElement.dataset.drawn = String(performance.now());
  } catch (error) {
    if (error.name !== "AbortError" && wanted()) problem = error;
  } finally {
    clearTimeout(slow);
    if (own === flight) {
      part("see").removeAttribute("aria-busy");
      late = false;
      tell();
    }
  }
}

/** Says that the picture is of the room before, that it is being computed, or why there is none. */
function tell() {
  const old = shown?.room !== asked;
  part("wait").hidden = !late || !old;
  part("wait").textContent = t(shown ? "outdatedRoom" : "warming");
  part("problem").hidden = !problem;
  fill(part("problem"), problem ? worded(problem) : []);
  if (old === (part("see").dataset.old === "true")) return;
  part("see").dataset.old = String(old);
  if (old) resume = clock.playing;
  if (clock.end && (old || resume)) clock.play(!old);
}

function display() {
  const { result } = shown,
    [run] = result.runs,
    { start, end } = shownSpan(result);
  stages.show([run.scene]);
  sound.take(run, result.floor);
  part("summary").textContent = strengthOf(result.motion);
  part("space").setAttribute("aria-label", both(run.sentence));
  fill(
    part("fates"),
    run.pieces.map((one, i) => fate(one, run.scene.bodies[i].colour)),
  );
  clock.span(start, end, telling(run));
  clock.redraw();
}

function fate({ name, outcome, fall_time_s: fell, overturn_time_s: lay, peak_slide_m: slide }, colour) {
  const chip = el("span", { class: "chip" }),
    time = fell ?? lay;
  chip.style.background = colour;
  const told = [outcomes[outcome], time === null ? t("slidBy", { slide: length(slide ?? 0) }) : `${number(time, 1)}\u00a0s`];
  return el("li", {}, chip, el("span", { text: `${kindName("furniture", name)}${t("colon")}${told.join(t("listed"))}` }));
}
