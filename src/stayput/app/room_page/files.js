// "Keep it": the room as a scenario file, opened and saved; the report and the table.

import * as api from "../api.js";
import { patiently } from "../connection.js";
import { copying, fill, offer, part } from "../dom.js";
import { SECONDS, linkTo, pressed, shortKind, wireFilm } from "../films.js";
import { utf8 } from "../packing.js";
import { wordedOfScenario } from "../refusals.js";
import { t } from "../words.js";
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
    if (file) open(file, say, opened);
  });
  const name = () => room.current().title || "room";
  pressed(part("toml"), say, async () => {
    offer(await api.toml({ scene: room.current(), measures: [] }), `${name()}.toml`, "application/toml");
    say();
  });
  const film = (button, query) =>
    wireFilm(button, say, () => ({
      content: played(),
      query: { ...query, ...(job && { job }) },
      name: name(),
    }));
  film(part("html"), { kind: "html" });
  film(part("film"), { kind: shortFilm, seconds: SECONDS });
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
  linkTo(job);
}
