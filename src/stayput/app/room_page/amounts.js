// Chances and what goes with them, as text.

import { inPercent, number, t } from "../words.js";

/** The interval of a difference of two chances in points, where it says in which direction. */
export function points({ low, high }) {
  if (low <= 0 && high >= 0) return t("noClearDifference");
  const signed = (share) => {
    const whole = Math.sign(share) * Math.round(Math.abs(inPercent(share)));
    return `${whole > 0 ? "+" : whole < 0 ? "−" : ""}${number(Math.abs(whole))}`;
  };
  return t("pointsBetween", { low: signed(low), high: signed(high) });
}

/** A quantity of runs in which something happened: its median and how far 90 % of them go. */
export const quantile = ({ median, p90 }, unit, decimals) =>
  median === null
    ? t("notKnown")
    : t("medianAndMost", {
        median: `${number(median, decimals)}\u00a0${unit}`,
        most: p90 === null ? t("notKnown") : `${number(p90, decimals)}\u00a0${unit}`,
      });

/** What a verdict rests on: runs under many earthquakes, or under a single record or other motion. */
export const basis = ({ motions, whole, runs, seed, seconds }) =>
  t(motions === 1 ? "basisOfOneMotion" : "basisOfRoom", {
    whole: number(whole),
    motions: number(Math.min(motions, whole)),
    runs: number(runs),
    seed: String(seed),
    seconds: number(seconds, 1),
  });

/** A text that begins large. */
export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
