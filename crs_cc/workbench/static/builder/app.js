/** Start of the world builder: the bar, the world, the sides, and the keys. */

import { button, el, fill, part } from "../dom.js";
import { restoreTheme } from "../theme.js";
import { Clipboard } from "./clipboard.js";
import { toolsFor } from "./drawing.js";
import { Model } from "./model.js";
import { makeOptions, makeUnits } from "./options.js";
import { makePanels } from "./panels.js";
import { Solid } from "./solid.js";
import { Tools } from "./tools.js";
import { View } from "./view.js";

restoreTheme();
document.body.classList.add("build");
const canvas = el("canvas", { tabIndex: 0, "aria-label": "The world from above", oncontextmenu: (event) => event.preventDefault() });
const model = new Model();
const view = new View(canvas, model);
const tools = new Tools(model, view);
const clipboard = new Clipboard(model, view);
const solid = new Solid(model, view);
fill(part("world"), canvas, solid.element, makeOptions(model, tools), makeUnits(model));
makePanels(model, view);

const bar = el("div.tools", { role: "toolbar", "aria-label": "Tools" });
const undo = button({ text: "Undo", title: "Undo", key: "Ctrl-Z", onclick: () => model.ask("undo") });
const redo = button({ text: "Redo", title: "Redo", key: "Ctrl-Y", onclick: () => model.ask("redo") });
const save = button({ text: "Save", title: "Save", key: "Ctrl-S", className: "primary", onclick: () => store() });
const attempt = button({ text: "Try", title: "Try: run the world, Back returns here", key: "F5", onclick: () => run() });
const deep = button({ text: "3-D", title: "Look at it in three dimensions, and back", key: "3", onclick: () => solid.toggle() });
const title = el("h1");
const note = el("span.note-text.said", { role: "status" });
fill(part("head"), title, bar, el("span.spacer"), note, deep, undo, redo, attempt, save);

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

async function duplicate() {
  const made = await model.apply("array", { values: { columns: 2, x: view.step() * 4 } });
  if (made?.length) model.choose(made);
}

async function group() {
  const name = model.selection.size ? prompt("Name of the object that is made of the selection", "object") : "";
  const made = name ? await model.apply("group", { values: { name } }) : null;
  if (made) model.choose(made);
}

const SHORTCUTS = {
  z: (event) => model.ask(event.shiftKey ? "redo" : "undo"),
  y: () => model.ask("redo"),
  s: () => store(),
  c: () => clipboard.copy(),
  x: () => clipboard.cut(),
  d: () => duplicate(),
  g: () => group(),
  a: () => model.select(model.things.map((thing) => thing.name).filter((name) => model.isFree(name) && model.shapes(name).length)),
};
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const ACTIONS = {
  f: () => view.fit(),
  F5: () => run(),
  3: () => !model.document?.isRobot && solid.toggle(),
  u: () => model.toggle(model.hidden, [...model.hidden]),
};
const ON_SELECTION = {
  Delete: () => model.apply("remove"),
  Backspace: () => model.apply("remove"),
  "[": () => model.apply("turn", { values: { angle: "15deg" } }),
  "]": () => model.apply("turn", { values: { angle: "-15deg" } }),
  i: () => model.toggle(model.hidden),
  k: () => model.toggle(model.locked),
  Enter: () => model.enter([...model.selection][0]),
};

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
  const tool = toolsFor(model.document?.isRobot).find((each) => each.key === event.key.toLowerCase());
  const arrow = ARROWS[event.key];
  const act = ACTIONS[event.key] ?? (model.selection.size && target.tagName !== "BUTTON" ? ON_SELECTION[event.key] : null);
  if (tool) tools.choose(tool.id);
  else if (act) act();
  else if (arrow && model.selection.size) model.apply("move", { values: { x: arrow[0] * view.step(), y: arrow[1] * view.step() } });
  else return false;
  return true;
}

document.addEventListener("keydown", (event) => {
  if (key(event)) event.preventDefault();
});

let shown = "";
model.addEventListener("change", () => {
  const { document: known } = model;
  if (!known) return;
  const name = known.file.split("/").at(-1) || "a new world";
  document.title = `${known.changed ? "* " : ""}${name} · crs build`;
  title.textContent = name + (known.changed ? " *" : "");
  const wrong = known.problems.some((problem) => problem.blocks);
  undo.disabled = !known.undo.length || !model.mayChange;
  redo.disabled = !known.redo.length || !model.mayChange;
  undo.title = `Undo ${known.undo[0] ?? ""} (Ctrl-Z)`;
  attempt.hidden = deep.hidden = known.isRobot;
  save.disabled = wrong || !model.mayChange;
  save.title = wrong ? "Save: the problems at the left are in the way" : "Save (Ctrl-S)";
  const where = model.path.join("/");
  if (known.area && (shown === "" || where !== shown.slice(1))) {
    view.fit();
    shown = `.${where}`;
  }
  showTools();
});
model.addEventListener("note", () => (note.textContent = model.note));
model.addEventListener("tool", () => {
  if (solid.isOn && tools.tool !== "select") solid.toggle();
  showTools();
  deep.setAttribute("aria-pressed", String(solid.isOn));
});

function showTools() {
  const buttons = toolsFor(model.document?.isRobot).map((tool) => {
    const made = button({ text: tool.id, title: tool.title, key: tool.key.toUpperCase(), onclick: () => tools.choose(tool.id) });
    made.setAttribute("aria-pressed", String(tool.id === tools.tool));
    return made;
  });
  if (bar.children.length !== buttons.length) fill(bar, ...buttons);
  else buttons.forEach((made, at) => bar.children[at].setAttribute("aria-pressed", made.getAttribute("aria-pressed")));
}

/** For tests and the curious. */
Object.assign(window, { crs: { model, view, tools, solid } });
