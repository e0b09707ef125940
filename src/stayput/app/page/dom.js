// Elements made in one call, and the few things that are asked of the page itself.

const SVG = "http://www.w3.org/2000/svg";

/** The element of this id. */
export const part = (id) => document.getElementById(id);

/**
 * An HTML element: properties by name, "class", "text", data and aria attributes, "on…" listeners; then
 * children.
 */
export function el(tag, properties = {}, ...children) {
  return filled(document.createElement(tag), properties, children);
}

/** An SVG element, made alike. */
export function svg(tag, properties = {}, ...children) {
  return filled(document.createElementNS(SVG, tag), properties, children);
}

function filled(element, properties, children) {
  for (const [name, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (name === "text") element.textContent = value;
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** Replaces the content of an element. */
export const fill = (element, ...children) => element.replaceChildren(...children.flat());

/** Whether one screen is shown at a time. */
export const narrow = () => matchMedia("(max-width: 63.99rem)").matches;

/** How wide a chart in this element is drawn, so that its letters have their own size [px]. */
export const widthFor = (element) => Math.max(300, Math.min(640, element.clientWidth || innerWidth - 64));

/** A function that waits until it has not been called for so many milliseconds; its `cancel` ends the waiting. */
export function settled(milliseconds, work) {
  let timer = 0;
  const wait = (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => work(...values), milliseconds);
  };
  wait.cancel = () => clearTimeout(timer);
  return wait;
}

/** Offers a text or blob as a file. */
export function offer(content, name, type) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = el("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Lets a button copy the address in a field, which is chosen as a whole where it is entered; "done" is called after. */
export function copying(button, field, done) {
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(field.value);
    } catch {
      field.select();
      document.execCommand("copy");
    }
    done();
  });
  field.addEventListener("focus", () => field.select());
}
