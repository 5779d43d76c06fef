/** The plot: expressions of the selected robot over time. */
import { button, el, fill } from "crs/dom.js";
import { entry } from "crs/change.js";
import { drawPlot, LINES } from "crs/plot.js";

const MOST = 8; // expressions
const SPANS = [["all", "all", 0], ["60", "60 s", 60], ["10", "10 s", 10], ["2", "2 s", 2]];
const EXAMPLES = "a variable of the program, State[17], sonar.0, speed, turn, battery, pose.x";

/** @type {import("./index.js").Panel} */
export const plot = {
  id: "plot",
  title: "Plot",
  summary: "Plot of variables and readings over time",
  key: "g",
  side: "below",
  needs: "debug",
  make(root, model, look, page) {
    const { instruments } = page;
    let expressions = ["speed"];
    let range = null; // while the user looks at a part: [begin, end]
    let span = 0;
    let scale = null;
    let isStale = true;
    const input = entry({ placeholder: `add: ${EXAMPLES}`, "aria-label": "expression to plot" });
    const wrong = el("span.wrong", { role: "alert" });
    const chips = el("div.chips");
    const spans = el("div.segmented", { role: "group", "aria-label": "span of time" }, ...SPANS.map(([id, text, seconds]) =>
      el("button", { type: "button", "data-span": id, onclick: () => zoom(Number(seconds)) }, text)));
    const past = button({ text: "Fill in the past", title: "Go back and read these values at earlier instants", onclick: () => fillIn() });
    const canvas = el("canvas", { tabIndex: 0, role: "img", "aria-label": "plot over time: click goes there, the wheel zooms" });
    root.classList.add("plot");
    root.append(el("div.bar", {}, input, spans, past, wrong), chips, el("div.canvas", {}, canvas));
    instruments.want("plot", () => ({ isShown: Boolean(root.offsetParent), expressions }));

    page.plot = (expression) => {
      add(expression);
      page.drawer.open("plot");
    };

    const add = (expression) => {
      if (!expression || expressions.includes(expression)) return;
      if (expressions.length >= MOST) wrong.textContent = `at most ${MOST} lines: remove one`;
      else {
        expressions = [...expressions, expression];
        instruments.ask();
        isStale = true;
      }
    };

    const zoom = (seconds) => {
      [span, range] = [seconds, null];
      isStale = true;
    };

    /** What is shown: a part, the last seconds, the loop of the time line, or all of it. */
    const shown = () => {
      const { t, span: loop } = model.state;
      if (range) return range;
      if (span) return [Math.max(0, Math.max(t, span) - span), Math.max(t, span)];
      return loop ?? [0, page.timeline.end];
    };

    const fillIn = async () => {
      const [begin, end] = shown();
      past.disabled = true;
      await instruments.fill(expressions, begin, Math.min(end, model.state.end), 200);
      past.disabled = false;
    };

    const legend = () => {
      const values = instruments.now?.robot === model.state.robot ? instruments.now.byName : new Map();
      fill(chips, el("span.hint", {}, model.selected.id), ...expressions.map((each, at) => {
        const mark = el("i.dot");
        mark.style.background = LINES[at % LINES.length];
        const value = values.get(each);
        const text = typeof value === "number" ? +value.toPrecision(5) : value ?? "";
        return el("span.chip", {}, mark, el("b", {}, each), el(typeof value === "number" ? "span" : "span.bad", {}, ` ${text}`),
          el("button.close", { type: "button", "aria-label": `remove ${each}`, title: "Remove", onclick: () => {
            expressions = expressions.filter((other) => other !== each);
            isStale = true;
          } }, "×"));
      }));
      for (const each of spans.children) {
        each.setAttribute("aria-pressed", String(!range && SPANS.some(([id, , seconds]) => id === each.dataset.span && seconds === span)));
      }
    };

    const draw = (time) => {
      if (!root.offsetParent) return;
      const key = `${time} ${canvas.clientWidth} ${canvas.clientHeight} ${model.state.robot} ${shown()}`;
      if (!isStale && key === root.dataset.drawn) return;
      root.dataset.drawn = key;
      if (isStale) legend();
      isStale = false;
      const [begin, end] = shown();
      scale = drawPlot(canvas, {
        series: expressions.map((each) => instruments.series.of(instruments.name(each))),
        begin, end: Math.max(end, begin + 1e-3), now: time, colours: look.colours,
      });
    };

    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key !== "Enter") return;
      wrong.textContent = "";
      add(input.value.trim());
      input.value = "";
    });
    canvas.addEventListener("click", (event) => scale && page.timeline.seek(scale.time(event.offsetX)));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      if (!scale) return;
      const [[begin, end], at] = [shown(), scale.time(event.offsetX)];
      const factor = event.deltaY > 0 ? 1.25 : 0.8;
      const next = [Math.max(0, at - (at - begin) * factor), Math.min(page.timeline.end, at + (end - at) * factor)];
      range = next[1] - next[0] > 0.05 ? next : range;
      if (range && range[0] <= 0 && range[1] >= page.timeline.end) range = null;
      isStale = true;
    }, { passive: false });
    for (const kind of ["instruments", "look", "forget", "hello", "state"]) model.on(kind, () => (isStale = true));
    model.on("tick", draw);
  },
};
