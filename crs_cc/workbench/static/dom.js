/** Elements of the page, and its icons. */

/** @param {string} id @returns {any} */
export const part = (id) => document.getElementById(id);

/**
 * Make an element. Properties that begin with `on` are listeners, those with a dash attributes.
 * @param {string} tag a name and classes: `button.primary`
 * @param {Record<string, any>} properties
 * @param {...(Node | string | null)} children
 * @returns {any}
 */
export function el(tag, properties = {}, ...children) {
  const [name, ...classes] = tag.split(".");
  const made = document.createElement(name);
  if (classes.length) made.className = classes.join(" ");
  for (const [key, value] of Object.entries(properties)) {
    if (value === undefined || value === null) continue;
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (key.includes("-") || key === "role") made.setAttribute(key, String(value));
    else /** @type {any} */ (made)[key] = value;
  }
  made.append(...children.filter((each) => each !== null && each !== undefined));
  return made;
}

const SHAPES = {
  play: "M7 4.5v15l12-7.5z",
  pause: "M6.5 5h4v14h-4zM13.5 5h4v14h-4z",
  next: "M6 5l8 7-8 7zM15.500 5h2.500v14h-2.500z",
  previous: "M18 5l-8 7 8 7zM6 5h2.500v14H6z",
  first: "M20 5l-7 7 7 7zM13 5l-7 7 7 7zM3.500 5h2v14h-2z",
  last: "M6 5l8 7-8 7zM16 5h2v14h-2z",
  loop: "M7 7h9V4l5 4.5L16 13v-3H7v4H4V9a2 2 0 0 1 3-2zM17 17H8v3l-5-4.5L8 11v3h9v-4h3v5a2 2 0 0 1-3 2z",
  over: "M4 15a8 8 0 0 1 14.5-4.5L21 8v7h-7l2.6-2.6A5 5 0 0 0 7 15zM10 16h4v4h-4z",
  into: "M10.5 3h3v7H17l-5 6-5-6h3.5zM10 17.5h4v4h-4z",
  out: "M10.5 16h3V9H17l-5-6-5 6h3.5zM10 17.5h4v4h-4z",
  back: "M20 15a8 8 0 0 0-14.5-4.5L3 8v7h7l-2.6-2.6A5 5 0 0 1 17 15zM10 16h4v4h-4z",
  intoback: "M10.500 16h3V9H17l-5-6-5 6h3.500zM4 18h16v2.500H4z",
  outback: "M4 3.500h16V6H4zM13.500 21h-3v-7H7l5-6 5 6h-3.500z",
  wide: "M3 5h18v14H3zM5.500 7.500v9H10v-9zM12 7.500v9h6.500v-9z",
  resume: "M5 5h2.500v14H5zM9.500 5l10 7-10 7z",
  reverse: "M19 5h-2.500v14H19zM14.500 5l-10 7 10 7z",
  camera: "M9 4h6l1.5 2.5H20a1 1 0 0 1 1 1V19a1 1 0 0 1-1 1H4a1 1 0 0 1-1-1V7.500a1 1 0 0 1 1-1h3.500zM12 9a4.200 4.200 0 1 0 0 8.400A4.200 4.200 0 0 0 12 9z",
  more: "M5 10a2 2 0 1 1 0 4 2 2 0 0 1 0-4zM12 10a2 2 0 1 1 0 4 2 2 0 0 1 0-4zM19 10a2 2 0 1 1 0 4 2 2 0 0 1 0-4z",
  split: "M3 4h8v7H3zM13 4h8v7h-8zM3 13h8v7H3zM13 13h8v7h-8z",
  single: "M3 4h18v16H3z",
  theme: "M12 3a9 9 0 1 0 0 18zM12 3a9 9 0 0 1 0 18v-2a7 7 0 0 0 0-14z",
  help: "M12 2a10 10 0 1 0 0 20 10 10 0 0 0 0-20zm-1 14.500h2.200v2.200H11zM8.300 9.300C8.300 7 10 5.600 12.100 5.600c2.200 0 3.800 1.300 3.800 3.200 0 2.500-2.700 2.900-2.700 5.200H11c0-3.300 2.700-3.500 2.700-5.100 0-.800-.600-1.300-1.600-1.300s-1.700.600-1.700 1.700z",
  heat: "M12 2c1 4 5 6 5 11a5 5 0 0 1-10 0c0-2 1-3.500 2-4.500 0 2 1 2.500 1.500 2.500C11.500 8 10.500 5 12 2z",
  share: "M18 3a3 3 0 1 1-2.300 4.900L9.300 11.100a3 3 0 0 1 0 1.800l6.400 3.200a3 3 0 1 1-.900 1.800l-6.400-3.200a3 3 0 1 1 0-5.400l6.400-3.200A3 3 0 0 1 18 3z",
};

/** An icon. @param {keyof typeof SHAPES} name @returns {SVGElement} */
export function icon(name) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", SHAPES[name]);
  path.setAttribute("fill-rule", "evenodd");
  svg.append(path);
  return svg;
}

/**
 * A button with an icon, a word, or both; its title names its key.
 * @param {{icon?: keyof typeof SHAPES, text?: string, title: string, key?: string,
 *   className?: string, onclick: (event: Event) => void}} options
 * @returns {HTMLButtonElement}
 */
export function button(options) {
  const title = options.key ? `${options.title} (${options.key})` : options.title;
  return el(
    "button",
    { type: "button", title, "aria-label": title, className: options.className, onclick: options.onclick },
    options.icon ? icon(options.icon) : null,
    options.text ? el("span", {}, options.text) : null,
  );
}

/** Put children in place of those that are there. @param {Element} parent @param {...(Node | string)} children */
export const fill = (parent, ...children) => parent.replaceChildren(...children);

/** A time for people. @param {number} time [s] */
export const clockText = (time) => `${time.toFixed(time < 1000 ? 3 : 2)} s`;
