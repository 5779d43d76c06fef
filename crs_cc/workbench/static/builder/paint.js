/** How shapes look from above: how they are drawn, what they span, and whether they are at a point. */

import { distance } from "./drawing.js";

const KINDS = {
  wall: "#5b6472", solid: "#8d95a3", movable: "#d9b88a", ground: "#b9a98c", goal: "#1a7f37",
  robot: "#0b66b8", light: "#e0a800", sound: "#8e44ad", source: "#b8860b", nest: "#3f51b5", range: "#0b66b8",
  body: "#c9d3df", wheel: "#333a44", sensor: "#0b66b8", beam: "#0b66b8",
};
const WARMTH = "#d1242f";
const WARM = 5; // [px]
const LEGIBLE = 8; // smaller robots have no room for their names [px]
const ALPHA = { ground: 0.45, goal: 0.45, source: 0.45, nest: 0.45, beam: 0.13, heights: 0.85 };

/**
 * Draw a shape.
 * @param {CanvasRenderingContext2D} pen @param {import("./view.js").View} view @param {import("./model.js").Shape} shape
 */
export function paintShape(pen, view, shape, { outline = "", alpha = 1, isChosen = false } = {}) {
  const colour = shape.colour ?? KINDS[shape.kind] ?? KINDS.solid;
  pen.globalAlpha = alpha * (ALPHA[shape.kind] ?? 1);
  pen.fillStyle = colour;
  pen.strokeStyle = outline || "rgb(0 0 0 / 35%)";
  pen.lineWidth = outline ? 2.5 : 1;
  if (shape.kind === "heights") paintHeights(pen, view, shape, outline);
  else if (shape.kind === "range") paintRange(pen, view, shape, colour);
  else if (shape.kind === "wall") paintWall(pen, view, shape, colour, outline);
  else if (shape.points) paintPolygon(pen, view, shape);
  else paintDisc(pen, view, shape);
  if (shape.heat) paintWarmth(pen, view, shape, isChosen);
  pen.globalAlpha = 1;
}

/** That something is warm, and, of what is selected, how far that is felt. */
function paintWarmth(pen, view, shape, isChosen) {
  const [first, third] = shape.points ? [shape.points[0], shape.points.at(shape.kind === "wall" ? 1 : 2)] : [[shape.x, shape.y], [shape.x, shape.y]];
  const place = middle(first, third);
  const [x, y] = view.toScreen(place);
  pen.beginPath();
  pen.arc(x, y, WARM, 0, 2 * Math.PI);
  pen.fillStyle = WARMTH;
  pen.fill();
  if (!isChosen || !shape.spread) return;
  const reach = shape.spread + (shape.points ? distance(first, third) / 2 : shape.radius);
  paintRange(pen, view, { x: place[0], y: place[1], radius: reach }, WARMTH);
}

/** The name of a robot, below it. */
export function paintName(pen, view, shape, name) {
  const [x, y] = view.toScreen([shape.x, shape.y - shape.radius]);
  if (shape.radius * view.scale < LEGIBLE) return;
  pen.font = "12px system-ui";
  pen.fillStyle = view.colours.muted;
  pen.textAlign = "center";
  pen.fillText(name, x, y + 15);
  pen.textAlign = "start";
}

function paintWall(pen, view, shape, colour, outline) {
  pen.beginPath();
  view.line(pen, shape.points);
  pen.lineCap = "round";
  const width = Math.max(2, (shape.thickness ?? 0.1) * view.scale);
  if (outline) {
    pen.lineWidth = width + 5;
    pen.stroke();
  }
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.stroke();
  pen.lineCap = "butt";
}

