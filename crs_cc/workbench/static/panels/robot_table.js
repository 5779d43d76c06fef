/** The table of robots: what each does, where, how fast, and what fails. Only rows in view are made. */
import { el } from "crs/dom.js";
import { oneAtATime } from "crs/one_at_a_time.js";
import { angleText } from "crs/units.js";

const ROW = 30; // pixels
const SPARE = 6; // rows beyond those in view
const COLUMNS = ["robot", "kind", "program", "line", "pose", "speed", "battery", "bumper", "state", "faults"];
const OUTCOMES = { exited: "ended", failed: "error", left: "left" };

/** A row: its elements stay, and only what has changed is written. */
class Row {
  /** @param {HTMLElement} body @param {(robot: number) => void} choose */
  constructor(body, choose) {
    this.robot = -1;
    this.dot = el("i.dot");
    this.name = document.createTextNode("");
    this.cells = COLUMNS.slice(1).map(() => el("span", { role: "gridcell" }));
    this.shown = [];
    this.element = el("div.row", { role: "row", onclick: () => choose(this.robot) },
      el("span", { role: "rowheader" }, this.dot, this.name), ...this.cells);
    body.append(this.element);
  }

  /** Be the row of another robot. */
  become(robot, name, colour) {
    this.robot = robot;
    this.element.id = `robot-row-${robot}`;
    this.name.data = name;
    this.dot.style.background = colour;
  }

  /** @param {number} top [pixels] @param {boolean} isChosen @param {[string, string][]} texts and their classes */
  show(top, isChosen, texts) {
    if (this.top !== top) this.element.style.transform = `translateY(${(this.top = top)}px)`;
    if (this.isChosen !== isChosen) this.element.setAttribute("aria-selected", String((this.isChosen = isChosen)));
    texts.forEach(([text, kind], at) => {
      const key = `${kind} ${text}`;
      if (this.shown[at] === key) return;
      this.shown[at] = key;
      const cell = this.cells[at];
      [cell.textContent, cell.className, cell.title] = [text, kind.slice(1), text.length > 12 ? text : ""];
    });
  }
}

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

    /** The place of the first row in view, and the robots of the rows. @returns {[number, number[]]} */
    const visible = () => {
      const first = Math.max(0, Math.floor(scroll.scrollTop / ROW) - SPARE);
      return [first, numbers.slice(first, first + Math.ceil(scroll.clientHeight / ROW) + 2 * SPARE)];
    };

    /** @type {Map<number, Row>} the rows that are shown, by robot; those that leave are used again */
    const rows = new Map();
    const draw = () => {
      if (!root.offsetParent || !model.run) return;
      isDrawn = true;
      const names = model.run.rosters.at(-1)?.robots ?? [];
      const [first, shown] = visible();
      const wanted = new Set(shown);
      const free = [...rows.keys()].filter((number) => !wanted.has(number));
      shown.forEach((number, at) => {
        let row = rows.get(number);
        if (!row) {
          const other = free.pop();
          row = other === undefined ? new Row(body, (chosen) => model.select(chosen)) : rows.get(other);
          rows.delete(other);
          rows.set(number, row);
          row.become(number, names[number], model.run.world.robots[number]?.colour ?? "#888888");
        }
        const data = known.get(number) ?? model.status.robots[number - model.status.first];
        row.show((first + at) * ROW, number === model.state.robot, cells(data, number));
      });
      for (const number of free) {
        rows.get(number).element.remove();
        rows.delete(number);
      }
    };

    /** The texts of a row, and their classes. @returns {[string, string][]} */
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
        [data.battery === null ? "–" : `${(100 * data.battery).toFixed(0)}%`, ".number"],
        [bumpers.length ? bumpers.join(", ") : "–", bumpers.length ? ".bad" : ""],
        [state || "runs", isBad ? ".bad" : ""],
        [(data.fails ?? []).join("; ") || "–", data.fails?.length ? ".bad" : ""],
      ];
    };

    const refresh = oneAtATime(async () => {
      if (!root.offsetParent || !model.isConnected) return;
      if (!model.run?.can.includes("debug")) return draw();
      try {
        const [, shown] = visible();
        const answer = await model.channel.request("rows", { robots: shown.slice(0, 100).join(",") });
        known.clear();
        for (const each of answer.robots) known.set(each.number, each);
        draw();
      } catch {
        // the next status asks again
      }
    });

    scroll.addEventListener("scroll", () => {
      draw();
      refresh();
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
      refresh();
    });
    for (const kind of ["hello", "roster", "truncate"]) model.on(kind, choose);
    model.on("status", refresh);
    model.on("look", () => {
      if (!isDrawn) choose();
      draw();
      refresh();
    });
  },
};
