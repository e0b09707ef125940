// Which screen is shown on a phone, with a place in the browser's history; and the reader's theme and language.

import { icon } from "./icons.js";
import { fill, narrow, part } from "./dom.js";
import { recalled, remember } from "./memory.js";
import { preferredLanguage, speak, spoken, t } from "./words.js";

const SCREENS = ["scene", "see", "understand", "keep"];

/** Shows one screen, which "back" leaves again; on a wide page all are there, and this one is scrolled to. */
export function goTo(screen, focus = true) {
  const other = document.body.dataset.screen !== screen;
  showScreen(screen, focus);
  if (other && narrow()) history.pushState({ screen }, "");
}

/** Shows the screen of a place in the browser's history. */
export function goBack(state) {
  const screen = state?.screen;
  if (SCREENS.includes(screen) && document.body.dataset.screen !== screen) showScreen(screen, narrow());
}

/** Notes which screen is shown, for the style sheet and for readers of screens. */
function mark(screen) {
  document.body.dataset.screen = screen;
  for (const button of document.querySelectorAll("#steps [data-screen]"))
    if (button.dataset.screen === screen) button.setAttribute("aria-current", "step");
    else button.removeAttribute("aria-current");
}

function showScreen(screen, focus) {
  mark(screen);
  if (narrow()) scrollTo(0, 0);
  else if (focus) part(screen).scrollIntoView({ block: "start" });
  if (focus) part(`${screen}-title`).focus({ preventScroll: true });
  dispatchEvent(new Event("shown"));
}

/** Wires the steps, the theme and the language; "changed" is called after either of the latter changed. */
export function wire(changed) {
  for (const button of document.querySelectorAll("#steps [data-screen]")) {
    button.prepend(icon(button.dataset.screen));
    button.addEventListener("click", () => goTo(button.dataset.screen));
  }
  for (const button of document.querySelectorAll("[data-go]"))
    button.addEventListener("click", () => goTo(button.dataset.go));
  for (const button of document.querySelectorAll("#languages button"))
    button.addEventListener("click", () => {
      remember("language", button.lang);
      speak(button.lang);
      marks();
      changed();
    });
  part("theme").addEventListener("click", () => {
    const next = dark() ? "light" : "dark";
    document.documentElement.dataset.theme = next;
    remember("theme", next);
    marks();
    changed();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    marks();
    changed();
  });
}

/** Puts the remembered theme and language in place, before anything is drawn; "first" is the screen to begin with. */
export function begin(first) {
  const theme = recalled("theme");
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
  speak(recalled("language") ?? preferredLanguage());
  const screen = history.state?.screen;
  mark(SCREENS.includes(screen) ? screen : first);
  history.replaceState({ screen: document.body.dataset.screen }, "");
  marks();
}

const dark = () =>
  (document.documentElement.dataset.theme ??
    (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";

function marks() {
  for (const button of document.querySelectorAll("#languages button"))
    button.setAttribute("aria-pressed", String(button.lang === spoken()));
  part("theme").setAttribute("aria-label", t(dark() ? "toLight" : "toDark"));
  fill(part("theme"), icon(dark() ? "light" : "dark"));
}
