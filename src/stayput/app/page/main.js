// The page: the scene is set, sent, seen, understood, kept. This file says what follows from what.

import * as api from "./api.js";
import { beforeNextFrame, fill, part, settled } from "./dom.js";
import { readInks } from "./inks.js";
import * as keep from "./keep.js";
import { fromHash, toHash } from "./link.js";
import * as measures from "./panel_measures.js";
import * as piece from "./panel_piece.js";
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
import { both, number, t } from "./words.js";

const PANELS = [piece, room, shaking, measures];
const SLOW = 1500;
let presets = null,
  shown = null,
  problem = null,
  flying = false,
  stale = false;

/** What the server is asked: the scene, and the measures that can be put there. */
const asked = () => ({ scene: forServer(current()), measures: measures.inPlace(current()) });

/** Simulates the scene now; while one answer is awaited only the newest scene waits for the next. */
async function simulate() {
  if (flying) {
    stale = true;
    return;
  }
  flying = true;
  stale = false;
  part("see").setAttribute("aria-busy", "true");
  const slow = setTimeout(() => (part("warming").hidden = false), SLOW);
  const scene = current();
  try {
    shown = { result: shake(await api.simulate(asked())), scene };
    tellProblem(null);
    display();
  } catch (error) {
    tellProblem(error);
    if (scene.record && lacksRecord(error)) {
      change({ record: null, scaled: false });
      upload.lost();
    }
  }
  flying = false;
  clearTimeout(slow);
  part("warming").hidden = true;
  part("see").removeAttribute("aria-busy");
  document.documentElement.dataset.drawn = String(performance.now());
  if (stale) simulate();
}

/** Says why there is no picture of the scene, or that there is one. */
function tellProblem(error) {
  problem = error;
  part("problem").hidden = !error;
  part("see").dataset.old = String(Boolean(error));
  fill(part("problem"), error ? worded(error) : []);
}

function display() {
  const { result, scene } = shown;
  see.show(result, scene);
  tell(result, [t("without"), t("with")], (time) => {
    see.clock.seek(time);
    if (part("see").clientWidth === 0) screens.goTo("see");
  });
  part("summary").textContent = summary(scene, result.motion);
}

function summary(scene, motion) {
  const place =
    scene.storeys > 0
      ? t("placeStorey", { storey: number(scene.storey), storeys: number(scene.storeys) })
      : t("placeGround");
  const strength =
    motion.ground_intensity === null
      ? ""
      : t("strength", {
          class: both(shaking.classOf(motion.ground_intensity).label),
          at: number(motion.ground_intensity, 2),
        });
  const felt =
    scene.storeys > 0 && motion.floor_intensity !== null
      ? t("felt", { at: number(motion.floor_intensity, 2) })
      : "";
  const source = [
    scene.record ? t("recorded", { name: scene.record.name }) : "",
    motion.synthetic ? t("synthetic") : "",
  ];
  return [place, strength, felt, ...source].filter(Boolean).join(t("space"));
}

/** Everything that is written in words, once more: another language or theme. */
function again() {
  readInks();
  for (const panel of PANELS) panel.build(presets);
  upload.again();
  understand.again(presets);
  see.again(presets);
  if (shown) display();
  tellProblem(problem);
}

const changed = beforeNextFrame(() => {
  for (const panel of PANELS) panel.update();
  upload.update();
  understand.outdated();
  simulate();
});
const address = settled(250, () => {
  history.replaceState(null, "", `#${toHash(current())}`);
  keep.update(measures.inPlace(current()).length > 0);
});

async function begin() {
  screens.begin();
  readInks();
  screens.wire(() => {
    if (presets) again();
  });
  see.wire();
  upload.wire();
  keep.wire(asked);
  part("sizes").addEventListener("rebuild", () => piece.build(presets));
  try {
    presets = await api.presets();
  } catch (error) {
    tellProblem(error);
    return;
  }
  await take(location.hash);
  for (const panel of PANELS) panel.build(presets);
  see.name(presets);
  understand.build(presets, asked);
  watch(() => {
    changed();
    address();
  });
  addEventListener("hashchange", async () => {
    await take(location.hash);
    again();
    changed();
  });
  address();
  simulate();
  understand.outdated();
}

/** Takes the scene of an address; a record of it is asked for on the server. */
async function take(hash) {
  const { scene, record } = fromHash(hash, presets, fromServer(presets));
  change(scene);
  if (!record) return;
  try {
    const scaled = scene.scaled;
    await upload.use(await api.motion(record));
    change({ scaled });
  } catch {
    upload.lost();
  }
}

begin();
