// What takes the server a while to draw, and how a page says so.

import { t } from "./words.js";

/** How long the short films are [s]. */
export const SECONDS = 10;

/** The kind of the short films: MP4 where the server can make it. */
export const shortKind = (kinds) => (kinds.includes("mp4") ? "mp4" : "gif");

const drawn = new Set(); // the buttons whose films are being drawn

/** Whether the film of a button is being drawn. */
export const isDrawn = (button) => drawn.has(button);

/** Closes a button and says on it, and by "say", that a film is being drawn, for as long as that takes. */
export async function drawing(button, say, work) {
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
