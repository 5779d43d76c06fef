/** What each tool draws: how the mouse gives its corners, and the element that becomes of them. */

const NEAR = 10; // [px] to close a polygon
const MIN = 0.001; // [m]
export const UNITS = { m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048 };

/**
 * The tools: `by` says how, by dragging from corner to corner or from a centre, clicking once or
 * corner by corner, or painting.
 */
export const TOOLS = [
  { id: "select", key: "v", by: "select", title: "Select, move, turn and resize; double-click an object to edit its definition" },
  { id: "wall", key: "w", by: "corners", title: "Walls: click each corner; type a length; Esc ends the chain" },
  { id: "box", key: "b", by: "rectangle", title: "Box: drag from corner to corner", more: {} },
  { id: "cylinder", key: "c", by: "disc", title: "Cylinder: drag from its centre" },
  { id: "polygon", key: "p", by: "corners", title: "Polygon: click each corner, then the first one again" },
  { id: "ramp", key: "m", by: "rectangle", title: "Ramp: drag from corner to corner; it rises to the right", more: { to: 0.3 } },
  { id: "plateau", key: "t", by: "rectangle", title: "Plateau, or step: drag from corner to corner", more: { height: 0.15 } },
  { id: "heights", key: "h", by: "brush", title: "Heights: drag to raise the ground, or Shift-drag to lower it" },
  { id: "robot", key: "r", by: "click", title: "Robot: click its initial position" },
  { id: "light", key: "l", by: "click", title: "Light: click" },
  { id: "sound", key: "n", by: "click", title: "Sound: click" },
  { id: "goal", key: "g", by: "disc", title: "Goal: drag the place to reach from its centre; if movable objects are selected, the place to bring them to" },
  { id: "sensor", key: "s", by: "click", title: "Sonar: click its position on the robot; it points away from the centre" },
];

/** The tools for a kind of document. @param {boolean} isRobot whether it is a robot definition */
export const toolsFor = (isRobot) => TOOLS.filter((tool) => (isRobot ? ["select", "sensor"].includes(tool.id) : tool.id !== "sensor"));

/** A length as it is written in a file. @param {number} value [m] @param {string} unit */
export const lengthIn = (value, unit) => `${+(value / UNITS[unit]).toFixed(4)}${unit}`;

export const toolOf = (id) => TOOLS.find((tool) => tool.id === id) ?? TOOLS[0];

/** Add what was dragged. @param {import("./model.js").Model} model @param {string} id */
export function addDragged(model, id, [x1, y1], [x2, y2]) {
  const tool = toolOf(id);
  if (tool.by === "disc") {
    const radius = radiusTo([x1, y1], [x2, y2]);
    if (radius > MIN) addDisc(model, id, { x: x1, y: y1, radius });
    return;
  }
  const [length, width] = [Math.abs(x2 - x1), Math.abs(y2 - y1)];
  if (length > MIN && width > MIN) {
    model.add(id, { x: (x1 + x2) / 2, y: (y1 + y2) / 2, length, width, ...tool.more });
  }
}

function addDisc(model, id, place) {
  if (id !== "goal") {
    model.add(id, place);
    return;
  }
  const [name] = model.selection;
  const visited = model.shapes(name).some((shape) => shape.element?.startsWith("visit"));
  const movable = [...model.selection].filter((each) => model.shapes(each).some((shape) => shape.kind === "movable"));
  if (visited) model.add("place", place, `${name}/visit`);
  else if (movable.length) model.add("bring", { objects: movable.join(" "), ...place });
  else model.add("reach", place);
}

/** Add what a click puts down. @param {any} model @param {string} id @param {number[]} at */
export function addClicked(model, id, [x, y]) {
  if (id === "sensor") model.mount([x, y]);
  else model.add(id, { x, y });
}

/** The corners of walls or of a polygon, one click after the other. */
export class Corners {
  /** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
  constructor(model, view) {
    this.model = model;
    this.view = view;
    /** @type {number[][]} */
    this.points = [];
    this.typed = "";
  }

  get last() {
    return this.points.at(-1);
  }

  clear() {
    this.points = [];
    this.typed = "";
  }

  /** Put a corner at a point. @param {string} id the tool */
  put(id, point) {
    const [first] = this.points;
    const isClosed = id === "polygon" && this.points.length > 2 && distance(point, first) * this.view.scale < NEAR;
    if (isClosed) {
      this.finish(id);
      return;
    }
    const { last } = this;
    this.typed = "";
    this.points.push(point);
    if (id === "wall" && last && distance(point, last) > MIN) {
      this.model.add("wall", { x1: last[0], y1: last[1], x2: point[0], y2: point[1] });
    }
  }

  /** End a chain, or close a polygon. @param {string} id the tool */
  finish(id) {
    if (id === "polygon" && this.points.length > 2) {
      const text = (value) => lengthIn(value, this.model.unit);
      this.model.add("polygon", { points: this.points.map(([x, y]) => `${text(x)},${text(y)}`).join(" ") });
    }
    this.clear();
  }

  /** A key while corners are put; whether it was one. @param {string} id @param {string} key @param {number[]} pointer */
  key(id, key, pointer) {
    if (!this.points.length) return false;
    if (id === "wall" && /^[0-9.]$/.test(key)) this.typed += key;
    else if (id === "wall" && key === "Backspace") this.typed = this.typed.slice(0, -1);
    else if (key === "Enter" && this.typed) this.put(id, this.ahead(pointer));
    else if (key === "Enter") this.finish(id);
    else return false;
    return true;
  }

  /** The next corner: at the typed length towards the pointer, or there. */
  ahead(pointer) {
    if (!this.typed) return pointer;
    const [x, y] = this.last ?? [0, 0];
    const length = Number(this.typed) * UNITS[this.model.unit];
    const share = length / (distance(pointer, [x, y]) || 1);
    return [x + (pointer[0] - x) * share, y + (pointer[1] - y) * share];
  }

  paint(pen, id, pointer, label) {
    const end = this.ahead(pointer);
    pen.beginPath();
    this.view.line(pen, [...(id === "wall" ? this.points.slice(-1) : this.points), end]);
    pen.stroke();
    label(this.typed || lengthIn(distance(end, this.last ?? end), this.model.unit), end);
  }
}

/** @param {number[]} one @param {number[]} other */
export const distance = ([x1, y1], [x2, y2]) => Math.hypot(x2 - x1, y2 - y1);

/** The radius of a circle through a point, to the millimetre. @param {number[]} centre @param {number[]} point */
export const radiusTo = (centre, point) => Math.round(distance(centre, point) * 1000) / 1000;
