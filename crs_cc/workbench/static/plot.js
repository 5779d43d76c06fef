/** A plot over time on a canvas: a strip with an axis of its own for each unit. */
import { gridStep } from "crs/units.js";
import { drawSeries, limitsOf } from "crs/series.js";

export const LINES = ["#2f7fe0", "#e8590c", "#2b8a3e", "#9c5fe0", "#d6406f", "#0c8599", "#a07800", "#7d828c"];
const LEFT = 62;
const RIGHT = 8;
const FOOT = 18;
const LEAST = 58; // the height of a strip
const GAP = 7; // between two

/** @typedef {{label: string, lines: {series: {times: number[], values: number[]}, colour: string}[]}} Strip */

/** The height that strips need [pixels]. @param {number} count */
export const leastHeight = (count) => count * LEAST + FOOT;

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{strips: Strip[], begin: number, end: number, now: number, colours: Record<string, string>}} what
 */
export function drawPlot(canvas, { strips, begin, end, now, colours }) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const x = (time) => LEFT + ((time - begin) / (end - begin)) * (width - LEFT - RIGHT);
  const box = { pen, colours, begin, end, x, right: width - RIGHT };
  const each = (height - FOOT) / Math.max(1, strips.length);
  timeAxis(box, height);
  strips.forEach((strip, at) => drawStrip(box, strip, at * each + 4, (at + 1) * each - GAP + 4));
  pen.strokeStyle = colours.accent;
  pen.lineWidth = 1;
  if (now >= begin && now <= end) line(pen, x(now), 0, x(now), height - FOOT + 4);
  return { time: (px) => begin + ((px - LEFT) / (width - LEFT - RIGHT)) * (end - begin) };
}

function timeAxis({ pen, colours, begin, end, x, right }, height) {
  pen.font = "11px system-ui, sans-serif";
  pen.lineWidth = 1;
  pen.strokeStyle = colours.grid;
  pen.fillStyle = colours.muted;
  pen.textAlign = "center";
  const every = gridStep(((end - begin) * 90) / Math.max(100, right - LEFT));
  for (let time = Math.ceil(begin / every) * every; time <= end; time += every) {
    line(pen, x(time), 4, x(time), height - FOOT);
    if (x(time) < right - 12) pen.fillText(`${+time.toPrecision(6)} s`, x(time), height - 4);
  }
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
  for (const { series, colour } of lines) {
    pen.strokeStyle = colour;
    drawSeries(pen, series, x, y);
  }
  pen.restore();
  pen.fillStyle = colours.text;
  pen.font = "600 11px system-ui, sans-serif";
  pen.fillText(label, LEFT - 6, top + 9, LEFT - 8);
  pen.font = "11px system-ui, sans-serif";
}

function line(pen, x0, y0, x1, y1) {
  pen.beginPath();
  pen.moveTo(Math.round(x0) + 0.5, Math.round(y0) + 0.5);
  pen.lineTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
  pen.stroke();
}
