// The page of a room: it is drawn, judged, seen, changed, kept. This file says what follows from what.

import * as api from "../api.js";
import { beforeNextFrame } from "../canvas/clock.js";
import { readInks } from "../canvas/pen.js";
import { patiently } from "../connection.js";
import { el, fill, part } from "../dom.js";
import { showLink } from "../films.js";
import * as building from "../panel_building.js";
import * as shaking from "../panel_shaking.js";
import { worded } from "../refusals.js";
import { watch as watchFields } from "../scene.js";
import * as screens from "../screens.js";
import * as upload from "../upload.js";
import { t } from "../words.js";
import * as actionPlan from "./action_plan.js";
import * as address from "./address.js";
import * as changes from "./changes.js";
import * as comparing from "./comparing.js";
import * as editor from "./editor.js";
import * as environment from "./environment.js";
import * as files from "./files.js";
import * as findings from "./findings.js";
import * as judging from "./judging.js";
import * as room from "./room.js";
import * as scenes from "./scenes.js";
import * as surfaces from "./surfaces.js";
import * as theatre from "./theatre.js";
import * as tried from "./tried.js";
import * as undoMemory from "./undo_memory.js";
import * as verdict from "./verdict.js";

const PANELS = [shaking, surfaces, building];
let presets = null,
  notice = null, // what is wrong with the room that was asked for, as the key of a sentence
  follows = 0; // steps in the browser's history, of which the newest counts

/** Says above the plan what is wrong with the room that was asked for; null: nothing. */
function tellNotice(key) {
  notice = key;
  part("notices").hidden = !key;
  if (!key) return;
  const close = el("button", { type: "button", text: t("understood"), onclick: () => tellNotice(null) });
  fill(part("notices"), el("p", {}, t(key), " ", close));
}

/** Shows the newest state of the question everywhere that it is shown. */
function judged(state) {
  verdict.show(state);
  editor.tellResult(state.result, { old: state.old });
  editor.tellRefusal(state.error);
  const done = state.job?.state === "done" ? state.job.id : null;
  files.point(done);
  theatre.judged(state.old || state.error ? null : state.result);
  actionPlan.take(done);
  tried.tell(Boolean(state.result) && !state.old);
  if (!state.result) return;
  findings.show(state.result);
  changes.show(state.result);
}

/** Everything that is written in words, once more: another language or theme. */
function again() {
  readInks();
  for (const panel of PANELS) panel.build(presets);
  upload.again();
  editor.build();
  theatre.again(presets);
  verdict.build();
  files.build();
  actionPlan.build();
  tried.show();
  scenes.list();
  comparing.show();
  judged(judging.state());
  tellNotice(notice);
}

/** What follows from a change of the room. */
const changed = beforeNextFrame(() => {
  environment.take();
  verdict.update();
  tried.show();
  judging.changed();
  actionPlan.update();
  theatre.changed();
  address.changed();
});

/** The server does not have the record of a link or a file: a computed earthquake takes its place. */
function lost() {
  tellNotice("recordGoneHere");
  room.replace(environment.withoutRecord(room.current()));
}

/** Takes the room of the address; where there is none, or it is damaged, that which the server proposes. */
async function take(hash) {
  const { room: found, damaged, records } = await address.read(hash);
  environment.noteRecords(found, records);
  if (damaged) tellNotice("roomDamaged");
  return found ?? room.current() ?? presets.room_scene;
}

function wire() {
  verdict.wire();
  judging.wire(judged);
  actionPlan.wire(() => judged(judging.state()));
  theatre.wire();
  scenes.wire(address.isOwn(room.current()));
  part("cancel").addEventListener("click", judging.cancel);
  part("verify").addEventListener("click", judging.again);
  upload.wire((file) => files.open(file, (...said) => upload.tell(() => [el("p", { role: "status" }, ...said)]), scenes.leave));
  files.wire(scenes.leave, presets.films);
  const fields = beforeNextFrame(() => {
    for (const panel of PANELS) panel.update();
    upload.update();
  });
  watchFields(fields);
  room.watch(changed);
  addEventListener("popstate", async (event) => {
    screens.goBack(event.state);
    const mine = ++follows,
      found = await take(location.hash);
    if (mine !== follows || JSON.stringify(found) === JSON.stringify(room.current())) return;
    room.change(found);
    address.settle();
    if (event.state === null) scenes.leave(); // a link that was put into the address
  });
}

async function begin() {
  screens.begin("scene");
  readInks();
  screens.wire(() => presets && again());
  try {
    presets = await api.presets();
  } catch (error) {
    fill(part("verdict"), ...worded(error));
    presets = await patiently(api.presets);
    fill(part("verdict"));
  }
  editor.wire(presets);
  room.replace(await take(location.hash));
  undoMemory.wire();
  for (const panel of PANELS) panel.build(presets);
  wire();
  environment.wire(presets, lost);
  again();
  address.wire(showLink);
  changed();
  document.documentElement.dataset.ready = "true";
}

begin();
