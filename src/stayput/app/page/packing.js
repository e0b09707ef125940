// Texts in links: compressed, in letters that an address may have.

/** Bytes that have gone through a stream. */
const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

/** A text or bytes as letters, digits, "-" and "_". */
export async function packed(content) {
  const bytes = new Uint8Array(await through(content, new CompressionStream("deflate-raw")));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The bytes of `packed`; an error where it is none. */
export function unpackedBytes(letters) {
  const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) =>
    letter.charCodeAt(0),
  );
  return through(bytes, new DecompressionStream("deflate-raw"));
}

/** The text of `packed`; an error where it is none. */
export const unpacked = async (letters) => utf8(await unpackedBytes(letters));

/** The text of bytes in UTF-8; an error where they are something else. */
export const utf8 = (bytes) => new TextDecoder("utf-8", { fatal: true }).decode(bytes);
