/** Cameras: where one looks from, changed by dragging and the wheel, or by following a robot. */

export class FlatCamera {
  /** @param {{x: number, y: number, length: number, width: number}} area */
  constructor(area) {
    this.area = area;
    this.reset();
  }

  reset() {
    this.x = this.area.x + this.area.length / 2;
    this.y = this.area.y + this.area.width / 2;
    this.zoom = 1;
  }

  /** Pixels in a metre. */
  scale(width, height) {
    const fit = Math.min(width / this.area.length, height / this.area.width);
    return 0.94 * fit * this.zoom;
  }

  drag(dx, dy, scale) {
    this.x -= dx / scale;
    this.y += dy / scale;
  }

  wheel(turn) {
    this.zoom = Math.min(400, Math.max(0.2, this.zoom * Math.exp(-turn / 400)));
  }
}

export class OrbitCamera {
  constructor(area) {
    this.area = area;
    this.reset();
  }

  reset() {
    this.x = this.area.x + this.area.length / 2;
    this.y = this.area.y + this.area.width / 2;
    this.distance = 1.1 * Math.max(this.area.length, this.area.width);
    this.azimuth = -Math.PI / 2;
    this.elevation = 0.9;
  }

  drag(dx, dy) {
    this.azimuth -= dx / 200;
    this.elevation = Math.min(1.55, Math.max(0.05, this.elevation + dy / 200));
  }

  wheel(turn) {
    this.distance = Math.min(1e4, Math.max(0.5, this.distance * Math.exp(turn / 400)));
  }

  /** Where the camera is. */
  eye() {
    const flat = this.distance * Math.cos(this.elevation);
    return [
      this.x + flat * Math.cos(this.azimuth),
      this.y + flat * Math.sin(this.azimuth),
      this.distance * Math.sin(this.elevation),
    ];
  }
}
