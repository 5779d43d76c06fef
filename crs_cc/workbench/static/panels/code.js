/** The debugger: source, steps either way, variables, stack and breakpoints of the selected robot. */
import { button, el, fill } from "crs/dom.js";
import { offerNames } from "crs/debug/name_menu.js";
import { Source } from "crs/debug/source.js";
import { Stops } from "crs/debug/stops.js";
import { Values } from "crs/debug/values.js";

const BACK = [
  ["reverse-continue", "reverse", "Run back to the previous stop", "Shift+F5"],
  ["reverse-finish", "outback", "Back to the call of this function", "Shift+F8"],
  ["reverse-step", "intoback", "Previous line, into calls", "Shift+F11"],
  ["reverse-next", "back", "Previous line, over calls", "Shift+F10"],
];
const AHEAD = [
  ["next", "over", "Next line, over calls", "F10"],
  ["step", "into", "Next line, into calls", "F11"],
  ["finish", "out", "Out of this function", "F8"],
  ["continue", "resume", "Run to the next breakpoint", "F5"],
];
const WAIT = 250; // [ms] for which the time must be unchanged before programs follow it

/** @type {import("./index.js").Panel} */
export const code = {
  id: "code",
  title: "Code",
  side: "right",
  needs: "debug",
  make(root, model, _look, page) {
    const run = (line) => page.console(line);
    const steps = (rows) => el("div.group", {}, ...rows.map(([line, name, title, key]) => button({ icon: name, title, key, onclick: () => run(line) })));
    const source = new Source(model, page);
    offerNames(source.element, model, page);
    const values = new Values(model, page);
    const stops = new Stops(model, page, async (file, line) => {
      await source.open(file, 0);
      source.scrollTo(line);
      source.edit(line);
    });
    const robots = el("select.robots-of", { "aria-label": "robot", title: "The robot whose program is shown", onchange: () => model.select(Number(robots.value)) });
    const files = el("select", { "aria-label": "file", title: "Source file", onchange: () => source.open(files.value, lineIn(files.value)) });
    const status = el("p.status", { role: "status" });
    const showLines = button({ text: "Show lines", title: "Run the recorded programs up to this time, to see their current lines", onclick: () => model.request("sync") });
    const stack = el("div.stack", { role: "list" });
    const section = (title, ...parts) => el("details", { open: true }, el("summary", {}, title), ...parts);
    const count = el("span.count");
    const wide = button({ icon: "wide", title: "Widen or narrow this panel", key: "Z", onclick: () => page.code.zoom() });
    root.append(
      el("div.bar", {}, steps(BACK), steps(AHEAD), el("span.spacer"), wide),
      el("div.bar.where", {}, robots, files, status, showLines),
      source.element,
      el("div.below", {}, section("Variables", values.element), section("Stack", stack), section(el("span", {}, "Breakpoints ", count), stops.element)));
    let timer = 0;
    let asked = -1;

    const lineIn = (file) => (model.position?.file === file ? model.position.line : 0);
    const isHere = () => model.position !== null && Math.abs(model.position.t - model.state.t) < 1e-9;

    /** Let the programs of a recording follow the time when it stops. */
    const follow = () => {
      clearTimeout(timer);
      const { playing, busy, t } = model.state;
      const mayAsk = model.can("debug") && !playing && !busy && !isHere();
      showLines.hidden = !mayAsk;
      if (!mayAsk || model.run.follows === false || asked === t) return;
      timer = setTimeout(() => {
        if (model.clock.held !== null || !root.offsetParent) return follow();
        asked = t;
        model.request("sync");
      }, WAIT);
    };

    const draw = () => {
      const { position, run: about } = model;
      if (!position) return;
      if (position.files.join() !== [...files.options].map((each) => each.value).join()) {
        fill(files, ...position.files.map((file) => el("option", { value: file }, file.split("/").at(-1))));
      }
      files.hidden = position.files.length < 2;
      const names = about.rosters.at(-1)?.robots ?? [];
      if (names.join() !== [...robots.options].map((each) => each.textContent).join()) {
        fill(robots, ...names.map((id, row) => el("option", { value: String(row) }, id)));
      }
      robots.hidden = names.length < 2;
      robots.value = String(position.robot);
      files.value = position.file;
      source.open(position.file, position.line);
      fill(stack, ...(position.frames.length ? position.frames.map(frame) : [el("p.hint", {}, "The program is not running.")]));
      count.textContent = position.breakpoints.length ? `(${position.breakpoints.length})` : "";
      stops.draw();
      values.load();
      state();
    };

    const frame = ({ number, function: name, arguments: given, file, line, library, current }) =>
      el("button.frame", { type: "button", role: "listitem", disabled: library, "aria-pressed": String(current), onclick: () => run(`frame ${number}`) },
        el("b", {}, name), ` ${given} `, el("span.at", {}, library ? "C library" : `${file}:${line}`));

    const state = () => {
      const { playing, busy, halt } = model.state;
      const isOn = playing || busy;
      root.classList.toggle("running", isOn || !isHere());
      const name = model.position?.frames.find((each) => each.current)?.function ?? "";
      const text = playing ? "running: pause to see the current line"
        : busy ? "working"
        : !isHere() ? "the programs have not been run to this time yet"
        : model.position?.error?.text || halt.text || (name ? `stopped in ${name}` : "");
      status.textContent = text;
      status.title = text;
      status.classList.toggle("bad", !isOn && (halt.reason === "error" || Boolean(isHere() && model.position?.error)));
      follow();
    };

    page.code = {
      get file() {
        return source.file;
      },
      /** The selected function, if it is called repeatedly: its variables exist only during a call. */
      get passing() {
        const frames = (model.position?.frames ?? []).filter((each) => !each.library);
        const at = frames.findIndex((each) => each.current);
        return at >= 0 && at < frames.length - 1 ? `${model.position.file}:${frames[at].line}` : "";
      },
      toggle: () => source.cursor && source.toggle(source.file, source.cursor),
      edit: () => source.cursor && source.edit(source.cursor),
      runTo: () => source.cursor && run(`until ${source.file}:${source.cursor}`),
      nextFile: () => {
        const all = model.position?.files ?? [];
        const file = all[(all.indexOf(source.file) + 1) % all.length];
        if (file) source.open((files.value = file), lineIn(file));
      },
      zoom: () => document.body.classList.toggle("wide"),
    };
    model.on("hello", () => {
      source.clear();
      stops.offer();
      asked = -1;
    });
    model.on("position", draw);
    model.on("state", state);
    let wasShown = false; // a listing that is hidden cannot be scrolled
    model.on("look", () => {
      const isShown = Boolean(root.offsetParent);
      if (isShown && !wasShown && lineIn(source.file)) source.scrollTo(lineIn(source.file));
      wasShown = isShown;
    });
  },
};
