/** The world from above on a canvas: where a point is, what is at a point, and the picture. */

import { gridStep, lengthText } from "../units.js";
import { palette } from "../theme.js";

const NEAR = 8; // [px]
const KINDS = {
  wall: "#5b6472", solid: "#8d95a3", movable: "#d9b88a", ground: "#b9a98c", goal: "#1a7f37",
  robot: "#0b66b8", light: "#e0a800", sound: "#8e44ad",
};

export class View {
  /** @param {HTMLCanvasElement} canvas @param {import("./model.js").Model} model */
  constructor(canvas, model) {
    this.canvas = canvas;
    this.model = model;
    this.centre = [0, 0];
    this.scale = 80; // [px/m]
    /** @type {((pen: CanvasRenderingContext2D) => void) | null} */
    this.preview = null;
    /** How the selection is moved while it is dragged. @type {((point: number[]) => number[]) | null} */
    this.dragged = null;
    this.isWaiting = false;
    this.colours = palette();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.colours = palette();
      this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  toScreen([x, y]) {
    const { clientWidth, clientHeight } = this.canvas;
    return [clientWidth / 2 + (x - this.centre[0]) * this.scale, clientHeight / 2 - (y - this.centre[1]) * this.scale];
  }

  toWorld([x, y]) {
    const { clientWidth, clientHeight } = this.canvas;
    return [this.centre[0] + (x - clientWidth / 2) / this.scale, this.centre[1] - (y - clientHeight / 2) / this.scale];
  }

  fit() {
    const area = this.model.document?.area;
    if (!area) return;
    const { clientWidth, clientHeight } = this.canvas;
    this.centre = [area.x + area.length / 2, area.y + area.width / 2];
    this.scale = 0.9 * Math.min(clientWidth / area.length, clientHeight / area.width);
    this.draw();
  }

  /** Zoom about a point of the canvas. */
  zoom(factor, at) {
    const before = this.toWorld(at);
    this.scale = Math.min(5000, Math.max(0.05, this.scale * factor));
    const after = this.toWorld(at);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
    this.draw();
  }

  /** The step of the grid [m]. */
  step() {
    return gridStep(12 / this.scale);
  }

  /** The name of the element at a point of the world, the topmost; empty if there is none. */
  at(point) {
    const things = this.model.document?.things ?? [];
    for (let index = things.length - 1; index >= 0; index -= 1) {
      const { name } = things[index];
      if (this.model.shapes(name).some((shape) => isOn(shape, point, NEAR / 2 / this.scale))) return name;
    }
    return "";
  }

  /** The names of the elements whose corners are all inside of a rectangle of the world. */
  inside([x1, y1], [x2, y2]) {
    const [left, right] = [Math.min(x1, x2), Math.max(x1, x2)];
    const [low, high] = [Math.min(y1, y2), Math.max(y1, y2)];
    const isIn = ([x, y]) => x >= left && x <= right && y >= low && y <= high;
    const names = (this.model.document?.things ?? []).map((thing) => thing.name);
    return names.filter((name) => {
      const shapes = this.model.shapes(name);
      return shapes.length > 0 && shapes.every((shape) => corners(shape).every(isIn));
    });
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
    const { canvas } = this;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== width * ratio || canvas.height !== height * ratio) {
      canvas.width = width * ratio;
      canvas.height = height * ratio;
    }
    const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { colours } = this;
    pen.fillStyle = colours.sky;
    pen.fillRect(0, 0, width, height);
    if (!this.model.document?.area) return;
    this.paintFloor(pen, colours, width, height);
    const wrong = new Set(this.model.document.problems.map((each) => each.name));
    for (const { name } of this.model.document.things) {
      const isChosen = this.model.selection.has(name);
      for (const shape of this.model.shapes(name)) {
        this.paintShape(pen, isChosen && this.dragged ? moved(shape, this.dragged) : shape, {
          outline: isChosen ? colours.accent : wrong.has(name) ? colours.danger : "",
        });
      }
    }
    this.preview?.(pen);
  }

