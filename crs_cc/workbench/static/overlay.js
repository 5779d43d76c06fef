/**
 * What is drawn over a view, flat or not: trails, sonar cones, labels, contacts, the scale.
 * Each part is a row of `PARTS`; `show` has their switches.
 */
import { fieldScale } from "crs/field_map.js";
import { heatColour, maxHeat } from "crs/heat.js";
import { degraded, laser, ranges } from "crs/overlay_devices.js";
import { otherRun } from "crs/overlay_other.js";
import { movable } from "crs/overlay_objects.js";
import { askedBeam, cameraStrip, heatRange, infraredBeams } from "crs/overlay_sensors.js";
import { angleText, gridStep, lengthText } from "crs/units.js";

const MANY = 60; // robots: of more, only the selected one is annotated
const LINE = 17; // between names, one above the other [pixels]
const ECHO_S = 0.8; // how long contacts are marked [s]

/** @typedef {{name: string, title: string, on: boolean, only?: (run: any) => any, device?: string, draw: (o: Overlay) => void}} Part
 *   `only`: whether a run has any of it; `device`: what a robot must have */

/** @type {Part[]} */
export const PARTS = [
  { name: "trails", title: "Trails", on: true, draw: trails },
  { name: "paths", title: "Full paths: true and odometry", on: true, only: (run) => run.paths, draw: paths },
  { name: "marks", title: "Drawings by programs", on: true, only: (run) => run.marks, draw: marks },
  { name: "fields", title: "Pheromone fields", on: true, only: (run) => run.world.fields?.length, draw: fieldScale },
  { name: "movable", title: "Movable objects", on: true, only: (run) => run.world.shapes.some((shape) => shape.movable), draw: movable },
  { name: "sonar", title: "Sonar echoes", on: true, draw: sonar },
  { name: "laser", title: "Laser", on: true, device: "laser", draw: laser },
  { name: "camera", title: "Camera", on: true, device: "camera", draw: cameraStrip },
  { name: "infrared", title: "Infrared beams", on: true, device: "infrared", draw: infraredBeams },
  { name: "heat", title: "Range of the heat sensor", on: false, device: "heat", draw: heatRange },
  { name: "degraded", title: "Degraded devices", on: true, draw: degraded },
  { name: "bumpers", title: "Bumpers", on: true, draw: bumpers },
  { name: "believed", title: "Odometry poses", on: false, draw: believed },
  { name: "contacts", title: "Collisions", on: true, draw: contacts },
  { name: "messages", title: "Messages", on: true, draw: messages },
  { name: "ranges", title: "Radio range", on: false, draw: ranges },
  { name: "labels", title: "Names", on: true, draw: labels },
  { name: "grid", title: "Grid and scale", on: true, draw: scale },
];

