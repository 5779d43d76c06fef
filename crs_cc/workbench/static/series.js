/** Values over time, by name: what sparklines and plots draw. */

const MAX = 4000; // points of a series

/**
 * The samples of a quantity. Values of programs stay until they change (`isStep`); each may have its
 * text, and its place in the run, to which one can go.
 * @typedef {{times: number[], values: number[], texts: (string | undefined)[], places: (string | undefined)[], isStep: boolean}} Samples
 */

export class Series {
  constructor() {
    /** @type {Map<string, Samples>} */
    this.byName = new Map();
  }

  /** @param {string} name @returns {Samples} */
  of(name) {
    let found = this.byName.get(name);
    if (!found) this.byName.set(name, (found = { times: [], values: [], texts: [], places: [], isStep: false }));
    return found;
  }

  /** Note a value; one of the same time is replaced. @param {string} name @param {number} time @param {any} value @param {string} [text] */
  add(name, time, value, text) {
    const { times, values, texts, places } = this.of(name);
    let at = times.length;
    while (at > 0 && times[at - 1] > time + 1e-9) at--;
    const number = typeof value === "number" ? value : NaN;
    const isKnown = at > 0 && Math.abs(times[at - 1] - time) < 1e-9;
    if (isKnown && places[at - 1]) return; // what is known exactly is not sampled again
    const from = isKnown ? at - 1 : at;
    times.splice(from, isKnown ? 1 : 0, time);
    values.splice(from, isKnown ? 1 : 0, number);
    texts.splice(from, isKnown ? 1 : 0, text);
    places.splice(from, isKnown ? 1 : 0, undefined);
    this.thin(name);
  }

  /** Put samples in place of those that are known of the same span. @param {string} name @param {number[]} added @param {any[]} numbers */
  merge(name, added, numbers) {
    if (!added.length) return;
    this.replace(name, added[0], added[added.length - 1], added.map((time, at) => [time, numbers[at]]));
  }

  /** Put samples (time, number, text, place) in place of those from one time to another. @param {string} name @param {number} begin @param {number} end @param {any[][]} rows */
  replace(name, begin, end, rows) {
    const { times, values, texts, places } = this.of(name);
    const first = times.findIndex((time) => time >= begin - 1e-9);
    const from = first < 0 ? times.length : first;
    const after = times.findIndex((time) => time > end + 1e-9);
    const count = Math.max(0, (after < 0 ? times.length : after) - from);
    times.splice(from, count, ...rows.map(([time]) => time));
    values.splice(from, count, ...rows.map(([, number]) => number ?? NaN));
    texts.splice(from, count, ...rows.map(([, , text]) => text));
    places.splice(from, count, ...rows.map(([, , , place]) => place));
    this.thin(name);
  }

  /** Of the older half, keep the least and the greatest of each four, if there are too many. */
  thin(name) {
    const { times, values, texts, places } = this.of(name);
    if (times.length <= MAX) return;
    const kept = [];
    for (let at = 0; at < MAX / 2; at += 4) kept.push(...outermost(values, at, at + 4));
    /** @type {any[][]} */
    const columns = [times, values, texts, places];
    for (const each of columns) each.splice(0, MAX / 2, ...kept.map((at) => each[at]));
  }

  /** Discard what was after a time. @param {number} time */
  truncate(time) {
    for (const { times, values, texts, places } of this.byName.values()) {
      while (times.length && times[times.length - 1] > time + 1e-9) for (const each of [times, values, texts, places]) each.pop();
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

/** The place of the last sample at or before a time; -1 for none. @param {number[]} times @param {number} time */
export function indexAt(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time + 1e-9) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** The least and greatest value in a span of time, with the one that a step has at its begin; nothing if there is none. */
export function limitsOf({ times, values, isStep }, begin, end) {
  let [least, most] = [Infinity, -Infinity];
  const from = isStep ? times[indexAt(times, begin)] ?? begin : begin;
  times.forEach((time, at) => {
    const value = values[at];
    if (time < from || time > end || Number.isNaN(value)) return;
    if (value < least) least = value;
    if (value > most) most = value;
  });
  return least <= most ? [least, most] : null;
}

/**
 * Draw a series as a line or as steps; gaps where there is no value.
 * @param {CanvasRenderingContext2D} pen
 * @param {{times: number[], values: number[], isStep?: boolean}} series
 * @param {(time: number) => number} x @param {(value: number) => number} y
 * @param {number} [until] how far the last step goes [s]
 */
export function drawSeries(pen, { times, values, isStep }, x, y, until) {
  pen.beginPath();
  let isOn = false;
  if (times.length === 1) pen.arc(x(times[0]), y(values[0]), 1.5, 0, 7);
  times.forEach((time, at) => {
    if (isOn && isStep) pen.lineTo(x(time), y(values[at - 1]));
    if (Number.isNaN(values[at])) {
      isOn = false;
      return;
    }
    if (isOn) pen.lineTo(x(time), y(values[at]));
    else pen.moveTo(x(time), y(values[at]));
    isOn = true;
  });
  if (isOn && isStep && until !== undefined) pen.lineTo(x(Math.max(until, times[times.length - 1])), y(values[values.length - 1]));
  pen.stroke();
}
