/** The world from above, on a canvas. */
import { FlatCamera } from "crs/camera.js";
import { cornersOf } from "crs/scene.js";

export class View2D {
  /** @param {import("./scene.js").Scene} scene @param {HTMLCanvasElement} canvas */
  constructor(scene, canvas) {
    this.scene = scene;
    this.canvas = canvas;
    this.camera = new FlatCamera(scene.area);
  }

  draw(time) {
    const { canvas, camera } = this;
    const pen = canvas.getContext("2d");
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    [canvas.width, canvas.height] = [width * ratio, height * ratio];
    this.scale = camera.scale(width, height);
    pen.fillStyle = "#eceef2";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    const k = this.scale * ratio;
    pen.setTransform(k, 0, 0, -k, canvas.width / 2 - camera.x * k, canvas.height / 2 + camera.y * k);
    pen.lineWidth = 1 / this.scale;
    this.floor(pen);
    this.paths(pen);
    for (const shape of this.scene.shapes) this.shape(pen, shape);
    this.contacts(pen, time);
    for (const body of this.scene.bodies) this.robot(pen, body);
  }

  floor(pen) {
    const { x, y, length, width } = this.scene.area;
    pen.fillStyle = "#ffffff";
    pen.fillRect(x, y, length, width);
    pen.strokeStyle = "#e3e6eb";
    pen.beginPath();
    const step = Math.max(1, 10 ** Math.ceil(Math.log10(length / 60)));
    for (let at = Math.ceil(x / step) * step; at <= x + length; at += step) {
      pen.moveTo(at, y);
      pen.lineTo(at, y + width);
    }
    for (let at = Math.ceil(y / step) * step; at <= y + width; at += step) {
      pen.moveTo(x, at);
      pen.lineTo(x + length, at);
    }
    pen.stroke();
  }

  paths(pen) {
    for (const { points, colour, believed } of this.scene.run.paths) {
      pen.strokeStyle = colour;
      pen.globalAlpha = believed ? 0.6 : 0.35;
      pen.lineWidth = 2 / this.scale;
      pen.setLineDash(believed ? [5 / this.scale, 5 / this.scale] : []);
      pen.beginPath();
      points.forEach(([x, y], index) => (index ? pen.lineTo(x, y) : pen.moveTo(x, y)));
      pen.stroke();
    }
    pen.setLineDash([]);
    pen.globalAlpha = 1;
    pen.lineWidth = 1 / this.scale;
  }

  shape(pen, shape) {
    pen.fillStyle = shape.colour;
    pen.strokeStyle = "#3d4450";
    pen.beginPath();
    if (shape.radius) pen.arc(shape.x, shape.y, shape.radius, 0, 2 * Math.PI);
    else cornersOf(shape).forEach(([x, y], index) => (index ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.closePath();
    pen.fill();
    pen.stroke();
  }

  contacts(pen, time) {
    pen.strokeStyle = "#d1242f";
    pen.lineWidth = 2 / this.scale;
    const arm = 5 / this.scale;
    pen.beginPath();
    for (const [at, kind, , , x, y] of this.scene.run.events) {
      if (kind !== "collision" || at > time || x === null) continue;
      pen.moveTo(x - arm, y - arm);
      pen.lineTo(x + arm, y + arm);
      pen.moveTo(x - arm, y + arm);
      pen.lineTo(x + arm, y - arm);
    }
    pen.stroke();
    pen.lineWidth = 1 / this.scale;
  }

  robot(pen, body) {
    const radius = Math.max(body.radius, 3 / this.scale);
    pen.fillStyle = body.colour;
    pen.strokeStyle = "#ffffff";
    pen.beginPath();
    pen.arc(body.x, body.y, radius, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
    pen.fillStyle = "#ffffff";
    pen.beginPath();
    for (const turn of [0, 2.5, -2.5]) {
      const angle = body.heading + turn;
      pen.lineTo(body.x + 0.72 * radius * Math.cos(angle), body.y + 0.72 * radius * Math.sin(angle));
    }
    pen.fill();
    if (body.turret !== null) {
      pen.beginPath();
      pen.moveTo(body.x, body.y);
      pen.lineTo(body.x + radius * Math.cos(body.turret), body.y + radius * Math.sin(body.turret));
      pen.stroke();
    }
  }
}
