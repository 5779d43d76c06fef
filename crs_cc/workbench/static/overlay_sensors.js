/** What the selected robot's camera, infrared ring and heat sensor have measured last, and a beam that was asked for. */
import { heatColour } from "crs/heat.js";
import { lengthText } from "crs/units.js";

const STRIP = { height: 26, most: 420, top: 62 }; // of the picture [pixels]
const SIDES = 64; // of a circle

/** A point on the body, in the frame of its mount. */
function placed(body, ahead, left, height) {
  const [cos, sin] = [Math.cos(body.mount), Math.sin(body.mount)];
  return [body.x + ahead * cos - left * sin, body.y + ahead * sin + left * cos, body.z + height];
}

/** The camera's row of pixels at the top of the view, and in the world what it has seen. */
export function cameraStrip(o) {
  const { pen, look } = o;
  const body = o.scene.body(look.selected);
  const about = body?.kind?.camera;
  const seen = look.devices?.camera ?? [];
  if (!about || !seen.length) return;
  const from = placed(body, about.x, about.y, about.z);
  const step = about.fov / seen.length;
  const at = (number, range) => {
    const angle = body.mount + about.direction + ((seen.length - 1) / 2 - number) * step;
    return [from[0] + range * Math.cos(angle), from[1] + range * Math.sin(angle), from[2]];
  };
  pen.fillStyle = look.colours.muted;
  pen.globalAlpha = 0.16;
  pen.beginPath();
  o.path([from, ...seen.map(([, range], number) => at(number, range ?? about.range)), from]);
  pen.fill();
  pen.globalAlpha = 1;
  for (const [number, [colour, range]] of seen.entries()) {
    if (range === null) continue;
    const [x, y, w] = o.project(...at(number, range));
    pen.fillStyle = colour;
    if (w > 0) pen.fillRect(x - 1.5, y - 1.5, 3, 3);
  }
  strip(o, seen);
}

function strip({ pen, look, width }, seen) {
  const wide = Math.min(STRIP.most, width - 40);
  const left = (width - wide) / 2;
  seen.forEach(([colour], number) => {
    pen.fillStyle = colour;
    pen.fillRect(left + (number * wide) / seen.length, STRIP.top, wide / seen.length + 0.6, STRIP.height);
  });
  pen.strokeStyle = look.colours.panel;
  pen.lineWidth = 2;
  pen.strokeRect(left, STRIP.top, wide, STRIP.height);
}

/** The beams of the infrared ring, as far as each reading says that something is. */
export function infraredBeams(o) {
  const { pen, look } = o;
  const body = o.scene.body(look.selected);
  const about = body?.kind?.infrared;
  const levels = look.devices?.infrared ?? [];
  if (!about) return;
  pen.lineWidth = 2;
  levels.forEach((level, number) => {
    if (level === null || level >= about.farthest) return;
    const angle = (number * 2 * Math.PI) / levels.length;
    const ray = [body.radius, body.radius + level * about.step].map((reach) => placed(body, reach * Math.cos(angle), reach * Math.sin(angle), about.z));
    pen.strokeStyle = pen.fillStyle = "#c2255c";
    pen.beginPath();
    o.path(ray);
    pen.stroke();
    const [x, y, w] = o.project(...ray[1]);
    if (w > 0) pen.fillRect(x - 2.5, y - 2.5, 5, 5);
  });
}

/** How far the heat sensor reaches, and what it has read. */
export function heatRange(o) {
  const { pen, look } = o;
  const body = o.scene.body(look.selected);
  const reach = body?.kind?.heat;
  if (!reach) return;
  const reading = look.devices?.heat ?? null;
  pen.strokeStyle = pen.fillStyle = heatColour(0.7);
  pen.lineWidth = 1.4;
  pen.setLineDash([2, 4]);
  pen.beginPath();
  o.circle(body.x, body.y, body.z + 0.02, reach, SIDES);
  pen.stroke();
  pen.setLineDash([]);
  const [x, y, w] = o.project(body.x, body.y - reach, body.z + 0.02);
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  if (w > 0) pen.fillText(`heat sensor: ${reading === null ? "not read yet" : reading}`, x, y + 13);
}

/** The beam of a sonar that a value came from, at the instant at which it was fired. */
export function askedBeam(o, { sonar, echo, met, robot, t }) {
  const { pen, look } = o;
  const body = o.scene.body(robot);
  const about = body?.kind?.sonars?.[sonar];
  if (!about || Math.abs(look.time - t) > (look.model.run.timestep_s ?? 0) + 1e-6) return;
  const [ahead, left] = [about.x, about.y];
  const z = body.height * 0.7;
  const from = placed(body, ahead, left, z);
  const reach = echo ?? 6;
  const arc = Array.from({ length: 9 }, (_, at) => {
    const angle = about.direction + (at / 4 - 1) * about.half_angle;
    return placed(body, ahead + reach * Math.cos(angle), left + reach * Math.sin(angle), z);
  });
  pen.fillStyle = pen.strokeStyle = look.colours.accent;
  pen.beginPath();
  o.path([from, ...arc, from]);
  pen.globalAlpha = 0.3;
  pen.fill();
  pen.globalAlpha = 1;
  pen.lineWidth = 2;
  pen.stroke();
  pen.lineWidth = 4;
  pen.beginPath();
  if (echo !== null) o.path(arc);
  pen.stroke();
  const [x, y, w] = o.project(...arc[4]);
  if (w <= 0) return;
  const text = echo === null ? `sonar ${sonar}: no echo` : `sonar ${sonar}: ${lengthText(echo)}${met ? `, ${met}` : ""}`;
  pen.font = "600 12.5px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.lineWidth = 4;
  pen.lineJoin = "round";
  pen.strokeStyle = look.colours.panel;
  pen.strokeText(text, x, y - 24);
  pen.fillText(text, x, y - 24);
}
