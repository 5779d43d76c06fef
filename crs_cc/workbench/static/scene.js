/**
 * The visible objects and robots, and their positions at a time.
 *
 * @typedef {{id: string, x: number, y: number, angle: number, height: number, colour: string,
 *   corners?: number[][], radius?: number, heat?: number, movable?: boolean, lift?: number}} Shape
 * @typedef {{id: string, x: number, y: number, z: number, heading: number, turret: number | null,
 *   base: number, mount: number, slope: [number, number] | null, radius: number, height: number, colour: string, kind: any, row: number}} Body
 */
import { Ground } from "crs/ground.js";

const HEIGHT = 0.35;

export class Scene {
  /** @param {any} run the first message of the channel, or the contents of the page */
  constructor(run) {
    this.run = run;
    this.area = run.world.area;
    this.ground = new Ground(run.world.ground);
    /** @type {Shape[]} */
    this.shapes = run.world.shapes.map((shape) => ({ ...shape }));
    this.byId = new Map(this.shapes.map((shape) => [shape.id, shape]));
    this.robots = new Map(run.world.robots.map((robot) => [robot.id, robot]));
    /** @type {Body[]} the robots in the world */
    this.bodies = [];
    /** @type {Body[]} by row, of the frames so far: made once, as there may be thousands */
    this.known = [];
    this.time = -1;
    /** @type {Map<string, number>} the heights of objects that robots carry [m] */
    this.carried = new Map();
    /** @type {Record<string, number>} of what no longer has the heat of the world */
    this.heats = {};
  }

  /** The current heat of an object or a robot. @param {{id: string, heat?: number}} item */
  heat(item) {
    return this.heats[item.id] ?? item.heat ?? this.robots.get(item.id)?.heat ?? 0;
  }

  /** Note what robots hold. @param {Record<number, string[]>} holds by robot */
  hold(holds) {
    this.carried.clear();
    for (const [row, items] of Object.entries(holds ?? {})) {
      const kind = this.body(Number(row))?.kind;
      for (const id of items) this.carried.set(id, kind?.arm ? kind.height : 0.03);
    }
  }

  /** Who was there at a time. */
  roster(time) {
    let found = this.run.rosters[0];
    for (const each of this.run.rosters) if (each.t <= time + 1e-9) found = each;
    return found;
  }

  /** Put everything where a frame says. @param {import("./frames.js").Frame} frame */
  place(frame) {
    const roster = this.roster(frame.time);
    const { rows, values, columns } = frame;
    this.time = frame.time;
    this.bodies = [];
    const count = Math.min(rows, roster.robots.length);
    for (let row = 0; row < count; row++) {
      const x = values[row];
      if (Number.isNaN(x)) continue;
      const body = this.bodyOf(row, roster.robots[row]);
      const y = values[rows + row];
      [body.x, body.y, body.z, body.slope] = [x, y, this.ground.height(x, y), this.ground.slope(x, y)];
      body.heading = values[2 * rows + row];
      if (!body.kind?.steers) body.base = body.heading;
      body.turret = columns > 3 && body.kind?.turret !== false ? values[3 * rows + row] : null;
      body.mount = body.turret ?? body.base;
      this.bodies.push(body);
    }
    roster.objects.forEach((id, number) => {
      const [shape, row] = [this.byId.get(id), roster.robots.length + number];
      if (!shape || row >= rows) return;
      shape.lift = this.carried.get(id) ?? 0;
      [shape.x, shape.y, shape.angle] = [values[row], values[rows + row], values[2 * rows + row]];
    });
  }

  /** The body of a robot, with what does not change; `place` sets the rest. @param {number} row @param {string} id */
  bodyOf(row, id) {
    const before = this.known[row];
    if (before?.id === id) return before;
    const { kind: name, start, radius, colour } = this.robots.get(id) ?? { radius: 0.2, colour: "#888888" };
    const kind = this.run.world.kinds?.[name];
    const body = { id, row, kind, radius, colour, height: kind?.height ?? HEIGHT, x: 0, y: 0, z: 0, slope: null, heading: 0, turret: null, base: start?.[2] ?? 0, mount: 0 };
    this.known[row] = body;
    return body;
  }

  /** The robot of a row. @param {number} row */
  body(row) {
    const guess = this.bodies[row];
    return guess?.row === row ? guess : this.bodies.find((body) => body.row === row);
  }
}

/** The corners of a shape in the world. @param {Shape} shape @returns {number[][]} */
export function cornersOf(shape) {
  const [cos, sin] = [Math.cos(shape.angle), Math.sin(shape.angle)];
  return (shape.corners ?? []).map(([x, y]) => [
    shape.x + x * cos - y * sin,
    shape.y + x * sin + y * cos,
  ]);
}
