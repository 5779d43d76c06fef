/** What the programs have printed, up to the time that is shown; a click goes to when it was printed. */
import { el, fill } from "crs/dom.js";

const MAX = 1500; // pieces

/** @type {import("./index.js").Panel} */
export const output = {
  id: "output",
  title: "Output",
  side: "right",
  recorded: true,
  make(root, model, _look, page) {
    const only = el("input", { type: "checkbox", onchange: () => draw(true) });
    const go = ({ target }) => {
      const { time } = target.dataset;
      if (time !== undefined && getSelection()?.isCollapsed !== false) page.timeline.seek(Number(time)); // not while text is selected
    };
    const text = el("pre#output.output", { tabIndex: 0, "aria-label": "what the programs print", onclick: go });
    text.id = "output";
    root.append(el("label.only", {}, only, "selected robot only"), text);
    let key = "";

    const draw = (isForced = false) => {
      if (!model.run) return;
      const time = model.clock.shown + 1e-9;
      const all = model.run.output;
      let count = all.length;
      while (count > 0 && all[count - 1][0] > time) count--;
      const now = `${count} ${all.length} ${model.state.robot} ${only.checked}`;
      if (now === key || (!isForced && !root.offsetParent && !model.channel.isLocal)) return;
      key = now;
      const names = model.run.rosters.at(-1)?.robots ?? [];
      const several = names.length > 1;
      const name = (robot) => (typeof robot === "number" ? names[robot] : robot);
      const chosen = only.checked ? all.slice(0, count).filter((each) => name(each[1]) === model.selected.id) : all.slice(0, count);
      let line = true;
      fill(text, ...chosen.slice(-MAX).map(([at, robot, stream, content]) => {
        const shown = several && line ? `[${name(robot)}] ${content}` : content;
        line = content.endsWith("\n");
        const piece = el(stream === 2 ? "span.err" : "span", { title: `${at.toFixed(3)} s: go there` }, shown);
        piece.dataset.time = String(at);
        return piece;
      }));
      text.scrollTop = text.scrollHeight;
    };

    model.on("tick", () => draw());
    for (const kind of ["hello", "truncate"]) model.on(kind, () => (key = ""));
  },
};
