/** What is drawn over the world. */
import { el, fill } from "crs/dom.js";
import { PARTS } from "crs/overlay.js";

/** @type {import("./index.js").Panel} */
export const overlays = {
  id: "overlays",
  title: "Show",
  side: "left",
  make(root, model, look) {
    const has = (device) => Object.values(model.run.world.kinds ?? {}).some((kind) => kind[device]);
    const only = el("label", {}, el("input", { type: "checkbox", onchange: (event) => look.setSelectedOnly(event.target.checked) }), "Only for the selected robot");
    const draw = () => {
      only.hidden = (model.run.rosters.at(-1)?.robots.length ?? 0) < 2;
      fill(root, el("div.switches", {}, only, ...PARTS.filter(({ only, device }) => (!only || only(model.run)) && (!device || has(device))).map((part) =>
        el("label", {}, el("input", { type: "checkbox", checked: look.show[part.name], onchange: () => look.toggle(part.name) }), part.title))));
    };
    model.on("hello", draw);
    model.on("look", draw);
  },
};
