/** Start of the world builder: the bar, the world, the sides, and the keys. */

import { button, el, fill, part } from "../dom.js";
import { restoreTheme } from "../theme.js";
import { Clipboard } from "./clipboard.js";
import { toolsFor } from "./drawing.js";
import { recall, remember } from "./memory.js";
import { Model } from "./model.js";
import { keysButton, listenToKeys } from "./keys.js";
import { makeOptions } from "./options.js";
import { makePanels } from "./panels.js";
import { Solid } from "./solid.js";
import { makeStatus } from "./status.js";
import { Tools } from "./tools.js";
import { View } from "./view.js";

restoreTheme();
document.body.classList.add("build");
const canvas = el("canvas", { tabIndex: 0, "aria-label": "Top view of the world", oncontextmenu: (event) => event.preventDefault() });
const model = new Model();
const view = new View(canvas, model);
const tools = new Tools(model, view);
const clipboard = new Clipboard(model, view);
const solid = new Solid(model, view);
fill(part("world"), canvas, solid.element, makeOptions(model, tools), makeStatus(model, view, tools, solid));
makePanels(model, view);

const bar = el("div.tools", { role: "toolbar", "aria-label": "Tools" });
const undo = button({ text: "Undo", title: "Undo", key: "Ctrl-Z", onclick: () => model.request("undo") });
const redo = button({ text: "Redo", title: "Redo", key: "Ctrl-Y", onclick: () => model.request("redo") });
const save = button({ text: "Save", title: "Save", key: "Ctrl-S", className: "primary", onclick: () => store() });
const attempt = button({ text: "Try", title: "Try: run the world; Back returns here", key: "F5", onclick: () => run() });
const deep = button({ text: "3-D", title: "Switch between plan and 3-D view", key: "3", onclick: () => solid.toggle() });
const title = el("h1");
fill(part("head"), title, bar, el("span.spacer"), deep, undo, redo, keysButton(), attempt, save);

const fileName = () => model.document.file.split("/").at(-1);

async function store() {
  const file = model.document.file || prompt("Save as", "room.xml");
  if (!file) return;
  const saved = await model.request("save", model.document.file ? {} : { file });
  if (saved) model.notify(`saved ${saved}`);
}

async function run() {
  model.notify("starting the run...");
  const address = await model.request("run");
  if (address) location.href = `${address}&trial=${encodeURIComponent(fileName() || "the new world")}`;
}

async function duplicate() {
  const made = await model.apply("array", { values: { columns: 2, x: view.step() * 4 } });
  if (made?.length) model.choose(made);
}

async function group() {
  const name = model.selection.size ? prompt("Name of the new object", "object") : "";
  const made = name ? await model.apply("group", { values: { name } }) : null;
  if (made) model.choose(made);
}

listenToKeys(model, view, tools, { store, run, duplicate, group, clipboard, solid });

remember(model, view);

let shown = "";
model.addEventListener("change", () => {
  const { document: known } = model;
  if (!known) return;
  const name = fileName() || "a new world";
  document.title = `${known.changed ? "* " : ""}${name} · crs build`;
  title.textContent = name;
  title.classList.toggle("changed", known.changed);
  const wrong = known.problems.some((problem) => problem.blocks);
  undo.disabled = !known.undo.length || !model.mayChange;
  redo.disabled = !known.redo.length || !model.mayChange;
  undo.title = `Undo ${known.undo[0] ?? ""} (Ctrl-Z)`;
  attempt.hidden = deep.hidden = known.isRobot;
  save.disabled = wrong || !model.mayChange;
  save.title = wrong ? "Save: first fix the problems listed on the left" : "Save (Ctrl-S)";
  const where = model.path.join("/");
  if (known.area && shown === "" && recall(model, view)) {
    shown = `.${model.path.join("/")}`;
    model.emit("change");
    return;
  }
  if (known.area && (!view.isPlaced || where !== shown.slice(1))) view.fit();
  if (known.area) shown = `.${where}`;
  showTools();
});
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