export class Overlay {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
  }

  /** @param {any} view @param {any} camera @param {any} look */
  draw(view, camera, look) {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      [this.canvas.width, this.canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    }
    this.pen = this.canvas.getContext("2d");
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, width, height);
    this.view = view;
    this.camera = camera;
    this.look = look;
    this.scene = view.scene;
    this.project = view.project;
    this.width = width;
    this.height = height;
    this.several = this.scene.bodies.length <= MANY;
    for (const part of PARTS) if (look.show[part.name]) part.draw(this);
    this.selection();
    if (look.beam) askedBeam(this, look.beam);
    if (look.other) otherRun(this);
    if (look.heat) heatScale(this);
  }

  /** The robots that are annotated. */
  chosen() {
    if (this.several) return this.scene.bodies.filter(({ row }) => this.concerns(row));
    const body = this.scene.body(this.look.selected);
    return body ? [body] : [];
  }

  /** Whether what is about these robots is drawn: all, or the selected one. @param {...number} rows */
  concerns(...rows) {
    return !this.look.isSelectedOnly || rows.includes(this.look.selected);
  }

  /** A line through points [x, y, z]; parts behind the camera are left out. */
  path(points) {
    const { pen } = this;
    let isDown = false;
    for (const point of points) {
      const at = point ? this.project(point[0], point[1], point[2] ?? 0) : null;
      if (!at || at[2] <= 0.02) isDown = false;
      else if (isDown) pen.lineTo(at[0], at[1]);
      else {
        pen.moveTo(at[0], at[1]);
        isDown = true;
      }
    }
  }

  circle(x, y, z, radius, steps = 28) {
    const points = [];
    for (let step = 0; step <= steps; step++) {
      const angle = (step / steps) * 2 * Math.PI;
      points.push([x + radius * Math.cos(angle), y + radius * Math.sin(angle), z]);
    }
    this.path(points);
  }

  /** A plate on which a text is read whatever is behind it. @param {number} left @param {number} top @param {number} width @param {number} height @param {string} colour */
  plate(left, top, width, height, colour, { alpha = 1, radius = 5 } = {}) {
    const { pen } = this;
    pen.globalAlpha = alpha;
    pen.fillStyle = colour;
    pen.beginPath();
    pen.roundRect(left, top, width, height, radius);
    pen.fill();
    pen.globalAlpha = 1;
  }

  selection() {
    const body = this.scene.body(this.look.selected);
    if (!body || this.scene.bodies.length < 2) return;
    const { pen } = this;
    pen.strokeStyle = this.look.colours.accent;
    pen.lineWidth = 2;
    pen.beginPath();
    this.circle(body.x, body.y, body.z + 0.01, body.radius * 1.35);
    pen.stroke();
  }
}

/** The scale of the infrared view: which colour is which heat. */
function heatScale(o) {
  const { pen, look } = o;
  const most = maxHeat(o.scene);
  const [left, top, size] = [o.width - 30, o.height / 2 - 80, 160];
  pen.fillStyle = "rgb(11 16 38 / 80%)"; // as cold as can be, so that the text is read on any heat
  pen.beginPath();
  pen.roundRect(left - 146, top - 25, 166, 21, 6);
  pen.roundRect(left - 42, top - 8, 62, size + 18, 6);
  pen.fill();
  for (let row = 0; row < size; row++) {
    pen.fillStyle = heatColour(1 - row / size);
    pen.fillRect(left, top + row, 14, 1.5);
  }
  pen.strokeStyle = look.colours.muted;
  pen.lineWidth = 1;
  pen.strokeRect(left, top, 14, size);
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "right";
  pen.fillStyle = "#dfe4ec";
  for (const share of [0, 0.25, 0.5, 0.75, 1]) pen.fillText(`${+(most * share).toPrecision(3)}`, left - 5, top + size * (1 - share) + 4);
  pen.fillText("heat, as the sensor reads it", left + 14, top - 9);
}

function trails(o) {
  const { pen, look } = o;
  pen.lineWidth = 2;
  pen.lineJoin = "round";
  for (const body of o.chosen()) {
    const points = look.trails.of(body.row);
    if (points.length < 2) continue;
    const [newest, oldest] = [points.at(-1).t, points[0].t];
    const share = Math.max(1, Math.ceil(points.length / 12));
    pen.strokeStyle = body.colour;
    for (let at = 0; at < points.length - 1; at += share) {
      const piece = points.slice(at, at + share + 1);
      pen.globalAlpha = 0.08 + 0.62 * ((piece[0].t - oldest) / Math.max(1e-6, newest - oldest));
      pen.beginPath();
      o.path(piece.map(({ x, y }) => [x, y, o.scene.ground.height(x, y) + 0.01]));
      pen.stroke();
    }
    pen.globalAlpha = 0.7;
    pen.beginPath();
    o.path([points.at(-1), body].map(({ x, y }) => [x, y, body.z + 0.01]));
    pen.stroke();
  }
  pen.globalAlpha = 1;
}

