/** What the mouse does: select, move, turn, resize, and draw with each tool. */

import { angleText } from "../units.js";
import { addClicked, addDragged, Corners, distance, lengthIn, toolOf } from "./drawing.js";
import { handleAt, paintHandles } from "./handles.js";
import { Brush } from "./heights.js";

const NEAR = 10; // [px] to snap to an end
const HELD = 2000; // [ms] that a world may be frozen before it is redrawn
const FREE = 1e4; // per metre: of places with Alt
const ANGLE = Math.PI / 12; // of turns without Alt
const RIGHT = Math.PI / 36; // walls this near to a right angle get one

export class Tools {
  /** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
  constructor(model, view) {
    this.model = model;
    this.view = view;
    this.tool = "select";
    this.corners = new Corners(model, view);
    this.brush = new Brush(model, view);
    this.pointer = [0, 0];
    /** @type {any} */
    this.drag = null;
    view.preview = (pen) => this.paint(pen);
    const { canvas } = view;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("dblclick", (event) => this.open(event));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      view.zoom(Math.exp(-event.deltaY / 400), [event.offsetX, event.offsetY]);
    }, { passive: false });
  }

  choose(tool) {
    this.tool = tool;
    this.cancel();
    this.model.emit("tool");
  }

  cancel() {
    this.corners.clear();
    this.drag = null;
    this.view.dragged = null;
    this.view.draw();
  }

  /** A point near the pointer: the end of a wall, a right angle, or on the grid; Alt is free. */
  snapped(event) {
    const at = [event.offsetX, event.offsetY];
    const point = this.view.toWorld(at);
    if (event.altKey) return point.map((value) => Math.round(value * FREE) / FREE);
    const step = this.view.step();
    const [x, y] = point.map((value) => Math.round(value / step) * step);
    if (toolOf(this.tool).by === "brush") return point;
    const end = this.endNear(point);
    if (end) return end;
    const { last } = this.corners;
    if (!last || this.tool === "polygon") return [x, y];
    const angle = Math.atan2(point[1] - last[1], point[0] - last[0]);
    const right = Math.round(angle / (Math.PI / 2)) * (Math.PI / 2);
    if (Math.abs(angle - right) > RIGHT) return [x, y];
    return Math.abs(Math.cos(right)) > 0.5 ? [x, last[1]] : [last[0], y];
  }

  /** The end of a wall near a point. */
  endNear(point) {
    const near = NEAR / this.view.scale;
    for (const { name, tag } of this.model.items) {
      if (tag !== "wall") continue;
      const end = this.model.shapes(name)[0]?.points?.find((each) => distance(each, point) < near);
      if (end) return [...end];
    }
    return null;
  }

  // -- pressing, moving, releasing ---------------------------------------------------------------

  down(event) {
    this.view.canvas.focus();
    this.view.canvas.setPointerCapture(event.pointerId);
    const at = [event.offsetX, event.offsetY];
    const { by } = toolOf(this.tool);
    if (event.button === 1 || event.button === 2) {
      this.drag = { kind: "pan", at, centre: [...this.view.centre] };
    } else if (by === "select") {
      this.grasp(event, at, this.view.toWorld(at));
    } else if (by === "rectangle" || by === "disc") {
      this.drag = { kind: "draw", from: this.snapped(event), to: this.snapped(event) };
    } else if (by === "brush") {
      this.drag = { kind: "brush" };
      this.brush.begin(this.view.toWorld(at), event.shiftKey);
    }
  }

  grasp(event, at, point) {
    const handle = handleAt(this.model, this.view, at);
    if (handle) {
      this.drag = { ...handle, kind: handle.kind === "turn" ? "turn" : "resize", from: point };
      return;
    }
    const name = this.view.at(point);
    const { selection } = this.model;
    if (!name && this.view.isOnEdge(point)) {
      this.model.select(["area"]);
      return;
    }
    if (event.shiftKey && name) {
      this.model.select(selection.has(name) ? [...selection].filter((each) => each !== name) : [...selection, name]);
      return;
    }
    if (name && !selection.has(name)) this.model.select([name]);
    this.drag = name ? { kind: "move", from: point } : { kind: "frame", from: point, to: point };
    if (!name && !event.shiftKey) this.model.select([]);
  }

  move(event) {
    this.pointer = this.snapped(event);
    const point = this.view.toWorld([event.offsetX, event.offsetY]);
    const { drag } = this;
    if (drag?.kind === "pan") {
      const scale = this.view.scale;
      this.view.centre = [drag.centre[0] - (event.offsetX - drag.at[0]) / scale, drag.centre[1] + (event.offsetY - drag.at[1]) / scale];
      this.view.moving(HELD);
    } else if (drag?.kind === "move") {
      const step = event.altKey ? 1 / FREE : this.view.step();
      drag.by = [0, 1].map((axis) => Math.round((point[axis] - drag.from[axis]) / step) * step);
      this.view.dragged = ([x, y]) => [x + drag.by[0], y + drag.by[1]];
    } else if (drag?.kind === "turn") {
      this.turn(drag, point, event.altKey);
    } else if (drag?.kind === "brush") {
      this.brush.paint(point);
    } else if (drag) {
      drag.to = drag.kind === "frame" ? point : this.pointer;
    }
    this.view.draw();
  }

  turn(drag, point, isFree) {
    const [x, y] = drag.middle;
    const angle = Math.atan2(point[1] - y, point[0] - x) - (drag.start ?? Math.PI / 2);
    drag.angle = isFree ? angle : Math.round(angle / ANGLE) * ANGLE;
    const [cos, sin] = [Math.cos(drag.angle), Math.sin(drag.angle)];
    this.view.dragged = ([px, py]) => [x + cos * (px - x) - sin * (py - y), y + sin * (px - x) + cos * (py - y)];
  }

  async up(event) {
    const { drag, tool, model } = this;
    this.drag = null;
    if (drag?.kind === "pan") this.view.moving(0);
    const { by } = toolOf(tool);
    if (by === "click" && drag?.kind !== "pan") this.put(tool, event);
    else if (by === "corners" && drag?.kind !== "pan") this.corners.put(tool, this.snapped(event));
    else if (drag?.kind === "move" && drag.by && (drag.by[0] || drag.by[1])) {
      await model.apply("move", { values: { x: drag.by[0], y: drag.by[1] } });
    } else if (drag?.kind === "turn" && drag.angle) {
      await model.apply("turn", { values: { angle: drag.angle, x: drag.middle[0], y: drag.middle[1] } });
    } else if (drag?.kind === "resize" && drag.to) {
      await model.apply("set", { names: drag.name ? [drag.name] : [...model.selection], attributes: model.written(drag.set(drag.to)) });
    } else if (drag?.kind === "frame") {
      const names = this.view.inside(drag.from, drag.to);
      model.select(event.shiftKey ? [...model.selection, ...names] : names);
    } else if (drag?.kind === "draw" && !distance(drag.from, drag.to)) this.pick(event);
    else if (drag?.kind === "draw") addDragged(model, tool, drag.from, drag.to);
    else if (drag?.kind === "brush") await this.brush.end();
    this.view.dragged = null;
    this.view.draw();
  }

  /** Select what is under the pointer, if anything is. */
  pick(event) {
    const name = this.view.at(this.view.toWorld([event.offsetX, event.offsetY]));
    if (name) this.model.select([name]);
  }

  /** Put something down; one of its kind that is there is selected instead. */
  put(tool, event) {
    const name = this.view.at(this.view.toWorld([event.offsetX, event.offsetY]));
    if (this.model.item(name)?.tag === tool) this.model.select([name]);
    else addClicked(this.model, tool, this.snapped(event));
  }

  /** A double click: close what is drawn, or open an object. */
  open(event) {
    if (this.tool !== "select") {
      this.corners.finish(this.tool);
      return;
    }
    const name = this.view.at(this.view.toWorld([event.offsetX, event.offsetY]));
    if (name) this.model.enter(name);
    else if (this.model.inside) this.model.leave();
  }

  /** A key while something is drawn; whether it was one. @param {KeyboardEvent} event */
  key(event) {
    if (event.key === "Escape") {
      if (this.corners.points.length) this.cancel();
      else if (this.tool !== "select") this.choose("select");
      else if (this.model.inside) this.model.leave();
      return true;
    }
    const isOurs = this.corners.key(this.tool, event.key, this.pointer);
    if (isOurs) this.view.draw();
    return isOurs;
  }

  // -- the picture -------------------------------------------------------------------------------

  paint(pen) {
    const { view, drag } = this;
    const { accent } = view.colours;
    if (this.tool === "select" && (!drag || drag.kind === "pan")) paintHandles(pen, this.model, view, accent);
    pen.strokeStyle = accent;
    pen.fillStyle = accent;
    pen.lineWidth = 2;
    pen.font = "13px system-ui";
    const label = (text, point) => {
      const [x, y] = view.toScreen(point);
      pen.fillText(text, x + 14, y - 12);
    };
    if (this.corners.points.length) this.corners.paint(pen, this.tool, this.pointer, label);
    else if (drag?.kind === "draw" || drag?.kind === "frame") this.paintDrag(pen, drag, label);
    else if (drag?.kind === "turn" && drag.angle !== undefined) label(angleText(drag.angle), drag.middle);
    else if (drag?.kind === "resize" && drag.to) {
      const [x, y] = view.toScreen(drag.to);
      pen.strokeRect(x - 6, y - 6, 12, 12);
    } else if (toolOf(this.tool).by === "brush") this.brush.show(pen, this.pointer);
  }

  paintDrag(pen, drag, label) {
    const [from, to] = [this.view.toScreen(drag.from), this.view.toScreen(drag.to)];
    pen.beginPath();
    if (drag.kind === "draw" && toolOf(this.tool).by === "disc") pen.arc(from[0], from[1], distance(from, to), 0, 7);
    else pen.rect(from[0], from[1], to[0] - from[0], to[1] - from[1]);
    pen.stroke();
    if (drag.kind === "draw") label([0, 1].map((axis) => lengthIn(Math.abs(drag.to[axis] - drag.from[axis]), this.model.unit)).join(" × "), drag.to);
  }
}
