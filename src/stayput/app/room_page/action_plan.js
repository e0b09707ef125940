// The plan to buy and do: what the home is like, the plan worked out with its progress, and where it is opened.

import * as api from "../api.js";
import { patiently, pause } from "../connection.js";
import { toggle } from "../controls.js";
import { fill, part } from "../dom.js";
import { worded } from "../refusals.js";
import { plain } from "../scene.js";
import { number, spoken, t } from "../words.js";
import * as room from "./room.js";

const HOME = ["no_drilling", "tatami", "plasterboard", "dropped_ceiling"],
  LOOK = 500; // how often the server is asked how far it has come [ms]
/** What the room says of the home. */
const SAID = {
  no_drilling: ({ home }) => home?.no_drilling === true,
  tatami: ({ room: { floor } = {} }) => typeof floor === "string" && floor.startsWith("tatami"),
  plasterboard: ({ room: { walls } = {} }) => walls === "plasterboard",
  dropped_ceiling: ({ room: { ceiling } = {} }) => ceiling?.construction === "dropped",
};
/** What is ticked goes into the room, whose runs are of that home. */
const surfaces = (before, changed) => ({ ...before, room: { ...before.room, ...changed } }),
  TICKED = {
    no_drilling: (before, on) => ({ ...before, home: { no_drilling: on } }),
    tatami: (before, on) => surfaces(before, { floor: on ? "tatami, along the weave" : plain.floor }),
    plasterboard: (before, on) => surfaces(before, { walls: on ? "plasterboard" : plain.wallConstruction }),
    dropped_ceiling: (before, on) => {
      const construction = on ? "dropped" : plain.ceilingConstruction;
      return surfaces(before, { ceiling: { height: plain.ceiling, ...before.room?.ceiling, construction } });
    },
  };
const fields = {};
let said = null, // of the home, when that was last told
  job = null, // the verdict's, once that is complete
  flight = null, // what ends the question about a plan
  made = false,
  homeSaid = () => {}; // called when what the home is like has been said

/** Wires the buttons; "changed" is called when what the home is like has been said. */
export function wire(changed) {
  homeSaid = changed;
  part("make-plan").addEventListener("click", work);
  part("stop-plan").addEventListener("click", () => forget());
  part("card").addEventListener("click", ({ target }) => {
    target.hash = location.hash; // the room, to which the plan leads back
  });
}

/** Builds what the home is like; called again for another language. */
export function build() {
  fill(
    part("home"),
    HOME.map((name) => {
      const field = toggle({
        label: t(`allowed_${name}`),
        changed: (on) => {
          room.change(TICKED[name](room.current(), on));
          update();
        },
      });
      fields[name] = field;
      return field.element;
    }),
  );
  update();
  tell();
}

/** Whether a change may be made in this home. */
export const mayBe = ({ drilled }) => !drilled || !isSo("no_drilling");

const isSo = (name) => SAID[name](room.current());

/** Ticks what is so, and tells where that has changed. */
export function update() {
  for (const [name, field] of Object.entries(fields)) field.set(isSo(name));
  const before = said;
  said = JSON.stringify(asked());
  if (before === null || before === said) return;
  forget();
  homeSaid();
}

/** Takes the job of a verdict that is complete, or null. */
export function take(finished) {
  if (finished === job) return;
  job = finished;
  forget();
}

const asked = () => Object.fromEntries(HOME.filter(isSo).map((name) => [name, "true"]));

/** There is no plan of the room and the home as they are now. */
function forget() {
  flight?.abort();
  flight = null;
  made = false;
  say();
  tell();
}

const say = (...content) => {
  fill(part("plan-said"), ...content);
  part("plan-said").classList.toggle("refusal", content.length > 0);
};

async function work() {
  const own = (flight = new AbortController()),
    wanted = () => own === flight,
    of = job;
  say();
  tell();
  follow(of, own, wanted);
  try {
    await patiently(() => api.plan(of, asked(), own.signal), wanted);
    made = wanted();
  } catch (error) {
    if (error.name !== "AbortError" && wanted()) say(...worded(error));
  } finally {
    if (wanted()) {
      flight = null;
      tell();
      if (made) part("card").focus({ preventScroll: true });
    }
  }
}

/** Says how far a plan has come, for as long as it is worked at. */
async function follow(of, { signal }, wanted) {
  while (wanted()) {
    const { runs } = await api.planProgress(of, asked(), signal).catch(() => ({ runs: 0 }));
    if (wanted() && runs) part("plan-state").textContent = t("planRuns", { runs: number(runs) });
    await pause(LOOK);
  }
}

function tell() {
  const busy = flight !== null,
    link = part("card");
  part("make-plan").hidden = busy || made;
  part("make-plan").disabled = !job;
  part("plan-wait").hidden = Boolean(job);
  part("plan-progress").hidden = !busy;
  if (!busy) part("plan-state").textContent = "";
  else part("plan-state").textContent ||= t("planRuns", { runs: number(0) });
  link.hidden = !made;
  if (made) link.href = api.planAddress(job, { lang: spoken(), ...asked() });
}
