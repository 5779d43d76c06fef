/**
 * What the instruments of a robot show, now and since the run began. Panels say what they want
 * (`want`), listen to `instruments`, and read `series`.
 *
 * The server keeps the history of what robots did and measured (`history`). Of what programs computed
 * the debugger finds each change, running that part of the past again (`fill`).
 *
 * @typedef {{isShown: boolean, expressions: string[], since?: number}} Wish
 *   since: from which time on; by default from the start
 */
import { oneAtATime } from "crs/one_at_a_time.js";
import { Series } from "crs/series.js";

const SPAN = 20; // how far back sparklines go [s]
const PIECES = 10; // in which a history is read
const MAX = 1000; // samples of a history that are asked for at once
const GIVEN_UP = /^interrupted|the run goes on|the run is busy/; // and not wrong for ever
const NO_VALUE = ["no echo", "not finite"]; // of expressions that may have one at other times

export class Instruments {
  /** @param {any} model */
  constructor(model) {
    this.model = model;
    this.series = new Series();
    /** @type {Map<string, () => Wish>} */
    this.wishes = new Map();
    /** @type {Map<string, string>} the units of expressions */
    this.units = new Map();
    /** @type {Map<string, number>} until when the history of a series is known */
    this.known = new Map();
    /** @type {Set<string>} series of which the server keeps no history */
    this.untraced = new Set();
    /** @type {Map<string, [number, number]>} the spans of those that have been filled in */
    this.filled = new Map();
    /** @type {Map<string, string>} why the history of a series is not known */
    this.wrong = new Map();
    this.isFilling = false;
    /** @type {any} the last answer, of the selected robot */
    this.now = null;
    this.refresh = oneAtATime(() => this.inspect());
    model.on("status", () => this.refresh());
    model.on("look", () => this.refresh());
    model.on("truncate", ({ time_s }) => this.truncate(time_s));
    model.on("hello", () => {
      this.series.clear();
      for (const each of [this.known, this.untraced, this.filled, this.wrong]) each.clear();
      this.now = null;
    });
  }

  truncate(time) {
    this.series.truncate(time);
    this.wrong.clear();
    for (const [name, until] of this.known) this.known.set(name, Math.min(until, time));
    for (const [name, [begin, end]] of this.filled) this.filled.set(name, [Math.min(begin, time), Math.min(end, time)]);
  }

  /** Set the requests of a panel while it is shown. @param {string} name @param {() => Wish} wish */
  want(name, wish) {
    this.wishes.set(name, wish);
  }

  /** Names are those of the robot and the expression. */
  name(expression, robot = this.model.state.robot) {
    return `${robot} ${expression}`;
  }

  /** What is wanted by panels that are shown. @returns {Wish[]} */
  shownWishes() {
    return [...this.wishes.values()].map((wish) => wish()).filter((wish) => wish.isShown);
  }

  async inspect() {
    const wishes = this.shownWishes();
    if (!wishes.length || !this.model.run?.can.includes("change") || !this.model.isConnected) return;
    const { robot } = this.model.state;
    const wanted = wishes.flatMap((wish) => wish.expressions).filter((each) => !isAtLine(each));
    const expressions = [...new Set(["speed", "battery", ...wanted])].slice(0, 40);
    try {
      this.note(await this.model.channel.request("inspect", { robot, expressions: expressions.join("\n") }), expressions);
    } catch {
      this.now = null; // the robot has left, or the programs of a recording are at another time
    }
    try {
      for (const wish of this.shownWishes()) await this.catchUp(robot, wish); // it may want what the answer has named
    } catch {
      this.now = null;
    }
    this.model.emit("instruments", this.now);
  }

  note(answer, expressions) {
    const { t, robot, sensors, values, texts, units } = answer;
    for (const [device, { elements }] of Object.entries(sensors)) {
      for (const [element, , value] of elements) this.series.add(this.name(`${device}.${element}`, robot), t, value);
    }
    expressions.forEach((expression, at) => {
      const isStep = texts[at] !== null;
      if (isStep) this.series.of(this.name(expression, robot)).isStep = true;
      this.series.add(this.name(expression, robot), t, values[at], texts[at] ?? undefined);
      this.units.set(expression, units[at] || (isStep ? unitIn(texts[at]) : ""));
    });
    this.now = { ...answer, byName: new Map(expressions.map((each, at) => [each, texts[at] ?? values[at]])) };
  }

