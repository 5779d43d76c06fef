/** The sides of the page: elements, properties, operations, problems. */

import { el, fill, part } from "../dom.js";
import { makeLibrary } from "./library.js";
import { drawProperties, makeAddForm } from "./properties.js";

/** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
export function makePanels(model, view) {
  const items = el("div.items", { role: "listbox", "aria-label": "Elements", "aria-multiselectable": "true" });
  const problems = el("div.problems", { role: "list", "aria-label": "Problems" });
  const table = el("div.properties");
  const operations = el("div.operations");
  fill(
    part("sides"),
    el("aside.left", {}, section("Elements", items), section("Problems", problems)),
    el("aside.right", {}, section("Properties", table), folded("Operation", operations), folded("Add", makeAddForm(model), false), folded("Library", makeLibrary(model, view), false)),
  );
  const list = new ItemList(model, items);
  let shown = "";
  const operation = operations.closest("details");
  const showOperation = () => (operation.hidden = !model.selection.size);
  model.addEventListener("change", () => {
    showOperation();
    list.draw();
    drawProblems(model, view, problems);
    shown = drawOperations(model, operations, shown);
    drawProperties(model, table);
  });
  model.addEventListener("select", () => {
    showOperation();
    list.mark();
    drawProperties(model, table);
  });
}

export const section = (title, body) => el("section", {}, el("h2", {}, title), body);

export const folded = (title, body, open = true) => el("details.section", { open }, el("summary", {}, title), body);

/** The list of elements; rows stay as they are while names and kinds do. */
class ItemList {
  constructor(model, root) {
    this.model = model;
    this.root = root;
    /** @type {Map<string, any>} */
    this.rows = new Map();
    /** What is shown as selected. */
    this.marked = new Set();
  }

  draw() {
    const { model } = this;
    const before = this.rows;
    this.rows = new Map();
    for (const { name, tag } of model.items) {
      const key = `${tag} ${name}`;
      this.rows.set(key, before.get(key) ?? this.row(name, tag));
    }
    const isSame = before.size === this.rows.size && [...this.rows.values()].every((row, at) => row === this.root.children[at]);
    if (!isSame) fill(this.root, ...this.rows.values());
    this.mark();
    this.state();
  }

  row(name, tag) {
    const { model } = this;
    const choose = (event) => model.select(event.shiftKey ? [...model.selection, name] : [name]);
    const made = el("button.item", { type: "button", role: "option", "aria-selected": "false", onclick: choose, ondblclick: () => model.enter(name) }, el("b", {}, name.slice(name.indexOf("/", model.inside?.root.length ?? Infinity) + 1)), el("span.state"), el("span", {}, tag === name ? "" : tag));
    made.dataset.name = name;
    return made;
  }

  /** Show in the list what is hidden and locked. */
  state() {
    const { hidden, locked } = this.model;
    for (const row of this.root.children) {
      const { name } = row.dataset;
      const state = [hidden.has(name) ? "hidden" : "", locked.has(name) ? "locked" : ""].join(" ").trim();
      if (row.children[1].textContent !== state) row.children[1].textContent = state;
    }
  }

  /** Show in the list what is selected. */
  mark() {
    const { selection, index } = this.model;
    for (const name of [...this.marked].filter((each) => !selection.has(each))) this.select(name, false);
    for (const name of selection) if (index.has(name) && !this.marked.has(name)) this.select(name, true);
  }

  select(name, isOn) {
    const tag = this.model.index.get(name)?.tag;
    const row = this.rows.get(`${tag} ${name}`);
    row?.setAttribute("aria-selected", String(isOn));
    if (isOn && this.model.selection.size === 1) row?.scrollIntoView({ block: "nearest" });
    if (isOn) this.marked.add(name);
    else this.marked.delete(name);
  }
}

function drawProblems(model, view, root) {
  const go = (problem) => {
    if (!problem.name) return;
    while (model.inside) model.leave();
    model.select([problem.name]);
    view.show(problem.name);
  };
  const rows = (model.document?.problems ?? []).map((problem) =>
    el(
      `button.problem.${problem.severity}`,
      { type: "button", role: "listitem", title: problem.hint, onclick: () => go(problem) },
      el("b", {}, problem.file ? `${problem.file}, line ${problem.line}` : problem.name || "the world"),
      el("span", {}, problem.text),
    ),
  );
  fill(root, ...(rows.length ? rows : [el("p.note-text", {}, "none: the world can be saved")]));
}

const USUAL = "move";

/** The form of the operation that is chosen, made from the builder's table. */
function drawOperations(model, root, shown) {
  if (!model.operations?.length) return shown;
  const names = model.operations.map((row) => row.name).join();
  if (shown === names) return shown;
  const form = el("form", { onsubmit: (event) => event.preventDefault() });
  const chooser = el("select", { "aria-label": "operation", onchange: () => draw() },
    ...model.operations.map((row) => el("option", { value: row.name, selected: row.name === USUAL }, row.name)));
  const draw = () => {
    const row = model.operations.find((each) => each.name === chooser.value);
    const inputs = row.fields.map((each) =>
      each.choices.length
        ? el("select", { name: each.name, title: each.help }, ...each.choices.map((word) => el("option", {}, word)))
        : el("input", { type: "text", name: each.name, title: each.help, placeholder: each.default ?? "" }),
    );
    const run = async () => {
      const values = Object.fromEntries(inputs.filter((input) => input.value).map((input) => [input.name, input.value]));
      const made = await model.apply(row.name, { values });
      if (made?.length) model.choose(made);
    };
    fill(form, el("p.note-text", {}, row.summary),
      ...inputs.map((input) => el("label.property", {}, el("span", {}, input.name), input)),
      el("button.primary", { type: "submit", onclick: run }, row.name));
  };
  draw();
  fill(root, chooser, form);
  return names;
}
