// Histories as they are sent: numbers; those of 32 bits in base 64; or second differences of whole numbers.

/** The numbers of a history. */
export function numbers(sent) {
  if (typeof sent === "string") return ofBase64(sent);
  return sent.second_differences ? summed(sent) : Float64Array.from(sent);
}

function ofBase64(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true));
}

/** What has these second differences; "width" numbers stand for each time. */
function summed({ digits, width, second_differences: second }) {
  const steps = Array(width).fill(0),
    last = Array(width).fill(0),
    unit = 10 ** digits;
  return Float64Array.from(second, (one, i) => {
    steps[i % width] += one;
    last[i % width] += steps[i % width];
    return last[i % width] / unit;
  });
}
