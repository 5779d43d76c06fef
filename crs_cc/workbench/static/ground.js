/** The ground: ramps and plateaus on a floor, or on a map of heights. */

const REACH = 0.12; // half the distance over which a slope is measured: about that of wheels [m]

export class Ground {
  /** @param {any} ground as the world has it; nothing for a flat floor */
  constructor(ground) {
    this.patches = (ground?.patches ?? []).map((patch) => ({
      ...patch,
      cos: Math.cos(patch.heading),
      sin: Math.sin(patch.heading),
    }));
    this.map = ground?.map ?? null;
    this.isFlat = !this.patches.length && !this.map;
  }

  /** The height at a place [m]: that of the highest of those that overlap. */
  height(x, y) {
    if (this.isFlat) return 0;
    let height = this.map ? this.mapHeight(x, y) : 0;
    for (const patch of this.patches) {
      const [dx, dy] = [x - patch.x, y - patch.y];
      const along = dx * patch.cos + dy * patch.sin;
      const across = dy * patch.cos - dx * patch.sin;
      if (Math.abs(along) > patch.length / 2 || Math.abs(across) > patch.width / 2) continue;
      const share = along / patch.length + 0.5;
      height = Math.max(height, patch.from + (patch.to - patch.from) * share);
    }
    return height;
  }

  /** How steep it is at a place, along x and y; nothing where it is flat. @returns {[number, number] | null} */
  slope(x, y) {
    if (this.isFlat) return null;
    const [a, b] = [this.height(x + REACH, y) - this.height(x - REACH, y), this.height(x, y + REACH) - this.height(x, y - REACH)];
    return a || b ? [a / (2 * REACH), b / (2 * REACH)] : null;
  }

  mapHeight(x, y) {
    const { heights, pixel } = this.map;
    const [rows, columns] = [heights.length, heights[0].length];
    const u = Math.min(columns - 1, Math.max(0, (x - this.map.x) / pixel));
    const v = Math.min(rows - 1, Math.max(0, (y - this.map.y) / pixel));
    const [column, row] = [Math.min(columns - 2, Math.floor(u)), Math.min(rows - 2, Math.floor(v))];
    const [a, b] = [u - column, v - row];
    const low = heights[row][column] * (1 - a) + heights[row][column + 1] * a;
    const high = heights[row + 1][column] * (1 - a) + heights[row + 1][column + 1] * a;
    return low * (1 - b) + high * b;
  }
}
