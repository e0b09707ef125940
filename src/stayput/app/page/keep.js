// "Keep it": the link, the scenario as TOML, the report, the data.

import * as api from "./api.js";
import { copying, fill, offer, part } from "./dom.js";
import { SECONDS, isDrawn, linkTo, pressed, shortKind, showLink, wireFilm } from "./films.js";
import * as pieces from "./pieces.js";
import { FURTHER, current, precisely } from "./scene.js";
import { t } from "./words.js";

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

/** The scene and its measures with the precision that is chosen, on which the chances rest. */
const complete = ({ scene, measures }) => ({
  scene: Array.isArray(scene.furniture) ? scene : precisely(scene, Number(part("precision").value)),
  measures,
});

/** Wires the buttons; "request" gives the scene and its measures. */
export function wire(request) {
  copying(part("copy"), part("address"), () => say(t("copied")));
  pressed(part("toml"), say, async () => {
    const text = pieces.shownText() ?? (await api.toml(complete(request())));
    offer(text, pieces.shownName() ?? "scenario.toml", "application/toml");
  });
  for (const which of ["without", "with"]) {
    pressed(part(`csv-${which}`), say, async () =>
      offer(await api.runAsCsv(request(), which), `run_${which}.csv`, "text/csv"),
    );
    const film = (button, query) => {
      const asked = () => ({ content: request(), query: { which, ...query() }, name: `run_${which}` });
      wireFilm(button, say, asked, () => (button.disabled = shut(button)));
    };
    film(part(`html-${which}`), () => ({ kind: "html" }));
    film(part(`film-${which}`), () => ({ kind, seconds: SECONDS, ...(job && { job }) }));
  }
}

/** Points the links of the verdict at a finished job, or at nothing. */
export function point(done) {
  job = done;
  linkTo(job);
}

/** Shows the address of the scene, what is too long for one, and whether there is a run with measures. */
export function update(measured) {
  const { record } = current(),
    alone = pieces.asked() ? null : [record, ...FURTHER.map((part) => record?.[part])].find((one) => one && !one.letters);
  showLink(pieces.tooLong(), alone?.name ?? null);
  held = measured && !pieces.asked();
  for (const what of ["csv", "html", "film"]) part(`${what}-with`).disabled = shut(part(`${what}-with`));
}
