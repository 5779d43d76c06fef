/** Values over time, by name: what sparklines and plots draw. */

const MOST = 4000; // points of a series

export class Series {
  constructor() {
    /** @type {Map<string, {times: number[], values: number[]}>} */
    this.byName = new Map();
  }

  /** @param {string} name */
  of(name) {
    let found = this.byName.get(name);
    if (!found) this.byName.set(name, (found = { times: [], values: [] }));
    return found;
  }

  /** Note a value; one of the same time is replaced. @param {string} name @param {number} time @param {any} value */
  add(name, time, value) {
    const { times, values } = this.of(name);
    let at = times.length;
    while (at > 0 && times[at - 1] > time + 1e-9) at--;
    const number = typeof value === "number" ? value : NaN;
    if (at > 0 && Math.abs(times[at - 1] - time) < 1e-9) values[at - 1] = number;
    else {
      times.splice(at, 0, time);
      values.splice(at, 0, number);
    }
    this.thin(name);
  }

  /** Put samples in place of those that are known of the same span. @param {string} name @param {number[]} added @param {any[]} numbers */
  merge(name, added, numbers) {
    if (!added.length) return;
    const { times, values } = this.of(name);
    const first = times.findIndex((time) => time >= added[0] - 1e-9);
    const from = first < 0 ? times.length : first;
    const after = times.findIndex((time) => time > added[added.length - 1] + 1e-9);
    const count = (after < 0 ? times.length : after) - from;
    times.splice(from, count, ...added);
    values.splice(from, count, ...numbers.map((each) => each ?? NaN));
    this.thin(name);
  }

  /** Of the older half, keep the least and the greatest of each four, if there are too many. */
  thin(name) {
    const { times, values } = this.of(name);
    if (times.length <= MOST) return;
    const kept = [];
    for (let at = 0; at < MOST / 2; at += 4) kept.push(...outermost(values, at, at + 4));
    for (const each of [times, values]) each.splice(0, MOST / 2, ...kept.map((at) => each[at]));
  }

  /** Discard what was after a time. @param {number} time */
  forget(time) {
    for (const { times, values } of this.byName.values()) {
      while (times.length && times[times.length - 1] > time + 1e-9) {
        times.pop();
        values.pop();
      }
    }
  }

  clear() {
    this.byName.clear();
  }
}

/** The places of the least and the greatest of some values, in their order. @returns {number[]} */
function outermost(values, from, to) {
  let [least, most] = [from, from];
  for (let at = from + 1; at < to; at++) {
    if (values[at] < values[least] || Number.isNaN(values[least])) least = at;
    if (values[at] > values[most] || Number.isNaN(values[most])) most = at;
  }
  return least === most ? [from, to - 1] : [Math.min(least, most), Math.max(least, most)];
}

/** The least and greatest value in a span of time; nothing if there is none. */
export function limitsOf({ times, values }, begin, end) {
  let [least, most] = [Infinity, -Infinity];
  times.forEach((time, at) => {
    const value = values[at];
    if (time < begin || time > end || Number.isNaN(value)) return;
    if (value < least) least = value;
    if (value > most) most = value;
  });
  return least <= most ? [least, most] : null;
}

/**
 * Draw a series as a line; gaps where there is no value.
 * @param {CanvasRenderingContext2D} pen
 * @param {{times: number[], values: number[]}} series
 * @param {(time: number) => number} x @param {(value: number) => number} y
 */
export function drawSeries(pen, { times, values }, x, y) {
  pen.beginPath();
  let isOn = false;
  if (times.length === 1) pen.arc(x(times[0]), y(values[0]), 1.5, 0, 7);
  times.forEach((time, at) => {
    if (Number.isNaN(values[at])) {
      isOn = false;
      return;
    }
    if (isOn) pen.lineTo(x(time), y(values[at]));
    else pen.moveTo(x(time), y(values[at]));
    isOn = true;
  });
  pen.stroke();
}
