// What both pages let the reader keep: films, which take the server a while to draw, and links to the report and table.

import * as api from "./api.js";
import { offer, part } from "./dom.js";
import { worded } from "./refusals.js";
import { spoken, t } from "./words.js";

/** How long the short films are [s]. */
export const SECONDS = 10;

/** The kind of the short films: MP4 where the server can make it. */
export const shortKind = (kinds) => (kinds.includes("mp4") ? "mp4" : "gif");

const drawn = new Set(); // the buttons whose films are being drawn

/** Whether the film of a button is being drawn. */
export const isDrawn = (button) => drawn.has(button);

/** Does some work when a button is pressed; "say" is called with what goes wrong. */
export const pressed = (button, say, work) =>
  button.addEventListener("click", async () => {
    try {
      await work();
    } catch (error) {
      say(...worded(error));
    }
  });

/**
 * Lets a button have a film drawn and offer it as a file; "asked" gives what the server is asked when it is pressed:
 * {content, query, name}. "done" is called when the film is there or has failed.
 */
export const wireFilm = (button, say, asked, done = () => {}) =>
  pressed(button, say, async () => {
    try {
      await drawing(button, say, async () => {
        const { content, query, name } = asked(),
          film = await api.film(content, { lang: spoken(), ...query });
        offer(film, `${name}.${query.kind}`, film.type);
      });
    } finally {
      done();
    }
  });

/** Shows the address as a link, or that it is "long"; "missing" is the name of a record that it does not hold, or null. */
export function showLink(long, missing) {
  part("link").hidden = long;
  part("link-long").hidden = !long;
  part("link-record").hidden = missing === null;
  part("link-record").textContent = missing === null ? "" : t("linkRecord", { name: missing });
  part("address").value = location.href;
}

/** Points the links of the verdict at a finished job, or at nothing. */
export function linkTo(job) {
  for (const [id, addressOf] of [
    ["report", api.reportAddress],
    ["table", api.tableAddress],
  ]) {
    const link = part(id);
    if (job) link.setAttribute("href", addressOf(job, spoken()));
    else link.removeAttribute("href");
    link.setAttribute("aria-disabled", String(!job));
  }
  part("report-wait").hidden = Boolean(job);
}

/** Closes a button and says on it, and by "say", that a film is being drawn, for as long as that takes. */
async function drawing(button, say, work) {
  const usual = button.dataset.t;
  const tell = (key) => {
    button.dataset.t = key; // from which another language is written
    button.textContent = t(key);
  };
  drawn.add(button);
  button.disabled = true;
  tell("drawingNow");
  say(t("drawing"));
  try {
    await work();
    say();
  } finally {
    drawn.delete(button);
    button.disabled = false;
    tell(usual);
  }
}
