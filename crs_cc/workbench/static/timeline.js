/** The timeline: play, pause, step, speed; the way to any instant; marks for what happened. */
import { button, clockText, el, fill } from "crs/dom.js";
import { gridStep } from "crs/units.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 0];
const MARK = 3.9; // the height of a row of marks [pixels]
const ASK = 80; // [ms] between two questions while the user drags

/** Kinds of marks: name, colour, and which events they are. */
export const MARKS = [
  { name: "error", title: "Errors", colour: "danger", is: (kind) => kind === "failed" || kind === "error" },
  { name: "collision", title: "Collisions", colour: "#e8590c", is: (kind) => kind === "collision" },
  { name: "near", title: "Close approaches", colour: "#b08900", is: (kind) => kind === "near" },
  { name: "message", title: "Messages", colour: "#8250df", is: (kind) => kind.startsWith("message") },
  { name: "print", title: "Prints", colour: "#1a7f37", is: (kind) => kind === "print" },
  { name: "note", title: "Notes", colour: "accent", is: (kind) => kind === "note" },
  { name: "found", title: "Found", colour: "#c2255c", is: (kind) => kind === "found" },
  { name: "change", title: "Changes", colour: "#0c8599", is: (kind) => kind === "change" },
  { name: "differs", title: "Differences", colour: "#d6336c", is: (kind) => kind === "differs" },
  { name: "other", title: "Other events", colour: "muted", is: () => true },
];

/** @param {string} kind */
export const markOf = (kind) => MARKS.find((mark) => mark.is(kind)) ?? MARKS[MARKS.length - 1];

export class Timeline {
  /** @param {HTMLElement} root @param {any} model @param {any} look @param {any} page */
  constructor(root, model, look, page) {
    this.model = model;
    this.page = page;
    this.look = look;
    this.kind = "any";
    this.askedAt = 0;
    /** @type {number[] | null} the part that is shown; all of it for none */
    this.range = null;
    /** How many of the last seconds are shown; 0 for all. */
    this.last = 0;
    this.clock = el("output", { "aria-label": "simulated time" });
    this.clockButton = el("button.clock", { type: "button", title: "Simulated time: click to enter a time to go to (.)", onclick: () => this.enter() }, this.clock);
    this.wanted = el("input.clock", { type: "text", hidden: true, "aria-label": "time to go to, in seconds, or a step: -10", onkeydown: (event) => this.take(event), onblur: () => this.leave() });
    this.rate = el("span.rate", { title: "Measured ratio of simulated time to real time" });
    this.playButton = button({ icon: "play", title: "Play or pause", key: "Space", className: "primary", onclick: () => this.toggle() });
    this.speed = el("select", { title: "Speed, relative to real time", "aria-label": "speed", onchange: () => this.setSpeed(Number(this.speed.value)) },
      ...SPEEDS.map((each) => el("option", { value: String(each) }, each ? `${each} ×` : "max")));
    this.jumps = el("select", { title: "Events to which the arrows jump", "aria-label": "kind of event", onchange: () => (this.kind = this.jumps.value) },
      el("option", { value: "any" }, "any event"), ...MARKS.map((each) => el("option", { value: each.name }, each.title.toLowerCase())));
    this.loopButton = button({ icon: "loop", title: "Repeat the last five seconds, or stop repeating; Shift-drag on the timeline to repeat any span", key: "L", onclick: () => this.loop() });
    this.live = button({ text: "Back to now", title: "Go to the latest time of the run", key: "End", className: "chip", onclick: () => this.release() });
    this.whole = button({ text: "Whole run", title: "Show the whole timeline; the wheel zooms in", className: "chip", onclick: () => this.showPart(null) });
    this.canvas = el("canvas");
    this.track = el("div.track", { tabIndex: 0, role: "slider", "aria-label": "timeline", "aria-valuemin": 0 }, this.canvas);
    fill(root,
      el("div.transport", {},
        this.clockButton, this.wanted,
        el("div.group", {},
          button({ icon: "first", title: "Go to the start", key: "Home", onclick: () => this.seek(0) }),
          button({ text: "−10 s", title: "Back ten seconds", key: "Shift+↓", onclick: () => this.back(10) }),
          button({ icon: "previous", title: "One timestep back", key: "←", onclick: () => this.step(-1) }),
          this.playButton,
          button({ icon: "next", title: "One timestep forward", key: "→", onclick: () => this.step(1) })),
        this.speed, this.rate, this.loopButton, this.live, this.whole,
        el("span.spacer"),
        el("div.group.jump", {},
          button({ text: "‹", title: "Previous event", key: "P", onclick: () => this.jump(-1) }),
          this.jumps,
          button({ text: "›", title: "Next event", key: "N", onclick: () => this.jump(1) }))),
      this.track);
    this.listen();
    for (const kind of ["state", "hello", "truncate", "event", "output", "look", "near", "panel", "found", "compared"]) model.on(kind, () => (this.isStale = true));
    this.isStale = true;
  }