/** The paths of a whole recorded run; those that odometry believed are dashed. */
function paths(o) {
  const { pen } = o;
  for (const { points, colour, believed: isBelieved } of o.look.model.run.paths ?? []) {
    pen.strokeStyle = colour;
    pen.globalAlpha = isBelieved ? 0.45 : 0.25;
    pen.lineWidth = 1.5;
    pen.setLineDash(isBelieved ? [5, 5] : []);
    pen.beginPath();
    o.path(points.map(([x, y]) => [x, y, o.scene.ground.height(x, y) + 0.005]));
    pen.stroke();
  }
  pen.setLineDash([]);
  pen.globalAlpha = 1;
}

/** What programs had drawn up to the time that is shown. */
function marks(o) {
  const { pen } = o;
  pen.lineWidth = 1.5;
  for (const [since, until, colour, points] of o.look.model.run.marks ?? []) {
    if (since > o.look.time || (until !== null && until <= o.look.time)) continue;
    pen.strokeStyle = colour === "#000000" ? o.look.colours.text : colour; // on a dark floor, too
    pen.beginPath();
    o.path(points.map(([x, y]) => [x, y, o.scene.ground.height(x, y) + 0.01]));
    pen.stroke();
  }
}

function sonar(o) {
  const { pen, look } = o;
  for (const body of o.chosen()) {
    const echoes = look.sensors.echoes(body.row);
    if (!echoes || !body.kind) continue;
    const isChosen = body.row === look.selected;
    body.kind.sonars.forEach((each, number) => {
      const echo = echoes[number];
      if (echo === null || echo === undefined || echo < 0) return;
      const heading = body.mount + each.direction;
      const [cos, sin] = [Math.cos(body.mount), Math.sin(body.mount)];
      const from = [body.x + each.x * cos - each.y * sin, body.y + each.x * sin + each.y * cos];
      const z = body.z + body.height * 0.7;
      const arc = [-1, -0.5, 0, 0.5, 1].map((turn) => {
        const angle = heading + turn * each.half_angle;
        return [from[0] + echo * Math.cos(angle), from[1] + echo * Math.sin(angle), z];
      });
      const closeness = Math.max(0, 1 - echo / 2);
      if (!isChosen && !closeness) return;
      pen.fillStyle = closeness > 0.6 ? "#d1242f" : body.colour;
      if (isChosen) {
        pen.beginPath();
        o.path([[...from, z], ...arc, [...from, z]]);
        pen.globalAlpha = 0.05 + 0.15 * closeness;
        pen.fill();
      }
      pen.beginPath();
      o.path(arc);
      pen.strokeStyle = pen.fillStyle;
      pen.globalAlpha = (isChosen ? 0.45 : 0.1) + 0.5 * closeness;
      pen.lineWidth = 1.5;
      pen.stroke();
    });
  }
  pen.globalAlpha = 1;
}

function bumpers(o) {
  const { pen, look } = o;
  pen.strokeStyle = "#e5383b";
  pen.lineWidth = 4;
  for (const body of o.scene.bodies) {
    const bits = look.sensors.bumpers(body.row);
    if (!bits || !body.kind || !o.concerns(body.row)) continue;
    for (const { bit, bearing, span } of body.kind.bumpers) {
      if (!((bits >> bit) & 1)) continue;
      const points = [];
      for (let step = 0; step <= 8; step++) {
        const angle = body.base + bearing + span * (step / 8 - 0.5);
        points.push([body.x + body.radius * 1.05 * Math.cos(angle), body.y + body.radius * 1.05 * Math.sin(angle), body.z + 0.08]);
      }
      pen.beginPath();
      o.path(points);
      pen.stroke();
    }
  }
}

function believed(o) {
  const { pen, look } = o;
  pen.setLineDash([5, 4]);
  pen.lineWidth = 1.5;
  for (const body of o.chosen()) {
    const pose = look.sensors.believed(body.row);
    if (!pose) continue;
    const [x, y, heading] = pose;
    pen.strokeStyle = body.colour;
    pen.beginPath();
    o.circle(x, y, body.z + 0.01, body.radius);
    o.path([[x, y, body.z + 0.01], [x + body.radius * Math.cos(heading), y + body.radius * Math.sin(heading), body.z + 0.01]]);
    o.path([[x, y, body.z + 0.01], [body.x, body.y, body.z + 0.01]]);
    pen.stroke();
  }
  pen.setLineDash([]);
}

