/** Driving the selected robot by hand: arrow keys, W A S D, or a gamepad. */
import { el } from "crs/dom.js";
import { change } from "crs/change.js";

const KEYS = {
  ArrowUp: [1, 0], ArrowDown: [-1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1],
  w: [1, 0], s: [-1, 0], a: [0, 1], d: [0, -1],
};
const [SPEED, TURN] = [0.3, 45]; // [m/s], [deg/s]; with Shift twice as fast
const DEAD = 0.15; // of a stick
const EVERY = 100; // [ms] between two commands of a stick

export class Driving {
  /** @param {any} model @param {any} page */
  constructor(model, page) {
    this.model = model;
    this.page = page;
    this.isOn = false;
    this.note = el("p.driving", { role: "status" });
    this.note.hidden = true;
    this.pressed = new Set();
    this.sent = "";
    this.isAsking = false;
    addEventListener("keydown", (event) => this.key(event, true), true);
    addEventListener("keyup", (event) => this.key(event, false), true);
    addEventListener("blur", () => this.release());
    model.on("look", () => this.isOn && this.robot !== model.state.robot && this.end());
    model.on("tick", () => this.isOn && this.stick());
  }

  toggle() {
    if (this.isOn) this.end();
    else this.begin();
  }

  async begin() {
    const { model } = this;
    this.robot = model.state.robot;
    this.name = model.selected.id;
    this.isOn = true;
    this.sent = "0 0";
    this.note.hidden = false;
    this.note.textContent = `Driving ${this.name}: arrows or W A S D, Shift for twice the speed, Esc ends. Its program still sends commands; suspend it with Sleep to control the robot alone.`;
    /** @type {HTMLElement | null} */ (document.activeElement)?.blur();
    model.emit("driving");
    if (!model.state.playing) model.request("play");
  }

  end() {
    this.release();
    this.isOn = false;
    this.note.hidden = true;
    this.model.emit("driving");
  }

  release() {
    if (!this.pressed.size) return;
    this.pressed.clear();
    this.steer();
  }

  key(event, isDown) {
    if (!this.isOn || event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input[type=text], textarea, select")) return;
    if (event.key === "Escape" && isDown) this.end();
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (name !== "Shift" && !KEYS[name]) return;
    if (name !== "Shift") {
      event.preventDefault();
      event.stopImmediatePropagation();
      if (isDown) this.pressed.add(name);
      else this.pressed.delete(name);
    }
    if (!event.repeat) this.steer(event.shiftKey ? 2 : 1);
  }

  steer(factor = 1) {
    let [ahead, left] = [0, 0];
    for (const name of this.pressed) {
      ahead += KEYS[name][0];
      left += KEYS[name][1];
    }
    this.setSpeed(factor * SPEED * Math.sign(ahead), factor * TURN * Math.sign(left));
  }

  stick() {
    const pad = navigator.getGamepads?.().find((each) => each?.connected);
    const now = performance.now();
    if (!pad || now - (this.askedAt ?? 0) < EVERY) return;
    const live = (value) => (Math.abs(value) < DEAD ? 0 : Math.round(value * 20) / 20);
    const [left, ahead] = [live(-pad.axes[0]), live(-pad.axes[1])];
    if (!left && !ahead && !this.wasStick) return;
    this.wasStick = Boolean(left || ahead);
    this.askedAt = now;
    this.setSpeed(2 * SPEED * ahead, 2 * TURN * left);
  }

  /** Tell the robot; while the last command is on its way, only the newest one waits. */
  async setSpeed(speed, turn) {
    this.wanted = `${+speed.toFixed(3)} ${+turn.toFixed(1)}`;
    if (this.isAsking) return;
    this.isAsking = true;
    while (this.wanted !== this.sent) {
      this.sent = this.wanted;
      const wrong = await change(this.model, `drive ${this.name} ${this.sent}`);
      if (wrong) {
        this.model.notify(wrong, true);
        this.end();
      }
    }
    this.isAsking = false;
  }
}
