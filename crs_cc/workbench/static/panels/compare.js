/** Comparing with another run: which one, where they first differ, and by how much. */
import { APART } from "crs/compared.js";
import { button, el, fill } from "crs/dom.js";
import { drawPlot, LEFT, LINES, RIGHT } from "crs/plot.js";

const TITLES = { event: "event", print: "output" };

/** @type {import("./index.js").Panel} */
export const compare = {
  id: "compare",
  title: "Compare",
  summary: "Where this run and another one first differ",
  key: ";",
  side: "below",
  asks: true,
  isHeld: (run) => Boolean(run.other),
  make(root, model, look, page) {
    const { compared } = page;
    root.classList.add("compare");
    const chosen = el("select", { "aria-label": "run to compare with", title: "The run that this one is compared with", onchange: () => (chosen.value ? compared.with(chosen.value) : compared.end()) });
    const file = el("input", { type: "file", accept: ".mcap", hidden: true, onchange: () => {
      if (file.files[0]) compared.open(file.files[0]);
      file.value = "";
    } });
    const open = button({ text: "Open a recording ...", title: "Compare with a recorded run: choose an .mcap file, or drop one anywhere on the page", onclick: () => file.click() });
    const search = button({ text: "Find the first variable", title: "Run both again, side by side, up to the first timestep at which a variable differs", onclick: () => (compared.isSearching ? compared.stop() : compared.search()) });
    const plot = button({ text: "Plot the distance", title: "Plot the selected robot's distance from its position in the other run", onclick: () => page.plot(APART + compared.run.name) });
    const end = button({ text: "End", title: "Stop comparing: remove the ghosts and the dashed paths", onclick: () => compared.end() });
    const close = button({ text: "Close the file", title: "Close the recording", onclick: () => compared.close(compared.run.name) });
    const about = el("span.hint", { "aria-live": "polite" });
    const result = el("div.differences", { "aria-live": "polite" });
    const isHeld = model.channel.isLocal;
    const mayOpen = model.run.role === "control" && !isHeld;
    const distance = el("canvas.apart", { role: "img", hidden: true, title: "Distance of the selected robot from its position in the other run [m]; click to go to a time", onclick: (event) => {
      const share = (event.offsetX - LEFT) / Math.max(1, distance.clientWidth - LEFT - RIGHT);
      page.timeline.seek(Math.min(1, Math.max(0, share)) * model.run.end_s);
    } });
    root.append(el("div.bar", {}, el("label", {}, "with ", chosen), ...(mayOpen ? [open, file] : []), search, plot, close, end, about), distance, result);

    page.compare = (name) => {
      page.drawer.open("compare");
      return compared.with(name);
    };
    page.takeFile = mayOpen ? (dropped) => compared.open(dropped) : null;

    const there = (t) => el("button.link.when", { type: "button", title: "Go there", onclick: () => page.timeline.seek(t) }, `${t.toFixed(3)} s`);
    const named = ({ robot, what }) => `${robot} ${TITLES[what] ?? what}`;
    const row = (each) => el("tr", {}, el("td", {}, there(each.t)), el("td", {}, named(each)), el("td", {}, each.here), el("td", {}, each.there), el("td", {}, each.by));
    const table = (name, rows) => el("table", {},
      el("thead", {}, el("tr", {}, ...["first at", "what", "this run", name, "difference"].map((each) => el("th", {}, each)))), el("tbody", {}, ...rows));

    /** The result as a sentence. */
    const sentence = () => {
      const { run, exact, first } = compared;
      const upTo = (t) => `up to ${t.toFixed(2)} s`;
      if (!first) return [el("p", {}, `No difference from ${run.name} found, ${upTo(run.until)}.`, exact?.is_done && !exact.wrong ? ` All variables are the same, ${upTo(exact.t)}.` : "")];
      const variable = compared.firstVariable;
      const is = (each) => [there(each.t), " ", el("b", {}, named(each)), ` is ${each.here} here, ${each.there} there${each.by ? ` (difference ${each.by})` : ""}.`];
      const isOther = variable && (variable.t !== first.t || variable.what !== first.what);
      return [el("p.first", {}, "First difference from ", el("b", {}, run.name), ": ", ...is(first)),
        ...(isOther ? [el("p.first", {}, "First variable: ", ...is(variable))] : []),
        ...(exact?.is_done && !exact.wrong && !variable ? [el("p", {}, `No program variable differs, ${upTo(exact.t)}.`)] : [])];
    };

    const show = () => {
      const { run, exact, choices, isSearching } = compared;
      const shown = choices.map(({ name, title, end: known }) => el("option", { value: name, title }, `${name} (to ${known.toFixed(2)} s)`));
      fill(chosen, el("option", { value: "" }, choices.length ? "no run" : "no other run yet"), ...shown);
      chosen.value = run?.name ?? "";
      for (const each of [plot, end]) each.hidden = !run;
      plot.hidden ||= !page.plot || isHeld;
      search.hidden = !run || !model.can("debug") || (exact?.is_done && Boolean(compared.firstVariable));
      close.hidden = !run || !mayOpen || !choices.some(({ name, isFile }) => isFile && name === run.name);
      search.querySelector("span").textContent = isSearching ? "Stop" : "Find the first variable";
      about.textContent = exact?.wrong || (isSearching && exact ? `variables are the same up to ${exact.t.toFixed(2)} of ${exact.until.toFixed(2)} s` : "");
      about.classList.toggle("wrong", Boolean(exact?.wrong));
      if (!run && isHeld) return fill(result, el("p.hint", {}, "This page contains another run: select it above."));
      if (!run) return fill(result, el("p.hint", {}, "Compare this run with one that was kept after a change in the past (see Changes), or with a recording: open an .mcap file, or drop it on the page. Its robots are drawn as ghosts, its paths dashed."));
      const rows = [...(exact?.found ?? []), ...run.differences].sort((one, another) => one.t - another.t).map(row);
      fill(result, ...sentence(), ...(rows.length ? [table(run.name, rows)] : []));
    };
    /** Draw the distance of the selected robot, where the page holds it. */
    const trace = () => {
      const robot = model.run.rosters.at(-1).robots[model.state.robot];
      const rows = compared.run?.apart?.[robot];
      distance.hidden = !rows;
      if (!rows || !distance.clientWidth) return;
      const [times, values] = [0, 1].map((column) => rows.map((row) => row[column] ?? NaN));
      const series = { times, values, texts: [], places: [], isStep: false };
      const strips = [{ label: "distance [m]", words: false, lines: [{ series, colour: LINES[0], until: times.at(-1) ?? 0 }] }];
      distance.setAttribute("aria-label", `distance of ${robot} from its position in ${compared.run.name}`);
      drawPlot(distance, { strips, begin: 0, end: Math.max(model.run.end_s, 1e-3), now: model.state.t, pointed: null, colours: look.colours });
    };
    for (const kind of ["compared", "panel", "others", "hello", "look"]) model.on(kind, () => (show(), trace()));
    show();
    if (!isHeld) return;
    model.on("state", trace);
    addEventListener("resize", trace);
    model.on("others", () => model.others[0] && !compared.run && page.compare(model.others[0].name));
  },
};
