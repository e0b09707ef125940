// "Keep it": the link, the scenario as TOML, the report, the data.

import * as api from "./api.js";
import { copying, fill, offer, part } from "./dom.js";
import { SECONDS, drawing, isDrawn, shortKind } from "./films.js";
import * as pieces from "./pieces.js";
import { worded } from "./refusals.js";
import { current, sampled } from "./scene.js";
import { spoken, t } from "./words.js";

let held = false, // whether there is a run with measures
  kind = "gif", // of the short films
  job = null; // the verdict that is said in them

const say = (...content) => fill(part("kept"), content);

/** Whether a button of a run is closed: its film is being drawn, or there is no such run. */
const shut = (button) => isDrawn(button) || (button.id.endsWith("-with") && !held);

/** Takes the kinds of films that the server can make: the short ones are MP4 where it can. */
export function films(kinds) {
  kind = shortKind(kinds);
  for (const which of ["Without", "With"]) {
    const button = part(`film-${which.toLowerCase()}`);
    button.dataset.t = `${kind}${which}`;
    button.textContent = t(button.dataset.t);
  }
}

/** The scene and its measures with the accuracy that is chosen, on which the chances rest. */
const complete = ({ scene, measures }) => ({
  scene: Array.isArray(scene.furniture) ? scene : sampled(scene, Number(part("samples").value)),
  measures,
});

/** Wires the buttons; "request" gives the scene and its measures. */
export function wire(request) {
  const attempt = (work) => async () => {
    try {
      await work();
    } catch (error) {
      say(...worded(error));
    }
  };
  copying(part("copy"), part("address"), () => say(t("copied")));
  part("toml").addEventListener(
    "click",
    attempt(async () =>
      offer(
        pieces.shownText() ?? (await api.toml(complete(request()))),
        pieces.shownName() ?? "scenario.toml",
        "application/toml",
      ),
    ),
  );
  for (const which of ["without", "with"]) {
    part(`csv-${which}`).addEventListener(
      "click",
      attempt(async () => offer(await api.runAsCsv(request(), which), `run_${which}.csv`, "text/csv")),
    );
    const wireFilm = (button, asked) =>
      button.addEventListener(
        "click",
        attempt(async () => {
          try {
            await drawing(button, say, async () => {
              const query = { which, lang: spoken(), ...asked() },
                made = await api.film(request(), query);
              offer(made, `run_${which}.${query.kind}`, made.type);
            });
          } finally {
            button.disabled = shut(button);
          }
        }),
      );
    wireFilm(part(`html-${which}`), () => ({ kind: "html" }));
    wireFilm(part(`film-${which}`), () => ({ kind, seconds: SECONDS, ...(job && { job }) }));
  }
}

/** Points the links of the verdict at a finished job, or at nothing. */
export function point(done) {
  job = done;
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

/** Shows the address of the scene, what is too long for one, and whether there is a run with measures. */
export function update(measured) {
  const long = pieces.tooLong(),
    { record } = current(),
    alone = pieces.asked() ? null : [record, record?.vertical].find((one) => one && !one.letters);
  part("link").hidden = long;
  part("link-long").hidden = !long;
  part("link-record").hidden = !alone;
  part("link-record").textContent = alone ? t("linkRecord", { name: alone.name }) : "";
  part("address").value = location.href;
  held = measured && !pieces.asked();
  for (const what of ["csv", "html", "film"]) part(`${what}-with`).disabled = shut(part(`${what}-with`));
}
