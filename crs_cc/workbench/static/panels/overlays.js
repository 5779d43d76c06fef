/** What is drawn over the world. */
import { el, fill } from "crs/dom.js";
import { PARTS } from "crs/overlay.js";

/** @type {import("./index.js").Panel} */
export const overlays = {
  id: "overlays",
  title: "Show",
  side: "left",
  make(root, model, look) {
    const draw = () =>
      fill(root, el("div.switches", {}, ...PARTS.filter(({ only }) => !only || model.run[only]).map((part) =>
        el("label", {}, el("input", { type: "checkbox", checked: look.show[part.name], onchange: () => look.toggle(part.name) }), part.title))));
    model.on("hello", draw);
    model.on("look", draw);
  },
};
