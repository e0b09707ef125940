// Histories as they are sent: numbers, or those of 32 bits in base 64.

/** The numbers of a history. */
export const numbers = (sent) => (typeof sent === "string" ? ofBase64(sent) : Float64Array.from(sent));

function ofBase64(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true));
}
