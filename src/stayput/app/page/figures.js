// Charts to keep: beside each chart buttons that fetch it as a picture with its caption, or as its numbers.

import { el, fill, offer } from "./dom.js";
import { worded } from "./refusals.js";
import { spoken, t } from "./words.js";

const KINDS = ["svg", "pdf", "csv"];

/**
 * Puts the buttons beside the charts; called again for another language. "sources" has for each chart what gives a
 * function of {kind, lang} that fetches it, or null where the chart is not there yet.
 */
export function build(sources) {
  for (const place of document.querySelectorAll("[data-figure]")) {
    const name = place.dataset.figure,
      said = el("span", { role: "status", class: "hint" });
    fill(
      place,
      el("span", { class: "hint", text: t("keepFigure") }),
      ...KINDS.map((kind) =>
        el("button", {
          type: "button",
          text: kind.toUpperCase(),
          "aria-label": t("keepFigureAs", { name: t(`figure_${name}`), kind: kind.toUpperCase() }),
          onclick: (event) => save(event.currentTarget, said, sources[name](), `stayput_${name}.${kind}`, kind),
        }),
      ),
      said,
    );
  }
}

async function save(button, said, fetched, name, kind) {
  if (!fetched) return fill(said, t("figureWait"));
  button.disabled = true;
  fill(said, t("figureDrawing"));
  try {
    const made = await fetched({ kind, lang: spoken() });
    offer(made, name, made.type);
    fill(said);
  } catch (error) {
    fill(said, worded(error));
  } finally {
    button.disabled = false;
  }
}
