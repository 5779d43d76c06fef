/** The drawer over the time line: wide panels (the table of robots, the plot, messages), one at a time. */
import { el } from "crs/dom.js";

export class Drawer {
  /** @param {HTMLElement} root the foot of the page @param {any} model */
  constructor(root, model) {
    this.model = model;
    this.root = root;
    this.opened = "";
    this.bar = el("div.group.drawers", { role: "group", "aria-label": "drawers" });
    this.box = el("section.drawer", { id: "drawer" });
    this.box.hidden = true;
    root.querySelector(".transport .spacer")?.after(this.bar);
    root.before(this.box);
  }

  /** Add a panel. @param {any} panel @param {HTMLElement} section */
  add(panel, section) {
    section.hidden = true;
    section.setAttribute("aria-label", panel.title);
    this.box.append(section);
    const button = el("button", { type: "button", id: `drawer-${panel.id}`, title: `${panel.summary} (${panel.key.toUpperCase()})`,
      "aria-expanded": "false", "aria-controls": section.id, onclick: () => this.toggle(panel.id) }, panel.title);
    this.bar.append(button);
  }

  /** Open a panel, or close it if it is open. */
  toggle(id) {
    if (this.box.querySelector(`#panel-${id}`)) this.open(this.opened === id ? "" : id);
  }

  /** @param {string} id which panel; empty for none */
  open(id) {
    this.opened = id;
    this.box.hidden = !id;
    for (const section of this.box.children) section.hidden = section.id !== `panel-${id}`;
    for (const button of this.bar.children) {
      const isOpen = button.id === `drawer-${id}`;
      button.setAttribute("aria-expanded", String(isOpen));
      button.setAttribute("aria-pressed", String(isOpen));
    }
    this.model.tell("look");
  }
}
