// The room in space, shaken: asked for after each change, played beside the plan.

import * as api from "../api.js";
import { patiently, whyLong } from "../connection.js";
import { fill, narrow, part, settled } from "../dom.js";
import { worded } from "../refusals.js";
import { shake, shownSpan, telling } from "../runs.js";
import { strengthOf } from "../panel_shaking.js";
import * as stages from "../stages.js";
import { colourFates, fate } from "../story.js";
import * as transport from "../transport.js";
import { both, length, share, t } from "../words.js";
import { kindName } from "./kinds.js";
import * as room from "./room.js";

const SETTLED = 600, // after the last change [ms]
  SLOW = 400;
const { clock } = transport;
let outcomes = {},
  shown = null, // {result, room, scene}
  asked = null,
  verdict = null, // the newest on the room, or null
  typical = null, // which run of the verdict is shown, {member, sample}, where it is the one that it proposes
  own = false, // whether the reader has chosen the earthquake
  flight = null,
  problem = null,
  late = null, // where the answer is long in coming, why, as the key of a sentence
  resume = false;

/** Wires the picture and its buttons. */
export function wire() {
  transport.wire(draw);
  stages.wire(() => clock.redraw());
  addEventListener("shown", fromTheStart);
}

/** On a phone the picture begins anew when its screen is entered. */
function fromTheStart() {
  if (!narrow() || document.body.dataset.screen !== "see" || !clock.playing) return;
  clock.seek(clock.start);
  clock.play(true);
}

/** Writes the words again, for another language or theme. */
export function again(presets) {
  outcomes = Object.fromEntries(presets.outcomes.map((one) => [one.id, both(one.label)]));
  transport.again();
  stages.build();
  if (shown) display();
  tell();
}

function draw(now) {
  if (!shown) return;
  stages.draw(0, now);
  colourFates(part("fates"), shown.result.runs[0].scene, now);
}

const soon = settled(SETTLED, () => work());

const memberOf = (one) => one.shaking?.member ?? 1;
const shaken = (one) => `${memberOf(one)} ${room.computed(one)}`;

/** Shakes the room as it now is: the first one at once, others once they have settled. */
export function changed() {
  const first = asked === null,
    before = asked;
  if (!first && shaken(room.current()) === shaken(before)) return;
  asked = room.current();
  if (!first) {
    const another = memberOf(asked) !== memberOf(before);
    if (another) own = room.computed(asked) === room.computed(before);
    typical = another ? null : typical;
  }
  flight?.abort();
  problem = null;
  late = null;
  tell();
  if (!asked.furniture.length) soon.cancel();
  else if (first) work();
  else soon();
}

async function work() {
  const mine = asked,
    own = (flight = new AbortController()),
    wanted = () => own === flight && mine === asked;
  const slow = setTimeout(async () => {
    const why = await whyLong();
    if (!wanted() || shown?.room === mine || problem) return;
    late = why;
    tell();
  }, SLOW);
  part("see").setAttribute("aria-busy", "true");
  try {
    const content = played();
    const answer = await patiently(() => api.simulate(content, own.signal), wanted);
    if (!answer || !wanted()) return;
    shown = { result: shake(answer), room: mine, happens: answer.in_room ?? null };
    display();
    document.documentElement.dataset.drawn = String(performance.now());
  } catch (error) {
    if (error.name !== "AbortError" && wanted()) problem = error;
  } finally {
    clearTimeout(slow);
    if (own === flight) {
      part("see").removeAttribute("aria-busy");
      late = null;
      tell();
    }
  }
}

/** Says that the picture is of the room before, that it is being computed, or why there is none. */
function tell() {
  const old = shown?.room !== asked;
  const empty = asked?.furniture.length === 0;
  part("wait").hidden = !empty && (!late || !old);
  part("wait").textContent = t(empty ? "state_empty" : shown ? "outdated" : (late ?? "computing"));
  part("problem").hidden = !problem;
  fill(part("problem"), problem ? worded(problem) : []);
  if (old === (part("see").dataset.old === "true")) return;
  part("see").dataset.old = String(old);
  if (old) resume = clock.playing;
  if (clock.end && (old || resume)) clock.play(!old);
}

/** What is shown: the run of the verdict that it proposes, or the room as it says itself. */
export function played() {
  const scene = room.current();
  if (!typical) return { scene, measures: [] };
  return { scene: { ...scene, shaking: { ...scene.shaking, member: typical.member } }, measures: [], sample: typical.sample };
}

/** Takes the newest verdict, or null; unless the reader has chosen an earthquake, its typical run is shown. */
export function judged(result) {
  verdict = result;
  compare();
  const proposed = result?.complete ? result.typical : null,
    scene = room.current();
  if (!proposed || own || !scene.shaking?.suite || shown?.room !== asked) return;
  if (typical?.sample === proposed.sample && typical.member === proposed.member) return;
  typical = proposed;
  flight?.abort();
  work();
}

/** Says what happens in what is shown, beside how often that is so. */
function compare() {
  const happens = shown?.room === asked ? shown?.happens : null,
    line = part("this-one");
  line.hidden = !happens || verdict?.hit.estimate == null;
  if (line.hidden) return;
  const { hit, shut_in: shut } = verdict,
    pieces = [...new Set(happens.hits.map(({ piece }) => kindName("furniture", piece)))].join(t("listed"));
  const told = [
    pieces
      ? t("inThisHit", { pieces, share: share(hit) })
      : t("inThisNone", { share: share({ estimate: 1 - hit.estimate, low: 1 - hit.high, high: 1 - hit.low }) }),
    happens.shut_in.length ? t("inThisShut", { share: share(shut) }) : "",
  ];
  line.textContent = told.filter(Boolean).join(t("space"));
}

function display() {
  const { result } = shown,
    [run] = result.runs,
    { end } = shownSpan(result);
  stages.show([run.scene]);
  part("summary").textContent = strengthOf(result.motion);
  part("space").setAttribute("aria-label", both(run.sentence));
  fill(
    part("fates"),
    run.pieces.map((one) => {
      const standing = t("slidBy", { slide: length(one.peak_slide_m ?? 0) });
      return fate(one, { name: kindName("furniture", one.name), outcomes, standing });
    }),
  );
  compare();
  clock.span(0, end, telling(run));
  clock.redraw();
}
