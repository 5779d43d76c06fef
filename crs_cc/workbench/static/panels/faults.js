/** Faults: degrade any element of any sensor or actuator of the selected robot; what is in force; heal. */
import { change, changeOrSay, choice, entry, field, setOptions, typed } from "crs/change.js";
import { button, el, fill } from "crs/dom.js";
import { sideText } from "crs/units.js";

const TITLES = { onset: "from", duration: "for", recovery: "fading for" };
const HINTS = {
  gain: "times", bias: "plus", noise: "standard deviation", step: "rounded to", stuck: "fixed value", delay: "delayed by",
  dropouts: "fraction dropped, 0 to 1", onset: "now", duration: "ever", recovery: "0",
};
const PHASES = { waits: "waits", acts: "acts", fades: "fades", over: "over" };

/** @type {import("./index.js").Panel} */
export const faults = {
  id: "faults",
  title: "Faults",
  side: "right",
  needs: "change",
  make(root, model) {
    const title = el("h2.robot-name");
    const form = el("form.fields", { onsubmit: (event) => {
      event.preventDefault();
      degrade();
    } });
    const list = el("div.fault-list");
    const heading = el("h3", {}, "In force");
    root.append(el("div.robot-body", {}, title, form, heading, list));
    let asked = "";
    /** @type {any} */
    let parts = null;

    const load = async () => {
      const { id, number } = model.selected;
      if (!root.offsetParent || !id || asked === id) return;
      asked = id;
      title.textContent = `Faults of ${id}`;
      const answer = await model.request("faults", { robot: number });
      if (answer && asked === id) make(answer);
    };

    const make = ({ devices, fields }) => {
      const kinds = (acts) => devices.filter((each) => each.acts === acts).map((each) => el("option", { value: each.name, title: each.title }, each.name));
      const device = el("select", { onchange: () => elements() },
        el("optgroup", { label: "sensors" }, ...kinds(false)), el("optgroup", { label: "actuators" }, ...kinds(true)));
      if (devices.some((each) => each.name === "sonar")) device.value = "sonar";
      const element = choice([["", "all"]], { onchange: () => units() });
      const laws = fields.map((law) => {
        if (law.kind === "flag") {
          const box = el("input", { type: "checkbox" });
          return { law, ...field(law.name, box) };
        }
        const made = field(TITLES[law.name] ?? law.name, entry({ placeholder: HINTS[law.name] ?? "" }), law.unit ?? "");
        if (!law.word) return { law, ...made };
        const held = el("input", { type: "checkbox", title: "the last value before the onset", onchange: () => (made.input.disabled = held.checked) });
        made.row.querySelector(".entry").append(el("label.held", {}, held, law.word));
        return { law, ...made, held };
      });
      const what = el("p.hint");
      parts = { devices, device, element, laws, what };
      const rows = (isTime) => laws.filter(({ law }) => law.is_time === isTime).map(({ row }) => row);
      fill(form, field("device", device).row, field("element", element).row, what,
        el("div.laws", {}, ...rows(false)), el("div.laws", {}, ...rows(true)),
        el("div.row-end", {}, button({ text: "Clear", title: "Clear the form", onclick: () => make({ devices, fields }) }),
          el("button.primary", { type: "submit" }, "Degrade")));
      elements();
    };

    const chosen = () => parts.devices.find((each) => each.name === parts.device.value);

    const elements = () => {
      const { title: text, nothing, elements: all } = chosen();
      const kind = model.scene.body(model.selected.number)?.kind;
      const sides = { sonar: kind?.sonars.map((each) => each.direction), bumper: kind?.bumpers.map((each) => each.bearing) }[chosen().name];
      const about = (number, name) => (sides?.[number] !== undefined ? sideText(sides[number]) : name === String(number) ? "" : name);
      const named = all.map(([number, name]) => [String(number), about(number, name) ? `${number} (${about(number, name)})` : name]);
      setOptions(parts.element, all.length > 1 ? [["", "all"], ...named] : named);
      parts.what.textContent = `${text[0].toUpperCase()}${text.slice(1)}. Dead or dropped: ${nothing}.`;
      units();
    };

    /** Values are in the unit of the element. */
    const units = () => {
      const { elements: all } = chosen();
      const [, , unit] = all.find(([number]) => String(number) === parts.element.value) ?? all[0];
      for (const each of parts.laws) if (each.law.unit === null && each.law.kind !== "flag") each.unit(unit === "-" ? "" : unit);
    };

    const degrade = async () => {
      const words = [];
      for (const { law, input, held } of parts.laws) {
        if (law.kind === "flag") words.push(...(input.checked ? [law.name] : []));
        else if (held?.checked) words.push(law.name);
        else if (typed(input)) words.push(law.name, typed(input));
      }
      const { value } = parts.element;
      const device = `${parts.device.value}${value && chosen().elements.length > 1 ? `.${value}` : ""}`;
      const wrong = await change(model, `degrade ${model.selected.id} ${device} ${words.join(" ")}`);
      for (const each of parts.laws) each.setError("");
      if (!wrong) return;
      for (const line of (words.length ? wrong : "choose at least one fault").split("\n")) {
        const about = parts.laws.find(({ law }) => line.startsWith(`${law.name}:`) || line.startsWith(`${law.name} `));
        (about ?? parts.laws[0]).setError(line.replace(`${about?.law.name}: `, ""));
      }
    };

    const show = () => {
      const all = model.panel?.faults ?? [];
      const own = model.selected.id;
      const sorted = [...all.filter((each) => each.robot === own), ...all.filter((each) => each.robot !== own)];
      heading.textContent = all.length ? `In force (${all.length})` : "In force";
      if (!sorted.length) return fill(list, el("p.hint", {}, "No degradations."));
      fill(list, ...sorted.map((each) => el("div.in-force", {},
        el("span.chip", { title: timesOf(each) }, PHASES[each.phase] ?? each.phase),
        el("button.link", { type: "button", title: `Select ${each.robot}`, onclick: () => select(each.robot) }, each.robot),
        el("span", {}, each.text, el("span.times", {}, ` ${timesOf(each)}`)),
        button({ text: "Heal", title: `Remove ${each.id}`, onclick: () => changeOrSay(model, `heal ${each.id}`) }))));
    };

    const select = (id) => {
      const number = (model.run.rosters.at(-1)?.robots ?? []).indexOf(id);
      if (number >= 0) model.select(number);
    };

    model.on("panel", show);
    model.on("look", () => {
      load();
      show();
    });
    model.on("hello", () => {
      asked = "";
      load();
    });
  },
};

function timesOf({ onset, duration, recovery }) {
  const end = duration === null ? "" : `, for ${+duration.toFixed(3)} s`;
  return `from ${+onset.toFixed(3)} s${end}${recovery ? `, fades in ${+recovery.toFixed(3)} s` : ""}`;
}
