/** What the mouse does: select, move, turn, resize, and draw with each tool. */

import { angleText, lengthText } from "../units.js";
import { handleAt, paintHandles } from "./handles.js";

const NEAR = 10; // [px] to snap to an end
const ANGLE = Math.PI / 12; // of turns without Alt
const RIGHT = Math.PI / 36; // walls this near to a right angle get one

export const TOOLS = [
  { id: "select", key: "v", title: "Select, move, turn and resize" },
  { id: "wall", key: "w", title: "Walls: click each corner; type a length; Esc ends the chain" },
  { id: "box", key: "b", title: "Box: drag from corner to corner" },
  { id: "cylinder", key: "c", title: "Cylinder: drag from its centre" },
  { id: "polygon", key: "p", title: "Polygon: click each corner, the first one again to close it" },
  { id: "ramp", key: "m", title: "Ramp: drag from corner to corner; it rises to the right" },
  { id: "robot", key: "r", title: "Robot: click where it starts" },
  { id: "light", key: "l", title: "Light: click" },
];

const RECTANGLES = { box: {}, ramp: { to: 0.3 } };

export class Tools {
  /** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
  constructor(model, view) {
    this.model = model;
    this.view = view;
    this.tool = "select";
    /** The corners of what is being drawn. @type {number[][]} */
    this.points = [];
    this.typed = "";
    this.pointer = [0, 0];
    /** @type {any} */
    this.drag = null;
    view.preview = (pen) => this.paint(pen);
    const { canvas } = view;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("dblclick", () => this.finish());
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      view.zoom(Math.exp(-event.deltaY / 400), [event.offsetX, event.offsetY]);
    }, { passive: false });
  }

  choose(tool) {
    this.tool = tool;
    this.cancel();
    this.model.tell("tool");
  }

  cancel() {
    this.points = [];
    this.typed = "";
    this.drag = null;
    this.view.dragged = null;
    this.view.draw();
  }

  /** A point near the pointer: the end of a wall, a right angle, or on the grid; Alt is free. */
  snapped(event) {
    const at = [event.offsetX, event.offsetY];
    const point = this.view.toWorld(at);
    if (event.altKey) return point;
    for (const { name, tag } of this.model.document?.things ?? []) {
      if (tag !== "wall") continue;
      for (const end of this.model.shapes(name)[0]?.points ?? []) {
        const [x, y] = this.view.toScreen(end);
        if (Math.hypot(x - at[0], y - at[1]) < NEAR) return [...end];
      }
    }
    const step = this.view.step();
    const [x, y] = point.map((value) => Math.round(value / step) * step);
    const last = this.points.at(-1);
    if (!last || this.tool === "polygon") return [x, y];
    const angle = Math.atan2(point[1] - last[1], point[0] - last[0]);
    const right = Math.round(angle / (Math.PI / 2)) * (Math.PI / 2);
    if (Math.abs(angle - right) > RIGHT) return [x, y];
    return Math.abs(Math.cos(right)) > 0.5 ? [x, last[1]] : [last[0], y];
  }

  down(event) {
    this.view.canvas.focus();
    this.view.canvas.setPointerCapture(event.pointerId);
    const at = [event.offsetX, event.offsetY];
    const point = this.view.toWorld(at);
    if (event.button === 1 || event.button === 2) {
      this.drag = { kind: "pan", at, centre: [...this.view.centre] };
    } else if (this.tool === "select") {
      this.grasp(event, at, point);
    } else if (this.tool in RECTANGLES || this.tool === "cylinder") {
      this.drag = { kind: "draw", from: this.snapped(event), to: this.snapped(event) };
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
    } else if (drag?.kind === "move") {
      const step = event.altKey ? 1e-4 : this.view.step();
      drag.by = [0, 1].map((axis) => Math.round((point[axis] - drag.from[axis]) / step) * step);
      this.view.dragged = ([x, y]) => [x + drag.by[0], y + drag.by[1]];
    } else if (drag?.kind === "turn") {
      const [x, y] = drag.middle;
      const angle = Math.atan2(point[1] - y, point[0] - x) - Math.PI / 2;
      drag.angle = event.altKey ? angle : Math.round(angle / ANGLE) * ANGLE;
      const [cos, sin] = [Math.cos(drag.angle), Math.sin(drag.angle)];
      this.view.dragged = ([px, py]) => [x + cos * (px - x) - sin * (py - y), y + sin * (px - x) + cos * (py - y)];
    } else if (drag) {
      drag.to = drag.kind === "frame" ? point : this.pointer;
    }
    this.view.draw();
  }

  async up(event) {
    const { drag } = this;
    this.drag = null;
    if (this.tool !== "select" && drag?.kind !== "pan" && drag?.kind !== "draw") {
      this.click(this.snapped(event));
      return;
    }
    if (!drag) return;
    if (drag.kind === "move" && drag.by && (drag.by[0] || drag.by[1])) {
      await this.model.apply("move", { values: { x: drag.by[0], y: drag.by[1] } });
    } else if (drag.kind === "turn" && drag.angle) {
      await this.model.apply("turn", { values: { angle: drag.angle, x: drag.middle[0], y: drag.middle[1] } });
    } else if (drag.kind === "resize" && drag.to) {
      await this.model.apply("set", { attributes: drag.set(drag.to) });
    } else if (drag.kind === "frame") {
      const names = this.view.inside(drag.from, drag.to);
      this.model.select(event.shiftKey ? [...this.model.selection, ...names] : names);
    } else if (drag.kind === "draw") {
      this.drawn(drag.from, drag.to);
    }
    this.view.dragged = null;
    this.view.draw();
  }

  drawn([x1, y1], [x2, y2]) {
    const [length, width] = [Math.abs(x2 - x1), Math.abs(y2 - y1)];
    if (this.tool === "cylinder") {
      const radius = Math.hypot(x2 - x1, y2 - y1);
      if (radius > 0.001) this.model.add("cylinder", { x: x1, y: y1, radius });
    } else if (length > 0.001 && width > 0.001) {
      const more = RECTANGLES[this.tool];
      this.model.add(this.tool, { x: (x1 + x2) / 2, y: (y1 + y2) / 2, length, width, ...more });
    }
  }

  click(point) {
    if (this.tool === "robot" || this.tool === "light") {
      this.model.add(this.tool, { x: point[0], y: point[1] });
      return;
    }
    if (this.tool === "polygon") {
      const [first] = this.points;
      if (first && this.points.length > 2 && Math.hypot(point[0] - first[0], point[1] - first[1]) * this.view.scale < NEAR) this.finish();
      else this.points.push(point);
    } else if (this.tool === "wall") {
      this.corner(point);
    }
    this.view.draw();
  }

  /** Add a wall from the last corner to a point. */
  corner(point) {
    const last = this.points.at(-1);
    this.typed = "";
    this.points.push(point);
    if (last && Math.hypot(point[0] - last[0], point[1] - last[1]) > 0.001) {
      this.model.add("wall", { x1: last[0], y1: last[1], x2: point[0], y2: point[1] });
    }
  }

  /** End a chain, or close a polygon. */
  finish() {
    if (this.tool === "polygon" && this.points.length > 2) {
      const unit = this.model.document.unit;
      const size = { m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048 }[unit] ?? 1;
      const text = (value) => `${+(value / size).toFixed(4)}${unit}`;
      this.model.add("polygon", { points: this.points.map(([x, y]) => `${text(x)},${text(y)}`).join(" ") });
    }
    this.cancel();
  }

  /** A key while something is drawn; whether it was one. @param {KeyboardEvent} event */
  key(event) {
    if (event.key === "Escape") {
      if (this.points.length) this.cancel();
      else this.choose("select");
      return true;
    }
    if (!this.points.length) return false;
    if (this.tool === "wall" && /^[0-9.]$/.test(event.key)) this.typed += event.key;
    else if (this.tool === "wall" && event.key === "Backspace") this.typed = this.typed.slice(0, -1);
    else if (event.key === "Enter" && this.typed) this.corner(this.atLength(Number(this.typed)));
    else if (event.key === "Enter") this.finish();
    else return false;
    this.view.draw();
    return true;
  }

  /** The point at a length from the last corner, towards the pointer. */
  atLength(length) {
    const [x, y] = this.points.at(-1) ?? [0, 0];
    const distance = Math.hypot(this.pointer[0] - x, this.pointer[1] - y) || 1;
    return [x + ((this.pointer[0] - x) * length) / distance, y + ((this.pointer[1] - y) * length) / distance];
  }

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
    if (this.points.length) {
      const end = this.typed ? this.atLength(Number(this.typed)) : this.pointer;
      pen.beginPath();
      view.line(pen, [...(this.tool === "wall" ? this.points.slice(-1) : this.points), end]);
      pen.stroke();
      const last = this.points.at(-1) ?? end;
      label(this.typed || lengthText(Math.hypot(end[0] - last[0], end[1] - last[1])), end);
    } else if (drag?.kind === "draw" || drag?.kind === "frame") {
      const [from, to] = [view.toScreen(drag.from), view.toScreen(drag.to)];
      pen.beginPath();
      if (this.tool === "cylinder") pen.arc(from[0], from[1], Math.hypot(to[0] - from[0], to[1] - from[1]), 0, 7);
      else pen.rect(from[0], from[1], to[0] - from[0], to[1] - from[1]);
      pen.stroke();
      const size = [0, 1].map((axis) => lengthText(Math.abs(drag.to[axis] - drag.from[axis])));
      if (drag.kind === "draw") label(size.join(" × "), drag.to);
    } else if (drag?.kind === "turn" && drag.angle !== undefined) {
      label(angleText(drag.angle), drag.middle);
    } else if (drag?.kind === "resize" && drag.to) {
      const [x, y] = view.toScreen(drag.to);
      pen.strokeRect(x - 6, y - 6, 12, 12);
    }
  }
}
