/** The runs that changes in the past have left: each can be shown again, and compared with this one. */
import { button, el, fill } from "crs/dom.js";

const TITLES = { event: "event", print: "output" };

/** @param {any} model @param {any} look @param {any} page @returns {HTMLElement} */
export function branches(model, look, page) {
  const list = el("div.branch-list", { role: "list", "aria-label": "runs" });
  const result = el("div.differences", { "aria-live": "polite" });
  const body = el("section.branches", {}, el("h3", {}, "Runs"),
    el("p.hint", {}, "A change in the past begins another run; the one before stays as it was."), list, result);

  const compare = async (name) => {
    const answer = await model.ask("compare", { name });
    if (!answer) return;
    look.other = answer;
    look.version++;
    show();
  };

  const forget = () => {
    look.other = null;
    look.version++;
    show();
  };

  const row = ({ name, current, since, end }) => el("div.branch", { role: "listitem", "aria-current": current ? "true" : undefined },
    el("b", {}, name), el("span.times", {}, since ? `changed at ${since.toFixed(2)} s, known to ${end.toFixed(2)} s` : `known to ${end.toFixed(2)} s`),
    ...(current ? [el("span.chip", {}, "this one")] : [
      button({ text: "Compare", title: `Where ${name} and this run first differ`, onclick: () => compare(name) }),
      button({ text: "Show", title: `Go on with ${name}`, onclick: () => model.ask("switch", { name }) }),
    ]));

  const difference = (current, name) => ({ t, robot, what, here, there }) => el("tr", {},
    el("td", {}, el("button.link.when", { type: "button", title: "Go there", onclick: () => page.timeline.seek(t) }, `${t.toFixed(3)} s`)),
    el("td", {}, `${robot} ${TITLES[what] ?? what}`), el("td", { title: current }, here), el("td", { title: name }, there));

  const table = ({ name, differences }, current) => {
    if (!differences.length) return [el("p.hint", {}, `${name} and ${current} are the same, as far as both are known.`)];
    const [first] = differences;
    return [
      el("p", {}, `They first differ at ${first.t.toFixed(3)} s: ${first.robot} ${TITLES[first.what] ?? first.what}. The path of ${name} is dashed.`),
      el("table", {}, el("thead", {}, el("tr", {}, ...["first at", "quantity", current, name].map((each) => el("th", {}, each)))),
        el("tbody", {}, ...differences.map(difference(current, name)))),
      el("div.row-end", {}, button({ text: "End comparing", title: "Remove the dashed paths", onclick: forget })),
    ];
  };

  const show = () => {
    const all = model.panel?.branches ?? [];
    body.hidden = all.length < 2;
    fill(list, ...all.map(row));
    const current = all.find((each) => each.current)?.name ?? "this run";
    if (look.other && !all.some((each) => each.name === look.other.name && !each.current)) look.other = null;
    fill(result, ...(look.other ? table(look.other, current) : []));
  };
  model.on("panel", show);
  model.on("hello", forget);
  show();
  return body;
}
