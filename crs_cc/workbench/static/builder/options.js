/** Above the world: the way out of a definition, and the settings of the brush. */

import { el, fill } from "../dom.js";
import { UNITS } from "./drawing.js";

/** The unit of what is drawn, as in the file unless one is chosen. @param {import("./model.js").Model} model */
export function makeUnits(model) {
  const choose = (event) => {
    model.chosenUnit = event.target.value;
    event.target.blur();
  };
  const chooser = el("select.unit", { "aria-label": "unit", title: "Unit for drawing and typing", onchange: choose });
  const auto = el("option", { value: "" });
  model.addEventListener("change", () => (chooser.value = model.chosenUnit));
  model.addEventListener("change", () => (auto.textContent = `as in the file: ${model.document?.unit ?? "m"}`));
  const others = Object.keys(UNITS).map((unit) => el("option", { value: unit }, unit));
  chooser.append(auto, ...others);
  return chooser;
}

/** @param {import("./model.js").Model} model @param {import("./tools.js").Tools} tools */
export function makeOptions(model, tools) {
  const root = el("div.options");
  const { brush } = tools;
  const size = (name, title) =>
    el("label", { title }, name, el("input", {
      type: "number", step: 0.01, min: 0.01, value: brush[name], "aria-label": `brush ${name} in metres`,
      onchange: (event) => (brush[name] = Math.max(0.001, Number(event.target.value) || brush[name])),
    }), "m");
  const most = el("input", { type: "number", step: 0.1, min: 0.1, max: 100, value: 1, "aria-label": "height of white in metres" });
  const picture = el("input", { type: "file", accept: "image/*", "aria-label": "image of heights", onchange: () => picture.files?.[0] && brush.read(picture.files[0], Number(most.value) || 1) });
  const brushes = [size("radius", "Radius of the brush"), size("rise", "Height that one stroke adds at its centre"), el("label.picture", { title: "Heights from an image: black is low, white is high" }, "or from an image", picture), el("label", {}, "white is", most, "m")];
  const draw = () => {
    const { inside, path } = model;
    const crumbs = inside ? [el("span", {}, `definition of ${path.join(" › ")}: changes apply to all copies`), el("button", { type: "button", onclick: () => model.leave() }, "Done (Esc)")] : [];
    const isBare = model.document && !model.document.area && !model.document.problems.length;
    const bare = isBare ? [el("span", {}, "This file has definitions but no floor: change their attributes on the right, or edit them in a world that includes them.")] : [];
    fill(root, ...bare, ...crumbs, ...(tools.tool === "heights" ? brushes : []));
    root.hidden = !root.children.length;
  };
  for (const kind of ["change", "tool"]) model.addEventListener(kind, draw);
  return root;
}
