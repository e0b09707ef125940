// Which screen is shown on a phone, and the reader's theme and language, which the browser remembers.

import { icon } from "./icons.js";
import { fill, narrow, part } from "./dom.js";
import { asked, speak, spoken, t } from "./words.js";

const SCREENS = ["scene", "see", "understand", "keep"];
const kept = (name) => {
  try {
    return localStorage.getItem(`stayput-${name}`);
  } catch {
    return null;
  }
};
const keep = (name, value) => {
  try {
    localStorage.setItem(`stayput-${name}`, value);
  } catch {
    /* private mode: not remembered */
  }
};

/** Shows one screen; on a wide page all are there, and this one is scrolled to. */
export function goTo(screen, focus = true) {
  document.body.dataset.screen = screen;
  for (const button of document.querySelectorAll("#steps button"))
    if (button.dataset.screen === screen) button.setAttribute("aria-current", "step");
    else button.removeAttribute("aria-current");
  if (narrow()) scrollTo(0, 0);
  else if (focus) part(screen).scrollIntoView({ block: "start" });
  if (focus) part(`${screen}-title`).focus({ preventScroll: true });
  dispatchEvent(new Event("shown"));
}

/** Wires the steps, the theme and the language; "changed" is called after either of the latter changed. */
export function wire(changed) {
  for (const button of document.querySelectorAll("#steps button")) {
    button.prepend(icon(button.dataset.screen));
    button.addEventListener("click", () => goTo(button.dataset.screen));
  }
  for (const button of document.querySelectorAll("[data-go]"))
    button.addEventListener("click", () => goTo(button.dataset.go));
  for (const button of document.querySelectorAll("#languages button"))
    button.addEventListener("click", () => {
      keep("language", button.lang);
      speak(button.lang);
      marks();
      changed();
    });
  part("theme").addEventListener("click", () => {
    const next = dark() ? "light" : "dark";
    document.documentElement.dataset.theme = next;
    keep("theme", next);
    marks();
    changed();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    marks();
    changed();
  });
}

/** Puts the remembered theme and language in place, before anything is drawn. */
export function begin() {
  const theme = kept("theme");
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
  speak(kept("language") ?? asked());
  document.body.dataset.screen = SCREENS[1];
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
