/** Start of the world builder: the bar, the world, the sides, and the keys. */

import { button, el, fill, part } from "../dom.js";
import { restoreTheme } from "../theme.js";
import { Model } from "./model.js";
import { makePanels } from "./panels.js";
import { TOOLS, Tools } from "./tools.js";
import { View } from "./view.js";

restoreTheme();
document.body.classList.add("build");
const canvas = el("canvas", { tabIndex: 0, "aria-label": "The world from above", oncontextmenu: (event) => event.preventDefault() });
fill(part("world"), canvas);
const model = new Model();
const view = new View(canvas, model);
const tools = new Tools(model, view);
makePanels(model, view);

const pressed = TOOLS.map((tool) => button({ text: tool.id, title: tool.title, key: tool.key.toUpperCase(), onclick: () => tools.choose(tool.id) }));
const undo = button({ text: "Undo", title: "Undo", key: "Ctrl-Z", onclick: () => model.ask("undo") });
const redo = button({ text: "Redo", title: "Redo", key: "Ctrl-Y", onclick: () => model.ask("redo") });
const save = button({ text: "Save", title: "Save", key: "Ctrl-S", className: "primary", onclick: () => store() });
const attempt = button({ text: "Try", title: "Try: run the world, Back returns here", key: "F5", onclick: () => run() });
const title = el("h1");
const note = el("span.note-text.said", { role: "status" });
fill(part("head"), title, ...pressed, el("span.spacer"), note, undo, redo, attempt, save);

async function store() {
  const file = model.document.file || prompt("Save as", "room.xml");
  if (!file) return;
  const saved = await model.ask("save", model.document.file ? {} : { file });
  if (saved) model.say(`saved ${saved}`);
}

async function run() {
  const address = await model.ask("try");
  if (address) location.href = address;
}

async function copy(name) {
  const clip = await model.ask("copy", { names: [...model.selection] });
  if (clip && name === "x") await model.apply("remove");
}

async function duplicate() {
  const made = await model.apply("array", { values: { columns: 2, x: view.step() * 4 } });
  if (made?.length) model.choose(made);
}

const SHORTCUTS = {
  z: (event) => model.ask(event.shiftKey ? "redo" : "undo"),
  y: () => model.ask("redo"),
  s: () => store(),
  c: () => copy("c"),
  x: () => copy("x"),
  v: () => model.paste({ x: view.step() * 4, y: -view.step() * 4 }),
  d: () => duplicate(),
  a: () => model.select(model.document.things.map((thing) => thing.name).filter((name) => model.shapes(name).length)),
};
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** @param {KeyboardEvent} event */
function key(event) {
  const target = /** @type {HTMLElement} */ (event.target);
  if (["INPUT", "SELECT", "TEXTAREA"].includes(target.tagName)) return false;
  if (event.ctrlKey || event.metaKey) {
    const act = SHORTCUTS[event.key.toLowerCase()];
    act?.(event);
    return Boolean(act);
  }
  if (tools.key(event)) return true;
  const tool = TOOLS.find((each) => each.key === event.key.toLowerCase());
  const arrow = ARROWS[event.key];
  if (tool) tools.choose(tool.id);
  else if (event.key === "f") view.fit();
  else if (event.key === "F5") run();
  else if (!model.selection.size) return false;
  else if (event.key === "Delete" || event.key === "Backspace") model.apply("remove");
  else if (arrow) model.apply("move", { values: { x: arrow[0] * view.step(), y: arrow[1] * view.step() } });
  else if (event.key === "[" || event.key === "]") model.apply("turn", { values: { angle: event.key === "[" ? "15deg" : "-15deg" } });
  else return false;
  return true;
}

document.addEventListener("keydown", (event) => {
  if (key(event)) event.preventDefault();
});

let isFitted = false;
model.addEventListener("change", () => {
  const { document: known } = model;
  if (!known) return;
  const name = known.file.split("/").at(-1) || "a new world";
  document.title = `${known.changed ? "* " : ""}${name} · crs build`;
  title.textContent = name + (known.changed ? " *" : "");
  undo.disabled = !known.undo.length || !model.mayChange;
  redo.disabled = !known.redo.length || !model.mayChange;
  undo.title = `Undo ${known.undo[0] ?? ""} (Ctrl-Z)`;
  save.disabled = known.problems.length > 0 || !model.mayChange;
  save.title = known.problems.length ? "Save: the problems at the left are in the way" : "Save (Ctrl-S)";
  if (!isFitted && known.area) view.fit();
  isFitted = true;
  view.draw();
});
model.addEventListener("note", () => (note.textContent = model.note));
const showTool = () => pressed.forEach((each, index) => each.setAttribute("aria-pressed", String(TOOLS[index].id === tools.tool)));
model.addEventListener("tool", showTool);
showTool();

/** For tests and the curious. */
Object.assign(window, { crs: { model, view, tools } });
