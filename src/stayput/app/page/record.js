// What is shown of a record: how long and how strong it is, and its trace.

import { svg } from "./dom.js";
import { classOf, published } from "./panel_shaking.js";
import { both, number, t } from "./words.js";

/** Its duration, peak and intensity. */
export function inNumbers({ duration_s: duration, pga_m_s2: peak, intensity }) {
  const strength =
    intensity === null
      ? ""
      : t("recordStrength", { at: number(published(intensity), 1), class: both(classOf(intensity).label) });
  return `${number(duration, 0)}\u00a0s, ${number(peak, 2)}\u00a0m/s²${strength}`;
}

/** Its trace: the lowest and the highest value in each of many short times. */
export function picture({ time_s, low_m_s2, high_m_s2 }) {
  const most = Math.max(...high_m_s2, ...low_m_s2.map((one) => -one), 1e-9),
    end = time_s.at(-1) || 1;
  const at = (values) =>
    values.map((one, i) => `${((300 * time_s[i]) / end).toFixed(1)} ${(24 - (22 * one) / most).toFixed(1)}`);
  return svg(
    "svg",
    { viewBox: "0 0 300 48", class: "trace", role: "img", "aria-label": t("recordAlt") },
    svg("path", { d: `M${at(high_m_s2).join("L")}L${at(low_m_s2).reverse().join("L")}Z` }),
  );
}
