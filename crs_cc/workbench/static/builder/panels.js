/** The sides of the page: elements, properties, operations, problems. */

import { el, fill, part } from "../dom.js";

/** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
export function makePanels(model, view) {
  const things = el("div.things", { role: "listbox", "aria-label": "Elements" });
  const problems = el("div.problems", { role: "list", "aria-label": "Problems" });
  const table = el("div.properties");
  const operations = el("div.operations");
  fill(
    part("sides"),
    el("aside.left", {}, section("Elements", things), section("Problems", problems)),
    el("aside.right", {}, section("Properties", table), section("Operation", operations)),
  );
  let shown = "";
  model.addEventListener("change", () => {
    drawThings(model, things);
    drawProblems(model, view, problems);
    shown = drawOperations(model, operations, shown);
    drawProperties(model, table);
  });
  model.addEventListener("select", () => {
    drawThings(model, things);
    drawProperties(model, table);
    view.draw();
  });
}

const section = (title, body) => el("section", {}, el("h2", {}, title), body);

function drawThings(model, root) {
  const rows = (model.document?.things ?? []).map((thing) =>
    el(
      "button.thing",
      {
        type: "button",
        role: "option",
        "aria-selected": model.selection.has(thing.name),
        onclick: (event) => model.select(event.shiftKey ? [...model.selection, thing.name] : [thing.name]),
      },
      el("b", {}, thing.name),
      el("span", {}, thing.tag),
    ),
  );
  fill(root, ...rows);
}

function drawProblems(model, view, root) {
  const rows = (model.document?.problems ?? []).map((problem) =>
    el(
      "button.problem",
      {
        type: "button",
        role: "listitem",
        title: problem.hint,
        onclick: () => {
          if (!problem.name) return;
          model.select([problem.name]);
          const [shape] = model.shapes(problem.name);
          if (shape) view.centre = shape.points?.[0] ?? [shape.x, shape.y];
          view.draw();
        },
      },
      el("b", {}, `line ${problem.line}`),
      el("span", {}, problem.text),
    ),
  );
  fill(root, ...(rows.length ? rows : [el("p.note-text", {}, "none: the world can be saved")]));
}

async function drawProperties(model, root) {
  const names = [...model.selection];
  if (names.length !== 1) {
    const text = names.length ? `${names.length} elements are selected` : "nothing is selected";
    fill(root, el("p.note-text", {}, text));
    return;
  }
  const [name] = names;
  const found = await model.ask("properties", { name });
  if (!found || !model.selection.has(name) || root.contains(document.activeElement)) return;
  fill(root, el("p", {}, el("b", {}, name), ` <${found.tag}>`), ...found.rows.map((row) => property(model, name, row)));
}

function property(model, name, row) {
  const set = async (value) => {
    /** @type {HTMLElement} */ (document.activeElement)?.blur();
    await model.apply("set", { names: [name], attributes: { [row.name]: value } });
    if (row.name === "id" && value) model.choose([value]);
  };
  const properties = {
    "aria-label": row.name,
    title: row.help,
    onchange: (event) => set(event.target.value),
  };
  const known = { material: model.document.materials, ref: model.document.definitions, definition: model.document.robots }[row.name];
  let input;
  if (row.choices.length || known) {
    const options = ["", ...new Set([...(row.choices.length ? row.choices : known), row.value ?? ""])].filter((each, at) => each || !at);
    input = el("select", properties, ...options.map((each) => el("option", { value: each, selected: each === (row.value ?? "") }, each || `(${row.default ?? "none"})`)));
  } else {
    const hint = row.default ?? (row.units.length ? row.units.join(", ") : "");
    input = el("input", { ...properties, type: "text", value: row.value ?? "", placeholder: hint, spellcheck: false });
  }
  return el("label.property", {}, el("span", { className: row.required ? "required" : "" }, row.name), input);
}

/** The form of the operation that is chosen, made from the builder's table. */
function drawOperations(model, root, shown) {
  if (!model.operations?.length) return shown;
  const names = model.operations.map((row) => row.name).join();
  if (shown === names) return shown;
  const form = el("form", { onsubmit: (event) => event.preventDefault() });
  const chooser = el("select", { "aria-label": "operation", onchange: () => draw() },
    ...model.operations.map((row) => el("option", { value: row.name }, row.name)));
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
