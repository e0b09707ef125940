// What the browser remembers of the reader's choices: theme, language, speed, care, the building.

/** What was remembered under a name, or null. */
export function recalled(name) {
  try {
    return localStorage.getItem(`stayput-${name}`);
  } catch {
    return null;
  }
}

/** Remembers a text under a name. */
export function remember(name, value) {
  try {
    localStorage.setItem(`stayput-${name}`, value);
  } catch {
    /* private mode: not remembered */
  }
}
