/** Values over time on a canvas: a strip with an axis of its own for each unit, and one for what is no number. */
import { gridStep } from "crs/units.js";
import { drawSeries, indexAt, limitsOf } from "crs/series.js";

export const LINES = ["#2f7fe0", "#e8590c", "#2b8a3e", "#9c5fe0", "#d6406f", "#0c8599", "#a07800", "#7d828c"];
export const LEFT = 62;
export const RIGHT = 8;
const HEIGHT = 52; // of a strip
const FLAT = 28; // of one with words
const GAP = 7; // between two

/**
 * `label`: the unit, or the only expression; `words`: whether its values are no numbers.
 * @typedef {{label: string, words: boolean, lines: {series: import("./series.js").Samples, colour: string, until: number}[]}} Strip
 */

/** The height that strips need [pixels]. @param {Strip[]} strips */
export const heightOf = (strips) => strips.reduce((sum, each) => sum + (each.words ? FLAT : HEIGHT), 0);

/** Whether values are words: enumerators, texts, pointers. @param {import("./series.js").Samples} series */
export const areWords = ({ texts, values }) => texts.some((text, at) => text !== undefined && (/^[A-Za-z_"({[]|^0x/.test(text) || Number.isNaN(values[at])) && !/^(nan|-?inf|unreadable|<)/.test(text));

/**
 * Draw strips; return where each ends [pixels].
 * @param {HTMLCanvasElement} canvas
 * @param {{strips: Strip[], begin: number, end: number, now: number, pointed: number | null, colours: Record<string, string>}} what
 * @returns {number[]}
 */
export function drawPlot(canvas, { strips, begin, end, now, pointed, colours }) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const x = (time) => LEFT + ((time - begin) / (end - begin)) * (width - LEFT - RIGHT);
  const box = { pen, colours, begin, end, x, right: width - RIGHT };
  pen.font = "11px system-ui, sans-serif";
  pen.lineWidth = 1;
  pen.strokeStyle = colours.grid;
  const every = gridStep(((end - begin) * 90) / Math.max(100, width - LEFT - RIGHT));
  for (let time = Math.ceil(begin / every) * every; time <= end; time += every) line(pen, x(time), 0, x(time), height);
  const spare = Math.max(0, height - heightOf(strips)) / Math.max(1, strips.filter((each) => !each.words).length);
  let top = 0;
  const ends = [];
  for (const strip of strips) {
    const low = top + (strip.words ? FLAT : HEIGHT + spare);
    if (strip.words) drawWords(box, strip, top + 4, low - GAP + 4);
    else drawStrip(box, strip, top + 4, low - GAP + 4);
    ends.push((top = low));
  }
  pen.lineWidth = 1;
  for (const [time, colour] of /** @type {[number | null, string][]} */ ([[pointed, colours.muted], [now, colours.accent]])) {
    pen.strokeStyle = colour;
    if (time !== null && time >= begin && time <= end) line(pen, x(time), 0, x(time), height);
  }
  return ends;
}

/** Draw values that are no numbers: a box for each, with its text as far as it fits. */
function drawWords({ pen, colours, begin, end, x, right }, { label, lines }, top, low) {
  for (const { series, colour, until } of lines) {
    const { times, texts } = series;
    const last = Math.min(end, Math.max(until, times[times.length - 1] ?? 0));
    let count = 0;
    for (let at = Math.max(0, indexAt(times, begin)); at < times.length && times[at] <= end; at++) {
      let next = at + 1;
      while (next < times.length && texts[next] === texts[at]) next++; // a span that was read apart begins with the same
      const [from, to] = [Math.max(LEFT, x(times[at])), Math.min(right, x(Math.min(last, times[next] ?? last)))];
      at = next - 1;
      if (to <= from) continue;
      pen.fillStyle = pen.strokeStyle = colour;
      pen.globalAlpha = count++ % 2 ? 0.12 : 0.26;
      pen.fillRect(from, top + 3, to - from, low - top - 3);
      pen.globalAlpha = 0.8;
      pen.fillRect(from, top + 3, 1, low - top - 3);
      pen.globalAlpha = 1;
      pen.fillStyle = colours.text;
      pen.textAlign = "left";
      const text = fitting(pen, texts[at] ?? "", to - from - 8);
      if (text) pen.fillText(text, from + 4, (top + low) / 2 + 5.5);
    }
  }
  named(pen, colours, label, top + 6);
}

/** As much of a text as fits. */
function fitting(pen, text, width) {
  if (width < 12 || pen.measureText(text).width <= width) return width < 12 ? "" : text;
  let length = text.length;
  while (length > 1 && pen.measureText(`${text.slice(0, length)}…`).width > width) length--;
  return length > 1 ? `${text.slice(0, length)}…` : "";
}

function named(pen, colours, label, top) {
  pen.fillStyle = colours.text;
  pen.textAlign = "right";
  pen.font = "600 11px system-ui, sans-serif";
  pen.fillText(fitting(pen, label, LEFT - 8), LEFT - 6, top + 9);
  pen.font = "11px system-ui, sans-serif";
}

function drawStrip({ pen, colours, begin, end, x, right }, { label, lines }, top, low) {
  const found = lines.map(({ series }) => limitsOf(series, begin, end)).filter((each) => each !== null);
  let [least, most] = found.length ? [Math.min(...found.map((each) => each[0])), Math.max(...found.map((each) => each[1]))] : [0, 1];
  const room = (most - least) * 0.06 || Math.abs(most) * 0.1 || 1;
  [least, most] = [least - room, most + room];
  const y = (value) => low - ((value - least) / (most - least)) * (low - top);
  pen.strokeStyle = colours.grid;
  pen.fillStyle = colours.muted;
  pen.lineWidth = 1;
  pen.textAlign = "right";
  const step = gridStep((most - least) / Math.max(2, (low - top) / 26));
  for (let value = Math.ceil(least / step) * step; value <= most; value += step) {
    line(pen, LEFT, y(value), right, y(value));
    if (y(value) > top + 14) pen.fillText(String(+value.toPrecision(6)), LEFT - 6, y(value) + 4);
  }
  pen.strokeStyle = colours.muted;
  line(pen, LEFT, top, LEFT, low);
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, top - 1, right - LEFT, low - top + 2);
  pen.clip();
  pen.lineWidth = 1.6;
  for (const { series, colour, until } of lines) {
    pen.strokeStyle = colour;
    drawSeries(pen, series, x, y, until);
  }
  pen.restore();
  named(pen, colours, label, top);
}

function line(pen, x0, y0, x1, y1) {
  pen.beginPath();
  pen.moveTo(Math.round(x0) + 0.5, Math.round(y0) + 0.5);
  pen.lineTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
  pen.stroke();
}
