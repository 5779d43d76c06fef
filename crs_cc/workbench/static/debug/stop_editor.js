/** The form of a line's breakpoint: condition, log point, robot, and what to do there. */
import { button, el } from "crs/dom.js";

/**
 * @param {any} model @param {any} page @param {string} file @param {number} line
 * @param {any} point the breakpoint that is there; nothing for none
 */
export function stopEditor(model, page, file, line, point) {
  const robots = model.run.rosters.at(-1)?.robots ?? [];
  const text = (name, value, hint) => el("input", { type: "text", name, value, placeholder: hint, spellcheck: false, autocomplete: "off" });
  const condition = text("condition", point?.condition ?? "", "always; or: front < 30 && speed > 0");
  const log = text("log", point?.log ?? "", "stop; or print: speed is {speed}");
  const ignore = el("input", { type: "number", name: "ignore", min: 0, value: point?.ignore ?? 0 });
  const robot = el("select", { name: "robot" }, el("option", { value: "-1" }, "any robot"), ...robots.map((id, row) => el("option", { value: String(row) }, id)));
  robot.value = String(point?.robot ?? -1);
  const commands = el("textarea", { name: "commands", rows: 2, value: point?.commands ?? "", placeholder: "debugger commands, one per line", spellcheck: false });
  const enabled = el("input", { type: "checkbox", checked: point?.enabled ?? true });
  const wrong = el("p.field-error", { role: "alert" });
  const field = (name, input) => el("label", {}, el("span", {}, name), input);
  const close = () => form.remove();

  const save = async (event) => {
    event.preventDefault();
    wrong.textContent = "";
    const fields = { file, line, condition: condition.value, log: log.value, robot: Number(robot.value), ignore: Number(ignore.value) | 0, commands: commands.value, enabled: enabled.checked };
    try {
      await model.channel.request("breakpoint", fields);
      close();
    } catch (error) {
      wrong.textContent = error.message;
      condition.setAttribute("aria-invalid", "true");
    }
  };
  const remove = () => {
    if (point) model.request("break", { file, line });
    close();
  };
  const here = () => {
    close();
    page.console(`until ${file}:${line}`);
  };
  const printPast = async () => {
    if (!log.value.trim()) wrong.textContent = "enter the text to print: speed is {speed}";
    else wrong.textContent = await page.found.search("log_messages", { file, line, text: log.value }, `line ${line}`);
    if (!wrong.textContent) page.layout.open("events");
  };
  const form = el("form.stop-editor", { "aria-label": `breakpoint at line ${line}`, onsubmit: save, onkeydown: (event) => {
    event.stopPropagation();
    if (event.key === "Escape") close();
  } },
    field("Stop if", condition), wrong, field("Instead", log),
    el("div.row", {}, robots.length > 1 ? field("Robot", robot) : null, field("Ignore first", ignore), field("On", enabled)),
    field("Then do", commands),
    el("div.row", {},
      el("button.primary", { type: "submit" }, point ? "Change" : "Set"),
      button({ text: "Print the past", title: "List what this line would have printed in the run so far", onclick: printPast }),
      button({ text: "Run to here", title: "Run the program to this line", onclick: here }),
      point ? button({ text: "Remove", title: "Remove the breakpoint", onclick: remove }) : null,
      button({ text: "Cancel", title: "Discard the changes", key: "Esc", onclick: close })));
  return form;
}
