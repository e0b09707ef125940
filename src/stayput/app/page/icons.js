// The page's pictures for buttons: drawn here, so that no font is needed.

import { svg } from "./dom.js";

const PATHS = {
  play: "M7 4l13 8-13 8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  again: "M12 4a8 8 0 1 0 7.7 10h-2.6A5.5 5.5 0 1 1 12 6.5V10l6-4.8L12 .5z",
  scene: "M3 20V9l9-6 9 6v11h-6v-6H9v6z",
  see: "M12 5C6 5 2.5 10 1.500 12 2.500 14 6 19 12 19s9.500-5 10.500-7C21.500 10 18 5 12 5zm0 11a4 4 0 1 1 0-8 4 4 0 0 1 0 8z",
  understand: "M3 3h2.500v15.500H21V21H3zM7 13h3v4H7zm4.500-5h3v9h-3zM16 5h3v12h-3z",
  keep: "M11 3h2v9l3.500-3.500L18 10l-6 6-6-6 1.500-1.500L11 12zM4 18h16v3H4z",
  light:
    "M12 7a5 5 0 1 0 0 10 5 5 0 0 0 0-10zM11 1h2v4h-2zM11 19h2v4h-2zM1 11h4v2H1zM19 11h4v2h-4zM4.200 2.800l2.800 2.800-1.400 1.400-2.800-2.800zM18.400 17l2.800 2.800-1.400 1.400-2.800-2.800zM2.800 19.800L5.600 17 7 18.400l-2.800 2.800zM17 5.600l2.800-2.800 1.400 1.400L18.400 7z",
  dark: "M20.500 14.500A9 9 0 0 1 9.500 3.500a9 9 0 1 0 11 11z",
};

/** An icon of this name, which a screen reader passes over. */
export function icon(name) {
  return svg(
    "svg",
    { class: "icon", viewBox: "0 0 24 24", "aria-hidden": "true", focusable: "false" },
    svg("path", { d: PATHS[name], "fill-rule": "evenodd" }),
  );
}
