/** What the page knows of the world that is edited, and what it asks of the builder. */

import { SocketChannel } from "../channel.js";
import { lengthIn } from "./drawing.js";
import { byPart, compose } from "./frames.js";

/**
 * @typedef {{kind: string, points?: number[][], x?: number, y?: number, radius?: number,
 *   thickness?: number, heading?: number, colour?: string, from?: number, to?: number,
 *   part?: string, element?: string, heat?: number, spread?: number | null, rows?: number[][], pixel?: number}} Shape
 * @typedef {{name: string, tag: string, attributes: Record<string, string>, pose?: [number, number, number]}} Item
 * @typedef {{root: string, pose: [number, number, number], items: Item[], shapes: Record<string, Shape[]>}} Inside
 */

const MAX_SONARS = 16;

export class Model extends EventTarget {
  constructor() {
    super();
    /** @type {any} */
    this.document = null;
    this.operations = [];
    /** Names of colours. @type {string[]} */
    this.colours = [];
    this.selection = new Set();
    /** New elements that are selected as soon as they are known. @type {string[] | null} */
    this.awaited = null;
    /** Elements that are not drawn, and that the mouse leaves alone. */
    this.hidden = new Set();
    this.locked = new Set();
    /** The objects whose definitions are opened, outermost first. @type {string[]} */
    this.path = [];
    /** The definition that is edited; null for the world. @type {Inside | null} */
    this.inside = null;
    /** @type {Map<string, Item>} */
    this.index = new Map();
    this.chosenUnit = "";
    this.isConnected = false;
    this.mayChange = false;
    /** The text below the world: the result of the last operation, or its error. */
    this.note = "";
    this.isWrong = false;
    this.channel = new SocketChannel((message) => this.handle(message));
  }

  handle(message) {
    if (message.type === "hello") {
      this.isConnected = true;
      this.mayChange = message.role === "control";
      this.operations = message.operations;
      this.colours = message.colours;
    } else if (message.type === "lost") {
      this.isConnected = false;
      this.notify(message.isOver ? "crs build has ended" : "not connected", true);
    } else if (message.type === "document") {
      this.document = message;
      this.updateIndex();
      for (const name of this.selection) if (!this.index.has(name)) this.selection.delete(name);
    }
    this.emit("change");
    this.chooseAwaited();
  }

  /** @param {string} kind */
  emit(kind) {
    this.dispatchEvent(new Event(kind));
  }

  /** @param {string} text @param {boolean} isWrong */
  notify(text, isWrong = false) {
    this.note = text;
    this.isWrong = isWrong;
    this.emit("note");
  }

  /** The elements that are edited: those of the world, or of a definition. @returns {Item[]} */
  get items() {
    return this.inside?.items ?? this.document?.items ?? [];
  }

  /** @returns {Item | undefined} */
  item(name) {
    return this.index.get(name);
  }

  /** @returns {Shape[]} */
  shapes(name) {
    return (this.inside?.shapes ?? this.document?.shapes)?.[name] ?? [];
  }

  /** The unit in which lengths are shown, typed and drawn: the user's choice, or that of the file. */
  get unit() {
    return this.chosenUnit || this.document?.unit || "m";
  }

  /** Attributes of what is drawn, whose numbers are lengths [m], in the unit that was chosen. */
  written(attributes) {
    if (!this.chosenUnit) return attributes;
    const text = (value) => (typeof value === "number" ? lengthIn(value, this.unit) : value);
    return Object.fromEntries(Object.entries(attributes).map(([name, value]) => [name, text(value)]));
  }

  // -- definitions -------------------------------------------------------------------------------

  /** Find again the definition that is edited, as far as it is still there. */
  updateIndex() {
    const { parts, items, shapes } = this.document;
    this.inside = null;
    this.index = new Map(items.map((item) => [item.name, item]));
    for (const [depth, name] of this.path.entries()) {
      const item = this.index.get(name);
      const known = item?.pose && Object.hasOwn(parts, item.attributes.ref) && parts[item.attributes.ref];
      if (!item?.pose || !known) {
        this.path = this.path.slice(0, depth);
        break;
      }
      const root = `define[${item.attributes.ref}]`;
      const own = (this.inside?.shapes ?? shapes)?.[name] ?? [];
      const pose = this.inside ? compose(this.inside.pose, item.pose) : item.pose;
      this.inside = { root, pose, items: known, shapes: byPart(own, item.pose, known, root) };
      this.index = new Map(known.map((part) => [part.name, part]));
    }
  }

