// What the server refuses, in words that the reader understands.

import { Refused } from "./api.js";
import { el } from "./dom.js";
import { spoken, t } from "./words.js";

const BY_STATUS = {
  0: "away",
  404: "gone",
  408: "tooSlow",
  413: "tooLarge",
  429: "busy",
  500: "broken",
  503: "busy",
};

/** Whether an error says that the server no longer has the record of the scene. */
export const lacksRecord = (error) => /^scene\.shaking\.(record|across|vertical)$/.test(error.field);

/** What is wrong with a scenario file, as `worded`; a record is not beside it as on the reader's disk. */
export const wordedOfScenario = (error) =>
  lacksRecord(error) ? [t("recordBeside")] : worded(error, "unreadable");

/**
 * An error as what is shown: a sentence in the reader's language; where there is only a general one, the server's
 * own words beside it.
 */
export function worded(error, lead = "refused") {
  if (!(error instanceof Refused)) {
    console.error(error);
    return [t("broken")];
  }
  const { status, message, japanese } = error;
  if (lacksRecord(error)) return [t("recordGone", { name: "" })];
  if (status in BY_STATUS) return [t(BY_STATUS[status])];
  if (spoken() === "en") return [`${t(lead)} ${message}`];
  if (japanese) return [japanese];
  return [t(lead), el("small", { class: "detail", lang: "en", text: message })];
}
