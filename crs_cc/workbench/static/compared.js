/**
 * The run that this one is compared with: where they first differ, its robots as ghosts, and files
 * that the user brings to compare with.
 *
 * @typedef {{t: number, robot: string, what: string, here: string, there: string, by: string, is_variable?: boolean}} Difference
 */
import { Frames, toBase64 } from "crs/frames.js";
import { oneAtATime } from "crs/one_at_a_time.js";
import { Scene } from "crs/scene.js";

const PIECE = 36000; // bytes of a file that are sent at once
const GROWN = 0.5; // of the known part, until runs are compared again [s]

/** Before the name of a run: the distance to where the robot is in that run. */
export const APART = "apart from ";

export class Compared {
  /** @param {any} model @param {any} look @param {any} page */
  constructor(model, look, page) {
    this.model = model;
    this.look = look;
    this.page = page;
    /** @type {any} the search for variables: its progress, result and error */
    this.exact = null;
    this.isSearching = false;
    this.refresh = oneAtATime(() => this.fetchComparison());
    model.on("hello", () => this.end());
    model.on("truncate", () => (this.exact = null));
    for (const kind of ["panel", "others", "truncate"]) model.on(kind, () => this.check());
    model.on("state", ({ playing, end }) => {
      const known = Math.min(end, this.run?.end ?? 0);
      if (this.run && !playing && known > this.run.until + GROWN) this.refresh();
    });
  }

  /** The run that is compared; nothing while none is. */
  get run() {
    return this.look.other;
  }

  /** The runs with which this one can be compared: their names, and what they are. @returns {{name: string, title: string, end: number, isFile: boolean}[]} */
  get choices() {
    const branches = (this.model.panel?.branches ?? []).filter(({ current }) => !current)
      .map(({ name, end }) => ({ name, title: "another run of this session", end, isFile: false }));
    return [...branches, ...this.model.others.map((each) => ({ ...each, isFile: true }))];
  }

  /** Compare with a run. @param {string} name */
  async with(name) {
    this.exact = null;
    const answer = await this.model.request("compare", { name });
    if (!answer) return;
    this.exact = answer.exact ?? null; // a page that holds both runs knows it
    this.take(answer);
    if (this.model.can("debug") && this.model.run.follows !== false) this.search();
  }

  async fetchComparison() {
    if (!this.run) return;
    const { name } = this.run;
    const answer = await this.model.request("compare", { name });
    if (answer && this.run?.name === name) this.take(answer);
  }

  take(answer) {
    const blocks = answer.blocks.map(([number, begin, end]) => [begin, end, number]);
    const before = this.run?.name === answer.name ? this.run : null;
    const frames = before?.frames ?? new Frames(blocks, answer.frame_s, (number) => this.model.channel.block(number));
    const scene = before?.scene ?? new Scene({ ...this.model.run, rosters: answer.rosters });
    this.look.other = { ...answer, frames, scene };
    this.notify();
  }

  notify() {
    const { first, run } = this;
    this.model.differs = first ? [[first.t, "differs", -1, `${first.robot} ${first.what}: ${first.here} here, ${first.there} in ${run.name}`, null, null]] : [];
    this.look.version++;
    this.model.emit("compared");
  }

  end() {
    this.look.other = this.exact = null;
    this.notify();
  }

  /** End comparing with a run that is no more, or is shown now. */
  check() {
    if (this.run && !this.choices.some(({ name }) => name === this.run.name)) this.end();
  }

  /** The first difference that is known, of variables or of what robots did. @returns {Difference | null} */
  get first() {
    const [exact] = this.exact?.found ?? [];
    const [known] = this.run?.differences ?? [];
    return (exact && known && known.t < exact.t - 1e-6 ? known : exact ?? known) ?? null;
  }

  /** The first variable of a program that is known to differ. @returns {Difference | null} */
  get firstVariable() {
    return this.exact?.found.find((each) => each.is_variable) ?? null;
  }

  /** Put the robots of the other run where they are at a time. @param {number} time */
  async place(time) {
    const { run } = this;
    if (!run || !run.frames.blocks.length) return;
    const frame = await run.frames.at(Math.min(time, run.end)).catch(() => null);
    if (frame) run.scene.place(frame);
  }

  /** Look for the first variable that differs, until it is found or the user does something else. */
  async search() {
    if (this.isSearching || !this.run) return;
    const { name } = this.run;
    this.isSearching = true;
    this.exact = { t: 0, until: 0, is_done: false, found: [], wrong: "" };
    let anew = true;
    while (this.isSearching && this.run?.name === name && this.exact && !this.exact.is_done) {
      this.notify();
      const before = this.exact;
      const answer = await this.model.channel.request("next_difference", { name, anew })
        .then((found) => ({ ...found, wrong: "" }), (error) => ({ ...before, is_done: true, wrong: error.message }));
      if (this.exact !== before) break; // the run has taken another course meanwhile
      this.exact = answer;
      anew = false;
    }
    this.isSearching = false;
    this.notify();
  }

  stop() {
    this.isSearching = false;
  }

  /** Compare with a file of the user. @param {File} file */
  async open(file) {
    const name = file.name.endsWith(".mcap") ? file.name : `${file.name}.mcap`;
    const bytes = new Uint8Array(await file.arrayBuffer());
    for (let offset = 0; offset < Math.max(1, bytes.length); offset += PIECE) {
      this.model.notify(`${file.name}: ${Math.round((100 * offset) / Math.max(1, bytes.length))}% sent`);
      const data = toBase64(bytes.subarray(offset, offset + PIECE));
      if (!(await this.model.request("upload_piece", { name, offset, data }))) return;
    }
    const opened = await this.model.request("open", { name });
    if (!opened) return;
    this.model.notify(`${name} is open`);
    this.page.compare(opened.name);
  }

  /** Close a recording. @param {string} name */
  close(name) {
    return this.model.request("close", { name });
  }
}
