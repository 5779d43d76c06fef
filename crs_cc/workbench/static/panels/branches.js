/** The runs that changes in the past have left: each can be shown again, and compared with this one. */
import { button, el, fill } from "crs/dom.js";

/** @param {any} model @param {any} page @returns {HTMLElement} */
export function branches(model, page) {
  const list = el("div.branch-list", { role: "list", "aria-label": "runs" });
  const body = el("section.branches", {}, el("h3", {}, "Runs"),
    el("p.hint", {}, "A change in the past starts a new run; the previous one is kept."), list);

  const row = ({ name, current, since, end }) => el("div.branch", { role: "listitem", "aria-current": current ? "true" : undefined },
    el("b", {}, name), el("span.times", {}, since ? `changed at ${since.toFixed(2)} s, known up to ${end.toFixed(2)} s` : `known up to ${end.toFixed(2)} s`),
    ...(current ? [el("span.chip", {}, "this one")] : [
      button({ text: "Compare", title: `Where ${name} and this run first differ`, onclick: () => page.compare(name) }),
      button({ text: "Show", title: `Continue with ${name}`, onclick: () => model.request("switch", { name }) }),
    ]));

  const show = () => {
    const all = model.panel?.branches ?? [];
    body.hidden = all.length < 2;
    fill(list, ...all.map(row));
  };
  model.on("panel", show);
  show();
  return body;
}
