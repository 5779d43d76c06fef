/** What has happened: collisions, messages, errors; a click goes there. */
import { el, fill } from "crs/dom.js";
import { MARKS, markOf } from "crs/timeline.js";

const MOST = 400; // rows

/** @type {import("./index.js").Panel} */
export const events = {
  id: "events",
  title: "Events",
  side: "right",
  make(root, model, look, page) {
    const chosen = new Set(MARKS.map((mark) => mark.name));
    const filters = el("div.filters", {}, ...MARKS.filter((mark) => mark.name !== "print").map((mark) =>
      el("label", {}, el("input", { type: "checkbox", checked: true, onchange: (event) => {
        if (event.target.checked) chosen.add(mark.name);
        else chosen.delete(mark.name);
        isStale = true;
      } }), mark.title)));
    const name = el("span");
    const isWanted = el("input", { type: "checkbox", onchange: () => (isStale = true) });
    const only = el("label.only-robot", { title: "Events of the selected robot, and of no robot" }, isWanted, name);
    filters.append(only);
    const closest = el("button.event.closest", { type: "button", title: "Go there", onclick: () => page.timeline.seek(first[0]) });
    const list = el("div.events");
    root.append(filters, closest, list);
    let isStale = true;
    let first = null; // the closest approach

    const draw = () => {
      if (!isStale || !model.run || !root.offsetParent) return;
      isStale = false;
      const { number, id } = model.selected;
      only.hidden = (model.run.rosters.at(-1)?.robots.length ?? 0) < 2;
      name.textContent = `Only ${id}`;
      const isOnly = !only.hidden && isWanted.checked;
      first = model.approaches.closest(isOnly ? number : null);
      closest.hidden = !first;
      if (first) fill(closest, el("b", {}, "Closest"), el("span.when", {}, `${first[0].toFixed(3)} s`), el("span", {}, first[3]));
      const found = model.happenings
        .filter(([, kind, row]) => chosen.has(markOf(kind).name) && !(isOnly && row >= 0 && row !== number))
        .sort((one, other) => one[0] - other[0]).slice(-MOST);
      if (!found.length) return fill(list, el("p.hint", {}, "Nothing has happened yet."));
      fill(list, ...found.reverse().map(([time, kind, , text]) => {
        const dot = el("i.dot");
        dot.style.background = look.colours[markOf(kind).colour] ?? markOf(kind).colour;
        return el("button.event", { type: "button", title: "Go there", onclick: () => page.timeline.seek(time) },
          dot, el("span.when", {}, `${time.toFixed(3)} s`), el("span", {}, text));
      }));
    };

    for (const kind of ["hello", "event", "forget", "near", "look", "roster", "panel"]) model.on(kind, () => (isStale = true));
    model.on("tick", draw);
  },
};
