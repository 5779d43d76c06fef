/** The paths of robots in the last seconds. */

const SECONDS = 20;
const MAX = 64; // robots
const STEP = 0.02; // [m] between two points, at least
const FINE = 0.3; // [s] between two points: more omits those between them
const GAP = 1.5; // [s] of the displayed time: more is a jump, and trails are looked up again

export class Trails {
  /** @param {() => void} changed called when paths have been looked up, to draw them */
  constructor(changed) {
    this.changed = changed;
    /** @type {Map<number, {t: number, x: number, y: number}[]>} */
    this.paths = new Map();
    this.time = -1;
    this.isStale = false; // whether frames hold more than the paths
    this.isLooking = false;
    this.isCoarse = false; // whether a path leaves something out
  }

  of(row) {
    return this.paths.get(row) ?? [];
  }

  /** @param {import("./scene.js").Scene} scene @param {any} frames @param {number} time */
  update(scene, frames, time) {
    if (time < this.time || time > this.time + GAP) {
      this.isStale = true;
      this.paths.clear(); // those of another time would end in a line to where robots are now
    } else {
      if (time > this.time + FINE) this.isCoarse = true;
      for (const body of scene.bodies.slice(0, MAX)) this.add(body.row, { t: time, x: body.x, y: body.y });
    }
    this.time = time;
    if (this.isStale && !this.isLooking) this.lookUp(scene, frames);
    for (const path of this.paths.values()) while (path.length && path[0].t < time - SECONDS) path.shift();
  }

  /** Frames of the latest time can be fetched: look paths up if they leave something out. */
  refine() {
    if (this.isCoarse) this.isStale = true;
  }

  add(row, point) {
    let path = this.paths.get(row);
    if (!path) this.paths.set(row, (path = []));
    const last = path.at(-1);
    if (!last || Math.hypot(point.x - last.x, point.y - last.y) > STEP) path.push(point);
  }

  /** Take the paths from the frames; the run may advance at the same time. */
  async lookUp(scene, frames) {
    [this.isLooking, this.isStale, this.isCoarse] = [true, false, false];
    const found = await frames.span(Math.max(0, this.time - SECONDS), this.time).catch(() => []);
    this.isLooking = false;
    const { time } = this;
    this.paths.clear();
    const rows = Math.min(MAX, scene.roster(time).robots.length);
    for (const frame of found) {
      for (let row = 0; row < Math.min(rows, frame.rows); row++) {
        const [x, y] = [frame.values[row], frame.values[frame.rows + row]];
        if (!Number.isNaN(x)) this.add(row, { t: frame.time, x, y });
      }
    }
    this.changed();
  }
}
