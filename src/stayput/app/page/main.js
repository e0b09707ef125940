// The page: the scene is set, sent, seen, understood, kept. This file says what follows from what.

import * as api from "./api.js";
import { patiently, untilBack, whyLong } from "./connection.js";
import * as everyday from "./everyday.js";
import { beforeNextFrame } from "./canvas/clock.js";
import { readInks } from "./canvas/pen.js";
import { fill, part, settled } from "./dom.js";
import * as keep from "./keep.js";
import { fromHash, toHash } from "./link.js";
import * as measures from "./panel_measures.js";
import * as building from "./panel_building.js";
import * as notices from "./notices.js";
import * as piece from "./panel_piece.js";
import * as pieces from "./pieces.js";
import * as room from "./panel_room.js";
import * as shaking from "./panel_shaking.js";
import { lacksRecord, worded } from "./refusals.js";
import { shake } from "./runs.js";
import { change, current, forServer, fromServer, watch } from "./scene.js";
import * as screens from "./screens.js";
import * as see from "./see.js";
import { tell } from "./story.js";
import * as understand from "./understand.js";
import * as upload from "./upload.js";
import { t } from "./words.js";

const PANELS = [piece, room, building, shaking, measures, everyday];
const SLOW = 400,
  PAUSE = 1500,
  BUSY = [429, 503];
let presets = null,
  shown = null,
  waiting = null,
  resume = false,
  problem = null,
  flying = false,
  stale = false,
  taking = false,
  follows = false, // a step in the browser's history
  edited = { keys: "", at: -Infinity };

/** What the server is asked: the scene, and the measures that can be put there. */
const request = () =>
  pieces.asked() ?? { scene: forServer(current()), measures: measures.inPlace(current()) };

/** Simulates the scene now; while one answer is awaited only the newest scene waits for the next. */
async function simulate() {
  if (flying) {
    stale = true;
    return;
  }
  flying = true;
  stale = false;
  part("see").setAttribute("aria-busy", "true");
  const slow = setTimeout(tellSlow, SLOW);
  const scene = current(),
    file = pieces.shownName();
  try {
    shown = { result: shake(pieces.answer() ?? (await api.simulate(request()))), scene, file };
    tellProblem(null);
    display();
  } catch (error) {
    tellProblem(error);
    if (error.status === 0) untilBack().then(recover);
    if (BUSY.includes(error.status)) setTimeout(() => problem === error && simulate(), PAUSE);
    if (scene.record && lacksRecord(error)) await upload.takeAgain(scene);
  }
  flying = false;
  clearTimeout(slow);
  tellWait(null);
  part("see").removeAttribute("aria-busy");
  document.documentElement.dataset.drawn = String(performance.now());
  if (stale) simulate();
}

/** The server is back: what it could not answer is asked again, unless that has been done. */
function recover() {
  if (problem?.status !== 0) return;
  simulate();
  understand.outdated();
}

/** Says that the picture is of the scene before, or that the first one is awaited; null: neither. */
function tellWait(what) {
  waiting = what;
  part("wait").hidden = !what;
  part("wait").textContent = what ? t(what) : "";
  tellOld();
}

/** Says why the picture is long in coming. */
async function tellSlow() {
  tellWait(shown ? "outdated" : "computing");
  if (shown) return;
  const why = await whyLong();
  if (waiting === "computing") tellWait(why);
}

/** Says why there is no picture of the scene, or that there is one. */
function tellProblem(error) {
  problem = error;
  part("problem").hidden = !error;
  fill(part("problem"), error ? worded(error) : []);
  tellOld();
}

/** Marks the picture where it is not of the scene as it stands. */
function tellOld() {
  const old = Boolean(problem) || waiting === "outdated";
  if (old === (part("see").dataset.old === "true")) return;
  part("see").dataset.old = String(old);
  if (old) resume = see.clock.playing;
  if (old || resume) see.clock.play(!old);
}

function display() {
  const { result, scene, file } = shown;
  see.show(result);
  pieces.list(file ? result.runs[0] : null, presets.outcomes, ownPiece);
  const first = t(file ? "piecesShaken" : "without");
  part("title-without").textContent = first;
  tell(result, [first, t("with")], presets.events, (time) => {
    see.clock.seek(time);
    if (part("see").clientWidth === 0) screens.goTo("see");
    see.lookAt();
  });
  part("summary").textContent = file ? shaking.strengthOf(result.motion) : shaking.summary(scene, result.motion);
}

