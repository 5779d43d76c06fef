/** Below the world: what the tool does, what a field means, what was done or is wrong, and where the pointer is. */

import { el, fill } from "../dom.js";
import { gridStep, lengthText } from "../units.js";
import { lengthIn, toolOf } from "./drawing.js";
import { makeUnits } from "./options.js";

const SELECTED = "Drag to move, the round handle to rotate, the square ones to resize; Ctrl-D copies, Delete removes";
const UNDRAWN = "Its properties are on the right";
const EDGE = "The area and the walls around it: size and wall thickness are on the right";

/** What can be done with what is selected. @param {import("./model.js").Model} model */
function selected(model) {
  if (model.selection.size === 1 && model.selection.has("area")) return EDGE;
  return [...model.selection].some((name) => model.shapes(name).length) ? SELECTED : UNDRAWN;
}

/** @param {import("./model.js").Model} model @param {import("./view.js").View} view @param {import("./tools.js").Tools} tools @param {import("./solid.js").Solid} solid */
export function makeStatus(model, view, tools, solid) {
  const notice = el("span.notice", { role: "status" });
  const place = el("span.place");
  let help = "";
  const draw = () => {
    const hint = solid.isOn ? solid.hint : tools.tool === "select" && model.selection.size ? selected(model) : toolOf(tools.tool).title;
    notice.textContent = help || model.note || hint;
    notice.className = `notice${help ? "" : model.isWrong ? " wrong" : model.note ? " news" : ""}`;
  };
  for (const kind of ["note", "tool", "select", "change"]) model.addEventListener(kind, draw);
  // A note is about what was done last.
  model.addEventListener("tool", () => model.note && !model.isWrong && model.notify(""));
  for (const kind of ["focusin", "pointerover"]) {
    document.addEventListener(kind, ({ target }) => {
      const field = /** @type {HTMLElement} */ (target).closest?.("aside.right label")?.querySelector("[title]");
      help = /** @type {HTMLElement | null} */ (field)?.title ?? "";
      draw();
    });
  }
  const point = (at) => {
    const where = at ? view.toWorld(at).map((value) => lengthIn(Number(value.toFixed(3)), model.unit)).join(", ") : "";
    place.textContent = `${where}${where && " · "}grid ${lengthText(gridStep(12 / view.scale))}`;
  };
  view.canvas.addEventListener("pointermove", (event) => point([event.offsetX, event.offsetY]));
  view.canvas.addEventListener("wheel", (event) => point([event.offsetX, event.offsetY]));
  view.canvas.addEventListener("pointerleave", () => point(null));
  model.addEventListener("change", () => place.textContent || point(null));
  const line = el("div.status");
  fill(line, notice, place, makeUnits(model));
  return line;
}
