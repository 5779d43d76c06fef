/**
 * The displayed time: smooth between the times that the run sends, and free of the run while the user
 * drags the timeline.
 */
import { isStill } from "crs/theme.js";

const DELAY = 0.1; // of real time behind the run, so that there is a frame to move towards [s]
const FOLLOW = 6; // how fast a difference goes [1/s]
const JUMP = 0.7; // of real time: more is a jump [s]

export class Clock {
  constructor() {
    this.shown = 0;
    this.target = 0;
    this.rate = 0;
    this.isPlaying = false;
    /** @type {number | null} the time that the user looks at, while it is not that of the run */
    this.held = null;
    this.updatedAt = 0;
  }

  /** @param {any} state @param {boolean} isLocal whether it is received with every picture */
  update(state, isLocal) {
    const now = performance.now() / 1000;
    const elapsed = now - this.updatedAt;
    if (this.isPlaying && state.playing && elapsed > 0.005 && state.t > this.target) {
      const rate = (state.t - this.target) / elapsed;
      this.rate += (rate - this.rate) * Math.min(1, elapsed * 4);
    } else if (!this.isPlaying && state.playing) {
      this.rate = state.speed ?? 1;
    }
    const isBack = state.t < this.target - 1e-9;
    [this.target, this.updatedAt, this.isPlaying] = [state.t, now, state.playing];
    if (isLocal || isBack) this.shown = state.t;
  }

  /** Advance by real time. @param {number} elapsed [s] @returns {number} the time to show */
  advance(elapsed) {
    if (this.held !== null) {
      this.shown = this.held;
      return this.shown;
    }
    if (!this.isPlaying) {
      const gap = this.target - this.shown;
      const isFar = isStill() || Math.abs(gap) > Math.max(0.3, this.rate * JUMP);
      this.shown = isFar || Math.abs(gap) < 1e-4 ? this.target : this.shown + gap * Math.min(1, elapsed * 15);
      return this.shown;
    }
    const late = performance.now() / 1000 - this.updatedAt;
    const aim = this.target + (Math.min(late, 0.5) - DELAY) * this.rate;
    this.shown += elapsed * this.rate;
    const gap = aim - this.shown;
    if (Math.abs(gap) > JUMP * Math.max(this.rate, 0.05)) this.shown = aim;
    else this.shown += gap * Math.min(1, elapsed * FOLLOW);
    this.shown = Math.max(0, Math.min(this.shown, this.target + 0.05 * this.rate));
    return this.shown;
  }
}
