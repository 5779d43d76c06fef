/** The source of a program: its current line, its breakpoints, and what has gone wrong there. */
import { el, fill } from "crs/dom.js";
import { highlight } from "crs/highlight.js";
import { stopEditor } from "crs/debug/stop_editor.js";

const TAB = "    ";

/** A line as it is shown. @param {string} text */
const expanded = (text) => text.replaceAll("\t", TAB);

export class Source {
  /** @param {any} model @param {any} page */
  constructor(model, page) {
    this.model = model;
    this.page = page;
    this.element = el("div.listing", { role: "group", "aria-label": "source", tabIndex: 0, onkeydown: (event) => this.key(event) });
    this.known = new Map();
    this.file = "";
    /** The line that the keyboard is at; that of the program until it is moved. */
    this.cursor = 0;
  }

  clear() {
    this.known.clear();
    this.file = "";
  }

  /** Show a file, and a line of it. @param {string} file @param {number} line 0 for none */
  async open(file, line) {
    if (!this.known.has(file)) {
      const answer = await this.model.request("source", { file });
      if (!answer) return;
      this.known.set(file, answer);
    }
    if (this.file !== file) {
      this.file = file;
      fill(this.element, ...this.lines(this.known.get(file)));
    }
    if (line) this.cursor = line;
    this.mark(line);
  }

  lines({ file, lines, code }) {
    const has = new Set(code);
    let isComment = false;
    return lines.map((text, index) => {
      const line = index + 1;
      const found = highlight(expanded(text), isComment);
      isComment = found.isComment;
      const gutter = el("button.gutter", {
        type: "button",
        tabIndex: -1,
        "aria-label": `breakpoint at line ${line}`,
        title: has.has(line) ? "Click: breakpoint on or off. Right click: condition, log point, run to here" : "",
        onclick: () => this.toggle(file, line),
        oncontextmenu: (event) => {
          event.preventDefault();
          this.edit(line);
        },
      }, String(line));
      const content = el("code", {}, ...found.parts.map(([part, kind]) => (kind ? el(`span.${kind}`, {}, part) : part)));
      const row = el(has.has(line) ? "div.line" : "div.line.idle", { onclick: () => this.move(line) }, gutter, content);
      row.dataset.line = String(line);
      return row;
    });
  }

  /** The row of a line; forms and reports are between them. */
  row(line) {
    return this.element.querySelector(`:scope > .line[data-line="${line}"]`);
  }

  async toggle(file, line) {
    const done = await this.model.request("break", { file, line });
    if (done?.note) this.model.notify(done.note);
  }

  /** Edit the breakpoint of a line, below it. */
  edit(line) {
    this.editor?.remove();
    const point = this.points().get(line);
    this.editor = stopEditor(this.model, this.page, this.file, line, point);
    this.row(line)?.after(this.editor);
    this.editor.querySelector("input")?.focus();
  }

  points() {
    const here = (this.model.position?.breakpoints ?? []).filter((each) => each.file === this.file);
    return new Map(here.map((each) => [each.line, each]));
  }

  /** Mark the program's current line, breakpoints, and a fault. @param {number} line */
  mark(line) {
    const { file, innermost, error } = this.model.position ?? {};
    const points = this.points();
    for (const old of this.element.querySelectorAll(".fault, .fault-mark")) old.remove();
    this.element.querySelectorAll(":scope > .line").forEach((row, index) => {
      const point = points.get(index + 1);
      row.classList.toggle("stop", Boolean(point));
      row.classList.toggle("off", Boolean(point && !point.enabled));
      row.classList.toggle("asks", Boolean(point && (point.condition || point.robot >= 0 || point.ignore)));
      row.classList.toggle("logs", Boolean(point?.log));
      row.classList.toggle("current", this.file === file && index + 1 === line);
      row.classList.toggle("outer", innermost === false);
      row.classList.toggle("cursor", index + 1 === this.cursor);
    });
    if (error && error.file === this.file) this.showFault(error);
    if (line && this.file === file) this.scrollTo(line);
  }

  /** What has gone wrong, at the expression. */
  showFault(error) {
    const row = this.row(error.line);
    if (!row) return;
    if (error.length) {
      const text = this.known.get(this.file).lines[error.line - 1];
      const mark = el("span.fault-mark");
      mark.style.left = `calc(var(--gutter) + ${expanded(text.slice(0, error.column - 1)).length}ch)`;
      mark.style.width = `${error.length}ch`;
      row.append(mark);
    }
    row.after(el("div.fault", { role: "alert" }, el("b", {}, error.text),
      ...error.values.map(([name, value]) => el("code", {}, `${name} = ${value}`)),
      ...error.notes.map((note) => el("p", {}, note))));
  }

  scrollTo(line) {
    const row = this.row(line);
    if (!row) return;
    const [box, at] = [this.element.getBoundingClientRect(), row.getBoundingClientRect()];
    const low = row.nextElementSibling?.matches(".fault") ? 110 : 30;
    if (at.top < box.top + 20 || at.bottom > box.bottom - low) this.element.scrollTop += at.top - box.top - box.height / 3;
  }

  /** Move the keyboard's line. */
  move(line) {
    const last = this.known.get(this.file)?.lines.length ?? 0;
    this.row(this.cursor)?.classList.remove("cursor");
    this.cursor = Math.min(last, Math.max(1, line));
    this.row(this.cursor)?.classList.add("cursor");
  }

  key(event) {
    if (event.target !== this.element) return;
    const ways = { ArrowUp: -1, ArrowDown: 1, PageUp: -15, PageDown: 15 };
    if (ways[event.key]) {
      this.move(this.cursor + ways[event.key]);
      this.row(this.cursor)?.scrollIntoView({ block: "nearest" });
    } else if (event.key === "Enter") this.edit(this.cursor);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
