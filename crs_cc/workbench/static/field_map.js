/** Pheromone fields on the floor: a colour for each, the denser the more there is. */
import { fromBase64 } from "crs/frames.js";

const COLOURS = [
  [124, 58, 237],
  [13, 148, 136],
  [217, 119, 6],
  [219, 39, 119],
];
const MIN = 0.16; // opacity of the smallest amount that is shown
const MAX = 0.88;

/** @typedef {{name: string, x: number, y: number, cell: number, rows: number, columns: number, most: number, data: string, shares?: Uint8Array}} FieldMap
 *   amounts as shares of the largest, a byte for each cell, by rows from the smallest y: in base 64 as `data`, or
 *   as `shares`; `data` is another where these are */

/** The colour of a field by its number. @param {number} number */
export const fieldRgb = (number) => COLOURS[number % COLOURS.length];

/** The opacity of an amount. @param {number} share of the largest, 0 to 1 */
export const opacity = (share) => (share > 0 ? MIN + (MAX - MIN) * share : 0);

/** A field as red, green, blue and opacity of each cell. @param {FieldMap} field @param {number} number */
export function fieldPixels(field, number) {
  const shares = field.shares ?? fromBase64(field.data);
  const data = new Uint8ClampedArray(4 * shares.length);
  for (let at = 0; at < shares.length; at++) {
    data.set(fieldRgb(number), 4 * at);
    data[4 * at + 3] = 255 * opacity(shares[at] / 255);
  }
  return data;
}

/** Pictures of fields, redrawn when any amount changes. */
export class FieldPictures {
  constructor() {
    /** @type {Map<string, {data: string, canvas: HTMLCanvasElement}>} */
    this.known = new Map();
  }

  /** @param {FieldMap} field @param {number} number */
  of(field, number) {
    const before = this.known.get(field.name);
    if (before?.data === field.data) return before.canvas;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [field.columns, field.rows];
    canvas.getContext("2d")?.putImageData(new ImageData(fieldPixels(field, number), field.columns, field.rows), 0, 0);
    this.known.set(field.name, { data: field.data, canvas });
    return canvas;
  }
}

/** The scale of the displayed fields: their colours, and the amount of the densest one. */
export function fieldScale(o) {
  const { pen, look } = o;
  const [left, width] = [12, 180];
  const shown = look.fields;
  let top = o.height - 58 - 22 * shown.length;
  if (!shown.length) return;
  pen.font = "11px system-ui, sans-serif";
  o.plate(left, top - 4, width, 22 * shown.length + 6, "rgb(11 16 38 / 80%)", { radius: 6 });
  shown.forEach((field, number) => {
    pen.fillStyle = look.colours.floor;
    pen.fillRect(left + 8, top + 4, 40, 10);
    for (let step = 0; step < 40; step++) {
      pen.fillStyle = `rgb(${fieldRgb(number).join(" ")} / ${Math.round(100 * opacity(step / 39))}%)`;
      pen.fillRect(left + 8 + step, top + 4, 1.2, 10);
    }
    pen.fillStyle = "#dfe4ec";
    pen.textAlign = "left";
    const name = field.name.length > 14 ? `${field.name.slice(0, 13)}…` : field.name;
    pen.fillText(`${name}  0 to ${+field.most.toPrecision(3)}`, left + 56, top + 13);
    top += 22;
  });
}
