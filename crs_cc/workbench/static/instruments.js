/**
 * What the instruments of a robot show, now and since the page looks. Panels say what they want
 * (`want`), listen to `instruments`, and read `series`.
 */
import { oneAtATime } from "crs/one_at_a_time.js";
import { Series } from "crs/series.js";

const SPAN = 20; // how far back sparklines go [s]
const SAMPLES = 120;

export class Instruments {
  /** @param {any} model */
  constructor(model) {
    this.model = model;
    this.series = new Series();
    /** @type {Map<string, () => {isShown: boolean, expressions: string[]}>} */
    this.wishes = new Map();
    /** @type {any} the last answer, of the selected robot */
    this.now = null;
    this.ask = oneAtATime(() => this.inspect());
    model.on("status", () => this.ask());
    model.on("look", () => this.ask());
    model.on("forget", ({ time_s }) => this.series.forget(time_s));
    model.on("hello", () => {
      this.series.clear();
      this.now = null;
    });
  }

  /** Say what a panel wants to know while it is shown. */
  want(name, wish) {
    this.wishes.set(name, wish);
  }

  /** Names are those of the robot and the expression. */
  name(expression, robot = this.model.state.robot) {
    return `${robot} ${expression}`;
  }

  async inspect() {
    const wishes = [...this.wishes.values()].map((wish) => wish()).filter((wish) => wish.isShown);
    if (!wishes.length || !this.model.run?.can.includes("debug") || !this.model.isConnected) return;
    const expressions = [...new Set(["speed", "battery", ...wishes.flatMap((wish) => wish.expressions)])];
    const { robot } = this.model.state;
    try {
      this.note(await this.model.channel.ask("inspect", { robot, expressions: expressions.join("\n") }), expressions);
    } catch {
      this.now = null; // the robot is no more, or the programs of a recording stand elsewhere
      this.model.tell("instruments", null);
    }
  }

  note(answer, expressions) {
    const { t, robot, sensors, values } = answer;
    for (const [device, { elements }] of Object.entries(sensors)) {
      for (const [element, , value] of elements) this.series.add(this.name(`${device}.${element}`, robot), t, value);
    }
    expressions.forEach((expression, at) => this.series.add(this.name(expression, robot), t, values[at]));
    this.now = { ...answer, byName: new Map(expressions.map((each, at) => [each, values[at]])) };
    this.model.tell("instruments", this.now);
  }

  /** Fill in a span of the past: the run goes there and back. */
  async fill(expressions, begin, end, count = SAMPLES) {
    const { robot } = this.model.state;
    const answer = await this.model.ask("past", { robot, expressions: expressions.join("\n"), begin_s: Math.max(0, begin), end_s: Math.max(0, begin, end), count });
    for (const [time, ...values] of answer?.rows ?? []) {
      expressions.forEach((each, at) => this.series.add(this.name(each, robot), time, values[at]));
    }
    this.model.tell("instruments", this.now);
  }

  /** The span that sparklines show. */
  get span() {
    const { t } = this.model.state;
    return [Math.max(0, t - SPAN), Math.max(t, 1)];
  }
}
