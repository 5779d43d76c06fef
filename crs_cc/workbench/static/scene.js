/**
 * What there is to see: things and robots, and where they are at a time.
 *
 * @typedef {{id: string, x: number, y: number, angle: number, height: number, colour: string,
 *   corners?: number[][], radius?: number}} Shape
 * @typedef {{id: string, x: number, y: number, heading: number, turret: number | null,
 *   radius: number, colour: string, row: number}} Body
 */

export class Scene {
  /** @param {any} run the contents of the page */
  constructor(run) {
    this.run = run;
    this.area = run.world.area;
    /** @type {Shape[]} */
    this.shapes = run.world.shapes;
    this.byId = new Map(this.shapes.map((shape) => [shape.id, shape]));
    this.robots = new Map(run.world.robots.map((robot) => [robot.id, robot]));
    /** @type {Body[]} */
    this.bodies = [];
    this.moved = new Set();
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
    this.bodies = [];
    roster.robots.slice(0, rows).forEach((id, row) => {
      if (Number.isNaN(values[row])) return;
      const known = this.robots.get(id) ?? { radius: 0.2, colour: "#888888" };
      this.bodies.push({
        id,
        row,
        x: values[row],
        y: values[rows + row],
        heading: values[2 * rows + row],
        turret: columns > 3 ? values[3 * rows + row] : null,
        radius: known.radius,
        colour: known.colour,
      });
    });
    roster.objects.forEach((id, number) => {
      const [shape, row] = [this.byId.get(id), roster.robots.length + number];
      if (!shape || row >= rows) return;
      [shape.x, shape.y, shape.angle] = [values[row], values[rows + row], values[2 * rows + row]];
    });
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
