/** The run that this one is compared with, over the view: its path, its robots as ghosts, how far they are apart. */
import { lengthText } from "crs/units.js";

const NEAR = 0.002; // [m] ghosts that are nearer are not drawn
const STEPS = 20; // of a circle

/** @param {any} o the overlay */
export function otherRun(o) {
  const { other } = o.look;
  paths(o, other.own, []);
  paths(o, other.paths, [3, 5]);
  if (o.look.time <= other.end + 1e-9) for (const ghost of other.scene.bodies) drawGhost(o, ghost);
}

/** Paths from where the runs part, as far as this one is known. @param {any} o @param {Record<string, number[][]>} all @param {number[]} dash */
function paths(o, all, dash) {
  const { pen } = o;
  const { end } = o.look.model.state;
  pen.lineWidth = dash.length ? 2 : 1.5;
  pen.setLineDash(dash);
  pen.globalAlpha = dash.length ? 1 : 0.5;
  for (const [id, path] of Object.entries(all)) {
    const body = o.scene.bodies.find((each) => each.id === id);
    if (body && !o.concerns(body.row)) continue;
    pen.strokeStyle = body?.colour ?? o.look.colours.muted;
    pen.beginPath();
    o.path(path.filter((point) => point[2] <= end).map(([x, y]) => [x, y, o.scene.ground.height(x, y) + 0.02]));
    pen.stroke();
  }
  pen.setLineDash([]);
  pen.globalAlpha = 1;
}

/** A robot of the other run: its outline, where it looks, and the way to it. */
function drawGhost(o, ghost) {
  const { pen, look } = o;
  const body = o.scene.bodies.find((each) => each.id === ghost.id);
  if (!body || !o.concerns(body.row)) return;
  const apart = Math.hypot(body.x - ghost.x, body.y - ghost.y);
  if (apart < NEAR) return;
  const top = ghost.z + 0.8 * ghost.height;
  pen.strokeStyle = pen.fillStyle = body.colour;
  pen.lineWidth = 1.5;
  pen.globalAlpha = 0.25;
  pen.beginPath();
  o.circle(ghost.x, ghost.y, ghost.z + 0.01, ghost.radius, STEPS);
  pen.fill();
  pen.globalAlpha = 0.9;
  pen.setLineDash([4, 3]);
  pen.beginPath();
  o.circle(ghost.x, ghost.y, ghost.z + 0.01, ghost.radius, STEPS);
  o.circle(ghost.x, ghost.y, top, ghost.radius, STEPS);
  for (const side of [0.25, 0.75, 1.25, 1.75]) {
    const [x, y] = [ghost.x + ghost.radius * Math.cos(side * Math.PI), ghost.y + ghost.radius * Math.sin(side * Math.PI)];
    o.path([[x, y, ghost.z + 0.01], [x, y, top]]);
  }
  pen.stroke();
  pen.setLineDash([]);
  pen.lineWidth = 2.5;
  pen.beginPath();
  o.path([[ghost.x, ghost.y, top], [ghost.x + ghost.radius * Math.cos(ghost.heading), ghost.y + ghost.radius * Math.sin(ghost.heading), top]]);
  pen.stroke();
  pen.lineWidth = 1;
  pen.strokeStyle = look.colours.muted;
  pen.beginPath();
  o.path([[body.x, body.y, body.z + 0.02], [ghost.x, ghost.y, ghost.z + 0.02]]);
  pen.stroke();
  pen.globalAlpha = 1;
  if (o.several || body.row === look.selected) name(o, ghost, top, `${look.other.name}: ${lengthText(apart)}`);
}

function name(o, ghost, top, text) {
  const { pen, look } = o;
  const [x, y, w] = o.project(ghost.x, ghost.y, top);
  if (w <= 0) return;
  pen.font = "italic 11px system-ui, sans-serif";
  pen.textAlign = "center";
  const half = pen.measureText(text).width / 2 + 5;
  const foot = y + Math.max(7, ghost.radius * o.view.pixels(w)) + 18;
  o.plate(x - half, foot - 12, 2 * half, 16, look.colours.panel, { alpha: 0.8 });
  pen.fillStyle = look.colours.muted;
  pen.fillText(text, x, foot);
}
