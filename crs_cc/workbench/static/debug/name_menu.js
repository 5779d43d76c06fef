/** What can be asked of a name in the source: a double click shows its value, and why, plot and watch. */
import { button, el } from "crs/dom.js";
import { OWN } from "crs/instruments.js";

/**
 * Let double clicks on names in an element show the menu.
 * @param {HTMLElement} listing @param {any} model @param {any} page
 */
export function offerNames(listing, model, page) {
  /** @type {HTMLElement | null} */
  let menu = null;
  const close = () => {
    menu?.remove();
    menu = null;
  };

  const show = async (name, row, x) => {
    close();
    const value = el("code", {}, name);
    const act = (text, title, does) => button({ text, title, onclick: () => {
      close();
      does();
    } });
    const line = page.code.passing;
    const plotted = OWN.includes(name) ? `(${name})` : name;
    const made = el("div.name-menu", { role: "toolbar", "aria-label": `questions about ${name}` }, value,
      act("why", "Where its value came from", () => page.why(name)),
      act("plot", "Plot its history under the timeline", () => page.plot(plotted)),
      line ? act("plot here", "Its values each time this line was reached", () => page.plot(`${name} at ${page.code.file}:${row.dataset.line}`)) : null,
      act("watch", "Show it at every stop", () => page.console(`display ${name}`)));
    made.style.left = `${Math.max(4, x)}px`;
    made.style.top = `${row.offsetTop + row.offsetHeight}px`;
    menu = made;
    listing.append(made);
    const { values, texts } = (await model.request("inspect", { robot: model.state.robot, expressions: name })) ?? { values: [""], texts: [null] };
    value.textContent = texts[0] !== null || typeof values[0] === "number" ? `${name} = ${texts[0] ?? values[0]}` : `${name}: ${values[0]}`;
  };

  listing.addEventListener("dblclick", (event) => {
    const row = /** @type {HTMLElement} */ (event.target).closest?.(".line");
    const name = getSelection()?.toString().trim() ?? "";
    if (!row || !/^[A-Za-z_]\w*$/.test(name) || !model.can("debug")) return;
    show(name, row, event.clientX - listing.getBoundingClientRect().left + listing.scrollLeft - 40);
  });
  listing.addEventListener("pointerdown", (event) => {
    if (!menu?.contains(/** @type {Node} */ (event.target))) close();
  });
  listing.addEventListener("keydown", (event) => {
    if (event.key === "Escape") close();
  });
  for (const kind of ["position", "hello"]) model.on(kind, close);
}
