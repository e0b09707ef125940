// "Keep it": the room as a scenario file, opened and saved; the report and the table.

import * as api from "../api.js";
import { patiently } from "../connection.js";
import { copying, fill, offer, part } from "../dom.js";
import { SECONDS, drawing, shortKind } from "../films.js";
import { utf8 } from "../packing.js";
import { worded, wordedOfScenario } from "../refusals.js";
import { spoken, t } from "../words.js";
import * as room from "./room.js";
import { played } from "./theatre.js";

let newest = 0,
  shortFilm = "gif",
  job = null;

const say = (...content) => fill(part("kept"), content);

/** Wires the buttons; "opened" is called after a file has become the room, "kinds" are films that the server can make. */
export function wire(opened, kinds) {
  shortFilm = shortKind(kinds);
  part("film").dataset.t = `${shortFilm}OfRoom`;
  part("film").textContent = t(part("film").dataset.t);
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
  const film = (button, query) =>
    button.addEventListener("click", async () => {
      const { title } = room.current();
      try {
        await drawing(button, say, async () => {
          const made = await api.film({ scene: played(), measures: [] }, { lang: spoken(), ...query() });
          offer(made, `${title || "room"}.${query().kind}`, made.type);
        });
      } catch (error) {
        say(...worded(error));
      }
    });
  film(part("html"), () => ({ kind: "html", ...(job && { job }) }));
  film(part("film"), () => ({ kind: shortFilm, seconds: SECONDS, ...(job && { job }) }));
  copying(part("copy"), part("address"), () => say(t("copied")));
}

/** Opens a scenario file in the room's place; "tell" shows what becomes of it. What is refused changes nothing. */
export async function open(file, tell, opened) {
  const mine = ++newest,
    wanted = () => mine === newest;
  const text = await file.arrayBuffer().then(utf8).catch(() => null);
  if (text === null) return tell(t("notText"));
  tell(t("sending"));
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

/** Writes the links anew, for another language. */
export const build = () => point(job);

/** Points the links of the verdict at a finished job, or at nothing. */
export function point(finished) {
  job = finished;
  for (const [id, address] of [
    ["report", job && api.reportAddress(job, spoken())],
    ["table", job && api.tableAddress(job)],
  ]) {
    const link = part(id);
    if (address) link.setAttribute("href", address);
    else link.removeAttribute("href");
    link.setAttribute("aria-disabled", String(!address));
  }
  part("report-wait").hidden = Boolean(job);
}