function paintPolygon(pen, view, shape) {
  pen.beginPath();
  view.line(pen, shape.points);
  pen.closePath();
  pen.fill();
  pen.stroke();
  if (shape.from === undefined || shape.from === shape.to) return;
  const [front, rear] = [middle(shape.points[0], shape.points[3]), middle(shape.points[1], shape.points[2])];
  const [low, high] = (shape.from < shape.to ? [rear, front] : [front, rear]).map((each) => view.toScreen(each));
  const [dx, dy] = [(high[0] - low[0]) / 8, (high[1] - low[1]) / 8];
  pen.beginPath(); // an arrow uphill
  pen.moveTo(low[0] + dx, low[1] + dy);
  pen.lineTo(high[0] - dx, high[1] - dy);
  pen.moveTo(high[0] - 2 * dx - dy, high[1] - 2 * dy + dx);
  pen.lineTo(high[0] - dx, high[1] - dy);
  pen.lineTo(high[0] - 2 * dx + dy, high[1] - 2 * dy - dx);
  pen.stroke();
}

const middle = ([x1, y1], [x2, y2]) => [(x1 + x2) / 2, (y1 + y2) / 2];

function paintDisc(pen, view, shape) {
  const [x, y] = view.toScreen([shape.x, shape.y]);
  const radius = Math.max(3, (shape.radius ?? 0.1) * view.scale);
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
  pen.stroke();
  if (shape.kind !== "robot") return;
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + radius * Math.cos(shape.heading ?? 0), y - radius * Math.sin(shape.heading ?? 0));
  pen.strokeStyle = "white";
  pen.lineWidth = 2.5;
  pen.stroke();
}

function paintRange(pen, view, shape, colour) {
  const [x, y] = view.toScreen([shape.x, shape.y]);
  pen.beginPath();
  pen.arc(x, y, shape.radius * view.scale, 0, 2 * Math.PI);
  pen.strokeStyle = colour;
  pen.setLineDash([7, 5]);
  pen.stroke();
  pen.setLineDash([]);
}

/** A map of heights, dark where it is high. */
function paintHeights(pen, view, shape, outline) {
  const [rows, columns] = [shape.rows.length, shape.rows[0].length];
  const most = Math.max(0.001, ...shape.rows.map((row) => Math.max(...row)));
  const image = new ImageData(columns, rows);
  const colours = new Uint32Array(image.data.buffer); // little-endian: alpha, blue, green, red
  shape.rows.forEach((row, r) => row.forEach((height, c) => (colours[r * columns + c] = (((200 * height) / most) << 24) | 0x285a78)));
  const small = new OffscreenCanvas(columns, rows);
  small.getContext("2d")?.putImageData(image, 0, 0);
  const [x, y] = view.toScreen(shape.points[3]);
  const size = [columns * shape.pixel * view.scale, rows * shape.pixel * view.scale];
  pen.drawImage(small, x, y, size[0], size[1]);
  if (outline) pen.strokeRect(x, y, size[0], size[1]);
}

/** Points that span a shape. @param {import("./model.js").Shape} shape */
export function corners(shape) {
  if (shape.points) return shape.points;
  const { x = 0, y = 0, radius = 0 } = shape;
  return [[x - radius, y - radius], [x + radius, y + radius]];
}

/** Whether a shape is at a point, or nearer than a distance. */
export function isOn(shape, [x, y], near) {
  if (["heights", "range", "beam", "body"].includes(shape.kind)) return false;
  if (shape.kind === "wall") {
    const [[x1, y1], [x2, y2]] = shape.points;
    const [dx, dy] = [x2 - x1, y2 - y1];
    const along = Math.max(0, Math.min(1, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy || 1)));
    return Math.hypot(x - x1 - along * dx, y - y1 - along * dy) <= shape.thickness / 2 + near;
  }
  if (!shape.points) return Math.hypot(x - shape.x, y - shape.y) <= shape.radius + near;
  let inside = false;
  shape.points.forEach(([x1, y1], index) => {
    const [x2, y2] = shape.points[(index + 1) % shape.points.length];
    if (y1 > y !== y2 > y && x < ((x2 - x1) * (y - y1)) / (y2 - y1) + x1) inside = !inside;
  });
  return inside;
}
