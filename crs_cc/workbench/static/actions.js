/** What can be done with the selected robot, and how it is driven by hand. */
import { button, el } from "crs/dom.js";
import { NOTHING, change, changeOrSay, entry, field, showErrors, setOptions, typed } from "crs/change.js";
import { Driving } from "crs/driving.js";

/** Forms that are opened by a button: what they ask for, the change that they make, and for which runs. */
const FORMS = [
  { id: "move", title: "Move", fields: [["x", "m", "x"], ["y", "m", "y"], ["heading", "°", "heading"]], fill: (pose) => pose,
    text: (robot, [x, y, heading]) => `move ${robot} to ${x} ${y} ${heading}` },
  { id: "turn", title: "Turn", fields: [["heading", "°", "heading"]], fill: (pose) => [pose[2]], text: (robot, [heading]) => `turn ${robot} to ${heading}` },
  { id: "sleep", title: "Sleep", fields: [["time", "s", "time"]], fill: () => ["5"], text: (robot, [time]) => `sleep ${robot} ${time}` },
  { id: "heat", title: "Heat", fields: [["heat", "", "heat"]], fill: () => ["10"], text: (robot, [heat]) => `heat ${robot} ${heat}` },
  { id: "recharge", title: "Recharge", fields: [["charge", "%", "charge"]], fill: () => ["100"], text: (robot, [charge]) => `charge ${robot} ${charge}` },
  { id: "evaporate", title: "Evaporation", fields: [["field", "", "field"], ["time", "s", "time"]], only: (run) => run.world.fields?.length,
    fill: (_pose, run) => [run.world.fields[0], "60"], text: (_robot, [field, time]) => `evaporate ${field} ${time === "never" ? time : `${time}s`}` },
];

/** @param {any} model @param {any} page @returns {HTMLElement} */
export function actions(model, page) {
  const driving = new Driving(model, page);
  const below = el("div.action-form");
  const name = () => model.selected.id;
  const faults = () => model.panel?.faults ?? [];
  const hold = button({ text: "Hold", title: "Hold the motors, or release them", onclick: () =>
    changeOrSay(model, `${isHeld() ? "release" : "hold"} ${name()}`) });
  const isHeld = () => faults().some((each) => each.id === `hold-${name()}`);
  const drive = button({ text: "Drive", title: "Drive it with the arrow keys, W A S D or a gamepad", onclick: () => driving.toggle() });
  const plain = (text, title, line) => button({ text, title, onclick: () => changeOrSay(model, line()) });
  const opened = { id: "" };
  const open = (form, opener) => {
    const isOpen = opened.id === form.id;
    opened.id = isOpen ? "" : form.id;
    for (const each of bar.querySelectorAll("[aria-expanded]")) each.setAttribute("aria-expanded", String(each === opener && !isOpen));
    below.replaceChildren(...(isOpen ? [] : [form.make()]));
    below.querySelector("input")?.focus();
  };
  const opener = (form) => {
    const made = button({ text: form.title, title: `${form.title} ...`, onclick: () => open(form, made) });
    made.setAttribute("aria-expanded", "false");
    return made;
  };
  const simple = FORMS.filter(({ only }) => !only || only(model.run)).map((form) => opener({ id: form.id, title: form.title, make: () => simpleForm(model, form) }));
  const mayAdd = model.run.can.includes("debug"); // programs are compiled where they are debugged
  const add = mayAdd ? [opener({ id: "add", title: "Add a robot", make: () => addForm(model) })] : [];
  const bar = el("div.actions", {}, drive,
    plain("Stop", "Stop the motors now", () => `drive ${name()} 0 0`), hold, ...simple,
    plain("Wake", "Wake its program", () => `wake ${name()}`),
    plain("Remove", "Remove it from the world", () => `remove ${name()}`), ...add);
  const show = () => {
    hold.querySelector("span").textContent = isHeld() ? "Release" : "Hold";
    drive.setAttribute("aria-pressed", String(driving.isOn));
    drive.querySelector("span").textContent = driving.isOn ? "Stop driving" : "Drive";
  };
  for (const kind of ["panel", "look", "driving"]) model.on(kind, show);
  return el("div", {}, bar, driving.note, below);
}

function poseOf(model) {
  const body = model.scene?.body(model.state.robot);
  return body ? [body.x.toFixed(2), body.y.toFixed(2), Math.round(((body.heading * 180) / Math.PI % 360) + 360) % 360] : ["0", "0", "0"];
}

function simpleForm(model, form) {
  const values = form.fill(poseOf(model).map(String), model.run);
  const fields = form.fields.map(([label, unit], at) => field(label, entry({ value: values[at] }), unit));
  return formOf(fields, form.title, async () => {
    const wrong = await change(model, form.text(model.selected.id, fields.map((each) => typed(each.input) || NOTHING)));
    showErrors(fields, wrong);
    return !wrong;
  });
}

function addForm(model) {
  const robots = () => model.run.rosters.at(-1)?.robots ?? [];
  const free = () => {
    let number = robots().length;
    while (robots().includes(`robot${number}`)) number++;
    return `robot${number}`;
  };
  const [x, y, heading] = poseOf(model).map(String);
  const like = el("select");
  setOptions(like, robots().slice(0, 500).map((each) => [each, each]));
  like.value = model.selected.id;
  const program = el("select");
  const file = el("input", { type: "file", accept: ".c" });
  const programs = [...new Set(model.status.robots.map((each) => each.program).concat(model.uploads ?? []))];
  setOptions(program, [["", "that robot's"], ...programs.map((each) => [each, each])]);
  const fields = [
    field("name", entry({ value: free() })), field("same type as", like), field("program", program), field("or a C file", file),
    field("x", entry({ value: String(Number(x) + 1) }), "m"), field("y", entry({ value: y }), "m"), field("heading", entry({ value: heading }), "°"),
  ];
  const [named, , , uploaded, ...pose] = fields;
  return formOf(fields, "Add", async () => {
    let running = program.value;
    if (file.files?.length) {
      const [chosen] = file.files;
      try {
        running = (await model.channel.request("upload", { name: chosen.name, text: await chosen.text() })).name;
        model.uploads = [...(model.uploads ?? []), running];
      } catch (error) {
        uploaded.setError(error.message);
        return false;
      }
    }
    const line = `join ${typed(named.input)} like ${like.value} to ${pose.map(({ input }) => typed(input) || NOTHING).join(" ")}`;
    const wrong = await change(model, running ? `${line} running ${running}` : line);
    showErrors([named, ...pose], wrong);
    if (!wrong) named.input.value = free();
    return !wrong;
  });
}

function formOf(fields, title, does) {
  return el("form.fields", { onsubmit: async (event) => {
    event.preventDefault();
    await does();
  } }, ...fields.map(({ row }) => row), el("div.row-end", {}, el("button.primary", { type: "submit" }, title)));
}
