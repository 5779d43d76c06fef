/** Histories under the timeline, which share its axis: expressions of the selected robot over time. */
import { entry } from "crs/change.js";
import { button, el, fill } from "crs/dom.js";
import { isAtLine, OWN } from "crs/instruments.js";
import { areWords, drawPlot, heightOf, LEFT, LINES, RIGHT } from "crs/plot.js";
import { indexAt } from "crs/series.js";

const MAX = 8; // expressions
const NEAR = 6; // a click so near to a change goes exactly there [pixels]
/** @type {[string, string, number][]} id, title, seconds */
const SPANS = [["all", "all", 0], ["60", "60 s", 60], ["10", "10 s", 10], ["2", "2 s", 2]];
const HISTORY_TIMEOUT = 6000; // time for reading unknown values without a request [ms]

/** @type {import("./index.js").Panel} */
export const plot = {
  id: "plot",
  title: "Plot",
  summary: "Histories of variables and readings, under the timeline",
  key: "g",
  side: "under",
  needs: "change",
  make(root, model, look, page) {
    const { instruments, timeline } = page;
    let expressions = ["speed"];
    /** @type {Map<string, number>} the colour of each, which it keeps */
    const colours = new Map([["speed", 0]]);
    let pointed = null; // the time at the pointer
    let isStale = true;
    let filledFor = "";
    /** @type {import("crs/plot.js").Strip[]} the strips that are drawn, and where each ends [pixels] */
    let drawn = [];
    /** @type {number[]} */
    let ends = [];
    const known = el("datalist", { id: "plot-names" }, ...OWN.map((value) => el("option", { value })));
    const input = entry({ placeholder: "add: clearance, sonar.0, a variable, error at 23 ...", title: `A variable or expression of the program; "error at 23" has its values each time line 23 was reached; or: ${OWN.join(", ")} ...`, "aria-label": "expression to plot" });
    input.setAttribute("list", known.id);
    const wrong = el("span.wrong", { role: "alert" });
    const chips = el("div.chips");
    const spans = el("div.segmented", { role: "group", "aria-label": "time span" }, ...SPANS.map(([id, text, seconds]) =>
      el("button", { type: "button", "data-span": id, onclick: () => timeline.showPart(null, seconds) }, text)));
    const past = button({ text: "Fill in the past", title: "Run the past again, and record each change to these values", onclick: () => fillIn() });
    past.hidden = true;
    const canvas = el("canvas", { tabIndex: 0, role: "img", "aria-label": "plot over time: click or drag to go to a time, or exactly to a change; the wheel zooms" });
    const box = el("div.canvas", {}, canvas);
    root.classList.add("plot");
    root.append(el("div.bar", {}, input, known, spans, past, chips, wrong), box);
    instruments.want("plot", () => ({ isShown: Boolean(root.offsetParent), expressions }));

    /** Add an expression. @param {string} expression */
    page.plot = (expression) => {
      page.drawer.open("plot");
      propose(expression);
    };

    const add = (expression) => {
      if (!expression || expressions.includes(expression)) return;
      if (expressions.length >= MAX) wrong.textContent = `at most ${MAX} lines: remove one`;
      else {
        expressions = [...expressions, expression];
        const taken = new Set(expressions.map((each) => colours.get(each)));
        if (!colours.has(expression)) colours.set(expression, LINES.findIndex((_, at) => !taken.has(at)));
        instruments.refresh();
        isStale = true;
      }
    };

    /** Add what the user has typed, unless something is wrong with it. */
    const propose = async (typed) => {
      const expression = isAtLine(typed) ? typed.replace(/ at (\d+)$/, ` at ${page.code?.file ?? ""}:$1`) : typed;
      const reason = expression && !OWN.includes(expression) ? await instruments.check(expression) : "";
      const others = `; besides variables there are ${OWN.join(", ")} ...`;
      wrong.textContent = reason && `${reason}${isAtLine(expression) ? "" : others}`;
      input.setAttribute("aria-invalid", String(Boolean(reason)));
      if (reason) return;
      add(expression);
      if (input.value.trim() === typed) input.value = "";
    };

    const knownSpan = () => {
      const [begin, end] = timeline.shownPart;
      return [begin, Math.min(end, model.state.end)];
    };
    const fillIn = async () => {
      if (model.state.playing) await model.request("pause");
      instruments.fill(expressions, ...knownSpan());
    };

    /** Read what is not known of these expressions, unless that takes long. */
    const fillSoon = () => {
      const { playing, busy } = model.state;
      const isMissing = expressions.some((each) => instruments.missing(each, ...knownSpan()));
      past.hidden = !isMissing || instruments.isFilling || !model.can("debug");
      const what = `${model.state.robot} ${expressions.join()} ${model.state.end} ${knownSpan().join()}`;
      if (!isMissing || playing || busy || instruments.isFilling || what === filledFor || !model.can("debug") || model.run.follows === false) return;
      filledFor = what;
      instruments.fill(expressions, ...knownSpan(), HISTORY_TIMEOUT);
    };

    /** Those of a unit share a strip; those without, and those that are no numbers, have their own. */
    const strips = () => {
      const byUnit = new Map();
      for (const each of expressions) {
        const series = seriesOf(each);
        const unit = instruments.units.get(each) ?? "";
        const words = series.isStep && areWords(series);
        const key = unit && !words ? `[${unit}]` : each;
        if (!byUnit.has(key)) byUnit.set(key, { label: key.replace(/ at \S+$/, ""), words, lines: [] });
        const [, until] = instruments.filled.get(instruments.name(each)) ?? [0, 0];
        byUnit.get(key).lines.push({ series, colour: colourOf(each), until: Math.min(until, model.state.end) });
      }
      return [...byUnit.values()];
    };
    const seriesOf = (expression) => instruments.series.of(instruments.name(expression));
    const colourOf = (expression) => LINES[(colours.get(expression) ?? 0) % LINES.length];

    /** A chip is kept while its value changes: one that is replaced under the pointer receives no click. */
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

    /** What an expression is at the pointer, or else now. @returns {[string, boolean]} its text, and whether it is no value */
    const valueOf = (expression) => {
      const error = instruments.wrong.get(instruments.name(expression));
      if (error) return [error, true];
      const values = instruments.now?.robot === model.state.robot ? instruments.now.byName : new Map();
      const unit = instruments.units.get(expression) ?? "";
      const series = seriesOf(expression);
      const at = indexAt(series.times, pointed ?? model.clock.shown);
      if (pointed === null && values.has(expression)) {
        const value = values.get(expression);
        return typeof value === "number" ? [`${+value.toPrecision(5)} ${unit}`, false] : [value ?? "", !series.isStep];
      }
      if (at < 0) return ["", false];
      return [series.texts[at] ?? (Number.isNaN(series.values[at]) ? "" : `${+series.values[at].toPrecision(5)} ${unit}`), false];
    };

    const legend = () => {
      const key = [model.selected.id, ...expressions].join("\n");
      if (key !== chips.dataset.key) fill(chips, el("span.hint", {}, model.selected.id), ...expressions.map(chip));
      chips.dataset.key = key;
      expressions.forEach((each, at) => {
        const shown = chips.children[at + 1].querySelector(".value");
        const [text, isBad] = valueOf(each);
        shown.textContent = ` ${text}`;
        shown.title = text;
        shown.classList.toggle("bad", isBad);
      });
      for (const each of spans.children) {
        each.setAttribute("aria-pressed", String(!timeline.range && SPANS.some(([id, , seconds]) => id === each.dataset.span && seconds === timeline.last)));
      }
    };

    const draw = (time) => {
      if (!root.offsetParent) return;
      const key = `${time} ${canvas.clientWidth} ${canvas.clientHeight} ${model.state.robot} ${timeline.shownPart} ${pointed}`;
      if (!isStale && key === root.dataset.drawn) return;
      root.dataset.drawn = key;
      legend();
      if (isStale) fillSoon();
      isStale = false;
      const [begin, end] = timeline.shownPart;
      const all = strips();
      canvas.style.height = box.style.height = `${heightOf(all)}px`;
      drawn = all;
      ends = drawPlot(canvas, { strips: all, begin, end: Math.max(end, begin + 1e-3), now: time, pointed, colours: look.colours });
    };

    const timeAt = (x) => timeline.timeAt(x - LEFT, canvas.clientWidth - LEFT - RIGHT);

    /** The place of the change that is nearest to a point in its strip, if it is near. @returns {string | undefined} */
    const placeAt = (time, y) => {
      const [begin, end] = timeline.shownPart;
      const near = (NEAR * (end - begin)) / Math.max(1, canvas.clientWidth - LEFT - RIGHT);
      let [found, least] = [undefined, near];
      const { lines } = drawn[ends.findIndex((low) => y < low)] ?? { lines: [] };
      for (const { times, texts, places } of lines.map(({ series }) => series)) {
        const at = indexAt(times, time);
        for (const each of [at, at + 1]) {
          if (places[each] && texts[each] !== texts[each - 1] && Math.abs(times[each] - time) < least) [found, least] = [places[each], Math.abs(times[each] - time)];
        }
      }
      return found;
    };

    const end = (event) => {
      const time = timeAt(event.offsetX);
      const place = placeAt(time, event.offsetY);
      if (place && Math.abs(event.clientX - pressed) < 3) page.go(place);
      else timeline.drag(time, true);
    };
    let pressed = 0;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pressed = event.clientX;
    });
    canvas.addEventListener("pointermove", (event) => {
      pointed = timeAt(event.offsetX);
      if (event.buttons && Math.abs(event.clientX - pressed) >= 3) timeline.drag(pointed, false);
    });
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointerleave", () => (pointed = null));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) timeline.pan((event.deltaX || event.deltaY) / canvas.clientWidth);
      else timeline.zoom(timeAt(event.offsetX), event.deltaY > 0 ? 1.25 : 0.8);
    }, { passive: false });
    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Enter") propose(input.value.trim());
      else if (event.key === "Escape") input.blur();
    });
    for (const kind of ["instruments", "look", "truncate", "hello", "state", "part"]) model.on(kind, () => (isStale = true));
    model.on("tick", draw);
  },
};
