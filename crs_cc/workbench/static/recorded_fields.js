/** Pheromone fields of a recorded run, at any time: the last sketch before it, and what has evaporated since. */
import { fromBase64, inflate } from "crs/frames.js";

const KEPT = 40; // sketches that are unpacked

/** @typedef {{name: string, x: number, y: number, cell: number, rows: number, columns: number, most: number, t: number, evaporation: number | null, packed: string}} Sketch */

export class RecordedFields {
  /**
   * @param {string[]} names of the fields, in their order
   * @param {Sketch[]} sketches by time @param {() => void} changed called when one has been unpacked, to draw it
   */
  constructor(names, sketches, changed) {
    this.all = names.map((name) => sketches.filter((sketch) => sketch.name === name)).filter((field) => field.length);
    this.changed = changed;
    /** @type {Map<Sketch, Uint8Array | null>} null while it is being unpacked */
    this.unpacked = new Map();
    /** @type {Map<string, import("./field_map.js").FieldMap>} what was shown last, which stays until the next is unpacked */
    this.shown = new Map();
  }

  /** What there was at a time. @param {number} time @returns {import("./field_map.js").FieldMap[]} */
  at(time) {
    return this.all.map((sketches) => {
      const sketch = sketches[lastBefore(sketches, time)];
      const shares = sketch && this.shares(sketch);
      if (sketch && !shares) return this.shown.get(sketch.name) ?? nothing(sketch);
      const field = shares ? { ...sketch, most: sketch.most * left(sketch, time), data: sketch.packed, shares } : nothing(sketches[0]);
      this.shown.set(field.name, field);
      return field;
    });
  }

  /** The shares of a sketch; null until they are unpacked. @param {Sketch} sketch */
  shares(sketch) {
    if (!this.unpacked.has(sketch)) {
      this.unpacked.set(sketch, null);
      if (this.unpacked.size > KEPT) this.unpacked.delete(this.unpacked.keys().next().value);
      inflate(fromBase64(sketch.packed)).then((shares) => {
        this.unpacked.set(sketch, shares);
        this.changed();
      });
    }
    return this.unpacked.get(sketch);
  }
}

/** An empty field. @param {Sketch} sketch */
const nothing = (sketch) => ({ ...sketch, most: 0, data: "", shares: new Uint8Array(sketch.rows * sketch.columns) });

/** What is left of an amount since a sketch. @param {Sketch} sketch @param {number} time */
const left = ({ t, evaporation }, time) => (evaporation ? Math.exp(Math.min(0, t - time) / evaporation) : 1);

/** The number of the last sketch up to a time; -1 before the first. @param {Sketch[]} sketches @param {number} time */
function lastBefore(sketches, time) {
  let [low, high] = [-1, sketches.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (sketches[middle].t <= time + 1e-6) low = middle;
    else high = middle - 1;
  }
  return low;
}