  /** Edit the definition of an object: all its copies follow. */
  enter(name) {
    const item = this.item(name);
    if (item?.tag !== "object") return;
    this.path = [...this.path, name];
    this.updateIndex();
    if (this.path.at(-1) !== name) this.notify(`${item.attributes.ref} is defined in an included file: edit that file`, true);
    this.select([]);
    this.emit("change");
  }

  /** Go back to the object or the world around the definition that is edited. */
  leave() {
    const name = this.path.at(-1);
    this.path = this.path.slice(0, -1);
    this.updateIndex();
    this.select(name ? [name] : []);
    this.emit("change");
  }

  // -- selection ---------------------------------------------------------------------------------

  select(names) {
    this.awaited = null;
    this.selection = new Set(names);
    this.emit("select");
  }

  /** Hide or lock elements, or undo that. @param {Set<string>} set */
  toggle(set, names = [...this.selection]) {
    const isOn = names.every((name) => set.has(name));
    for (const name of names) {
      if (isOn) set.delete(name);
      else set.add(name);
    }
    this.emit("change");
  }

  /** Whether the mouse may take an element. */
  isFree(name) {
    return !this.hidden.has(name) && !this.locked.has(name);
  }

  /** Select elements that are new: at once, or when they are known. */
  choose(names) {
    this.awaited = names;
    this.chooseAwaited();
  }

  /** Answers may arrive before documents of earlier changes, which do not know the new elements yet. */
  chooseAwaited() {
    if (this.awaited?.every((name) => this.item(name))) this.select(this.awaited);
  }

  // -- what is asked -----------------------------------------------------------------------------

  /** Send a request to the builder; show its error. @returns {Promise<any>} */
  async request(name, fields = {}) {
    try {
      const value = await this.channel.request(name, fields);
      if (!["properties", "form", "library", "scene"].includes(name)) this.notify("");
      return value;
    } catch (error) {
      this.notify(/** @type {Error} */ (error).message, true);
      return undefined;
    }
  }

  /** Do an operation with the selection, or with names. @returns {Promise<string[] | undefined>} */
  apply(operation, { names = [...this.selection], values = {}, attributes = {} } = {}) {
    return this.request("apply", { steps: [{ operation, names, values, attributes }] });
  }

  /** Add an element and select it. */
  async add(kind, attributes, into = this.inside?.root ?? "") {
    const names = await this.apply("add", { names: [], values: { kind, into }, attributes: this.written(attributes) });
    if (names) this.choose(names.filter((name) => !name.includes("/visit/")));
    return names;
  }

  /** Put a sonar on a robot, that looks away from its centre; its other numbers are those of the last one. */
  async mount([x, y]) {
    const sonars = this.items.filter((each) => each.tag === "sensor");
    const found = sonars.length ? await this.request("properties", { name: sonars.at(-1)?.name }) : null;
    const known = Object.fromEntries((found?.children ?? []).map((each) => [each.tag, each.text]));
    const all = await Promise.all(sonars.map((each) => this.request("properties", { name: each.name })));
    const taken = new Set(all.flatMap((each) => each.children.filter((child) => child.tag === "id").map((child) => Number(child.text))));
    let id = 0;
    while (taken.has(id)) id += 1;
    if (id >= MAX_SONARS) {
      this.notify(`a robot has at most ${MAX_SONARS} sonars`, true);
      return;
    }
    const name = sonars.length ? `sensor[${sonars.length}]` : "sensor";
    const length = (value) => lengthIn(value, this.unit);
    const leaf = (into, kind, text) => ({ operation: "add", values: { kind, into, text } });
    const place = (kind, text) => leaf(`${name}/position`, kind, text);
    await this.request("apply", {
      steps: [
        leaf("", "sensor", ""), leaf(name, "id", String(id)), leaf(name, "type", "sonar"), leaf(name, "position", ""),
        place("x-relative", length(x)), place("y-relative", length(y)), place("z-relative", known["z-relative"] ?? "20cm"),
        place("range", known.range ?? "3m"), place("radius", known.radius ?? "50cm"),
        place("dir-relative", `${+((Math.atan2(y, x) * 180) / Math.PI).toFixed(3)}deg`),
        ...this.inOrder(id),
      ],
    });
    this.choose([name]);
  }

  /** The step that lets a new sonar fire, if the robot has an order of its sonars. */
  inOrder(id) {
    const order = this.item("sonars")?.attributes.order;
    return order === undefined ? [] : [{ operation: "set", names: ["sonars"], attributes: { order: `${order} ${id}` } }];
  }

  async paste(clip, values) {
    while (this.inside) this.leave();
    const names = await this.request("paste", { values, ...(clip ? { clip } : {}) });
    if (names) this.choose(names);
  }
}
