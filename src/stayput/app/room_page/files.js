// "Keep it": the room as a scenario file, opened and saved; the report, the table, the plan to buy and do.

import * as api from "../api.js";
import { patiently } from "../connection.js";
import { toggle } from "../controls.js";
import { fill, offer, part } from "../dom.js";
import { utf8 } from "../packing.js";
import { worded, wordedOfScenario } from "../refusals.js";
import { spoken, t } from "../words.js";
import * as room from "./room.js";

const ALLOWED = ["no_drilling", "tatami", "plasterboard", "dropped_ceiling"];
const allowed = new Set();
let newest = 0,
  job = null;

const say = (...content) => fill(part("kept"), content);

/** Wires the buttons; "opened" is called after a file has become the room. */
export function wire(opened) {
  part("open").addEventListener("change", ({ target }) => {
    const [file] = target.files;
    target.value = "";
    if (file) open(file, (...content) => say(...content), opened);
  });
  part("toml").addEventListener("click", async () => {
    try {
      const text = await api.toml({ scene: room.current(), measures: [] });
      offer(text, `${room.current().title || "room"}.toml`, "application/toml");
      say();
    } catch (error) {
      say(...worded(error));
    }
  });
  part("copy").addEventListener("click", async () => {
    const field = part("address");
    try {
      await navigator.clipboard.writeText(field.value);
    } catch {
      field.select();
      document.execCommand("copy");
    }
    say(t("copied"));
  });
  part("address").addEventListener("focus", ({ target }) => target.select());
}

/** Opens a scenario file in the room's place; "tell" shows what becomes of it. What is refused changes nothing. */
export async function open(file, tell, opened) {
  const mine = ++newest,
    wanted = () => mine === newest;
  const text = await file.arrayBuffer().then(utf8).catch(() => null);
  if (text === null) return tell(t("notText"));
  tell(t("readingFile"));
  try {
    const read = await patiently(() => api.readScenario(text, file.name), wanted);
    if (!wanted()) return;
    if (!read.scene.plan) return tell(t("noRoomInFile"));
    room.replace(read.scene);
    opened();
    tell(t("openedFile", { name: file.name }));
  } catch (error) {
    if (wanted()) tell(...wordedOfScenario(error));
  }
}

/** Builds what is allowed in the plan to buy and do; called again for another language. */
export function build() {
  fill(
    part("allowed"),
    ALLOWED.map((name) => {
      const made = toggle({
        label: t(`allowed_${name}`),
        changed: (on) => {
          if (on) allowed.add(name);
          else allowed.delete(name);
          point(job);
        },
      });
      made.set(allowed.has(name));
      return made.element;
    }),
  );
  point(job);
}

/** Points the links of the verdict at a finished job, or at nothing. */
export function point(finished) {
  job = finished;
  const filters = Object.fromEntries([...allowed].map((name) => [name, "true"]));
  for (const [id, address] of [
    ["report", job && api.reportAddress(job, spoken())],
    ["table", job && api.tableAddress(job)],
    ["card", job && api.planAddress(job, { lang: spoken(), ...filters })],
  ]) {
    const link = part(id);
    if (address) link.setAttribute("href", address);
    else link.removeAttribute("href");
    link.setAttribute("aria-disabled", String(!address));
  }
  part("report-wait").hidden = Boolean(job);
}
