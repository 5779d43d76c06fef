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
    const draw = () =>
      fill(root, el("div.switches", {}, ...PARTS.filter(({ only, device }) => (!only || model.run[only]) && (!device || has(device))).map((part) =>
        el("label", {}, el("input", { type: "checkbox", checked: look.show[part.name], onchange: () => look.toggle(part.name) }), part.title))));
    model.on("hello", draw);
    model.on("look", draw);
  },
};
