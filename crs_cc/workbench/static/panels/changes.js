/** What was changed by hand: each can be taken back where the run goes back, and all can be written out. */
import { button, el, fill } from "crs/dom.js";
import { branches } from "crs/panels/branches.js";

/** @type {import("./index.js").Panel} */
export const changes = {
  id: "changes",
  title: "Changes",
  side: "right",
  needs: "change",
  make(root, model, look, page) {
    const list = el("div.change-list", { role: "list", "aria-label": "changes" });
    const save = async (form) => {
      const answer = await model.request("export", { form });
      if (!answer) return;
      const url = URL.createObjectURL(new Blob([answer.text], { type: "text/plain" }));
      el("a", { href: url, download: answer.name }).click();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
      model.notify(`${answer.name} saved`);
    };
    const script = button({ text: "Save as a script", title: "To repeat the changes: crs run --inputs changes.txt", onclick: () => save("inputs") });
    const xml = button({ text: "Save as XML", title: "The active faults and outages, as <degradation> and <shut> for a world file", onclick: () => save("xml") });
    const mayTakeBack = model.run.can.includes("debug");
    const hint = el("p.hint", {}, mayTakeBack
      ? "No changes. Your changes to the run (moves, faults, links, messages, variables) are listed here, and can be undone."
      : "No changes. Your changes to the run (moves, faults, links, messages) are listed here. This run only goes forward: they cannot be undone.");
    root.append(el("div.bar", {}, script, xml), branches(model, page), hint, list);

    const show = () => {
      const all = model.panel?.changes ?? [];
      hint.hidden = all.length > 0;
      script.disabled = all.length === 0;
      fill(list, ...[...all].reverse().map(({ number, t, text }) => el("div.change", { role: "listitem" },
        el("button.link.when", { type: "button", title: "Go there", onclick: () => page.timeline.seek(t) }, `${t.toFixed(3)} s`),
        el("code", {}, text),
        mayTakeBack ? button({ text: "Undo", title: "Undo this change and all later ones: the run goes back to the time before it", onclick: () => model.request("undo", { number }) }) : null)));
    };
    model.on("panel", show);
    model.on("hello", show);
    show();
  },
};
