/** The time line: where the run is, play and pause, speed, and marks for events. */

const MARKS = { collision: "#d1242f", failed: "#a0001c", exited: "#2b303a", degradation: "#b26a00" };

export class Timeline {
  /**
   * @param {number} end [s]
   * @param {any[][]} events
   * @param {{slider: HTMLInputElement, marks: HTMLCanvasElement, play: HTMLButtonElement,
   *   speed: HTMLSelectElement, clock: HTMLElement}} parts
   */
  constructor(end, events, parts) {
    this.end = end;
    this.events = events;
    this.parts = parts;
    this.time = 0;
    this.isPlaying = false;
    parts.slider.max = String(end);
    parts.slider.addEventListener("input", () => this.seek(Number(parts.slider.value)));
    parts.play.addEventListener("click", () => this.toggle());
    this.drawMarks();
    this.show();
  }

  get speed() {
    return Number(this.parts.speed.value);
  }

  toggle() {
    if (!this.isPlaying && this.time >= this.end) this.time = 0;
    this.isPlaying = !this.isPlaying;
    this.show();
  }

  seek(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.show();
  }

  /** Advance by real time. @param {number} elapsed [s] */
  advance(elapsed) {
    if (!this.isPlaying) return;
    this.seek(this.time + elapsed * this.speed);
    if (this.time >= this.end) this.toggle();
  }

  /** Go to the next event, or the one before. @param {number} way 1 or -1 */
  jump(way) {
    const times = this.events.map((event) => event[0]).filter((at) => (at - this.time) * way > 1e-6);
    if (times.length) this.seek(way > 0 ? Math.min(...times) : Math.max(...times));
  }

  show() {
    this.parts.slider.value = String(this.time);
    this.parts.play.textContent = this.isPlaying ? "Pause" : "Play";
    this.parts.clock.textContent = `${this.time.toFixed(2)} / ${this.end.toFixed(2)} s`;
  }

  drawMarks() {
    const canvas = this.parts.marks;
    const pen = canvas.getContext("2d");
    [canvas.width, canvas.height] = [canvas.clientWidth, canvas.clientHeight];
    for (const [at, kind] of this.events) {
      pen.fillStyle = MARKS[kind] ?? "#7b8494";
      pen.fillRect((at / Math.max(this.end, 1e-9)) * (canvas.width - 2), 0, 2, canvas.height);
    }
  }
}
