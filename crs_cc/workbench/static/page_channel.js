/** The channel of a page that holds a recorded run: it plays by itself. */
import { fromBase64 } from "crs/frames.js";

export class PageChannel {
  /** @param {any} run the contents of the page @param {(message: any) => void} onMessage */
  constructor(run, onMessage) {
    this.run = run;
    this.onMessage = onMessage;
    this.isLocal = true;
    this.time = 0;
    this.speed = 1;
    this.isPlaying = false;
    this.span = null;
    this.robot = 0;
    const hello = { ...run, type: "hello", kind: "recorded", role: "control", can: ["play", "seek"] };
    queueMicrotask(() => {
      this.onMessage(hello);
      this.publishState();
      if (run.other) this.onMessage({ type: "others", runs: [run.other] });
    });
  }

  /** @param {string} name @param {any} fields */
  async request(name, fields = {}) {
    if (name === "compare" && this.run.other) {
      const { other } = this.run;
      return { ...other, blocks: other.blocks.map(([begin, end], number) => [number, begin, end]) };
    }
    if (name === "play") {
      if (this.time >= this.run.end_s) this.time = 0;
      this.isPlaying = true;
    } else if (name === "pause") this.isPlaying = false;
    else if (name === "seek") this.time = fields.time_s;
    else if (name === "speed") this.speed = fields.speed || Infinity;
    else if (name === "select") this.robot = fields.robot;
    else if (name === "span") this.span = fields.end_s > fields.begin_s ? [fields.begin_s, fields.end_s] : null;
    else if (name === "step") {
      this.isPlaying = false;
      this.time += fields.timesteps * this.run.frame_s;
    } else throw new Error("this page contains a recording: it can only be played and viewed");
    this.time = Math.min(this.run.end_s, Math.max(0, this.time));
    this.publishState();
  }

  /** A block of frames of the run that this one is compared with. @param {number} number */
  async block(number) {
    return fromBase64(this.run.other.blocks[number][2]);
  }

  /** Advance by real time. @param {number} elapsed [s] */
  advance(elapsed) {
    if (!this.isPlaying) return;
    this.time = Math.min(this.run.end_s, this.time + elapsed * Math.min(this.speed, 1000));
    if (this.span && this.time >= this.span[1]) this.time = this.span[0];
    if (this.time >= this.run.end_s) this.isPlaying = false;
    this.publishState();
  }

  publishState() {
    const isOver = this.time >= this.run.end_s;
    this.onMessage({
      type: "state",
      t: this.time,
      end: this.run.end_s,
      playing: this.isPlaying,
      busy: false,
      waits: "",
      speed: Number.isFinite(this.speed) ? this.speed : null,
      rate: this.isPlaying ? this.speed : 0,
      span: this.span,
      robot: this.robot,
      halt: { reason: isOver ? "end" : "paused", text: isOver ? "end of the recording" : "", robot: -1 },
    });
  }
}
