/**
 * Infrared: heat as colour. The floor has what a heat sensor there would read, by the sensor's own
 * law (`sim/devices/heat`): the sum over objects of heat times max(0, 1 - distance / spread). Things
 * without a spread would add the same anywhere, so only they themselves have their colour.
 */
import { cornersOf } from "crs/scene.js";

const STOPS = [
  [0, 11, 16, 38],
  [0.2, 59, 26, 109],
  [0.4, 140, 41, 129],
  [0.6, 222, 73, 104],
  [0.8, 254, 159, 109],
  [1, 252, 253, 191],
];
const FINE = 96; // cells along the longer side of the floor

/** A share of the largest heat as red, green and blue. @param {number} share 0 to 1 */
export function heatRgb(share) {
  const at = Math.min(1, Math.max(0, share));
  const above = STOPS.findIndex(([stop]) => stop >= at);
  if (above <= 0) return STOPS[0].slice(1);
  const [low, high] = [STOPS[above - 1], STOPS[above]];
  const part = (at - low[0]) / (high[0] - low[0]);
  return [1, 2, 3].map((each) => Math.round(low[each] + (high[each] - low[each]) * part));
}

/** @param {number} share */
export const heatColour = (share) => `rgb(${heatRgb(share).join(", ")})`;

/** The distance of a place from the nearest point of an object [m]. */
function distance(shape, x, y) {
  if (shape.radius) return Math.max(0, Math.hypot(x - shape.x, y - shape.y) - shape.radius);
  const corners = cornersOf(shape);
  let [least, isInside] = [Infinity, true];
  corners.forEach(([ax, ay], number) => {
    const [bx, by] = corners[(number + 1) % corners.length];
    const [ex, ey, px, py] = [bx - ax, by - ay, x - ax, y - ay];
    const along = Math.min(1, Math.max(0, (px * ex + py * ey) / (ex * ex + ey * ey || 1)));
    least = Math.min(least, Math.hypot(px - along * ex, py - along * ey));
    if (ex * py - ey * px < 0) isInside = false;
  });
  return isInside ? 0 : least;
}

/** Heat that a sensor at a place reads. @param {any[]} objects with heat */
export function heatAt(objects, x, y) {
  let sum = 0;
  for (const object of objects) {
    const share = object.spread ? Math.max(0, 1 - distance(object, x, y) / object.spread) : 1;
    sum += object.heat * share;
  }
  return sum;
}

/** The hot objects of a scene, and hot robots at their positions. @param {any} scene */
export function hotObjects(scene) {
  return [...scene.shapes, ...scene.bodies]
    .filter((each) => scene.heat(each) > 0)
    .map((each) => ({ ...each, heat: scene.heat(each) }));
}

/** A picture of the heat on the floor, its lower left corner first. @param {any} scene */
export function heatPicture(scene, most) {
  const { x, y, length, width } = scene.area;
  const cell = Math.max(length, width) / FINE;
  const [columns, rows] = [Math.max(1, Math.round(length / cell)), Math.max(1, Math.round(width / cell))];
  const objects = hotObjects(scene).filter((object) => object.spread).slice(0, 50); // others are the same anywhere
  const data = new Uint8Array(columns * rows * 4);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const heat = heatAt(objects, x + ((column + 0.5) * length) / columns, y + ((row + 0.5) * width) / rows);
      data.set([...heatRgb(heat / most), 255], (row * columns + column) * 4);
    }
  }
  return { data, columns, rows };
}

/** The largest heat that the colours show. @param {any} scene */
export const maxHeat = (scene) => Math.max(1, ...hotObjects(scene).map((object) => object.heat));
