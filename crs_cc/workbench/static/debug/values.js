/** Variables, watched expressions, `State[]`, robot and world: rows that unfold, can be set, and asked of their past. */
import { button, el, fill } from "crs/dom.js";
import { OWN } from "crs/instruments.js";

export class Values {
  /** @param {any} model @param {any} page */
  constructor(model, page) {
    this.model = model;
    this.page = page;
    this.tree = el("div.values", { role: "tree", "aria-label": "variables", tabIndex: -1 });
    this.watch = el("input", { type: "text", placeholder: "watch an expression: State[17], p->next, a[0..4]", "aria-label": "expression to watch", spellcheck: false, autocomplete: "off" });
    this.wrong = el("p.field-error", { role: "alert" });
    const form = el("form.watch-form", { onsubmit: (event) => this.addWatch(event), onkeydown: (event) => event.stopPropagation() },
      this.watch, button({ text: "Watch", title: "Show it at every stop", onclick: () => form.requestSubmit() }), this.wrong);
    this.element = el("div", {}, form, this.tree);
    this.unfolded = new Set(["watched", "locals"]);
    this.stop = "";
    /** @type {Map<string, string>} what was shown at the stop before, and is now */
    this.before = new Map();
    this.now = new Map();
    this.isAsking = this.isStale = false;
  }

  async addWatch(event) {
    event.preventDefault();
    const text = this.watch.value.trim();
    if (!text) return;
    const { error } = await this.page.console(`display ${text}`, true);
    this.wrong.textContent = error;
    if (!error) this.watch.value = "";
  }

  /** Ask for what is unfolded, and show it. */
  async load() {
    const { model } = this;
    if (!model.position || this.tree.querySelector("input.new-value")) return;
    if (this.isAsking) {
      this.isStale = true;
      return;
    }
    this.isAsking = true;
    const rows = await model.request("values", { unfolded: this.keys() });
    this.isAsking = false;
    if (this.isStale) {
      this.isStale = false;
      this.load();
      return;
    }
    if (!Array.isArray(rows) || !rows.length) return;
    const { t, statement, robot } = model.position;
    const stop = `${t} ${statement} ${robot}`;
    if (stop !== this.stop) {
      this.stop = stop;
      this.before = this.now;
      this.now = new Map();
    }
    const focused = /** @type {HTMLElement | null} */ (document.activeElement?.closest?.(".value"))?.dataset.key;
    fill(this.tree, ...rows.flatMap((row) => this.rows(row, 1)));
    if (focused) this.tree.querySelector(`[data-key="${CSS.escape(focused)}"] .fold`)?.focus();
  }

  /** The keys of what is unfolded, as many as a command may hold. */
  keys() {
    let text = "";
    for (const key of this.unfolded) if (text.length + key.length < 3900) text += `${text && "\n"}${key}`;
    return text;
  }

  /** @returns {HTMLElement[]} */
  rows(row, level) {
    const isOpen = this.unfolded.has(row.key);
    const text = row.error ?? row.value ?? "";
    const old = this.before.get(row.key);
    if (row.value !== undefined) this.now.set(row.key, row.value);
    const isChanged = old !== undefined && row.value !== undefined && old !== row.value;
    const twist = row.parts
      ? el("button.fold", { type: "button", "aria-label": `${isOpen ? "fold" : "unfold"} ${row.name}`, onclick: () => this.fold(row.key) }, isOpen ? "▾" : "▸")
      : el("span.fold");
    const value = el("span.content", { title: isChanged ? `was ${old}` : (row.type ?? "") }, text);
    const element = el("div.value", { role: "treeitem", "aria-level": level, title: [row.type, row.name, row.scope && `(${row.scope})`].filter(Boolean).join(" ") },
      twist, el("span.name", {}, row.name), value);
    element.dataset.key = row.key;
    element.style.setProperty("--level", String(level));
    if (row.parts) element.setAttribute("aria-expanded", String(isOpen));
    element.classList.toggle("group", level === 1);
    element.classList.toggle("changed", isChanged);
    element.classList.toggle("bad", Boolean(row.error));
    if (row.parts) element.querySelector(".name").addEventListener("click", () => this.fold(row.key));
    if (row.set && this.model.can("debug")) {
      value.classList.add("settable");
      value.tabIndex = 0;
      value.setAttribute("role", "button");
      value.setAttribute("aria-label", `${row.name} is ${text}; set it`);
      value.title += "  double-click to set";
      value.addEventListener("dblclick", () => this.set(row, value));
      value.addEventListener("keydown", (event) => {
        const question = element.querySelector(`.questions [data-key="${event.key.toUpperCase()}"]`);
        if (event.key !== "Enter" && !question) return;
        event.preventDefault();
        event.stopPropagation();
        if (question) question.click();
        else this.set(row, value);
      });
    }
    if (row.ask && this.model.can("debug")) element.append(this.questions(row));
    if (row.number) element.append(button({ text: "×", title: `Stop watching ${row.name}`, className: "small", onclick: () => this.page.console(`undisplay ${row.number}`) }));
    const parts = isOpen ? (row.children ?? []).flatMap((part) => this.rows(part, level + 1)) : [];
    return [element, ...parts];
  }

  /** What can be asked of the past of a value; keys while the focus is in its row. */
  questions(row) {
    const { page } = this;
    const small = (text, title, key, onclick) => el("button.small", { type: "button", tabIndex: -1, title: `${title} (${key})`, "aria-label": `${title}: ${row.name}`, "data-key": key, onclick }, text);
    const isOwn = row.scope === "local" || row.scope === "parameter";
    const line = isOwn ? page.code.passing : "";
    return el("span.questions", {},
      row.last ? small("‹", "Back to its last write", "<", () => page.console(`last ${row.ask}`)) : null,
      row.last ? small("›", "Forward to its next write", ">", () => page.console(`next ${row.ask}`)) : null,
      small("why", "Where this value came from", "?", () => page.why(row.ask)),
      small("plot", "Plot its history under the timeline", "G", () => page.plot(line ? `${row.ask} at ${line}` : OWN.includes(row.ask) ? `(${row.ask})` : row.ask)));
  }

  fold(key) {
    if (this.unfolded.has(key)) this.unfolded.delete(key);
    else this.unfolded.add(key);
    this.load();
  }

  /** Set a value in its place. */
  set(row, value) {
    const input = el("input.new-value", { type: "text", value: row.value.split(" ")[0], "aria-label": `new value of ${row.name}`, spellcheck: false });
    const wrong = el("span.field-error", { role: "alert" });
    let isOver = false;
    const end = () => {
      if (isOver) return; // a field that is removed loses the focus, too
      isOver = true;
      input.remove();
      this.load();
    };
    input.addEventListener("keydown", async (event) => {
      event.stopPropagation();
      if (event.key === "Escape") end();
      if (event.key !== "Enter") return;
      const { error } = await this.page.console(`set var ${row.set} = ${input.value}`, true);
      wrong.textContent = error;
      if (!error) end();
    });
    input.addEventListener("blur", () => wrong.textContent || end());
    fill(value, input, wrong);
    input.select();
  }
}
