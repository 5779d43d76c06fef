/** The keyboard, and the list of its keys. */

import { button, el } from "../dom.js";
import { toolsFor } from "./drawing.js";

const TURN = "15deg";

/**
 * The keys besides those of tools: `needs` says that they act on what is selected.
 * @param {import("./model.js").Model} model @param {import("./view.js").View} view @param {Record<string, any>} actions
 * @returns {{keys: string[], text: string, does: () => unknown, needs?: boolean}[]}
 */
function table(model, view, { store, run, duplicate, group, clipboard, solid }) {
  const move = (x, y) => () => model.apply("move", { values: { x: x * view.step(), y: y * view.step() } });
  const turn = (angle) => () => model.apply("turn", { values: { angle } });
  const all = () => model.items.map((item) => item.name).filter((name) => model.isFree(name) && model.shapes(name).length);
  return [
    { keys: ["Ctrl+Z"], text: "undo", does: () => model.request("undo") },
    { keys: ["Ctrl+Y", "Ctrl+Shift+Z"], text: "redo", does: () => model.request("redo") },
    { keys: ["Ctrl+S"], text: "save", does: store },
    { keys: ["F5"], text: "try: run the world", does: run },
    { keys: ["Delete", "Backspace"], text: "remove", needs: true, does: () => model.apply("remove") },
    { keys: ["Ctrl+C"], text: "copy", does: () => clipboard.copy() },
    { keys: ["Ctrl+X"], text: "cut", does: () => clipboard.cut() },
    { keys: ["Ctrl+V"], text: "paste, also from another world", does: () => false },
    { keys: ["Ctrl+D"], text: "duplicate", does: duplicate },
    { keys: ["Ctrl+A"], text: "select all", does: () => model.select(all()) },
    { keys: ["Ctrl+G"], text: "group the selection into an object", does: group },
    { keys: ["Enter"], text: "edit the definition of an object", needs: true, does: () => model.enter([...model.selection][0]) },
    { keys: ["ArrowLeft"], text: "move left", needs: true, does: move(-1, 0) },
    { keys: ["ArrowRight"], text: "move right", needs: true, does: move(1, 0) },
    { keys: ["ArrowUp"], text: "move up", needs: true, does: move(0, 1) },
    { keys: ["ArrowDown"], text: "move down", needs: true, does: move(0, -1) },
    { keys: ["["], text: "turn left", needs: true, does: turn(TURN) },
    { keys: ["]"], text: "turn right", needs: true, does: turn(`-${TURN}`) },
    { keys: ["I"], text: "hide", needs: true, does: () => model.toggle(model.hidden) },
    { keys: ["U"], text: "show hidden elements", does: () => model.toggle(model.hidden, [...model.hidden]) },
    { keys: ["K"], text: "lock or unlock", needs: true, does: () => model.toggle(model.locked) },
    { keys: ["F"], text: "show everything", does: () => view.fit() },
    { keys: ["3"], text: "plan or 3-D view", does: () => !model.document?.isRobot && solid.toggle() },
    { keys: ["?"], text: "show or hide this list", does: toggleKeys },
  ];
}

const OTHERS = [
  ["Shift", "with a click: select several"],
  ["Alt", "while drawing or dragging: no snapping"],
  ["Wheel", "zoom; the right button moves the view"],
  ["Esc", "end a chain, leave the tool, close a definition"],
];
const SHOWN = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓" };
/** @type {any} */
let dialog = null;

const toggleKeys = () => (dialog.open ? dialog.close() : dialog.showModal());

export const keysButton = () => button({ icon: "help", title: "Keys", key: "?", onclick: toggleKeys });

/** The name of a pressed key, as in the table. @param {KeyboardEvent} event */
function nameOf(event) {
  const isLetter = event.key.length === 1;
  const key = isLetter ? event.key.toUpperCase() : event.key;
  const isCtrl = event.ctrlKey || event.metaKey;
  return `${isCtrl ? "Ctrl+" : ""}${isCtrl && event.shiftKey ? "Shift+" : ""}${key}`;
}

/**
 * @param {import("./model.js").Model} model @param {import("./view.js").View} view
 * @param {import("./tools.js").Tools} tools @param {Record<string, any>} actions
 */
export function listenToKeys(model, view, tools, actions) {
  const rows = table(model, view, actions);
  const byKey = new Map(rows.flatMap((row) => row.keys.map((key) => [key, row])));
  document.body.append((dialog = list(rows)));
  document.addEventListener("keydown", (event) => {
    const target = /** @type {HTMLElement} */ (event.target);
    const name = nameOf(event);
    if (["INPUT", "SELECT", "TEXTAREA"].includes(target.tagName) || (dialog.open && name !== "?")) return;
    const isCtrl = name.startsWith("Ctrl+");
    const row = byKey.get(name);
    const tool = toolsFor(model.document?.isRobot).find((each) => each.key.toUpperCase() === name);
    const isFree = !row?.needs || (model.selection.size && target.tagName !== "BUTTON");
    if (!isCtrl && tools.key(event)) event.preventDefault();
    else if (tool) tools.choose(tool.id);
    else if (row && isFree && row.does() !== false) event.preventDefault();
  });
}

/** The list of all keys. @param {{keys: string[], text: string}[]} rows */
function list(rows) {
  const line = (key, text) => el("div", {}, el("kbd", {}, SHOWN[key] ?? key), el("span", {}, text));
  return el("dialog.keys", { "aria-label": "keys" },
    el("h2", { tabIndex: -1, autofocus: true }, "Keys"),
    el("div.rows", {},
      ...toolsFor(false).map((tool) => line(tool.key.toUpperCase(), tool.id)),
      ...rows.map((row) => line(row.keys[0], row.text)),
      ...OTHERS.map(([key, text]) => line(key, text))),
    el("form", { method: "dialog" }, el("button", {}, "Close")));
}
