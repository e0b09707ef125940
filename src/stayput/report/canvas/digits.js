// Numbers as they are shown.

/** A number rounded to so many decimals; one that rounds to zero has no sign. */
export const rounded = (value, decimals) => Number(value.toFixed(decimals)) + 0;

/** A number with so many decimals. */
export const digits = (value, decimals) => rounded(value, decimals).toFixed(decimals).replace("-", "\u2212");