  listen() {
    const at = (event) => {
      const box = this.track.getBoundingClientRect();
      return this.timeAt(event.clientX - box.left, box.width);
    };
    this.track.addEventListener("wheel", (event) => {
      event.preventDefault();
      if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.pan(event.deltaX / this.track.clientWidth);
      else this.zoom(at(event), event.deltaY > 0 ? 1.25 : 0.8);
    }, { passive: false });
    this.track.addEventListener("pointerdown", (event) => {
      this.track.setPointerCapture(event.pointerId);
      this.spanFrom = event.shiftKey && this.model.can("seek") ? at(event) : null;
      if (this.spanFrom !== null) return;
      this.drag(at(event), false);
    });
    this.track.addEventListener("pointermove", (event) => {
      if (event.buttons && this.spanFrom !== null) this.markSpan(at(event), false);
      else if (event.buttons) this.drag(at(event), false);
      this.hover(event);
    });
    this.track.addEventListener("pointerup", (event) => (this.spanFrom !== null ? this.markSpan(at(event), true) : this.drag(at(event), true)));
  }

  /** Let the user type a time to go to: 12.5, or -10 for ten seconds earlier. */
  enter() {
    this.clockButton.hidden = true;
    this.wanted.hidden = false;
    this.wanted.value = this.clock.textContent.replace(" s", "");
    this.wanted.select();
    this.wanted.focus();
  }

  take(event) {
    event.stopPropagation();
    if (event.key === "Escape") this.leave();
    if (event.key !== "Enter") return;
    const text = this.wanted.value.trim();
    const number = Number(text.replace(/ ?s$/, ""));
    if (!text || !Number.isFinite(number)) return this.model.notify(`'${text}' is not a time: enter seconds, or -10 for ten seconds earlier`, true);
    this.leave();
    this.seek(/^[-+]/.test(text) ? (this.model.clock.held ?? this.model.state.t) + number : number);
  }

  leave() {
    this.wanted.hidden = true;
    this.clockButton.hidden = false;
  }

  /** Mark the span between where the pointer was pressed and here; repeat it at the end. */
  markSpan(time, isEnd) {
    const [begin, end] = [Math.min(time, this.spanFrom), Math.max(time, this.spanFrom)];
    this.marked = isEnd ? null : [begin, end];
    this.isStale = true;
    if (!isEnd) return;
    this.spanFrom = null;
    this.setSpan(begin, end);
  }

  /** Repeat a span, from its begin on. */
  setSpan(begin, end) {
    if (end - begin < 0.1) return this.model.notify("a span to repeat is at least 0.1 s long", true);
    this.model.request("span", { begin_s: begin, end_s: end });
    this.seek(begin);
  }

  /** Let the span that is repeated begin or end here. @param {number} which 0 or 1 */
  bound(which) {
    const { span, t, end } = this.model.state;
    const now = this.model.clock.held ?? t;
    const found = span ? [...span] : [0, Math.max(end, now + 1)];
    found[which] = now;
    if (found[1] - found[0] < 0.1) return this.model.notify("a span to repeat is at least 0.1 s long", true);
    this.model.request("span", { begin_s: found[0], end_s: found[1] });
  }

  /** The right end of the line: a little more than what is known, while it grows. */
  get end() {
    const { run, state } = this.model;
    const known = Math.max(state.end, state.t, 1e-9);
    return run?.kind === "recorded" ? known : Math.max(10, known * (state.playing ? 1.08 : 1.0));
  }

  /** The part that is shown: from when to when. @returns {number[]} */
  get shownPart() {
    if (this.range) return this.range;
    const t = Math.max(this.model.state.t, this.last);
    return this.last ? [t - this.last, t] : [0, this.end];
  }

  /** The time at a place of the line. @param {number} x @param {number} width [pixels] */
  timeAt(x, width) {
    const [begin, end] = this.shownPart;
    return begin + Math.min(1, Math.max(0, x / width)) * (end - begin);
  }

  /** Show a part, or all for none. @param {number[] | null} range @param {number} last */
  showPart(range, last = 0) {
    [this.range, this.last] = [range, last];
    this.isStale = true;
    this.model.emit("part");
  }

