/** The source of the selected robot: the current line, breakpoints by click, steps either way. */
import { button, el, fill } from "crs/dom.js";
import { highlight } from "crs/highlight.js";

const STEPS = [
  ["reverse-step", "back", "A line back, into calls", "Shift+F11"],
  ["reverse-next", "previous", "A line back, over calls", "Shift+F10"],
  ["next", "over", "To the next line, over calls", "F10"],
  ["step", "into", "To the next line, into calls", "F11"],
  ["finish", "out", "Out of this function", "Shift+F12"],
];

/** @type {import("./index.js").Panel} */
export const code = {
  id: "code",
  title: "Code",
  side: "right",
  needs: "debug",
  make(root, model, _look, page) {
    const files = el("select", { "aria-label": "file", onchange: () => open(files.value, 0) });
    const run = (line) => page.console(line);
    const bar = el("div.bar", {},
      files,
      el("span.spacer"),
      button({ icon: "reverse", title: "Run back to the breakpoint before", key: "Shift+F5", onclick: () => run("reverse-continue") }),
      ...STEPS.map(([line, name, title, key]) => button({ icon: name, title, key, onclick: () => run(line) })),
      button({ icon: "resume", title: "Run to the next breakpoint", key: "F5", onclick: () => run("continue") }));
    const status = el("p.status", { role: "status" });
    const source = el("div.source", { role: "table", "aria-label": "source", tabIndex: 0 });
    const stack = el("div.stack");
    const variables = el("table.variables");
    root.append(bar, status, source, el("div.below", {}, el("h3", {}, "Stack"), stack, el("h3", {}, "Variables"), variables));
    const known = new Map();
    let shown = "";

    const open = async (file, line) => {
      if (!known.has(file)) {
        const answer = await model.ask("source", { file });
        if (!answer) return;
        known.set(file, answer);
      }
      if (shown !== file) {
        shown = file;
        fill(source, ...lines(known.get(file)));
      }
      files.value = file;
      mark(line);
    };

    const lines = ({ file, lines: texts, code: withCode }) => {
      const has = new Set(withCode);
      let isComment = false;
      return texts.map((text, index) => {
        const number = index + 1;
        const found = highlight(text.replaceAll("\t", "    "), isComment);
        isComment = found.isComment;
        const gutter = el("button.gutter", {
          type: "button",
          tabIndex: -1,
          "aria-label": `breakpoint at line ${number}`,
          title: has.has(number) ? "Click to set or remove a breakpoint" : "",
          onclick: () => model.ask("break", { file, line: number }).then((done) => done?.note && model.say(done.note)),
        }, String(number));
        const content = el("code", {}, ...found.parts.map(([part, kind]) => (kind ? el(`span.${kind}`, {}, part) : part)));
        return el(has.has(number) ? "div.line" : "div.line.idle", {}, gutter, content);
      });
    };

    const mark = (line) => {
      const { breakpoints = [], file, innermost } = model.where ?? {};
      const points = new Map(breakpoints.filter((each) => each.file === shown).map((each) => [each.line, each]));
      [...source.children].forEach((row, index) => {
        const point = points.get(index + 1);
        row.classList.toggle("stop", Boolean(point));
        row.classList.toggle("off", Boolean(point && !point.enabled));
        row.classList.toggle("current", shown === file && index + 1 === line);
        row.classList.toggle("outer", !innermost);
      });
      const current = source.children[line - 1];
      if (current && line) {
        const box = source.getBoundingClientRect();
        const at = current.getBoundingClientRect();
        if (at.top < box.top + 30 || at.bottom > box.bottom - 30) {
          source.scrollTop += at.top - box.top - box.height / 2.5;
        }
      }
    };

    const draw = () => {
      const { where } = model;
      if (!where) return;
      if (where.files.join() !== [...files.options].map((each) => each.value).join()) {
        fill(files, ...where.files.map((file) => el("option", { value: file }, file.split("/").at(-1))));
      }
      open(where.file, where.line);
      fill(stack, ...where.frames.filter((each) => !each.library).map((each) =>
        el("button.frame", { type: "button", "aria-pressed": String(each.current), onclick: () => run(`frame ${each.number}`) },
          el("b", {}, each.function), ` ${each.file}:${each.line}`)));
      fill(variables, ...where.variables.map(({ name, value, type, scope }) =>
        el("tr", { title: `${type} ${name} (${scope})` }, el("th", {}, name), el("td", {}, value), el("td.type", {}, type))));
      state();
    };

    const state = () => {
      const { playing, busy, halt } = model.state;
      const isOn = playing || busy;
      root.classList.toggle("running", isOn);
      const name = model.where?.frames.find((each) => each.current)?.function ?? "";
      const text = isOn ? "running: pause to see where the program stands" : halt.text || (name ? `stopped in ${name}` : "");
      status.textContent = text;
      status.classList.toggle("bad", !isOn && halt.reason === "error");
    };

    model.on("hello", () => {
      known.clear();
      shown = "";
    });
    model.on("where", draw);
    model.on("state", state);
  },
};
