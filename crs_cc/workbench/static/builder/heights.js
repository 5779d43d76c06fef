/** The ground's map of heights: painted with a brush, or read from a picture. */

import { gridStep } from "../units.js";
import { distance } from "./drawing.js";
import { paintShape } from "./paint.js";

const MAX_CELLS = 64; // on a side of a new map
const MAX_POINTS = 2000; // of one stroke
const DIGITS = 1000; // heights are written in millimetres

export class Brush {
  /** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
  constructor(model, view) {
    this.model = model;
    this.view = view;
    this.radius = 0.5; // [m]
    this.rise = 0.05; // of one stroke, in its middle [m]
    /** What one stroke has raised. @type {any} */
    this.stroke = null;
  }

  /** The map of the world: its name and shape, nothing if there is none. */
  get map() {
    const item = this.model.items.find((each) => each.tag === "heightmap");
    const [shape] = item ? this.model.shapes(item.name) : [];
    return item && shape ? { name: item.name, shape } : null;
  }

  begin(point, lowers) {
    const shape = this.map?.shape ?? flat(this.model.document.area);
    const before = shape.rows.map((row) => [...row]);
    this.stroke = { shape, before, reached: before.map((row) => row.map(() => 0)), rise: (lowers ? -1 : 1) * this.rise, path: [] };
    this.paint(point);
  }

  /** Raise the cells around a point, each at most once as far as the brush reaches. @param {number[]} at a place [m] */
  paint(at) {
    if (!this.stroke) return;
    const { shape, before, reached, rise, path } = this.stroke;
    const last = path.at(-1);
    if (path.length >= MAX_POINTS || (last && distance(last, at) < this.radius / 8)) return;
    path.push(at);
    const [x, y] = at;
    const [left, top] = shape.points[3];
    const [first, end] = span(left, shape, x, this.radius, shape.rows[0].length);
    const [above, below] = span(-top, shape, -y, this.radius, shape.rows.length);
    for (let r = above; r < below; r++) {
      for (let c = first; c < end; c++) {
        const [dx, dy] = [left + (c + 0.5) * shape.pixel - x, top - (r + 0.5) * shape.pixel - y];
        reached[r][c] = Math.max(reached[r][c], 1 - (dx * dx + dy * dy) / (this.radius * this.radius));
        shape.rows[r][c] = Math.max(0, before[r][c] + rise * reached[r][c]);
      }
    }
    this.view.renew();
  }

  /** Have the builder do what was shown. */
  async end() {
    const { path, rise } = this.stroke ?? { path: [] };
    if (path.length) {
      const text = path.map((point) => point.map((value) => +value.toFixed(4)).join(",")).join(" ");
      await this.model.apply("raise", { names: [], values: { path: text, radius: this.radius, rise } });
    }
    this.stroke = null;
    this.view.draw();
  }

  /** Write a map into the world, in place of that which is there. */
  async store(shape) {
    const { map } = this;
    const table = { columns: shape.rows[0].length, heights: shape.rows.flat().join(" ") };
    if (map) await this.model.apply("set", { names: [map.name], attributes: { ...table, image: null, height: null } });
    else await this.model.apply("add", { names: [], values: { kind: "heightmap" }, attributes: { resolution: shape.pixel, x: shape.points[0][0], y: shape.points[0][1], ...table } });
  }

  /** Show what the brush would reach. */
  show(pen, point) {
    if (this.stroke && !this.map) paintShape(pen, this.view, this.stroke.shape);
    const [x, y] = this.view.toScreen(point);
    pen.beginPath();
    pen.arc(x, y, this.radius * this.view.scale, 0, 2 * Math.PI);
    pen.stroke();
  }

  /** Make the ground as a picture shows: black is low, white is high. @param {Blob} file @param {number} most height of white [m] */
  async read(file, most) {
    const picture = await createImageBitmap(file).catch(() => null);
    if (!picture) {
      this.model.notify("the browser cannot read this image", true);
      return;
    }
    const shape = flat(this.model.document.area);
    const [rows, columns] = [shape.rows.length, shape.rows[0].length];
    const pen = new OffscreenCanvas(columns, rows).getContext("2d");
    if (!pen) return;
    pen.imageSmoothingQuality = "high";
    pen.drawImage(picture, 0, 0, columns, rows);
    const { data } = pen.getImageData(0, 0, columns, rows);
    const grey = (index) => (0.299 * data[index] + 0.587 * data[index + 1] + 0.114 * data[index + 2]) / 255;
    shape.rows.forEach((row, r) => row.forEach((_, c) => (row[c] = Math.round(grey(4 * (r * columns + c)) * most * DIGITS) / DIGITS)));
    const old = this.map;
    if (old) await this.model.apply("remove", { names: [old.name] });
    await this.store(shape);
  }
}

/** The cells of a map, along one side, that a brush at a place reaches. */
function span(start, { pixel }, at, radius, count) {
  const [low, high] = [(at - radius - start) / pixel, (at + radius - start) / pixel];
  return [Math.max(0, Math.floor(low)), Math.min(count, Math.ceil(high))];
}

/** A map without heights on all of an area. */
function flat(area) {
  const pixel = gridStep(Math.max(area.length, area.width) / MAX_CELLS);
  const [columns, rows] = [area.length, area.width].map((side) => Math.max(2, Math.ceil(side / pixel)));
  const [right, top] = [area.x + columns * pixel, area.y + rows * pixel];
  const points = [[area.x, area.y], [right, area.y], [right, top], [area.x, top]];
  return { kind: "heights", pixel, points, rows: Array.from({ length: rows }, () => new Array(columns).fill(0)) };
}
