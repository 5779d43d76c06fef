/** What the page knows of the world that is edited, and what it asks of the builder. */

import { SocketChannel } from "../channel.js";

/**
 * @typedef {{kind: string, points?: number[][], x?: number, y?: number, radius?: number,
 *   thickness?: number, heading?: number, colour?: string, from?: number, to?: number}} Shape
 * @typedef {{name: string, tag: string, attributes: Record<string, string>}} Thing
 * @typedef {{text: string, hint: string, line: number, name: string}} Problem
 */

export class Model extends EventTarget {
  constructor() {
    super();
    /** @type {any} */
    this.document = null;
    this.operations = [];
    this.selection = new Set();
    this.isConnected = false;
    this.mayChange = false;
    this.note = "";
    this.channel = new SocketChannel((message) => this.hear(message));
  }

  hear(message) {
    if (message.type === "hello") {
      this.isConnected = true;
      this.mayChange = message.role === "control";
      this.operations = message.operations;
    } else if (message.type === "lost") {
      this.isConnected = false;
      this.say(message.isOver ? "crs build has ended" : "not connected");
    } else if (message.type === "document") {
      this.document = message;
      const there = new Set(message.things.map((thing) => thing.name));
      for (const name of this.selection) if (!there.has(name)) this.selection.delete(name);
    }
    this.tell("change");
  }

  /** @param {string} kind */
  tell(kind) {
    this.dispatchEvent(new Event(kind));
  }

  say(text) {
    this.note = text;
    this.tell("note");
  }

  /** @returns {Thing | undefined} */
  thing(name) {
    return this.document?.things.find((each) => each.name === name);
  }

  /** @returns {Shape[]} */
  shapes(name) {
    return this.document?.shapes?.[name] ?? [];
  }

  select(names) {
    this.selection = new Set(names);
    this.tell("select");
  }

  /** Ask the builder; what goes wrong is said. @returns {Promise<any>} */
  async ask(name, fields = {}) {
    try {
      const value = await this.channel.ask(name, fields);
      if (name !== "properties") this.say("");
      return value;
    } catch (error) {
      this.say(/** @type {Error} */ (error).message);
      return undefined;
    }
  }

  /** Do an operation with the selection, or with names. @returns {Promise<string[] | undefined>} */
  apply(operation, { names = [...this.selection], values = {}, attributes = {} } = {}) {
    return this.ask("apply", { steps: [{ operation, names, values, attributes }] });
  }

  /** Add an element and select it. */
  async add(kind, attributes) {
    const names = await this.apply("add", { names: [], values: { kind }, attributes });
    if (names) this.choose(names);
    return names;
  }

  /** Select elements that are new: at once, or when they are known. */
  choose(names) {
    const known = names.every((name) => this.thing(name));
    if (known) this.select(names);
    else this.addEventListener("change", () => this.select(names), { once: true });
  }

  async paste(values) {
    const names = await this.ask("paste", { values });
    if (names) this.choose(names);
  }
}