  /** Come nearer at a time, or go away from it. @param {number} time @param {number} factor */
  zoom(time, factor) {
    const [begin, end] = this.shownPart;
    const next = [Math.max(0, time - (time - begin) * factor), Math.min(this.end, time + (end - time) * factor)];
    if (next[0] <= 0 && next[1] >= this.end) this.showPart(null);
    else if (next[1] - next[0] > 0.05) this.showPart(next);
  }

  /** Move the part that is shown. @param {number} share of its length */
  pan(share) {
    const [begin, end] = this.shownPart;
    if (!this.range && !this.last) return;
    const by = Math.max(-begin, Math.min(this.end - end, share * (end - begin)));
    this.showPart([begin + by, end + by]);
  }

  /** Have a time in the part that is shown. @param {number} time */
  follow(time) {
    if (!this.range || (time >= this.range[0] - 1e-9 && time <= this.range[1] + 1e-9)) return;
    const length = this.range[1] - this.range[0];
    const begin = Math.max(0, time > this.range[1] ? time - 0.1 * length : time - 0.5 * length);
    this.showPart([begin, begin + length]);
  }

  hover(event) {
    const box = this.track.getBoundingClientRect();
    const [begin, end] = this.shownPart;
    const width = box.width / (end - begin);
    const x = event.clientX - box.left;
    const near = this.model.happenings.filter((each) => Math.abs((each[0] - begin) * width - x) < 4).slice(0, 6);
    this.track.title = near.map((each) => `${each[0].toFixed(3)} s  ${each[3]}`).join("\n");
  }

  /** Look at an instant while the line is dragged; stay there at its end. */
  drag(time, isEnd) {
    const { model } = this;
    const bounded = Math.min(time, model.state.end);
    model.clock.held = bounded;
    if (!model.can("seek")) {
      this.isStale = true;
      return;
    }
    const now = performance.now();
    if (!isEnd && now - this.askedAt < ASK) return;
    this.askedAt = now;
    if (model.state.playing || model.state.busy) model.request("pause");
    model.request("seek", { time_s: bounded }).then(() => {
      if (isEnd) model.clock.held = null;
    });
  }

  seek(time) {
    const { model } = this;
    const bounded = Math.max(0, time);
    if (!model.can("seek")) model.clock.held = Math.min(bounded, model.state.end);
    else {
      model.clock.held = null;
      if (model.state.busy) model.request("pause"); // what runs to another time is in vain
      model.request("seek", { time_s: bounded });
    }
    this.isStale = true;
  }

  /** Go back by so many seconds. @param {number} seconds */
  back(seconds) {
    this.seek((this.model.clock.held ?? this.model.state.t) - seconds);
  }

  release() {
    this.model.clock.held = null;
    this.isStale = true;
  }

  toggle() {
    const { model } = this;
    if (model.state.busy || model.state.playing) model.request("pause");
    else if (!model.can("play") && model.clock.held !== null) this.release();
    else model.request("play");
  }

  step(count) {
    if (this.model.can("seek")) this.model.request("step", { timesteps: count });
    else this.seek(this.model.clock.shown + count * this.model.run.frame_s);
  }

  setSpeed(speed) {
    this.model.request("speed", { speed });
  }

