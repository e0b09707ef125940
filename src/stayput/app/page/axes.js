// Round numbers along an axis.

/** Round values between two ends, about so many of them. */
export function ticks(low, high, wanted) {
  if (!(high > low)) return [low];
  const rough = (high - low) / wanted,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((one) => one * power >= rough - 1e-12);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
    found.push(Number((k * step).toPrecision(10)));
  return found;
}

/** A class of the JMA scale, as short as the room for it asks. */
export const shortClass = (name, narrow) => {
  const short = name.replace(/^震度/, "");
  return narrow ? short.replace("-lower", "\u2212").replace("-upper", "+") : short;
};

/** A tick's number, as short as it can be. */
export const label = (value) => String(Number(value.toPrecision(6))).replace("-", "\u2212");
