/**
 * A camera: where one looks from. Dragging turns it, with shift or the other button it moves;
 * it may go with a robot: above it, behind it, or on board.
 *
 * @typedef {"orbit" | "top" | "follow" | "chase" | "board"} Mode
 */

const EYE = 1.15; // the height of a camera on board, by the height of the robot
const LOWEST = 0.03;
const HIGHEST = Math.PI / 2 - 0.01;

export class Camera {
  /** @param {{x: number, y: number, length: number, width: number}} area */
  constructor(area) {
    this.area = area;
    /** @type {Mode} */
    this.mode = "orbit";
    this.fov = (42 * Math.PI) / 180;
    this.reset();
  }

  reset() {
    const { x, y, length, width } = this.area;
    const isVast = Math.max(length, width) > 200; // an empty world has no edge in sight
    this.x = isVast ? 0 : x + length / 2;
    this.y = isVast ? 0 : y + width / 2;
    this.z = 0;
    this.size = isVast ? 12 : Math.max(length, width);
    this.spanX = isVast ? 12 : length;
    this.spanY = isVast ? 12 : width;
    this.distance = 1.25 * this.size;
    this.azimuth = -Math.PI / 2 - 0.45;
    this.elevation = 0.82;
    this.zoom = 1;
    this.mustFit = true;
  }

  get isFlat() {
    return this.mode === "top";
  }

  /** Metres in a pixel of a view from above. */
  metres(width, height) {
    return Math.max(this.spanX / width, this.spanY / height) / (0.9 * this.zoom);
  }

  /** @param {number} dx @param {number} dy pixels @param {boolean} moves whether to move it */
  drag(dx, dy, moves, width, height) {
    if (this.isFlat || moves) {
      const metre = this.isFlat ? this.metres(width, height) : this.distance / height;
      const turn = this.isFlat ? -Math.PI / 2 : this.azimuth;
      const [right, ahead] = [-dx * metre, (dy * metre) / (this.isFlat ? 1 : Math.max(0.3, Math.sin(this.elevation)))];
      this.x += -right * Math.sin(turn) - ahead * Math.cos(turn);
      this.y += right * Math.cos(turn) - ahead * Math.sin(turn);
      if (this.mode === "follow") this.mode = "orbit";
    } else {
      this.azimuth -= dx / 180;
      this.elevation = Math.min(HIGHEST, Math.max(LOWEST, this.elevation + dy / 180));
    }
  }

  wheel(turn) {
    this.approach(Math.exp(-Math.max(-150, Math.min(150, turn)) / 500));
  }

  /** Show the world so many times as large. @param {number} scale */
  approach(scale) {
    this.distance = Math.min(50 * this.size, Math.max(0.4, this.distance / scale));
    this.zoom = Math.min(300, Math.max(0.05, this.zoom * scale));
  }

  /** Go with a robot. @param {any} body @param {number} elapsed [s] */
  follow(body, elapsed) {
    if (!body || this.mode === "orbit" || this.mode === "top") return;
    const share = Math.min(1, elapsed * 8);
    [this.x, this.y, this.z] = [body.x, body.y, body.z];
    if (this.mode === "chase") {
      const turn = body.heading + Math.PI - this.azimuth;
      this.azimuth += (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI))) * (this.isNew ? 1 : share);
      this.isNew = false;
    }
  }

  /** Go with it from now on, from near. @param {Mode} mode */
  setMode(mode) {
    const isNear = mode === "follow" || mode === "chase";
    if (isNear) this.mustFit = false;
    this.isNew = true;
    if (isNear && this.mode !== "follow" && this.mode !== "chase") {
      this.distance = Math.min(this.distance, 5);
      this.elevation = mode === "chase" ? 0.42 : Math.min(this.elevation, 0.75);
    }
    if (mode === "orbit" && (this.mode === "chase" || this.mode === "board")) this.reset();
    this.mode = mode;
  }

  /** Where it is, what it looks at, and which way is up. @param {any} body */
  pose(body) {
    if (this.mode === "board" && body) {
      const height = body.z + body.height * EYE;
      const [cos, sin] = [Math.cos(body.heading), Math.sin(body.heading)];
      const eye = [body.x + cos * body.radius * 0.7, body.y + sin * body.radius * 0.7, height];
      return { eye, target: [eye[0] + cos, eye[1] + sin, height - 0.12], up: [0, 0, 1] };
    }
    const target = [this.x, this.y, this.z];
    if (this.isFlat) return { eye: [this.x, this.y, 100], target: [this.x, this.y, 0], up: [0, 1, 0] };
    const flat = this.distance * Math.cos(this.elevation);
    const eye = [
      this.x + flat * Math.cos(this.azimuth),
      this.y + flat * Math.sin(this.azimuth),
      this.z + this.distance * Math.sin(this.elevation),
    ];
    return { eye, target, up: [0, 0, 1] };
  }

  /** Look from as near as shows the whole area. @param {number} aspect width by height */
  fit(aspect) {
    this.mustFit = false;
    const corners = [-1, 1].flatMap((i) => [-1, 1].map((j) => [(i * this.spanX) / 2, (j * this.spanY) / 2]));
    const [cosA, sinA] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [cosE, sinE] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    const half = Math.tan(this.fov / 2) * 0.92;
    let least = 0;
    for (const [x, y] of corners) {
      const [toward, side] = [x * cosA + y * sinA, Math.abs(y * cosA - x * sinA)];
      const [near, rise] = [toward * cosE, Math.abs(toward * sinE)];
      least = Math.max(least, near + side / (half * aspect), near + rise / half);
    }
    this.distance = least;
  }

  /** What it depends on, to notice a change. */
  get signature() {
    return [this.mode, this.x, this.y, this.z, this.distance, this.azimuth, this.elevation, this.zoom].join();
  }

  save() {
    const { mode, x, y, distance, azimuth, elevation, zoom } = this;
    return [mode, ...[x, y, distance, azimuth, elevation, zoom].map((each) => Number(each.toFixed(3)))].join("_");
  }

  restore(text) {
    const [mode, ...numbers] = text.split("_");
    if (numbers.length !== 6 || numbers.some((each) => !Number.isFinite(Number(each)))) return;
    this.mode = /** @type {Mode} */ (["orbit", "top", "follow", "chase", "board"].includes(mode) ? mode : "orbit");
    [this.x, this.y, this.distance, this.azimuth, this.elevation, this.zoom] = numbers.map(Number);
    this.mustFit = false;
  }
}