  faster(way) {
    const now = SPEEDS.indexOf(this.model.state.speed ?? 0);
    const next = SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, now + way))];
    if (next !== undefined) this.setSpeed(next);
  }

  loop() {
    const { span, t } = this.model.state;
    const begin = Math.max(0, t - 5);
    this.model.request("span", span ? { begin_s: 0, end_s: 0 } : { begin_s: begin, end_s: Math.max(t, begin + 1) });
  }

  /** The times of what is marked, with its kind. */
  marks() {
    return this.model.happenings.map((each) => [each[0], each[1]]).concat(this.model.run.output.map((each) => [each[0], "print"]));
  }

  /** Choose what the arrows jump to. @param {string} kind */
  jumpTo(kind) {
    this.kind = this.jumps.value = kind;
  }

  /** Go to the next event, or the one before. @param {number} way 1 or -1 */
  jump(way) {
    if (this.kind === "found" && this.model.found.rows.length && this.model.can("debug")) return this.page.found.step(way);
    const now = this.model.clock.held ?? this.model.state.t;
    const least = this.model.run.timestep_s ? 1e-6 + this.model.run.timestep_s * (way > 0 ? 1 : 0) : 1e-6;
    const all = this.marks()
      .filter(([, kind]) => (this.kind === "any" ? kind !== "near" : markOf(kind).name === this.kind))
      .map(([at]) => at);
    const times = all.filter((at) => (at - now) * way > least);
    if (!all.length) this.model.notify("no such event in the run so far");
    else if (!times.length) this.model.notify(way > 0 ? "no later event is known" : "no earlier event");
    else this.seek(way > 0 ? Math.min(...times) : Math.max(...times));
  }

  /** Show the time and, if something has changed, everything else. @param {number} time */
  show(time) {
    const { model } = this;
    if (time !== this.shown) this.follow(time);
    const { clientWidth, clientHeight } = this.track; // read before anything is written: no layout is needed for it
    this.clock.textContent = clockText(time);
    const isMoved = Math.abs(time - (this.shown ?? -1)) > 1e-6;
    this.shown = time;
    if (!isMoved && !this.isStale && clientWidth === this.width) return;
    const { state } = model;
    if (this.isStale) {
      const isOn = state.playing || state.busy;
      if (this.isOn !== isOn) {
        this.isOn = isOn;
        const made = button({ icon: isOn ? "pause" : "play", title: "", onclick: () => undefined });
        fill(this.playButton, ...made.childNodes);
        this.playButton.setAttribute("aria-label", isOn ? "Pause" : "Play");
      }
      this.speed.value = String(state.speed ?? 0);
      this.rate.textContent = state.playing && state.rate ? `${state.rate.toFixed(state.rate < 10 ? 2 : 0)} × real` : "";
      this.loopButton.setAttribute("aria-pressed", String(Boolean(state.span)));
      this.whole.hidden = !this.range && !this.last;
      this.live.hidden = model.clock.held === null || model.can("seek");
      const mayPlay = model.can("play") || model.clock.held !== null;
      this.playButton.disabled = this.speed.disabled = !mayPlay;
      this.isStale = false;
    }
    this.width = clientWidth;
    this.draw(time, clientWidth, clientHeight);
  }

  draw(time, width, height) {
    const ratio = window.devicePixelRatio || 1;
    if (this.canvas.width !== Math.round(width * ratio)) this.canvas.width = Math.round(width * ratio);
    if (this.canvas.height !== Math.round(height * ratio)) this.canvas.height = Math.round(height * ratio);
    const pen = this.canvas.getContext("2d");
    const { colours } = this.look;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    const [begin, end] = this.shownPart;
    const k = width / (end - begin);
    const x = (at) => Math.min(width, Math.max(0, (at - begin) * k));
    const [state, line] = [this.model.state, height - 22];
    pen.fillStyle = colours.track;
    pen.fillRect(0, line, width, 6);
    pen.fillStyle = colours.known;
    pen.fillRect(0, line, x(state.end), 6);
    pen.fillStyle = colours.accent;
    pen.fillRect(0, line, x(time), 6);
    const span = this.marked ?? state.span;
    if (span) {
      pen.globalAlpha = 0.25;
      pen.fillRect(x(span[0]), 0, x(span[1]) - x(span[0]), height - 12);
      pen.globalAlpha = 1;
    }
    this.drawMarks(pen, begin, end, k, line);
    pen.fillStyle = colours.muted;
    pen.font = "10px system-ui, sans-serif";
    pen.textAlign = "center";
    const step = gridStep(90 / k);
    for (let at = Math.floor(begin / step + 1) * step; x(at) < width - 12; at += step) {
      pen.fillRect(Math.round(x(at)), line + 6, 1, 3);
      if (x(at) > 12) pen.fillText(`${+at.toPrecision(6)} s`, x(at), height - 1);
    }
    pen.fillStyle = colours.accent;
    pen.beginPath();
    pen.arc(Math.min(width - 7, Math.max(7, x(time))), line + 3, 7, 0, 2 * Math.PI);
    pen.fill();
    this.track.setAttribute("aria-valuemax", this.end.toFixed(2));
    this.track.setAttribute("aria-valuenow", time.toFixed(3));
  }

  drawMarks(pen, begin, end, k, line) {
    const taken = new Set();
    const rank = new Map(MARKS.map((each, row) => [each, row]));
    for (const [at, kind] of this.marks()) {
      const mark = markOf(kind);
      if (at < begin || at > end) continue;
      const [x, row] = [Math.round((at - begin) * k), rank.get(mark)];
      const key = x * MARKS.length + row;
      if (taken.has(key)) continue; // thousands of them may share a pixel
      taken.add(key);
      pen.fillStyle = this.look.colours[mark.colour] ?? mark.colour;
      pen.fillRect(x - 1, line - 5 - (MARKS.length - 1 - row) * MARK, 2.5, MARK - 1);
    }
  }
}
