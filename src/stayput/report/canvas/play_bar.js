// What every player of a run in a page of its own has: play, time, speed, theme, keys, the time in the address.

import { digits } from "./digits.js";
import { player, prefersReducedMotion } from "./clock.js";
import { readInks } from "./pen.js";

/**
 * Lets the page's controls play a film from "start" to "end", and returns its clock. "draw" draws a time;
 * "#6.3" in the page's address opens it at 6.3 s, paused. Call "begin" of what is returned once all is there.
 */
export function playBar(film, { start, end }, draw) {
  const part = (id) => document.getElementById(id);
  const { texts } = film;
  function drawAll(now) {
    draw(now);
    part("clock").textContent = `${digits(now, 2)} s`;
    part("time").value = (1000 * (now - start)) / (end - start);
  }
  const clock = player(
    drawAll,
    (playing) => (part("play").textContent = playing ? texts.pause : texts.play),
    film.hold_s,
  );
  const again = () => {
    readInks();
    drawAll(clock.now);
  };
  for (const value of [...new Set([0.1, 0.25, 0.5, 1, 2, 4, film.speed])].sort((p, q) => p - q))
    part("speed").add(new Option(`${value} ×`, value, false, value === film.speed));
  clock.faster(film.speed);
  part("speed").onchange = (event) => clock.faster(Number(event.target.value));
  part("play").onclick = () => clock.toggle();
  part("time").oninput = (event) => clock.seek(start + (event.target.value / 1000) * (end - start));
  part("theme").onclick = () => {
    const dark = getComputedStyle(document.documentElement).getPropertyValue("--paper").trim() === "#14181d";
    document.documentElement.dataset.theme = dark ? "light" : "dark";
    again();
  };
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.target.closest("button, select, input")) return;
    if (event.key === " ") {
      clock.toggle();
      event.preventDefault();
    }
    if (event.key === "ArrowRight") clock.step(0.02);
    if (event.key === "ArrowLeft") clock.step(-0.02);
  });
  addEventListener("resize", again);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
  return {
    clock,
    again,
    begin() {
      const wanted = Number(location.hash.slice(1));
      const chosen = location.hash && Number.isFinite(wanted);
      readInks();
      const shown = film.plays ? start : film.telling_s;
      clock.span(start, end, chosen ? wanted : shown, chosen || !film.plays || prefersReducedMotion());
      again();
    },
  };
}
