/** The world from above, on a canvas: where there is no WebGL, or for those who prefer a map. */
import { FieldPictures } from "crs/field_map.js";
import { cornersOf } from "crs/scene.js";
import { gridStep } from "crs/units.js";

const WARM = "#d1242f"; // a dot on what is hot

export class View2D {
  /** @param {import("./scene.js").Scene} scene @param {HTMLCanvasElement} canvas */
  constructor(scene, canvas) {
    this.scene = scene;
    this.canvas = canvas;
    this.pictures = new FieldPictures();
    this.isFlat = true;
    this.isSoft = false;
    this.project = (x, y) => [x, y, 1];
    this.pixels = () => 1;
  }

  /** @param {any} camera @param {any} _body @param {any} look colours, and what is to be shown */
  draw(camera, _body, look) {
    const { canvas } = this;
    const pen = canvas.getContext("2d");
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    }
    const scale = 1 / camera.metres(width, height);
    this.scale = scale;
    this.pixels = () => scale;
    this.project = (x, y) => [width / 2 + (x - camera.x) * scale, height / 2 - (y - camera.y) * scale, 1];
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.fillStyle = look.colours.sky;
    pen.fillRect(0, 0, canvas.width, canvas.height);
    const k = scale * ratio;
    pen.setTransform(k, 0, 0, -k, canvas.width / 2 - camera.x * k, canvas.height / 2 + camera.y * k);
    pen.lineWidth = 1 / scale;
    this.floor(pen, look, camera, width, height);
    for (const shape of this.scene.shapes) this.shape(pen, shape, look);
    for (const body of this.scene.bodies) this.robot(pen, body, look);
  }

  /** Nothing is held that must be given back. */
  dispose() {}

  floor(pen, look, camera, width, height) {
    const { x, y, length, width: depth } = this.scene.area;
    pen.fillStyle = look.colours.floor;
    pen.fillRect(x, y, length, depth);
    this.patches(pen);
    this.places(pen);
    this.fields(pen, look);
    if (!look.show.grid) return;
    const [spanX, spanY] = [width / this.scale / 2, height / this.scale / 2];
    const [left, right] = [Math.max(x, camera.x - spanX), Math.min(x + length, camera.x + spanX)];
    const [low, high] = [Math.max(y, camera.y - spanY), Math.min(y + depth, camera.y + spanY)];
    const step = gridStep(90 / this.scale);
    pen.strokeStyle = look.colours.grid;
    pen.beginPath();
    for (let at = Math.ceil(left / step) * step; at <= right; at += step) {
      pen.moveTo(at, low);
      pen.lineTo(at, high);
    }
    for (let at = Math.ceil(low / step) * step; at <= high; at += step) {
      pen.moveTo(left, at);
      pen.lineTo(right, at);
    }
    pen.stroke();
  }

  patches(pen) {
    for (const patch of this.scene.ground.patches) {
      pen.save();
      pen.translate(patch.x, patch.y);
      pen.rotate(patch.heading);
      const shade = pen.createLinearGradient(-patch.length / 2, 0, patch.length / 2, 0);
      shade.addColorStop(0, `rgba(120,140,110,${0.12 + 0.4 * Math.min(1, patch.from)})`);
      shade.addColorStop(1, `rgba(120,140,110,${0.12 + 0.4 * Math.min(1, patch.to)})`);
      pen.fillStyle = shade;
      pen.fillRect(-patch.length / 2, -patch.width / 2, patch.length, patch.width);
      pen.restore();
    }
  }

  places(pen) {
    pen.globalAlpha = 0.25;
    for (const { x, y, radius, colour } of this.scene.run.world.places ?? []) {
      pen.fillStyle = colour;
      pen.beginPath();
      pen.arc(x, y, radius, 0, 2 * Math.PI);
      pen.fill();
    }
    pen.globalAlpha = 1;
  }

  fields(pen, look) {
    pen.imageSmoothingEnabled = false;
    look.fields.forEach((field, number) => {
      pen.drawImage(this.pictures.of(field, number), field.x, field.y, field.columns * field.cell, field.rows * field.cell);
    });
  }

  shape(pen, shape, look) {
    pen.fillStyle = look.heat ? look.heat(this.scene.heat(shape)) : shape.colour;
    pen.strokeStyle = look.colours.edge;
    pen.beginPath();
    if (shape.radius) pen.arc(shape.x, shape.y, shape.radius, 0, 2 * Math.PI);
    else cornersOf(shape).forEach(([x, y], index) => (index ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.closePath();
    pen.fill();
    pen.stroke();
    if (look.heat || !this.scene.heat(shape)) return;
    pen.fillStyle = WARM;
    pen.beginPath();
    pen.arc(shape.x, shape.y, 4 / this.scale, 0, 2 * Math.PI);
    pen.fill();
  }

  robot(pen, body, look) {
    const radius = Math.max(body.radius, 3 / this.scale);
    pen.fillStyle = look.heat ? look.heat(this.scene.heat(body)) : body.colour;
    pen.strokeStyle = "#ffffff";
    pen.beginPath();
    pen.arc(body.x, body.y, radius, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
    if (radius * this.scale < 4) return;
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

  /** The place on the floor under a point of the view. */
  ground(px, py, camera, width, height) {
    return [camera.x + (px - width / 2) / this.scale, camera.y - (py - height / 2) / this.scale];
  }
}