  /** Ask for the history of what a panel shows, as far as it is not known. @param {number} robot @param {Wish} wish */
  async catchUp(robot, { expressions, since = 0 }) {
    const until = (each) => Math.max(since, this.known.get(this.name(each, robot)) ?? 0);
    const { end } = this.model.state;
    const wanted = expressions.filter((each) => !this.untraced.has(this.name(each, robot)) && until(each) < end - 1e-9);
    if (!wanted.length) return;
    const begin = Math.min(...wanted.map(until));
    const answer = await this.model.channel.request("history", { robot, expressions: wanted.join("\n"), begin_s: begin, end_s: end, count: MAX });
    answer.series.forEach((samples, at) => {
      const name = this.name(wanted[at], robot);
      if (!samples) this.untraced.add(name);
      else {
        this.series.merge(name, samples[0], samples[1]);
        this.known.set(name, end);
      }
    });
  }

  /** What is wrong with an expression; empty if it can be plotted. */
  async check(expression) {
    const { robot, t } = this.model.state;
    try {
      if (isAtLine(expression)) {
        await this.model.channel.request("changes", { robot, expression, begin_s: t, end_s: t });
        return "";
      }
      const { values, texts } = await this.model.channel.request("inspect", { robot, expressions: expression });
      const [value] = values;
      return typeof value === "string" && texts[0] === null && !NO_VALUE.includes(value) ? value : "";
    } catch (error) {
      if (isAtLine(expression)) return error.message;
      return ""; // it is not known while the programs are at another time
    }
  }

  /** The part of a span in which an expression of the program has not been read; null for none. */
  missing(expression, begin, end) {
    const name = this.name(expression);
    if (isAtLine(expression)) this.untraced.add(name);
    if (!this.untraced.has(name) || this.wrong.has(name)) return null;
    const [from, to] = this.filled.get(name) ?? [end, end];
    if (end > to + 0.1) return [Math.max(begin, to), end];
    return begin < from - 0.1 ? [begin, from] : null;
  }

  /**
   * Read what is missing of expressions in a span: the run goes there and back, a piece at a time,
   * the latest first, while it is stopped.
   * @param {string[]} expressions @param {number} begin @param {number} end
   * @param {number} patience after which it stops [ms]
   */
  async fill(expressions, begin, end, patience = Infinity) {
    const { model } = this;
    const { robot } = model.state;
    if (this.isFilling) return;
    this.isFilling = true;
    const until = performance.now() + patience;
    const isFree = () => !model.state.playing && model.state.robot === robot && performance.now() < until;
    for (let parts = this.parts(expressions, begin, end); parts && isFree(); parts = this.parts(expressions, begin, end)) {
      let goesOn = true;
      for (const each of parts[0]) if (goesOn && isFree()) goesOn = await this.read(each, robot, parts[1], parts[2]);
      if (!goesOn) break;
      model.emit("instruments", this.now);
    }
    this.isFilling = false;
    model.emit("instruments", this.now);
  }

  /**
   * Read the history of an expression between two times.
   * @param {string} expression @param {number} robot @param {number} from @param {number} to
   * @returns {Promise<boolean>} whether more can be read
   */
  async read(expression, robot, from, to) {
    const name = this.name(expression, robot);
    try {
      const { rows, is_at } = await this.model.channel.request("changes", { robot, expression, begin_s: from, end_s: to });
      const series = this.series.of(name);
      series.isStep = !is_at;
      this.series.replace(name, from, to, rows);
      if (rows.length && !this.units.get(expression)) this.units.set(expression, unitIn(rows[0][2]));
      const [first, last] = this.filled.get(name) ?? [to, to];
      this.filled.set(name, [Math.min(first, from), Math.max(last, to)]);
    } catch (error) {
      if (!this.model.isConnected || GIVEN_UP.test(error.message)) return false;
      this.wrong.set(name, error.message);
    }
    return true;
  }

  /** The next piece to be read: expressions, and from when to when. */
  parts(expressions, begin, end) {
    const found = expressions.map((each) => [each, this.missing(each, begin, end)]).filter(([, part]) => part);
    if (!found.length) return null;
    const [from, to] = found[0][1];
    const wanted = found.filter(([, part]) => part[0] === from && part[1] === to).map(([each]) => each);
    return [wanted, Math.max(from, to - Math.max(2, (end - begin) / PIECES)), to];
  }

  /** The span that sparklines show. */
  get span() {
    const { t } = this.model.state;
    return [Math.max(0, t - SPAN), Math.max(t, 1)];
  }
}

/** Quantities of the robot itself, which hide variables of the same name. */
export const OWN = ["speed", "turn", "battery", "clearance", "pose.x", "pose.y", "pose.heading", "sonar.0", "sonar.1"];

/** Whether an expression is that of a line: `error at go.c:12`. @param {string} expression */
export const isAtLine = (expression) => / at \S+$/.test(expression);

/** The unit in a value's text: `115 in = 2.921 m`. @param {string} text */
const unitIn = (text) => /^-?[\d.]+ ([a-zA-Z°]+)/.exec(text)?.[1] ?? "";
