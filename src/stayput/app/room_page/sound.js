// The sound of the shaking, made here: a rumble as strong as the floor's acceleration, and a knock where something hits.
// It is off until it is asked for.

import { toggle } from "../controls.js";
import { fill, part } from "../dom.js";
import { t } from "../words.js";

const KNOCKS = ["floor impact", "wall impact", "ceiling impact", "overturned"],
  LOUDEST = 10, // the floor's acceleration at which the rumble is loudest [m/s²]
  FADE = 0.05; // how fast the rumble follows [s]
let on = false,
  machine = null,
  knocks = [],
  accelerations = [],
  last = 0;

/** Builds the switch; called again for another language. */
export function build() {
  const made = toggle({ label: t("sound"), hint: t("soundHint"), changed: turn });
  made.set(on);
  fill(part("sound"), made.element);
}

function turn(wanted) {
  on = wanted;
  machine ??= on ? started() : null;
  if (on) machine?.context.resume();
  else machine?.context.suspend();
}

/** A second of noise that goes round through a low-pass filter. */
function started() {
  const context = new AudioContext(),
    noise = context.createBuffer(1, context.sampleRate, context.sampleRate);
  noise.getChannelData(0).forEach((_, i, values) => (values[i] = 2 * Math.random() - 1));
  const source = new AudioBufferSourceNode(context, { buffer: noise, loop: true }),
    low = new BiquadFilterNode(context, { type: "lowpass", frequency: 90 }),
    loudness = new GainNode(context, { gain: 0 });
  source.connect(low).connect(loudness).connect(context.destination);
  source.start();
  return { context, noise, loudness };
}

/** Takes a run in space and how its floor moves. */
export function take(run, floor) {
  knocks = run.events.filter(({ kind }) => KNOCKS.includes(kind)).map(({ time_s: time }) => time);
  accelerations = floor.accelerations;
}

/** Sounds as the run does at a time that is shown; silent where it stands still. */
export function follow(now, playing) {
  const from = last;
  last = now;
  if (!on || !machine) return;
  const { context, loudness } = machine,
    strong = playing ? Math.min(1, accelerationAt(now) / LOUDEST) : 0;
  loudness.gain.setTargetAtTime(0.9 * strong, context.currentTime, FADE);
  if (playing && knocks.some((time) => time > from && time <= now)) knock();
}

const accelerationAt = (now) =>
  Math.hypot(
    ...accelerations.map(({ times, values }) => {
      const step = times[1] - times[0] || 1;
      return values[Math.min(values.length - 1, Math.max(0, Math.round((now - times[0]) / step)))];
    }),
  );

/** A short, dull blow. */
function knock() {
  const { context, noise } = machine,
    start = context.currentTime;
  const source = new AudioBufferSourceNode(context, { buffer: noise }),
    low = new BiquadFilterNode(context, { type: "lowpass", frequency: 240 }),
    loudness = new GainNode(context, { gain: 0.9 });
  loudness.gain.exponentialRampToValueAtTime(0.001, start + 0.25);
  source.connect(low).connect(loudness).connect(context.destination);
  source.start(start, Math.random() * 0.5, 0.25);
}
