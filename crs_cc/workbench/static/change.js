/** Changes of the run, as commands; errors are shown at the field that they are about. */
import { el } from "crs/dom.js";

/**
 * Make a change, and report the result.
 * @param {any} model @param {string} text @returns {Promise<string>} the error; empty if it was made
 */
export async function change(model, text) {
  const { end } = model.state;
  try {
    const { text: done } = await model.channel.request("edit", { text });
    const { t } = model.state;
    const isPast = model.can("seek") && end - t > model.run.timestep_s * 1.5;
    const rest = ` (a new run starts at ${t.toFixed(2)} s; Changes keeps the previous one)`;
    model.notify(isPast ? done + rest : done);
    return "";
  } catch (error) {
    return error.message;
  }
}

/** Make a change, and show its error over the view. */
export async function changeOrSay(model, text) {
  const wrong = await change(model, text);
  if (wrong) model.notify(wrong, true);
  return !wrong;
}

let fields = 0;

/**
 * A labelled field with a place for its unit and its error.
 * @param {string} label @param {any} input @param {string} unit
 */
export function field(label, input, unit = "") {
  input.id ||= `field-${++fields}`;
  const wrong = el("span.wrong", { id: `${input.id}-wrong`, role: "alert" });
  input.setAttribute("aria-describedby", wrong.id);
  const shown = el("span.unit", {}, unit);
  const row = el("div.field", {}, el("label", { htmlFor: input.id }, label), el("span.entry", {}, input, shown), wrong);
  const setError = (text) => {
    wrong.textContent = text;
    input.setAttribute("aria-invalid", String(Boolean(text)));
    row.classList.toggle("bad-field", Boolean(text));
  };
  input.addEventListener("input", () => setError(""));
  return { row, input, setError, unit: (text) => (shown.textContent = text) };
}

/**
 * Show errors, one per line, at the fields whose values they quote, or else at the first field.
 * @param {{input: any, setError: (text: string) => void}[]} fields @param {string} wrong
 */
export function showErrors(fields, wrong) {
  const texts = new Map();
  for (const line of wrong.split("\n").filter((each) => each)) {
    const quoting = fields.filter(({ input }) => line.includes(`'${typed(input) || NOTHING}'`));
    const about = quoting.find((each) => !texts.has(each)) ?? fields[0];
    texts.set(about, line);
  }
  for (const each of fields) each.setError(texts.get(each) ?? "");
}

/** The text in a command for an empty field. */
export const NOTHING = "?";

/** A text to type. */
export const entry = (properties = {}) => el("input", { type: "text", spellcheck: false, autocomplete: "off", ...properties });

/** A choice. @param {[string, string][]} options values and what is shown */
export function choice(options, properties = {}) {
  return el("select", properties, ...options.map(([value, text]) => el("option", { value }, text)));
}

/** Show other options, and keep the chosen one if it is still there. */
export function setOptions(select, options) {
  const key = JSON.stringify(options);
  if (select.dataset.options === key) return;
  select.dataset.options = key;
  const chosen = select.value;
  select.replaceChildren(...options.map(([value, text]) => el("option", { value }, text)));
  if (options.some(([value]) => value === chosen)) select.value = chosen;
}

/** A quantity as it is typed, without spaces. */
export const typed = (input) => input.value.trim().replace(/\s+/g, "");
