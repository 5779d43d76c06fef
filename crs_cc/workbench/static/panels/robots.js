/** The robots: what each does, and where. A click selects. */
import { el, fill } from "crs/dom.js";

const MANY = 200;
const HINTS = { activity: "The motion of its motors, and what its program is waiting for. A command takes time on the link, the line between computer and robot." };
const OUTCOMES = { exited: "ended", failed: "error", left: "left", running: "" };

/** @type {import("./index.js").Panel} */
export const robots = {
  id: "robots",
  title: "Robots",
  side: "left",
  make(root, model, look) {
    const list = el("div.robots", { role: "listbox", "aria-label": "robots" });
    const details = el("dl.details");
    root.append(list, details);
    let names = [];
    let first = 0;

    const draw = () => {
      const roster = model.run.rosters.at(-1)?.robots ?? [];
      first = model.status.robots.length ? model.status.first : 0;
      const shown = roster.slice(first, first + MANY);
      if (shown.join() !== names.join()) {
        names = shown;
        fill(list, ...shown.map((id, number) => row(id, first + number)));
        if (roster.length > shown.length) list.append(el("p.hint", {}, `${shown.length} of ${roster.length} robots`));
      }
      shown.forEach((id, number) => update(list.children[number], first + number));
      describe();
    };

    const row = (id, number) => {
      const colour = look.model.run.world.robots[number]?.colour ?? "#888888";
      const dot = el("i.dot");
      dot.style.background = colour;
      return el("button.robot", { type: "button", role: "option", onclick: () => model.select(number) },
        dot, el("b", {}, id), el("span.speed"), el("span.place"), el("span.does"));
    };

    const update = (element, number) => {
      element.setAttribute("aria-selected", String(number === model.state.robot));
      const data = model.status.robots[number - model.status.first];
      if (!data) return;
      const [, , speed, place, does] = element.children;
      const outcome = OUTCOMES[data.outcome] ?? data.outcome;
      const isPressed = Boolean(model.status.sensors.bumpers[number - model.status.first]);
      speed.textContent = outcome || (isPressed ? "bumper" : data.present ? `${data.speed.toFixed(2)} m/s` : "absent");
      speed.className = `speed ${data.outcome === "failed" || isPressed ? "bad" : ""}`;
      place.textContent = data.line ? `${data.file}:${data.line} ${data.function}` : data.program;
      does.textContent = data.outcome === "running" ? data.does : "";
    };

    const describe = () => {
      const data = model.status.robots[model.state.robot - model.status.first];
      if (!data) return fill(details);
      const body = look.model.scene?.body(model.state.robot);
      const turn = Math.round((data.turn * 180) / Math.PI);
      const rows = [
        ["kind", data.kind],
        ["program", data.program],
        body ? ["position", `${body.x.toFixed(3)}, ${body.y.toFixed(3)} m`] : null,
        body ? ["heading", `${(((body.heading * 180) / Math.PI + 3600) % 360).toFixed(1)}°`] : null,
        ["speed", `${data.speed.toFixed(3)} m/s, ${turn}°/s`],
        data.battery === null ? null : ["battery", `${(100 * data.battery).toFixed(1)}%`],
        ["collisions", String(data.collisions)],
        ["activity", data.does],
        data.fails?.length ? ["fails", data.fails.join("; ")] : null,
      ];
      fill(details, ...rows.filter((each) => each).flatMap(([name, text]) => [el("dt", {}, name), el("dd", { title: HINTS[name] }, text)]));
    };

    for (const kind of ["hello", "status", "look", "roster"]) model.on(kind, () => model.run && draw());
    let described = -1; // the time that the numbers are of
    model.on("tick", () => {
      const time = look.model.scene?.time ?? -1;
      if (model.state.playing || time === described) return;
      described = time;
      describe();
    });
  },
};
