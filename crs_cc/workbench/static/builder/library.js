/** The library of objects with their pictures, which are dragged into the world. */

import { el, fill } from "../dom.js";
import { corners, paintShape } from "./paint.js";

const SIDE = 56; // of a picture [px]

/** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
export function makeLibrary(model, view) {
  const root = el("div.library", { role: "list", "aria-label": "Library" });
  const draw = async () => {
    const objects = (await model.request("library")) ?? [];
    fill(root, ...objects.map((object, index) => entry(model, view, object, index)));
  };
  let isDrawn = false;
  model.addEventListener("change", () => {
    root.closest("details").hidden = Boolean(model.document?.isRobot);
    if (isDrawn || !model.isConnected || model.document?.isRobot) return;
    isDrawn = true;
    draw();
  });
  return root;
}

function entry(model, view, object, index) {
  const picture = el("canvas", { width: SIDE * 2, height: SIDE * 2 });
  paintPicture(picture, object.shapes);
  const put = async (point) => {
    const name = await model.request("insert", { index, values: { x: point[0], y: point[1] } });
    if (name) model.choose([name]);
  };
  const made = el("button", {
    type: "button",
    title: `${object.name} of ${object.file}: drag it into the world, or press Enter`,
    onclick: (event) => event.detail === 0 && put(snapped(view, view.centre)),
  }, picture, el("span", {}, object.name));
  drag(made, view, put);
  return el("div", { role: "listitem" }, made);
}

/** Follow the pointer from a button to a place in the world. */
function drag(button, view, put) {
  button.addEventListener("pointerdown", (event) => {
    button.setPointerCapture(event.pointerId);
    const ghost = button.firstChild.cloneNode();
    ghost.getContext("2d").drawImage(button.firstChild, 0, 0);
    ghost.className = "ghost";
    const follow = ({ clientX, clientY }) => Object.assign(ghost.style, { left: `${clientX - SIDE / 2}px`, top: `${clientY - SIDE / 2}px` });
    follow(event);
    document.body.append(ghost);
    button.addEventListener("pointermove", follow);
    const end = ({ type, clientX, clientY }) => {
      ghost.remove();
      button.removeEventListener("pointermove", follow);
      for (const kind of ["pointerup", "pointercancel"]) button.removeEventListener(kind, end);
      const box = view.canvas.getBoundingClientRect();
      const [x, y] = [clientX - box.left, clientY - box.top];
      if (type === "pointerup" && x > 0 && y > 0 && x < box.width && y < box.height) put(snapped(view, view.toWorld([x, y])));
    };
    for (const kind of ["pointerup", "pointercancel"]) button.addEventListener(kind, end);
  });
}

const snapped = (view, point) => point.map((value) => Math.round(value / view.step()) * view.step());

/** Draw shapes as large as they fit. */
function paintPicture(canvas, shapes) {
  const points = shapes.flatMap(corners);
  if (!points.length) return;
  const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = (0.9 * canvas.width) / Math.max(right - left, high - low, 0.1);
  const toScreen = ([x, y]) => [canvas.width / 2 + (x - (left + right) / 2) * scale, canvas.height / 2 - (y - (low + high) / 2) * scale];
  const line = (pen, among) => among.forEach((point, index) => pen[index ? "lineTo" : "moveTo"](...toScreen(point)));
  const pen = canvas.getContext("2d");
  for (const shape of shapes) paintShape(pen, /** @type {any} */ ({ scale, toScreen, line }), shape);
}