/** Shows the pieces of a file that was read, in the place of the page's own scene. */
function shakePieces() {
  edited.place = true;
  shakeAnew();
  if (part("see").clientWidth === 0) screens.goTo("see");
}

function shakeAnew() {
  understand.outdated();
  address();
  simulate();
}

/** Goes back to the page's own scene. */
function ownPiece() {
  pieces.leave();
  edited.place = true;
  shakeAnew();
}

/** Builds the panels, whose fields depend on the piece; what one of them says may depend on what another knows. */
function build() {
  for (const panel of PANELS) panel.build(presets);
  for (const panel of PANELS) panel.update();
  notices.update();
}

/** Everything that is written in words, once more: another language or theme. */
function again() {
  readInks();
  build();
  upload.again();
  understand.again();
  see.again();
  if (shown) display();
  keep.update(measures.inPlace(current()).length > 0);
  tellWait(waiting);
  tellProblem(problem);
}

const touched = new Set();
const changed = beforeNextFrame(() => {
  const keys = [...touched];
  touched.clear();
  for (const panel of PANELS) panel.update();
  upload.update();
  notices.update();
  if (keys.every(everyday.asks) && understand.everydayChanged()) return;
  understand.outdated();
  simulate();
});

/**
 * Keeps the scene in the address. A change gets a place of its own in the browser's history, so that "back" takes it
 * back; what goes on changing the same fields stays in one place.
 */
function writeAddress() {
  if (taking || follows) return;
  const hash = hashNow(),
    state = { screen: document.body.dataset.screen };
  if (hash !== location.hash) {
    if (edited.place) history.pushState(state, "", hash);
    else history.replaceState(history.state ?? state, "", hash);
    edited.place = false;
  }
  keep.update(measures.inPlace(current()).length > 0);
}

const address = settled(250, writeAddress);

const hashNow = () => `#${toHash(current(), pieces.linked())}`;

/** Notes which fields change, and whether that begins another place in the browser's history. */
function edit(keys) {
  const now = performance.now(),
    same = edited.keys === keys.join() && now - edited.at < PAUSE;
  edited = { keys: keys.join(), at: now, place: !taking && (!same || edited.place) };
}

async function begin() {
  screens.begin("see");
  readInks();
  screens.wire(() => {
    if (presets) again();
  });
  see.wire();
  upload.wire((file) => pieces.open(file, shakePieces));
  keep.wire(request);
  part("sizes").addEventListener("rebuild", () => piece.build(presets));
  try {
    presets = await api.presets();
  } catch (error) {
    tellProblem(error);
    if (error.status !== 0 && error.status !== 503) return;
    presets = await patiently(api.presets);
    tellProblem(null);
  }
  for (const panel of PANELS) panel.build(presets);
  await take(location.hash);
  build();
  keep.films(presets.films);
  understand.build(request);
  watch((keys) => {
    if (!taking) pieces.leave(); // what is set is set for the page's own piece
    edit(keys);
    for (const key of keys) touched.add(key);
    changed();
    address();
  });
  addEventListener("popstate", async (event) => {
    screens.goBack(event.state);
    if (follows || location.hash === hashNow()) return;
    follows = true;
    for (let hash = ""; hash !== location.hash; ) {
      hash = location.hash; // which may change again while what it names is fetched
      await take(hash);
      again();
    }
    follows = false;
    shakeAnew(); // another file is no change of the scene
  });
  writeAddress(); // at once: a change that follows soon has a place to go back to
  simulate();
  understand.outdated();
}

/** Takes the scene of an address; a record of it is asked for on the server, and a file's pieces are shaken there. */
async function take(hash) {
  const { scene, record, file } = fromHash(hash, presets, fromServer(presets));
  const gone = file && (await takeFile(file));
  if (hash !== location.hash) return; // the reader has gone on meanwhile
  if (!file || gone) pieces.leave();
  taking = true;
  try {
    change({ ...scene, gone });
    if (record) await upload.takeLinked(record, scene);
  } finally {
    taking = false;
  }
}

/** Takes a file of several pieces from a link; returns what is wrong with it, as the notices say it, or null. */
async function takeFile(linked) {
  const slow = setTimeout(tellSlow, SLOW);
  try {
    return (await pieces.takeLinked(linked)) ? null : { file: linked.name, error: null };
  } catch (error) {
    return { file: linked.name, error };
  } finally {
    clearTimeout(slow);
    tellWait(null);
  }
}

begin();