  paintFloor(pen, colours, width, height) {
    const { area } = this.model.document;
    const [left, top] = this.toScreen([area.x, area.y + area.width]);
    const size = [area.length * this.scale, area.width * this.scale];
    pen.fillStyle = colours.floor;
    pen.fillRect(left, top, size[0], size[1]);
    const step = this.step();
    const [low, high] = [this.toWorld([0, height]), this.toWorld([width, 0])];
    pen.lineWidth = 1;
    for (const strong of [false, true]) {
      pen.strokeStyle = colours.grid;
      const each = strong ? step * 5 : step;
      pen.beginPath();
      for (let x = Math.ceil(low[0] / each) * each; x < high[0]; x += each) {
        const [px] = this.toScreen([x, 0]);
        pen.moveTo(Math.round(px) + 0.5, 0);
        pen.lineTo(Math.round(px) + 0.5, height);
      }
      for (let y = Math.ceil(low[1] / each) * each; y < high[1]; y += each) {
        const [, py] = this.toScreen([0, y]);
        pen.moveTo(0, Math.round(py) + 0.5);
        pen.lineTo(width, Math.round(py) + 0.5);
      }
      pen.globalAlpha = strong ? 1 : 0.5;
      pen.stroke();
      pen.globalAlpha = 1;
    }
    if (area.edge > 0) {
      pen.strokeStyle = colours.edge;
      pen.lineWidth = Math.max(1, area.edge * this.scale);
      const out = pen.lineWidth / 2;
      pen.strokeRect(left - out, top - out, size[0] + 2 * out, size[1] + 2 * out);
    }
    pen.fillStyle = colours.muted;
    pen.font = "12px system-ui";
    pen.fillText(`grid ${lengthText(step)}`, 10, height - 10);
  }

  /** @param {CanvasRenderingContext2D} pen @param {import("./model.js").Shape} shape */
  paintShape(pen, shape, { outline = "", alpha = 1 } = {}) {
    const colour = shape.colour ?? KINDS[shape.kind] ?? KINDS.solid;
    pen.globalAlpha = alpha * (shape.kind === "ground" || shape.kind === "goal" ? 0.45 : 1);
    pen.fillStyle = colour;
    pen.strokeStyle = outline || "rgb(0 0 0 / 35%)";
    pen.lineWidth = outline ? 2.5 : 1;
    pen.beginPath();
    if (shape.kind === "wall") {
      this.line(pen, shape.points);
      pen.lineCap = "round";
      const width = Math.max(2, (shape.thickness ?? 0.1) * this.scale);
      if (outline) {
        pen.lineWidth = width + 5;
        pen.stroke();
      }
      pen.strokeStyle = colour;
      pen.lineWidth = width;
      pen.stroke();
      pen.lineCap = "butt";
    } else if (shape.points) {
      this.line(pen, shape.points);
      pen.closePath();
      pen.fill();
      pen.stroke();
    } else {
      const [x, y] = this.toScreen([shape.x, shape.y]);
      const radius = Math.max(3, (shape.radius ?? 0.1) * this.scale);
      pen.arc(x, y, radius, 0, 2 * Math.PI);
      pen.fill();
      pen.stroke();
      if (shape.kind === "robot") {
        pen.beginPath();
        pen.moveTo(x, y);
        pen.lineTo(x + radius * Math.cos(shape.heading ?? 0), y - radius * Math.sin(shape.heading ?? 0));
        pen.strokeStyle = "white";
        pen.lineWidth = 2.5;
        pen.stroke();
      }
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

/** A shape after a motion of the plane. */
export function moved(shape, motion) {
  if (shape.points) return { ...shape, points: shape.points.map(motion) };
  const [x, y] = motion([shape.x, shape.y]);
  const ahead = motion([shape.x + Math.cos(shape.heading ?? 0), shape.y + Math.sin(shape.heading ?? 0)]);
  return { ...shape, x, y, heading: Math.atan2(ahead[1] - y, ahead[0] - x) };
}

/** Points that span a shape. @param {import("./model.js").Shape} shape */
export function corners(shape) {
  if (shape.points) return shape.points;
  const { x = 0, y = 0, radius = 0 } = shape;
  return [[x - radius, y - radius], [x + radius, y + radius]];
}

function isOn(shape, [x, y], near) {
  if (shape.kind === "wall") {
    const [[x1, y1], [x2, y2]] = shape.points;
    const [dx, dy] = [x2 - x1, y2 - y1];
    const along = Math.max(0, Math.min(1, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy || 1)));
    return Math.hypot(x - x1 - along * dx, y - y1 - along * dy) <= shape.thickness / 2 + near;
  }
  if (!shape.points) return Math.hypot(x - shape.x, y - shape.y) <= shape.radius + near;
  let inside = false;
  shape.points.forEach(([x1, y1], index) => {
    const [x2, y2] = shape.points[(index + 1) % shape.points.length];
    if (y1 > y !== y2 > y && x < ((x2 - x1) * (y - y1)) / (y2 - y1) + x1) inside = !inside;
  });
  return inside;
}
