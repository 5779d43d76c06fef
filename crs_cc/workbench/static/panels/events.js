/** What has happened: collisions, messages, errors; a click goes there. */
import { entry } from "crs/change.js";
import { button, el, fill } from "crs/dom.js";
import { MARKS, markOf } from "crs/timeline.js";

const MAX = 400; // rows

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
    const only = el("label.only-robot", { title: "Only events of the selected robot, and those without a robot" }, isWanted, name);
    filters.append(only);
    const condition = entry({ placeholder: "when: speed > 0 && $world.distance(a, b) < 1", title: "A condition on the program and the world: the times at which it became true are marked on the timeline", "aria-label": "condition to find in the run" });
    const wrong = el("p.field-error", { role: "alert" });
    const find = async () => {
      const text = condition.value.trim();
      if (text) wrong.textContent = await page.found.search("when", { condition: text }, text);
    };
    const clear = button({ text: "Clear", title: "Remove the marks from the timeline", onclick: () => page.found.clear() });
    const finder = el("form.finder", { onkeydown: (event) => event.stopPropagation(), onsubmit: (event) => {
      event.preventDefault();
      find();
    } }, condition, button({ text: "Find", title: "Mark when this became true", onclick: () => finder.requestSubmit() }), clear, wrong);
    finder.hidden = !model.can("debug");
    const closest = el("button.event.closest", { type: "button", title: "Go there", onclick: () => page.timeline.seek(first[0]) });
    const list = el("div.events");
    root.append(finder, filters, closest, list);
    let isStale = true;
    let first = null; // the closest approach

    const draw = () => {
      if (!isStale || !model.run || !root.offsetParent) return;
      isStale = false;
      clear.hidden = !model.found.rows.length;
      const { number, id } = model.selected;
      only.hidden = (model.run.rosters.at(-1)?.robots.length ?? 0) < 2;
      name.textContent = `Only ${id}`;
      const isOnly = !only.hidden && isWanted.checked;
      first = model.approaches.closest(isOnly ? number : null);
      closest.hidden = !first;
      if (first) fill(closest, el("b", {}, "Closest"), el("span.when", {}, `${first[0].toFixed(3)} s`), el("span", {}, first[3]));
      const found = model.happenings
        .filter(([, kind, row]) => chosen.has(markOf(kind).name) && !(isOnly && row >= 0 && row !== number))
        .sort((one, other) => one[0] - other[0]).slice(-MAX);
      if (!found.length) return fill(list, el("p.hint", {}, "No events yet."));
      fill(list, ...found.reverse().map((each) => {
        const [time, kind, , text] = each;
        const dot = el("i.dot");
        dot.style.background = look.colours[markOf(kind).colour] ?? markOf(kind).colour;
        return el("button.event", { type: "button", title: "Go there", onclick: () => page.goTo(each) },
          dot, el("span.when", {}, `${time.toFixed(3)} s`), el("span", {}, text));
      }));
    };

    for (const kind of ["hello", "event", "truncate", "near", "look", "roster", "panel", "found", "compared"]) model.on(kind, () => (isStale = true));
    model.on("tick", draw);
  },
};
