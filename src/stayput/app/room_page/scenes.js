// "Keep it": the rooms that are kept on this device, to be opened, renamed, removed, and compared in pairs.

import { el, fill, part, svg } from "../dom.js";
import { tab } from "../memory.js";
import { goTo } from "../screens.js";
import { t } from "../words.js";
import { compare } from "./comparing.js";
import { drawPlan } from "./plan.js";
import * as room from "./room.js";
import * as shelf from "./shelf.js";

const OPENED = "room-open"; // which of the rooms this tab is working on
const marked = new Set();
let opened = null; // {id, revision}

const say = (text) => fill(part("scenes-said"), text);

/** Wires the panel; "own" says whether the room is the one that this tab had before. */
export function wire(own) {
  if (own) opened = JSON.parse(tab.recalled(OPENED) ?? "null");
  part("scene-name").value = (opened && shelf.get(opened.id)?.name) ?? "";
  part("keep-scene").addEventListener("submit", (event) => {
    event.preventDefault();
    keep(part("scene-name").value.trim() || room.current().title || t("unnamed"));
  });
  part("compare").addEventListener("click", () => {
    compare([...marked].map(shelf.get).filter(Boolean));
    part("comparison").scrollIntoView({ block: "nearest" });
  });
  shelf.watch(list);
}

/** Keeps the room: over the one that is open where it has that name, else as another. */
function keep(name) {
  const before = opened && shelf.get(opened.id),
    same = before?.name === name;
  attempt(() => {
    const kept = shelf.keep(name, room.current(), same ? opened : null);
    remember(kept);
    part("scene-name").value = kept.name;
    say(t(same && kept.id !== before.id ? "keptBeside" : "keptScene", { name: kept.name }));
  });
}

function attempt(work) {
  try {
    work();
  } catch (error) {
    if (!(error instanceof shelf.NotKept)) throw error;
    say(t(error.reason === "full" ? "scenesFull" : "scenesClosed"));
  }
  list();
}

/** Notes which of the rooms this tab is working on, also for when it is loaded again. */
function remember(kept) {
  opened = kept && { id: kept.id, revision: kept.revision };
  tab.remember(OPENED, JSON.stringify(opened));
}

/** Another room is drawn, from a file or a link: none that is kept is open. */
export function leave() {
  remember(null);
  part("scene-name").value = room.current().title ?? "";
}

/** Lists the rooms that are kept; called again for another language. */
export function list() {
  const scenes = shelf.all();
  for (const id of marked) if (!scenes.some((one) => one.id === id)) marked.delete(id);
  fill(part("scenes"), scenes.length ? scenes.map(entry) : el("li", { class: "hint", text: t("noScenes") }));
  part("compare").disabled = marked.size !== 2;
  part("compare").hidden = scenes.length < 2;
}

function entry(scene) {
  const picture = svg("svg");
  drawPlan(picture, scene.room, { readOnly: true, bare: true, wide: 150, high: 150 });
  const mark = el("input", { type: "checkbox", id: `mark-${scene.id}`, onchange: () => toggle(scene.id) });
  mark.checked = marked.has(scene.id);
  picture.setAttribute("aria-label", t("planOf", { name: scene.name }));
  return el(
    "li",
    { class: "scene" },
    picture,
    el(
      "div",
      {},
      el("strong", { text: scene.name }),
      el("span", { class: "row" },
        button("openScene", scene, () => open(scene)),
        button("renameScene", scene, () => rename(scene)),
        button("removeScene", scene, () => remove(scene)),
      ),
      el("span", { class: "check" }, mark, el("label", { for: mark.id, text: t("markScene") })),
    ),
  );
}

const button = (key, { name }, onclick) =>
  el("button", { type: "button", text: t(key), "aria-label": `${t(key)}${t("colon")}${name}`, onclick });

function open(scene) {
  room.replace(scene.room);
  remember(scene);
  part("scene-name").value = scene.name;
  say(t("openedFile", { name: scene.name }));
  goTo("scene");
}

function rename(scene) {
  const name = prompt(t("newName"), scene.name)?.trim();
  if (!name) return;
  attempt(() => {
    const renamed = shelf.rename(scene, name);
    if (opened?.id === scene.id) {
      remember(renamed);
      part("scene-name").value = renamed.name;
    }
  });
}

function remove(scene) {
  if (!confirm(t("removeSure", { name: scene.name }))) return;
  shelf.remove(scene.id);
  if (opened?.id === scene.id) remember(null);
  say(t("removedScene", { name: scene.name }));
  list();
}

function toggle(id) {
  if (!marked.delete(id)) marked.add(id);
  if (marked.size > 2) marked.delete([...marked][0]);
  list();
  part(`mark-${id}`).focus();
}
