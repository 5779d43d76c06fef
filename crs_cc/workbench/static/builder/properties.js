/** The attributes of what is selected, and the form for elements that are added by their attributes. */

import { el, fill } from "../dom.js";

/** @param {import("./model.js").Model} model */
export async function drawProperties(model, root) {
  const names = [...model.selection];
  if (!names.length) {
    fill(root, el("p.note-text", {}, "nothing is selected: click an element, or choose a tool above and draw"));
    return;
  }
  const found = await model.request("properties", { name: names[0] });
  if (!found || !model.selection.has(names[0]) || root.contains(document.activeElement)) return;
  if (names.length > 1) {
    const shared = sharedRows(model, names, found.rows);
    fill(root, el("p", {}, `${names.length} elements: changes apply to all`), ...shared.map((row) => property(model, names, row)));
    return;
  }
  fill(root, ...element(model, found), ...found.children.flatMap((child) => element(model, child)), ...adders(model, found));
}

/** The attributes that all selected elements may have; values that differ are not shown. */
function sharedRows(model, names, rows) {
  const items = names.map((name) => model.item(name));
  const isSame = items.every((item) => item?.tag === items[0]?.tag);
  const common = rows.filter((row) => row.name !== "id" && (isSame || ["colour", "material", "height", "heat", "spread", "sonar", "infrared"].includes(row.name)));
  return common.map((row) => ({ ...row, value: items.every((item) => item?.attributes[row.name] === row.value) ? row.value : null }));
}

/** An element's name with its attributes, or its text. */
function element(model, found) {
  const title = el("p", {}, el("b", {}, found.name), ` <${found.tag}>`);
  const rows = found.rows.map((row) => property(model, [found.name], row));
  if (found.text === null) return [title, ...rows];
  const set = (event) => model.apply("text", { names: [found.name], values: { text: event.target.value } });
  const input = el("input", { type: "text", value: found.text, "aria-label": `text of ${found.name}`, onchange: set });
  return [el("label.property", {}, el("span", {}, found.tag), input)];
}

/** Buttons for what can be added to an element. */
function adders(model, found) {
  const kinds = found.may.filter((kind) => kind === "argument" || (kind === "place" && found.tag === "visit"));
  const add = (kind) => model.apply("add", { names: [], values: { kind, into: found.name } });
  return kinds.map((kind) => el("button", { type: "button", onclick: () => add(kind) }, `Add ${kind}`));
}

function property(model, names, row) {
  const set = async (value) => {
    /** @type {HTMLElement} */ (document.activeElement)?.blur();
    await model.apply("set", { names, attributes: { [row.name]: value } });
    if (row.name === "id" && value) model.choose([value]);
  };
  const input = field(model, row, { onchange: (event) => set(event.target.value) });
  return el("label.property", {}, nameOf(row), input);
}

/** The name of an attribute, bold if it must be there; a quantity without a unit says so. */
function nameOf(row) {
  const isPlain = row.units.join() === "" && row.units.length;
  const name = el("span", { className: row.required ? "required" : "", title: row.help }, row.name);
  return isPlain ? el("span", {}, name, el("small", {}, " no unit")) : name;
}

let numbered = 0;

/** The input for an attribute: a choice among what is known, or a text. */
function field(model, row, more) {
  const properties = { "aria-label": row.name, title: row.help, ...more };
  const value = row.value ?? "";
  const { materials, definitions, robots, channels, programs } = model.document;
  const known = { material: materials, ref: definitions, definition: robots, channel: channels }[row.name];
  if (row.choices.length || known) {
    const options = ["", ...new Set([...(row.choices.length ? row.choices : known), value])].filter((each, at) => each || !at);
    return el("select", properties, ...options.map((each) => el("option", { value: each, selected: each === value }, each || `(${row.default ?? "none"})`)));
  }
  const hint = row.default ?? (row.units.length ? row.units.join(", ") : "");
  const input = el("input", { ...properties, type: "text", value, placeholder: hint, spellcheck: false });
  const offered = { program: programs, colour: model.colours }[row.name];
  if (!offered?.length) return input;
  const list = el("datalist", { id: `offered-${(numbered += 1)}` }, ...offered.map((each) => el("option", { value: each })));
  input.setAttribute("list", list.id);
  return el("span.offered", {}, input, list);
}

/** A form to add an element of any kind by its attributes. @param {import("./model.js").Model} model */
export function makeAddForm(model) {
  const form = el("form.operations", { onsubmit: (event) => event.preventDefault() });
  let kind = "";
  let into = "";
  const draw = async () => {
    const found = await model.request("form", { into, kind });
    if (!found) return;
    kind = found.kind;
    const choose = (event) => {
      kind = event.target.value;
      draw();
    };
    const chooser = el("select", { "aria-label": "kind to add", onchange: choose }, ...found.kinds.map((each) => el("option", { value: each, selected: each === kind }, each)));
    const rows = found.rows.map((row) => el("label.property", {}, nameOf(row), field(model, row, { name: row.name })));
    const [needed, others] = [0, 1].map((at) => rows.filter((_, index) => Number(!found.rows[index].required) === at));
    const add = () => {
      const inputs = [...form.querySelectorAll("[name]")].filter((input) => input.value);
      model.add(kind, Object.fromEntries(inputs.map((input) => [input.name, input.value])), into);
    };
    const rest = others.length ? el("details", {}, el("summary", {}, "more attributes"), ...others) : null;
    fill(form, chooser, ...needed, ...(rest ? [rest] : []), el("button.primary", { type: "submit", onclick: add }, "add"));
  };
  model.addEventListener("change", () => {
    const now = model.inside?.root ?? "";
    if (!model.isConnected || (form.firstChild && now === into)) return;
    [into, kind] = [now, now === into ? kind : ""];
    draw();
  });
  return form;
}
