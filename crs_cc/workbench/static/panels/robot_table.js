/** The table of robots: what each does, where, how fast, and what fails. Only rows in view are made. */
import { el, fill } from "crs/dom.js";
import { oneAtATime } from "crs/one_at_a_time.js";
import { angleText } from "crs/units.js";

const ROW = 30; // pixels
const SPARE = 6; // rows beyond those in view
const COLUMNS = ["robot", "kind", "program", "stands at", "pose", "speed", "battery", "bumper", "state", "what fails"];
const OUTCOMES = { exited: "ended", failed: "error", left: "left" };

/** @type {import("./index.js").Panel} */
export const robotTable = {
  id: "table",
  title: "Robots",
  summary: "Table of the robots",
  key: "9",
  side: "below",
  asks: true,
  make(root, model, look) {
    const filter = el("input", { type: "text", placeholder: "find a robot", "aria-label": "find a robot", spellcheck: false });
    const counted = el("span.hint");
    const body = el("div.rows", { role: "rowgroup" });
    const head = el("div.row.head", { role: "row" }, ...COLUMNS.map((name) => el("span", { role: "columnheader" }, name)));
    root.classList.add("robot-table");
    const scroll = el("div.scroll", { tabIndex: 0, role: "grid", "aria-label": "robots" }, head, body);
    root.append(el("div.bar", {}, filter, counted), scroll);
    /** @type {Map<number, any>} */
    const known = new Map();
    let numbers = [];
    let isDrawn = false;

    const choose = () => {
      const names = model.run?.rosters.at(-1)?.robots ?? [];
      const wanted = filter.value.trim().toLowerCase();
      numbers = names.map((_, number) => number).filter((number) => !wanted || names[number].toLowerCase().includes(wanted));
      counted.textContent = wanted ? `${numbers.length} of ${names.length}` : `${names.length} robot${names.length === 1 ? "" : "s"}`;
      body.style.height = `${numbers.length * ROW}px`;
      draw();
    };

    const visible = () => {
      const first = Math.max(0, Math.floor(scroll.scrollTop / ROW) - SPARE);
      return [first, numbers.slice(first, first + Math.ceil(scroll.clientHeight / ROW) + 2 * SPARE)];
    };

    const draw = () => {
      if (!root.offsetParent || !model.run) return;
      isDrawn = true;
      const names = model.run.rosters.at(-1)?.robots ?? [];
      const [first, shown] = visible();
      fill(body, ...shown.map((number, at) => row(names[number], number, first + at)));
    };

    const row = (id, number, place) => {
      const data = known.get(number) ?? model.status.robots[number - model.status.first];
      const dot = el("i.dot");
      dot.style.background = model.run.world.robots[number]?.colour ?? "#888888";
      const made = el("div.row", { role: "row", id: `robot-row-${number}`, "aria-selected": String(number === model.state.robot), onclick: () => model.select(number) },
        el("span", { role: "rowheader" }, dot, id), ...cells(data, number).map(([text, kind]) => el(`span${kind}`, { role: "gridcell", title: text.length > 12 ? text : undefined }, text)));
      made.style.top = `${place * ROW}px`;
      return made;
    };

    const cells = (data, number) => {
      if (!data) return COLUMNS.slice(1).map(() => ["", ""]);
      const body = data.pose ? null : model.scene?.body(number);
      const [x, y, heading] = data.pose ?? [body?.x, body?.y, body?.heading];
      const bumpers = [...Array(20).keys()].filter((bit) => (data.bumper >> bit) & 1);
      const isBad = data.outcome === "failed";
      const state = OUTCOMES[data.outcome] ?? (data.present ? data.does : "absent");
      return [
        [data.kind, ""], [data.program, ""],
        [data.line ? `${data.file}:${data.line} ${data.function}` : "", ".code"],
        [data.present && Number.isFinite(x) ? `${x.toFixed(3)}, ${y.toFixed(3)} m, ${angleText(heading)}` : "–", ".number"],
        [data.present ? `${data.speed.toFixed(2)} m/s` : "–", ".number"],
        [data.battery === null ? "–" : `${(100 * data.battery).toFixed(0)} %`, ".number"],
        [bumpers.length ? bumpers.join(", ") : "–", bumpers.length ? ".bad" : ""],
        [state || "runs", isBad ? ".bad" : ""],
        [(data.fails ?? []).join("; ") || "–", data.fails?.length ? ".bad" : ""],
      ];
    };

    const ask = oneAtATime(async () => {
      if (!root.offsetParent || !model.isConnected) return;
      if (!model.run?.can.includes("debug")) return draw();
      try {
        const [, shown] = visible();
        const answer = await model.channel.ask("rows", { robots: shown.slice(0, 100).join(",") });
        known.clear();
        for (const each of answer.robots) known.set(each.number, each);
        draw();
      } catch {
        // the next status asks again
      }
    });

    scroll.addEventListener("scroll", () => {
      draw();
      ask();
    });
    scroll.addEventListener("keydown", (event) => {
      const way = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      const at = Math.min(numbers.length - 1, Math.max(0, numbers.indexOf(model.state.robot) + way));
      if (numbers[at] === undefined) return;
      scroll.scrollTop = Math.max(Math.min(scroll.scrollTop, at * ROW), (at + 2) * ROW - scroll.clientHeight);
      model.select(numbers[at]);
    });
    filter.addEventListener("input", () => {
      scroll.scrollTop = 0;
      choose();
      ask();
    });
    for (const kind of ["hello", "roster", "forget"]) model.on(kind, choose);
    model.on("status", ask);
    model.on("look", () => {
      if (!isDrawn) choose();
      draw();
      ask();
    });
  },
};
