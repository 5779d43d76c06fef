/** The selected robot: what can be done with it, and what its instruments show. */
import { button, el, fill } from "crs/dom.js";
import { actions } from "crs/actions.js";
import { drawSeries, limitsOf } from "crs/series.js";

const [WIDTH, HEIGHT] = [66, 20];

/** @type {import("./index.js").Panel} */
export const robot = {
  id: "robot",
  title: "Robot",
  side: "right",
  needs: "change",
  make(root, model, look, page) {
    const { instruments } = page;
    const title = el("h2.robot-name");
    const sensors = el("div.sensors");
    const state = el("table.state-rows");
    const isDebugged = model.run.can.includes("debug"); // else its program is not asked
    const body = el("div.robot-body", {}, title, actions(model, page),
      el("details", { open: true }, el("summary", {}, "Sensors"), sensors),
      isDebugged ? el("details", { open: true }, el("summary", {}, "State[] of the program"), state) : null);
    root.append(body);
    instruments.want("robot", () => ({ isShown: Boolean(root.offsetParent), since: instruments.span[0],
      expressions: ["speed", ...(instruments.now?.sensors.sonar?.elements ?? []).map(([at]) => `sonar.${at}`)] }));

    const spark = (expression, label, text) => {
      const canvas = el("canvas", { width: WIDTH * 2, height: HEIGHT * 2 });
      const pen = canvas.getContext("2d");
      const series = instruments.series.of(instruments.name(expression));
      const [begin, end] = instruments.span;
      const [least, most] = limitsOf(series, begin, end) ?? [0, 1];
      pen.scale(2, 2);
      pen.lineWidth = 1.2;
      pen.strokeStyle = look.colours.accent;
      const room = most - least || 1;
      drawSeries(pen, series, (time) => ((time - begin) / (end - begin)) * WIDTH, (value) => HEIGHT - 3 - ((value - least) / room) * (HEIGHT - 6));
      return el("button.spark", { type: "button", title: `Plot ${expression}`, "aria-label": `${expression} ${text}, plot`, onclick: () => page.plot(expression) },
        el("span", {}, label), el("b", {}, text), canvas);
    };

    const draw = (now) => {
      if (!root.offsetParent) return;
      title.textContent = model.selected.id;
      if (!now && !isDebugged) return fill(sensors);
      if (!now) return fill(sensors, el("p.hint", {}, "Its sensors and State[] are available at times to which its program has been run."),
        button({ text: "Run the programs to this time", title: "They run again, with the recorded input", onclick: () => model.request("sync") }));
      if (now.robot !== model.state.robot) return;
      const own = [["speed", "speed", "m/s"], ["battery", "battery", "%"]]
        .filter(([name]) => typeof now.byName.get(name) === "number")
        .map(([name, label, unit]) => spark(name, label, `${now.byName.get(name).toFixed(2)} ${unit}`));
      const rows = [el("div.sparks.own", {}, ...own)];
      for (const [device, { unit, elements }] of Object.entries(now.sensors)) {
        rows.push(el("h4", {}, device, el("span.unit", {}, unit && unit !== "-" ? ` [${unit}]` : "")),
          el("div.sparks", {}, ...elements.map(([at, name, value]) =>
            spark(`${device}.${at}`, elements.length > 1 ? name : "", value === null ? "–" : String(+value.toFixed(3))))));
      }
      fill(sensors, ...rows);
      fill(state, ...(now.state.length ? now.state.map(([name, text]) => el("tr", {}, el("th", {}, name), el("td", {}, text)))
        : [el("tr", {}, el("td", {}, "This program has no State[] yet."))]));
    };

    model.on("instruments", draw);
    model.on("look", () => draw(instruments.now));
  },
};
