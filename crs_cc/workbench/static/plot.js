/** A plot of series over time on a canvas: axes, lines, the instant that is shown. */
import { gridStep } from "crs/units.js";
import { drawSeries, limitsOf } from "crs/series.js";

export const LINES = ["#0b66b8", "#e8590c", "#2b8a3e", "#8250df", "#c2255c", "#0c8599", "#a07800", "#5c5f66"];
const LEFT = 56;
const FOOT = 18;

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{series: {times: number[], values: number[]}[], begin: number, end: number, now: number,
 *   colours: Record<string, string>}} what
 */
export function drawPlot(canvas, { series, begin, end, now, colours }) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const found = series.map((each) => limitsOf(each, begin, end)).filter((each) => each !== null);
  let [least, most] = found.length ? [Math.min(...found.map((each) => each[0])), Math.max(...found.map((each) => each[1]))] : [0, 1];
  const room = (most - least) * 0.06 || Math.abs(most) * 0.1 || 1;
  [least, most] = [least - room, most + room];
  const x = (time) => LEFT + ((time - begin) / (end - begin)) * (width - LEFT - 8);
  const y = (value) => height - FOOT - ((value - least) / (most - least)) * (height - FOOT - 6);
  pen.font = "11px system-ui, sans-serif";
  pen.lineWidth = 1;
  pen.strokeStyle = colours.grid;
  pen.fillStyle = colours.muted;
  pen.textAlign = "right";
  const step = gridStep((most - least) / Math.max(2, height / 46));
  for (let value = Math.ceil(least / step) * step; value <= most; value += step) {
    line(pen, LEFT, y(value), width - 8, y(value));
    pen.fillText(String(+value.toPrecision(6)), LEFT - 6, y(value) + 4);
  }
  pen.textAlign = "center";
  const every = gridStep(((end - begin) * 90) / Math.max(100, width - LEFT));
  for (let time = Math.ceil(begin / every) * every; time <= end; time += every) {
    line(pen, x(time), 6, x(time), height - FOOT);
    pen.fillText(`${+time.toPrecision(6)} s`, x(time), height - 4);
  }
  pen.save();
  pen.beginPath();
  pen.rect(LEFT, 0, width - LEFT - 8, height - FOOT);
  pen.clip();
  pen.lineWidth = 1.6;
  series.forEach((each, at) => {
    pen.strokeStyle = LINES[at % LINES.length];
    drawSeries(pen, each, x, y);
  });
  pen.strokeStyle = colours.accent;
  pen.lineWidth = 1;
  line(pen, x(now), 0, x(now), height);
  pen.restore();
  if (!found.length) {
    pen.fillStyle = colours.muted;
    pen.font = "13px system-ui, sans-serif";
    pen.fillText("Values are noted while the run plays; \u201cFill in the past\u201d reads earlier ones.", LEFT + (width - LEFT) / 2, height / 2);
  }
  return { time: (px) => begin + ((px - LEFT) / (width - LEFT - 8)) * (end - begin) };
}

function line(pen, x0, y0, x1, y1) {
  pen.beginPath();
  pen.moveTo(Math.round(x0) + 0.5, Math.round(y0) + 0.5);
  pen.lineTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
  pen.stroke();
}
