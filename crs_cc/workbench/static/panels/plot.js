/** The plot: expressions of the selected robot over time. */
import { button, el, fill } from "crs/dom.js";
import { entry } from "crs/change.js";
import { drawPlot, leastHeight, LINES } from "crs/plot.js";

const MOST = 8; // expressions
/** @type {[string, string, number][]} id, title, seconds */
const SPANS = [["all", "all", 0], ["60", "60 s", 60], ["10", "10 s", 10], ["2", "2 s", 2]];
const OWN = ["speed", "turn", "battery", "clearance", "pose.x", "pose.y", "pose.heading", "sonar.0", "sonar.1"];
const PATIENCE = 6000; // for which what is not known is read without being told [ms]

/** @type {import("./index.js").Panel} */
export const plot = {
  id: "plot",
  title: "Plot",
  summary: "Plot of variables and readings over time",
  key: "g",
  side: "below",
  needs: "change",
  make(root, model, look, page) {
    const { instruments } = page;
    let expressions = ["speed"];
    /** @type {Map<string, number>} the colour of each, which it keeps */
    const colours = new Map([["speed", 0]]);
    let range = null; // while the user looks at a part: [begin, end]
    let span = 0;
    let scale = null;
    let isStale = true;
    let filledFor = "";
    const known = el("datalist", { id: "plot-names" }, ...OWN.map((value) => el("option", { value })));
    const input = entry({ placeholder: "add: clearance, sonar.0, a variable ...", title: `A variable or expression of the program, or: ${OWN.join(", ")} ...`, "aria-label": "expression to plot" });
    input.setAttribute("list", known.id);
    const wrong = el("span.wrong", { role: "alert" });
    const chips = el("div.chips");
    const spans = el("div.segmented", { role: "group", "aria-label": "span of time" }, ...SPANS.map(([id, text, seconds]) =>
      el("button", { type: "button", "data-span": id, onclick: () => zoom(Number(seconds)) }, text)));
    const past = button({ text: "Fill in the past", title: "Go back and read these values at earlier instants", onclick: () => fillIn() });
    past.hidden = true;
    const canvas = el("canvas", { tabIndex: 0, role: "img", "aria-label": "plot over time: click goes there, the wheel zooms" });
    root.classList.add("plot");
    root.append(el("div.bar", {}, input, known, spans, past, wrong), chips, el("div.canvas", {}, canvas));
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
        const taken = new Set(expressions.map((each) => colours.get(each)));
        if (!colours.has(expression)) colours.set(expression, LINES.findIndex((_, at) => !taken.has(at)));
        instruments.ask();
        isStale = true;
      }
    };

    /** Add what the user has typed, unless something is wrong with it. */
    const propose = async (expression) => {
      const reason = expression ? await instruments.check(expression) : "";
      wrong.textContent = reason && `${reason}; besides variables there are ${OWN.join(", ")} ...`;
      input.setAttribute("aria-invalid", String(Boolean(reason)));
      if (reason) return;
      add(expression);
      input.value = "";
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

    const knownSpan = () => [shown()[0], Math.min(shown()[1], model.state.end)];
    const fillIn = async () => {
      if (model.state.playing) await model.ask("pause");
      instruments.fill(expressions, ...knownSpan());
    };

    /** Read what is not known of these expressions, unless that takes long. */
    const fillSoon = () => {
      const { playing, busy } = model.state;
      const isMissing = expressions.some((each) => instruments.missing(each, ...knownSpan()));
      past.hidden = !isMissing || instruments.isFilling || !model.can("debug");
      const what = `${model.state.robot} ${expressions.join()} ${model.state.end} ${shown().join()}`;
      if (!isMissing || playing || busy || instruments.isFilling || what === filledFor || !model.can("debug")) return;
      filledFor = what;
      instruments.fill(expressions, ...knownSpan(), PATIENCE);
    };

    /** Those of a unit share a strip; those without have one of their own. */
    const strips = () => {
      const byUnit = new Map();
      for (const each of expressions) {
        const unit = instruments.units.get(each) ?? "";
        const key = unit ? `[${unit}]` : each;
        if (!byUnit.has(key)) byUnit.set(key, []);
        byUnit.get(key).push({ series: instruments.series.of(instruments.name(each)), colour: colourOf(each) });
      }
      return [...byUnit].map(([label, lines]) => ({ label, lines }));
    };
    const colourOf = (expression) => LINES[(colours.get(expression) ?? 0) % LINES.length];

    /** A chip stays while its value changes: one that is replaced under the pointer hears no click. */
    const chip = (each) => {
      const mark = el("i.dot");
      mark.style.background = colourOf(each);
      return el("span.chip", {}, mark, el("b", {}, each), el("span.value"),
        el("button.close", { type: "button", "aria-label": `remove ${each}`, title: "Remove", onclick: () => {
          expressions = expressions.filter((other) => other !== each);
          colours.delete(each);
          isStale = true;
        } }, "×"));
    };

    const legend = () => {
      const values = instruments.now?.robot === model.state.robot ? instruments.now.byName : new Map();
      const key = [model.selected.id, ...expressions].join("\n");
      if (key !== chips.dataset.key) fill(chips, el("span.hint", {}, model.selected.id), ...expressions.map(chip));
      chips.dataset.key = key;
      expressions.forEach((each, at) => {
        const shown = chips.children[at + 1].querySelector(".value");
        const value = values.get(each);
        shown.textContent = typeof value === "number" ? ` ${+value.toPrecision(5)} ${instruments.units.get(each) ?? ""}` : ` ${value ?? ""}`;
        shown.classList.toggle("bad", typeof value !== "number");
      });
      for (const each of spans.children) {
        each.setAttribute("aria-pressed", String(!range && SPANS.some(([id, , seconds]) => id === each.dataset.span && seconds === span)));
      }
    };

    const draw = (time) => {
      if (!root.offsetParent) return;
      const key = `${time} ${canvas.clientWidth} ${canvas.clientHeight} ${model.state.robot} ${shown()}`;
      if (!isStale && key === root.dataset.drawn) return;
      root.dataset.drawn = key;
      if (isStale) {
        legend();
        fillSoon();
      }
      isStale = false;
      const [begin, end] = shown();
      const all = strips();
      canvas.style.minHeight = `${leastHeight(all.length)}px`;
      scale = drawPlot(canvas, { strips: all, begin, end: Math.max(end, begin + 1e-3), now: time, colours: look.colours });
    };

    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key !== "Enter") return;
      propose(input.value.trim());
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
