// Texts in links: compressed, in letters that an address may have.

/** Bytes that have gone through a stream. */
const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

/** A text as letters, digits, "-" and "_". */
export async function packed(text) {
  const bytes = new Uint8Array(await through(text, new CompressionStream("deflate-raw")));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The text of `packed`; an error where it is none. */
export async function unpacked(letters) {
  const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) =>
    letter.charCodeAt(0),
  );
  return utf8(await through(bytes, new DecompressionStream("deflate-raw")));
}

/** The text of bytes in UTF-8; an error where they are something else. */
export const utf8 = (bytes) => new TextDecoder("utf-8", { fatal: true }).decode(bytes);
