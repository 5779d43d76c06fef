/**
 * What the page knows of the run. Panels listen for what they show: `on("state", show)`.
 *
 * Kinds: `hello` (all is new), `state` (time, playing, selected robot), `status` (the table of
 * robots), `where` (line, stack, variables), `event`, `output`, `forget`, `link` (connected or not),
 * `panel` (changes, faults, links), `found` (instants that were asked for), `others` (recordings to
 * compare with), `compared` (the run has been compared with another one), `part` (the part of the time
 * line that is shown), `look` (what the user looks at has changed: selection, overlays, theme).
 */
import { Approaches } from "crs/approaches.js";
import { Clock } from "crs/clock.js";
import { Frames, fromBase64 } from "crs/frames.js";

const QUIET = { reason: "paused", text: "", robot: -1 };

export class Model {
  constructor() {
    /** @type {Map<string, Set<(message: any) => void>>} */
    this.listeners = new Map();
    this.clock = new Clock();
    /** @type {any} */
    this.channel = null;
    this.run = null;
    this.state = { t: 0, end: 0, playing: false, busy: false, waits: "", speed: 1, rate: 0, span: null, robot: 0, halt: QUIET };
    this.status = { t: 0, first: 0, robots: [], sensors: { believed: [], echoes: [], bumpers: [] } };
    /** @type {any} */
    this.where = null;
    /** @type {any} */
    this.panel = null;
    /** @type {{title: string, rows: any[][]}} instants that a question has found */
    this.found = { title: "", rows: [] };
    /** @type {any[][]} where the run that it is compared with first differs, like events */
    this.differs = [];
    /** @type {{name: string, title: string, end: number}[]} recordings to compare with */
    this.others = [];
    this.isConnected = false;
    /** @type {import("./scene.js").Scene | null} */
    this.scene = null;
    this.approaches = new Approaches(this);
    /** Errors and what commands have answered, for the line below the view. */
    this.said = "";
  }

  /** @param {string} kind @param {(message: any) => void} listener */
  on(kind, listener) {
    if (!this.listeners.has(kind)) this.listeners.set(kind, new Set());
    this.listeners.get(kind)?.add(listener);
  }

  /** @param {string} kind @param {any} message */
  tell(kind, message = null) {
    for (const listener of this.listeners.get(kind) ?? []) listener(message);
  }

  /** Whether this page may do something: `play`, `seek`, `change`, `debug`. */
  can(what) {
    return Boolean(this.run?.can.includes(what)) && this.run.role === "control";
  }

  /** Have a command carried out; an error is shown. @returns {Promise<any>} null after an error */
  async ask(name, fields = {}) {
    try {
      return (await this.channel.ask(name, fields)) ?? {};
    } catch (error) {
      this.say(error.message, true);
      return null;
    }
  }

  /** Show a line of text. */
  say(text, isError = false) {
    this.tell("say", { text, isError });
  }

  /** Take a message of the channel. */
  hear(message) {
    const take = this[`hear_${message.type}`];
    if (take) take.call(this, message);
  }

  hear_hello(message) {
    if (message.isOtherVersion) {
      location.reload();
      return;
    }
    this.run = message;
    this.isConnected = true;
    const blocks = this.channel.isLocal
      ? message.blocks.map(([begin, end, text]) => [begin, end, fromBase64(text)])
      : message.blocks.map(([number, begin, end]) => [begin, end, number]);
    this.frames = new Frames(blocks, message.frame_s, (number) => this.channel.block(number));
    this.state = { ...this.state, end: message.end_s };
    this.tell("link");
    this.tell("hello", message);
  }

  hear_state(message) {
    const before = this.state;
    this.state = message;
    this.clock.hear(message, this.channel.isLocal);
    if (before.playing && !message.playing) this.frames?.settle();
    this.tell("state", message);
    if (before.robot !== message.robot) this.tell("look");
  }

  hear_status(message) {
    this.status = message;
    this.scene?.hold(message.devices?.holds);
    if (this.scene) this.scene.heats = message.devices?.heats ?? {};
    this.tell("status", message);
  }

  /** What has been changed, what is degraded, which links are blocked. */
  hear_panel(message) {
    this.panel = message;
    this.tell("panel", message);
  }

  /** Recordings to compare with have been opened or closed. */
  hear_others({ runs }) {
    this.others = runs;
    this.tell("others");
  }

  /** Robots have been added to the world. */
  hear_world(message) {
    this.run.world = message.world;
    this.tell("hello", this.run);
  }

  hear_where(message) {
    this.where = message;
    this.tell("where", message);
  }

  hear_frame({ time, data }) {
    this.frames?.add(time, data);
    this.state.end = Math.max(this.state.end, time);
    if (this.state.busy) this.clock.hear({ t: time, playing: true, speed: null }, false);
  }

  hear_block({ block }) {
    this.frames?.addBlock(block);
    this.tell("block");
  }

  hear_roster({ roster }) {
    this.run.rosters.push(roster);
    this.tell("roster", roster);
  }

  hear_event({ event }) {
    this.run.events.push(event);
    this.tell("event", event);
  }

  hear_output({ output }) {
    this.run.output.push(output);
    this.tell("output", output);
  }

  hear_forget(message) {
    const until = message.time_s + 1e-9;
    this.run.events = this.run.events.filter((event) => event[0] <= until);
    this.run.output = this.run.output.filter((piece) => piece[0] <= until);
    this.run.rosters = this.run.rosters.filter((roster) => roster.t <= until);
    this.frames?.forget(message.time_s, message.blocks);
    this.tell("forget", message);
  }

  /** The run continues in another branch, whose whole state is sent. */
  hear_course({ events, output, rosters, blocks, end_s }) {
    Object.assign(this.run, { events, output, rosters });
    const { last } = this.frames; // the next frame is sent as the difference from it
    this.frames = new Frames(blocks.map(([number, begin, end]) => [begin, end, number]), this.run.frame_s, (number) => this.channel.block(number));
    this.frames.last = last;
    this.state.end = end_s;
    this.tell("forget", { time_s: -1 });
    this.tell("roster", rosters.at(-1));
  }

  hear_lost(message) {
    this.isConnected = false;
    this.lost = message;
    this.tell("link");
  }

  /** All that has happened: events, close approaches, what was changed by hand, what was found (with its place); like events. @returns {any[][]} */
  get happenings() {
    const changes = (this.panel?.changes ?? []).map(({ t, text }) => [t, "change", -1, text, null, null]);
    const known = this.run?.events ?? [];
    const recorded = new Set(known.filter(([, kind]) => kind === "note").map(([t, , , text]) => `${t} ${text}`));
    const notes = (this.panel?.notes ?? []).filter(({ t, text }) => !recorded.has(`${t} ${text}`))
      .map(({ t, robot, text }) => [t, "note", robot, text, null, null]);
    const found = this.found.rows.map(([t, , text, place, robot]) => [t, "found", robot, text, null, null, null, place]);
    return [...known, ...this.approaches.events, ...changes, ...notes, ...found, ...this.differs];
  }

  /** The number and name of the selected robot. */
  get selected() {
    const roster = this.run?.rosters.at(-1)?.robots ?? [];
    return { number: this.state.robot, id: roster[this.state.robot] ?? "" };
  }

  select(robot) {
    this.state.robot = robot;
    this.tell("look");
    if (this.run.role === "control") this.ask("select", { robot });
  }
}