function contacts(o) {
  const { pen, look } = o;
  pen.strokeStyle = "#e5383b";
  for (const [at, kind, row, , x, y] of look.recent(ECHO_S)) {
    if (kind !== "collision" || x === null || !o.concerns(row)) continue;
    const share = (look.time - at) / ECHO_S;
    pen.lineWidth = 2.5;
    pen.globalAlpha = 1 - share;
    pen.beginPath();
    o.circle(x, y, o.scene.ground.height(x, y) + 0.05, 0.06 + 0.3 * share);
    pen.stroke();
  }
  pen.globalAlpha = 1;
}

function messages(o) {
  const { pen, look } = o;
  for (const { from, to, share, isLost } of look.traffic()) {
    const [a, b] = [o.scene.body(from), o.scene.body(to)];
    if (!a || !b || !o.concerns(from, to)) continue;
    const high = 0.35 * Math.hypot(a.x - b.x, a.y - b.y) + 0.3;
    const points = [];
    for (let step = 0; step <= 16; step++) {
      const k = step / 16;
      points.push([a.x + (b.x - a.x) * k, a.y + (b.y - a.y) * k, a.z + a.height + 4 * high * k * (1 - k)]);
    }
    pen.strokeStyle = pen.fillStyle = isLost ? "#e5383b" : "#8250df";
    pen.globalAlpha = 0.75 * (1 - share);
    pen.setLineDash([5, 4]);
    pen.lineWidth = 1.5;
    pen.beginPath();
    o.path(points);
    pen.stroke();
    pen.setLineDash([]);
  }
  pen.globalAlpha = 1;
}

function labels(o) {
  const { pen, look } = o;
  const taken = []; // left, right and height of those that are drawn
  pen.font = "600 11px system-ui, sans-serif";
  pen.textAlign = "center";
  for (const body of o.chosen()) {
    const [x, y, w] = o.project(body.x, body.y, body.z + body.height);
    if (w <= 0 || x < -40 || x > o.width + 40 || y < -20 || y > o.height + 20) continue;
    const size = Math.max(7, body.radius * o.view.pixels(w)) + 5;
    const half = pen.measureText(body.id).width / 2 + 5;
    let foot = y - size;
    const isIn = ([left, right, other]) => x + half > left && x - half < right && Math.abs(other - foot) < LINE;
    for (let each = taken.find(isIn); each; each = taken.find(isIn)) foot = each[2] - LINE; // above it
    taken.push([x - half, x + half, foot]);
    o.plate(x - half, foot - 15, 2 * half, 16, look.colours.panel, { alpha: 0.86 });
    pen.fillStyle = body.row === look.selected ? look.colours.accent : look.colours.text;
    pen.fillText(body.id, x, foot - 3.5);
  }
}

function scale(o) {
  const { pen, look, camera } = o;
  if (camera.mode === "board") return;
  const pixels = o.view.pixels(camera.distance);
  const step = gridStep(70 / pixels);
  const [right, low] = [o.width - 16, o.height - 16];
  pen.strokeStyle = pen.fillStyle = look.colours.muted;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(right - step * pixels, low - 4);
  pen.lineTo(right - step * pixels, low);
  pen.lineTo(right, low);
  pen.lineTo(right, low - 4);
  pen.stroke();
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.fillText(lengthText(step), right - (step * pixels) / 2, low - 5);
  const body = o.scene.body(look.selected);
  if (!body) return;
  const text = `${body.id}  ${body.x.toFixed(2)}, ${body.y.toFixed(2)} m  ${angleText(body.heading)}`;
  pen.textAlign = "left";
  o.plate(10, low - 16, pen.measureText(text).width + 12, 19, look.colours.panel, { alpha: 0.8, radius: 6 });
  pen.fillStyle = look.colours.muted;
  pen.fillText(text, 16, low - 2.5);
}
