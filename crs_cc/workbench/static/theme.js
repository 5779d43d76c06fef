/** Light and dark: the colours of the page for those that draw. */

const NAMES = ["sky", "sky-low", "floor", "grid", "grid-strong", "edge", "text", "muted", "accent", "panel", "danger", "track", "known"];

/** @returns {Record<string, string>} */
export function palette() {
  const probe = document.createElement("i");
  document.body.append(probe);
  const of = (name) => {
    probe.style.color = `var(--${name})`; // resolves light-dark(), which a variable's text does not
    return getComputedStyle(probe).color;
  };
  const found = Object.fromEntries(NAMES.map((name) => [name, of(name)]));
  probe.remove();
  return found;
}

/** Light, dark, or as the system is. @returns {string} */
export const theme = () => document.documentElement.dataset.theme ?? "auto";

/** @param {string} name */
export function setTheme(name) {
  if (name === "auto") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = name;
  try {
    localStorage.setItem("crs-theme", name);
  } catch {
    // a page from disk may have no storage
  }
}

export function restoreTheme() {
  try {
    setTheme(localStorage.getItem("crs-theme") ?? "auto");
  } catch {
    // as above
  }
}

/** Whether the user prefers reduced motion. */
export const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
