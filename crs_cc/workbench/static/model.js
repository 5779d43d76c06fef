/**
 * What the page knows of the run. Panels listen for what they show: `on("state", show)`.
 *
 * Kinds: `hello` (all is new), `state` (time, playing, selected robot), `status` (the table of
 * robots), `position` (line, stack, variables), `event`, `output`, `truncate`, `link` (connected or not),
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
    this.position = null;
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
  }

  /** @param {string} kind @param {(message: any) => void} listener */
  on(kind, listener) {
    if (!this.listeners.has(kind)) this.listeners.set(kind, new Set());
    this.listeners.get(kind)?.add(listener);
  }

  /** @param {string} kind @param {any} message */
  emit(kind, message = null) {
    for (const listener of this.listeners.get(kind) ?? []) listener(message);
  }

  /** Whether this page may do something: `play`, `seek`, `change`, `debug`. */
  can(what) {
    return Boolean(this.run?.can.includes(what)) && this.run.role === "control";
  }

  /** Execute a command on the server; show an error. @returns {Promise<any>} null after an error */
  async request(name, fields = {}) {
    try {
      return (await this.channel.request(name, fields)) ?? {};
    } catch (error) {
      this.notify(error.message, true);
      return null;
    }
  }

  /** Show a line of text. */
  notify(text, isError = false) {
    this.emit("notice", { text, isError });
  }

  /** Take a message of the channel. */
  handle(message) {
    const take = this[`handle_${message.type}`];
    if (take) take.call(this, message);
  }

  handle_hello(message) {
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
    this.emit("link");
    this.emit("hello", message);
  }

  handle_state(message) {
    const before = this.state;
    this.state = message;
    this.clock.update(message, this.channel.isLocal);
    if (before.playing && !message.playing) this.frames?.clearTail();
    this.emit("state", message);
    if (before.robot !== message.robot) this.emit("look");
  }

  handle_status(message) {
    this.status = message;
    this.scene?.hold(message.devices?.holds);
    if (this.scene) this.scene.heats = message.devices?.heats ?? {};
    this.emit("status", message);
  }

  /** What has been changed, what is degraded, which links are blocked. */
  handle_panel(message) {
    this.panel = message;
    this.emit("panel", message);
  }

  /** Recordings to compare with have been opened or closed. */
  handle_others({ runs }) {
    this.others = runs;
    this.emit("others");
  }

  /** Robots have been added to the world. */
  handle_world(message) {
    this.run.world = message.world;
    this.emit("hello", this.run);
  }

  handle_position(message) {
    this.position = message;
    this.emit("position", message);
  }

  handle_frame({ time, data }) {
    this.frames?.add(time, data);
    this.state.end = Math.max(this.state.end, time);
    if (this.state.busy) this.clock.update({ t: time, playing: true, speed: null }, false);
  }

  handle_block({ block }) {
    this.frames?.addBlock(block);
    this.emit("block");
  }

  handle_roster({ roster }) {
    this.run.rosters.push(roster);
    this.emit("roster", roster);
  }

  handle_event({ event }) {
    this.run.events.push(event);
    this.emit("event", event);
  }

  handle_output({ output }) {
    this.run.output.push(output);
    this.emit("output", output);
  }

  handle_truncate(message) {
    const until = message.time_s + 1e-9;
    this.run.events = this.run.events.filter((event) => event[0] <= until);
    this.run.output = this.run.output.filter((piece) => piece[0] <= until);
    this.run.rosters = this.run.rosters.filter((roster) => roster.t <= until);
    this.frames?.truncate(message.time_s, message.blocks);
    this.emit("truncate", message);
  }

  /** The run continues in another branch, whose whole state is sent. */
  handle_replace({ events, output, rosters, blocks, end_s }) {
    Object.assign(this.run, { events, output, rosters });
    const { last } = this.frames; // the next frame is sent as the difference from it
    this.frames = new Frames(blocks.map(([number, begin, end]) => [begin, end, number]), this.run.frame_s, (number) => this.channel.block(number));
    this.frames.last = last;
    this.state.end = end_s;
    this.emit("truncate", { time_s: -1 });
    this.emit("roster", rosters.at(-1));
  }

  handle_lost(message) {
    this.isConnected = false;
    this.lost = message;
    this.emit("link");
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
    this.emit("look");
    if (this.run.role === "control") this.request("select", { robot });
  }
}
