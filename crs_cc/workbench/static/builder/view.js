/** The world from above on a canvas: where a point is, what is at a point, and the picture. */

import { gridStep } from "../units.js";
import { palette } from "../theme.js";
import { into, moved } from "./frames.js";
import { Layer, penOf, resized } from "./layer.js";
import { corners, isOn, paintName, paintShape } from "./paint.js";

const NEAR = 8; // [px]
const FAST = 6; // a picture that takes less is always redrawn [ms]
const REST = 200; // without a move, until it is redrawn [ms]
const DIM = 0.3; // what is around a definition that is edited

export class View {
  /** @param {HTMLCanvasElement} canvas @param {import("./model.js").Model} model */
  constructor(canvas, model) {
    this.canvas = canvas;
    this.model = model;
    this.centre = [0, 0];
    this.scale = 80; // [px/m]
    /** Whether it shows what it should, not what it happens to. */
    this.isPlaced = false;
    /** @type {((pen: CanvasRenderingContext2D) => void) | null} */
    this.preview = null;
    /** How the selection is moved while it is dragged. @type {((point: number[]) => number[]) | null} */
    this.dragged = null;
    this.isWaiting = false;
    /** Everything, and again what is selected: pictures that are moved while something is dragged. */
    this.backdrop = new Layer();
    this.chosen = new Layer();
    this.version = 0;
    this.choice = 0;
    this.colours = palette();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.colours = palette();
      this.renew();
    });
    model.addEventListener("change", () => this.renew());
    model.addEventListener("select", () => {
      this.choice += 1;
      this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  toScreen([x, y]) {
    const { clientWidth, clientHeight } = this.size;
    return [clientWidth / 2 + (x - this.centre[0]) * this.scale, clientHeight / 2 - (y - this.centre[1]) * this.scale];
  }

  /** @param {number[]} at a place in the view [pixels] */
  toWorld([x, y]) {
    const { clientWidth, clientHeight } = this.size;
    return [this.centre[0] + (x - clientWidth / 2) / this.scale, this.centre[1] - (y - clientHeight / 2) / this.scale];
  }

  /** The canvas's size; while a picture is drawn, as it was at its start. */
  get size() {
    return this.frozen ?? this.canvas;
  }

  fit() {
    const { inside } = this.model;
    const area = this.model.document?.area;
    if (!area) return;
    const { clientWidth, clientHeight } = this.canvas;
    this.centre = inside ? [0, 0] : [area.x + area.length / 2, area.y + area.width / 2];
    this.scale = 0.9 * Math.min(clientWidth / area.length, clientHeight / area.width);
    this.isPlaced = true;
    this.draw();
  }

  /** Zoom about a point of the canvas. */
  zoom(factor, at) {
    const before = this.toWorld(at);
    this.scale = Math.min(5000, Math.max(0.05, this.scale * factor));
    const after = this.toWorld(at);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
    this.moving();
  }

  /** Show an element in the middle. */
  show(name) {
    const [shape] = this.model.shapes(name);
    if (shape) this.centre = shape.points?.[0] ?? [shape.x ?? 0, shape.y ?? 0];
    this.draw();
  }

  /** The step of the grid [m]. */
  step() {
    return gridStep(12 / this.scale);
  }

  /** The name of the element at a point of the world, the topmost; empty if there is none. */
  at(point) {
    const { model } = this;
    const near = NEAR / 2 / this.scale;
    const found = model.items.findLast(({ name }) => model.isFree(name) && model.shapes(name).some((shape) => isOn(shape, point, near)));
    return found?.name ?? "";
  }

  /** Whether a point is on the edge around the area. */
  isOnEdge([x, y]) {
    const { model } = this;
    const area = model.document?.area;
    if (!(area?.edge > 0) || model.inside || !model.item("area")) return false;
    const isWithin = (margin) => x >= area.x - margin && x <= area.x + area.length + margin && y >= area.y - margin && y <= area.y + area.width + margin;
    return isWithin(area.edge) && !isWithin(0);
  }

  /** The names of the elements whose corners are all inside of a rectangle of the world. */
  inside([x1, y1], [x2, y2]) {
    const { model } = this;
    const [left, right] = [Math.min(x1, x2), Math.max(x1, x2)];
    const [low, high] = [Math.min(y1, y2), Math.max(y1, y2)];
    const isIn = ([x, y]) => x >= left && x <= right && y >= low && y <= high;
    const names = model.items.map((item) => item.name).filter((name) => model.isFree(name));
    return names.filter((name) => {
      const shapes = model.shapes(name);
      return shapes.length > 0 && shapes.every((shape) => shape.kind !== "range" && corners(shape).every(isIn));
    });
  }

  // -- the picture -------------------------------------------------------------------------------

  /** Draw a picture soon, of which everything may be new. */
  renew() {
    this.version += 1;
    this.draw();
  }

  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.paint();
    });
  }

  paint() {
    const { canvas, backdrop, chosen } = this;
    const ratio = devicePixelRatio || 1;
    this.frozen = { clientWidth: canvas.clientWidth, clientHeight: canvas.clientHeight };
    const [width, height] = [this.frozen.clientWidth, this.frozen.clientHeight];
    resized(canvas, width, height, ratio);
    const isBusy = this.isMoving && backdrop.took > FAST;
    backdrop.renew(this, `${this.version}`, isBusy, (pen) => this.paintAll(pen, width, height));
    chosen.renew(this, `${this.version},${this.choice}`, isBusy, (pen) => {
      for (const name of this.model.selection) this.paintItem(pen, name, true);
    });
    const pen = penOf(canvas, ratio);
    pen.fillStyle = this.colours.sky;
    pen.fillRect(0, 0, width, height);
    backdrop.show(pen, this, null);
    chosen.show(pen, this, this.dragged);
    if (this.model.document?.area) this.preview?.(pen);
    this.frozen = null;
  }

  /** The view moves: large worlds are redrawn when it rests. @param {number} rest [ms] */
  moving(rest = REST) {
    this.isMoving = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      this.isMoving = false;
      this.draw();
    }, rest);
    this.draw();
  }

  /** Everything, without what shows that it is selected. */
  paintAll(pen, width, height) {
    const { model, colours } = this;
    pen.fillStyle = colours.sky;
    pen.fillRect(0, 0, width, height);
    if (!model.document?.area) return;
    this.paintFloor(pen, colours, width, height);
    if (model.inside) this.paintAround(pen, into(model.inside.pose));
    this.wrong = new Set(model.document.problems.map((each) => each.name));
    for (const { name } of model.items) this.paintItem(pen, name, false);
  }

  paintItem(pen, name, isChosen) {
    const { model, colours } = this;
    if (model.hidden.has(name)) return;
    const outline = isChosen ? colours.accent : this.wrong?.has(name) ? colours.danger : "";
    for (const shape of model.shapes(name)) {
      if (shape.kind !== "range" || isChosen) paintShape(pen, this, shape, { outline, isChosen });
      if (shape.kind === "robot") paintName(pen, this, shape, name);
    }
  }

  /** The world around a definition that is edited, seen from the object that was opened. */
  paintAround(pen, motion) {
    const { document: known, path } = this.model;
    for (const { name } of known.items) {
      if (name === path[0] && path.length === 1) continue;
      for (const shape of known.shapes[name] ?? []) {
        if (shape.kind !== "range" && shape.kind !== "heights") paintShape(pen, this, moved(shape, motion), { alpha: DIM });
      }
    }
  }

  paintFloor(pen, colours, width, height) {
    const { area } = this.model.document;
    const { inside } = this.model;
    const motion = inside ? into(inside.pose) : (point) => point;
    const [right, top] = [area.x + area.length, area.y + area.width];
    const floor = [[area.x, area.y], [right, area.y], [right, top], [area.x, top]].map(motion);
    pen.beginPath();
    this.line(pen, floor);
    pen.closePath();
    pen.fillStyle = colours.floor;
    pen.fill();
    this.paintGrid(pen, colours, width, height);
    if (!(area.edge > 0)) return;
    const out = area.edge / 2;
    const line = [[area.x - out, area.y - out], [right + out, area.y - out], [right + out, top + out], [area.x - out, top + out]];
    pen.strokeStyle = colours.edge;
    pen.lineWidth = Math.max(1, area.edge * this.scale);
    pen.beginPath();
    this.line(pen, line.map(motion));
    pen.closePath();
    pen.stroke();
  }

  paintGrid(pen, colours, width, height) {
    const step = this.step();
    const [low, high] = [this.toWorld([0, height]), this.toWorld([width, 0])];
    pen.lineWidth = 1;
    pen.strokeStyle = colours.grid;
    for (const strong of [false, true]) {
      const each = strong ? step * 5 : step;
      pen.beginPath();
      for (let x = Math.ceil(low[0] / each) * each; x < high[0]; x += each) {
        const px = Math.round(this.toScreen([x, 0])[0]) + 0.5;
        pen.moveTo(px, 0);
        pen.lineTo(px, height);
      }
      for (let y = Math.ceil(low[1] / each) * each; y < high[1]; y += each) {
        const py = Math.round(this.toScreen([0, y])[1]) + 0.5;
        pen.moveTo(0, py);
        pen.lineTo(width, py);
      }
      pen.globalAlpha = strong ? 1 : 0.5;
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  line(pen, points) {
    points.forEach((point, index) => {
      const [x, y] = this.toScreen(point);
      if (index) pen.lineTo(x, y);
      else pen.moveTo(x, y);
    });
  }
}

