// Chances and what goes with them, as text.

import { inPercent, number, percent, t } from "../words.js";

/** A chance with its interval: "83 % (65 to 92 %)"; less where it is not known. */
export function chance({ estimate, low, high }) {
  if (estimate === null) return t("notKnown");
  if (low === null) return percent(estimate);
  return t("chanceBetween", { share: percent(estimate), low: percent(low), high: percent(high) });
}

/** A difference of two chances in points, with its interval and its sign. */
export function points({ estimate, low, high }) {
  const signed = (share) => {
    const whole = Math.sign(share) * Math.round(Math.abs(inPercent(share)));
    return `${whole > 0 ? "+" : whole < 0 ? "−" : ""}${number(Math.abs(whole))}`;
  };
  return t("pointsBetween", { by: signed(estimate), low: signed(low), high: signed(high) });
}

/** A quantity of runs in which something happened: its median and how far 90 % of them go. */
export const quantile = ({ median, p90 }, unit, decimals) =>
  median === null
    ? t("notKnown")
    : t("medianAndMost", {
        median: `${number(median, decimals)}\u00a0${unit}`,
        most: p90 === null ? t("notKnown") : `${number(p90, decimals)}\u00a0${unit}`,
      });

/** How many runs of the room a verdict rests on. */
export const wholeRuns = ({ motions, samples }) => number(motions * samples);

/** What a verdict rests on: runs under many earthquakes, or under a single record or other motion. */
export const basis = ({ motions, samples, runs, seed, seconds }) =>
  t(motions === 1 ? "basisOfOneMotion" : "basisOfRoom", {
    whole: wholeRuns({ motions, samples }),
    motions: number(motions),
    each: number(samples),
    runs: number(runs),
    seed: String(seed),
    seconds: number(seconds, 1),
  });

/** A text that begins large. */
export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
