/**
 * The wide panels: over the timeline those that are looked at one at a time (the table of robots,
 * messages, where values came from), under it what shares its axis (the plot).
 */
import { el } from "crs/dom.js";

const SMALL = "(max-width: 1100px), (max-height: 640px)"; // there is room for one of both

export class Drawer {
  /** @param {HTMLElement} root the foot of the page @param {any} model */
  constructor(root, model) {
    this.model = model;
    this.bar = el("div.group.drawers", { role: "group", "aria-label": "drawers" });
    this.box = el("section.drawer", { id: "drawer" });
    this.under = el("section.under", { id: "under" });
    this.box.hidden = this.under.hidden = true;
    root.querySelector(".transport .spacer")?.after(this.bar);
    root.before(this.box);
    root.append(this.under);
  }

  /** Add a panel. @param {any} panel @param {HTMLElement} section */
  add(panel, section) {
    section.hidden = true;
    section.setAttribute("aria-label", panel.title);
    (panel.side === "under" ? this.under : this.box).append(section);
    const button = el("button", { type: "button", id: `drawer-${panel.id}`, title: `${panel.summary} (${panel.key.toUpperCase()})`,
      "aria-expanded": "false", "aria-controls": section.id, onclick: () => this.toggle(panel.id) }, panel.title);
    this.bar.append(button);
  }

  /** Open a panel, or close it if it is open. @param {string} id */
  toggle(id) {
    const section = document.getElementById(`panel-${id}`);
    if (section) this.set(section, Boolean(section.hidden));
  }

  /** Open a panel. @param {string} id */
  open(id) {
    const section = document.getElementById(`panel-${id}`);
    if (section?.hidden) this.set(section, true);
  }

  /** Show a panel in its box, and no other one there; or close the box. @param {HTMLElement} section @param {boolean} isOpen */
  set(section, isOpen) {
    const box = /** @type {HTMLElement} */ (section.parentElement);
    if (isOpen && matchMedia(SMALL).matches) {
      const other = box === this.box ? this.under : this.box;
      for (const each of /** @type {Iterable<HTMLElement>} */ (other.children)) if (!each.hidden) this.set(each, false);
    }
    for (const each of /** @type {Iterable<HTMLElement>} */ (box.children)) {
      each.hidden = each !== section || !isOpen;
      const button = this.bar.querySelector(`#drawer-${each.id.replace("panel-", "")}`);
      button?.setAttribute("aria-expanded", String(!each.hidden));
      button?.setAttribute("aria-pressed", String(!each.hidden));
    }
    box.hidden = !isOpen;
    document.body.classList.toggle("plotted", !this.under.hidden);
    this.model.emit("look");
  }
}
