// What the browser remembers of the reader's choices: theme, language, speed, care, the building.

/** A memory in one of the browser's storages: a text under a name, or null. */
const memory = (storage) => ({
  recalled(name) {
    try {
      return storage().getItem(`stayput-${name}`);
    } catch {
      return null;
    }
  },
  remember(name, value) {
    try {
      storage().setItem(`stayput-${name}`, value);
    } catch {
      /* private mode: not remembered */
    }
  },
});

const { recalled, remember } = memory(() => localStorage);
export { recalled, remember };

/** What this tab remembers, until it is closed. */
export const tab = memory(() => sessionStorage);
