/** Handles of what is selected: a knob that turns, ends of walls, corners of boxes, a radius. */

import { lengthIn, radiusTo } from "./drawing.js";
import { corners } from "./paint.js";

const KNOB = 28; // [px] above the selection

/** The rectangle around the selection [m]; null if nothing with a shape is selected. */
export function bounds(model) {
  const found = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (const name of model.selection) {
    for (const [x, y] of model.shapes(name).flatMap(corners)) {
      found.left = Math.min(found.left, x);
      found.right = Math.max(found.right, x);
      found.low = Math.min(found.low, y);
      found.high = Math.max(found.high, y);
    }
  }
  return found.left <= found.right ? found : null;
}

/**
 * The handles of the selection, each with its place and what a drag of it sets.
 * @returns {{kind: string, place: number[], name?: string, set?: (to: number[]) => Record<string, number | string>}[]}
 */
export function handles(model, view) {
  const around = bounds(model);
  if (!around) return [];
  const middle = [(around.left + around.right) / 2, (around.low + around.high) / 2];
  /** @type {any[]} */
  const found = [{ kind: "turn", place: [middle[0], around.high + KNOB / view.scale], middle }];
  if (model.selection.size !== 1) return found;
  const [name] = model.selection;
  const item = model.item(name);
  const [shape] = model.shapes(name);
  if (!shape || shape.kind === "heights") return [];
  const { unit } = model;
  if (item?.tag === "body") return [rim(name, shape, unit)];
  if (item?.tag === "drive") return model.shapes(name).map((each) => wheel(name, each, unit));
  const own = model.shapes(name).find((each) => each.kind === "sensor");
  if (own) return item?.tag === "laser" || item?.tag === "arm" ? [] : [aim(own, view)];
  if (shape.kind === "range" || shape.kind === "goal") return model.shapes(name).map((each) => ring(name, each));
  if (item?.tag === "wall") {
    found.push({ kind: "end", place: shape.points[0], set: ([x, y]) => ({ x1: x, y1: y }) });
    found.push({ kind: "end", place: shape.points[1], set: ([x, y]) => ({ x2: x, y2: y }) });
  } else if (["cylinder", "source", "nest"].includes(item?.tag ?? "")) {
    const place = [shape.x + shape.radius, shape.y];
    found.push({ kind: "size", place, set: (to) => ({ radius: Math.max(0.01, radiusTo([shape.x, shape.y], to)) }) });
  } else if (["box", "ramp", "plateau"].includes(item?.tag ?? "")) {
    shape.points.forEach((place, index) => found.push({ kind: "size", place, set: (to) => resized(shape, index, to) }));
  }
  return found;
}

/** The handle of the radius of a goal's place, or of the range of a channel. */
function ring(name, shape) {
  const attribute = shape.kind === "range" ? "range" : "radius";
  const set = (to) => ({ [attribute]: Math.max(0.01, radiusTo([shape.x, shape.y], to)) });
  const target = shape.element ? `${name}/${shape.element}` : name;
  return { kind: "size", place: [shape.x + shape.radius, shape.y], name: target, set };
}

/** The handle of a wheel, which sets the distance of both. */
function wheel(name, shape, unit) {
  const place = [0, (shape.points[0][1] + shape.points[2][1]) / 2];
  return { kind: "size", place, name, set: ([, y]) => ({ "wheel-base": lengthIn(Math.max(0.01, 2 * Math.abs(y)), unit) }) };
}

/** The handle of a robot's body, which sets its radius. */
function rim(name, { radius }, unit) {
  return { kind: "size", place: [-radius, 0], name, set: ([x, y]) => ({ radius: lengthIn(Math.max(0.01, Math.hypot(x, y)), unit) }) };
}

/** The knob in front of a sensor, by which it is turned about itself. */
function aim({ x, y, heading }, view) {
  const away = (2 * KNOB) / view.scale;
  return { kind: "turn", place: [x + away * Math.cos(heading), y + away * Math.sin(heading)], middle: [x, y], start: heading };
}

/** The attributes of a box of which one corner goes to a place, and the opposite one stays. */
function resized(shape, index, [x, y]) {
  const [fixed, first, second] = [shape.points[(index + 2) % 4], shape.points[0], shape.points[1]];
  const heading = Math.atan2(first[1] - second[1], first[0] - second[0]);
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  const [dx, dy] = [x - fixed[0], y - fixed[1]];
  return {
    x: (x + fixed[0]) / 2,
    y: (y + fixed[1]) / 2,
    length: Math.max(0.01, Math.abs(cos * dx + sin * dy)),
    width: Math.max(0.01, Math.abs(cos * dy - sin * dx)),
  };
}

export function paintHandles(pen, model, view, colour) {
  for (const { kind, place } of handles(model, view)) {
    const [x, y] = view.toScreen(place);
    pen.beginPath();
    if (kind === "turn") pen.arc(x, y, 7, 0, 2 * Math.PI);
    else pen.rect(x - 5, y - 5, 10, 10);
    pen.fillStyle = "white";
    pen.strokeStyle = colour;
    pen.lineWidth = 2;
    pen.fill();
    pen.stroke();
  }
}

/** The handle at a point of the canvas. */
export const handleAt = (model, view, [x, y]) =>
  handles(model, view).find(({ place }) => {
    const [px, py] = view.toScreen(place);
    return Math.hypot(px - x, py - y) <= 9;
  });
