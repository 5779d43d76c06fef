/** The list of all that the run stops at, and the form for what is no line: events, values, calls. */
import { button, el, fill } from "crs/dom.js";

const KINDS = [
  ["break", "Function or robot call", "turn, or ws, get_sn"],
  ["watch", "Value changes", "speed, *p, map[3]"],
  ["wwatch", "Value is written", "speed, *p, map[3]"],
  ["rwatch", "Value is read", "speed, *p, map[3]"],
  ["awatch", "Value is read or written", "speed, *p, map[3]"],
  ["catch", "Event in the world", ""],
];
const ACCESS = { change: "changes", write: "is written", read: "is read", access: "is read or written" };

export class Stops {
  /** @param {any} model @param {any} page @param {(file: string, line: number) => void} edit */
  constructor(model, page, edit) {
    this.model = model;
    this.page = page;
    this.edit = edit;
    this.list = el("div.stops", { role: "list" });
    this.kind = el("select", { "aria-label": "what to stop at", onchange: () => this.offer() }, ...KINDS.map(([name, title]) => el("option", { value: name }, title)));
    this.names = el("datalist", { id: "functions" });
    this.text = el("input", { type: "text", "aria-label": "function or expression", spellcheck: false, autocomplete: "off" });
    this.text.setAttribute("list", "functions");
    this.event = el("select", { "aria-label": "event", hidden: true });
    this.condition = el("input", { type: "text", placeholder: "if: always", "aria-label": "condition", spellcheck: false, autocomplete: "off" });
    this.robot = el("select", { "aria-label": "robot" });
    this.wrong = el("p.field-error", { role: "alert" });
    const form = el("form.stop-form", { "aria-label": "stop at something else", onsubmit: (event) => this.add(event), onkeydown: (event) => event.stopPropagation() },
      this.kind, this.names, this.text, this.event, this.robot, this.condition, button({ text: "Add", title: "Add this breakpoint", onclick: () => form.requestSubmit() }), this.wrong);
    this.element = el("div", {}, this.list, form);
    this.offer();
  }

  /** Offer what fits the kind that is chosen. */
  async offer() {
    const [name, , hint] = KINDS.find(([each]) => each === this.kind.value) ?? KINDS[0];
    this.event.hidden = name !== "catch";
    this.text.hidden = name === "catch";
    this.text.placeholder = hint;
    this.wrong.textContent = "";
    if (!this.model.run) return;
    if (name === "catch" && !this.event.options.length) {
      const kinds = (await this.model.request("catchable")) ?? [];
      fill(this.event, ...kinds.map(([each, meaning]) => el("option", { value: each }, meaning)));
      this.event.value = "collision";
    }
    if (name === "break" && !this.names.children.length && this.model.can("debug")) {
      const found = await this.model.request("complete", { line: "break " });
      fill(this.names, ...(found?.words ?? []).map((word) => el("option", { value: word })));
    }
  }

  async add(event) {
    event.preventDefault();
    const what = this.kind.value === "catch" ? this.event.value : this.text.value.trim();
    const robot = this.robot.value ? ` robot ${this.robot.value}` : "";
    const condition = this.condition.value.trim() ? ` if ${this.condition.value.trim()}` : "";
    const { error } = await this.page.console(`${this.kind.value} ${what}${robot}${condition}`, true);
    this.wrong.textContent = error;
    if (!error) this.text.value = this.condition.value = "";
  }

  draw() {
    const { position, run } = this.model;
    const robots = run.rosters.at(-1)?.robots ?? [];
    if (this.robot.options.length !== robots.length + 1) {
      fill(this.robot, el("option", { value: "" }, "any robot"), ...robots.map((id) => el("option", { value: id }, id)));
      this.robot.hidden = robots.length < 2;
    }
    const rows = (position?.breakpoints ?? []).map((point) => this.row(point, robots));
    fill(this.list, ...(rows.length ? rows : [el("p.hint", {}, "None. Click a line number, or add one below.")]));
  }

  /** Mark when a breakpoint was hit, or would have been. */
  async find({ number }, title) {
    const error = await this.page.found.search("hits", { number }, title);
    if (error) this.model.notify(error, true);
  }

  row(point, robots) {
    const file = point.file.split("/").at(-1);
    const [title, what] = point.kind === "watchpoint" ? [point.text, ACCESS[point.access]] : point.kind === "catchpoint" ? [point.text, "happens"] : [point.line ? `${file}:${point.line}` : point.text, point.line ? "" : "is called"];
    const more = [what, point.condition && `if ${point.condition}`, point.robot >= 0 && robots[point.robot], point.log && `prints ${point.log}`, point.ignore && `ignores ${point.ignore}`, point.hits && (point.hits > 1 ? `hit ${point.hits} times` : "hit once")].filter(Boolean).join(", ");
    const shown = el("button.what", { type: "button", title: point.line ? "Show and edit it" : "", onclick: () => point.line && this.edit(point.file, point.line) }, el("b", {}, title), ` ${more}`);
    return el("div.stop-row", { role: "listitem" },
      el("input", { type: "checkbox", checked: point.enabled, "aria-label": `breakpoint ${point.number} is on`, onchange: () => this.page.console(`${point.enabled ? "disable" : "enable"} ${point.number}`) }),
      shown,
      this.model.can("debug") ? button({ text: "hits", title: `Mark all hits of breakpoint ${point.number} in the run so far on the timeline`, className: "small", onclick: () => this.find(point, title) }) : null,
      button({ text: "×", title: `Remove breakpoint ${point.number}`, className: "small", onclick: () => this.page.console(`delete ${point.number}`) }));
  }
}
