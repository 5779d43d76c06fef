/** What is drawn over a view of devices: the laser's scan, what is degraded, how far radios reach. */

const RED = "#e5383b";

/** The last scan of the selected robot's laser. */
export function laser(o) {
  const { pen, look } = o;
  const body = o.scene.body(look.selected);
  const scan = look.devices?.laser ?? [];
  const about = body?.kind?.laser;
  if (!about || !scan.length) return;
  const z = body.z + about.z;
  const from = [body.x + about.forward * Math.cos(body.mount), body.y + about.forward * Math.sin(body.mount)];
  const step = about.fov / Math.max(1, scan.length);
  const points = scan.map((range, number) => {
    const angle = body.mount + (number - (scan.length - 1) / 2) * step;
    const reach = range ?? about.range;
    return [from[0] + reach * Math.cos(angle), from[1] + reach * Math.sin(angle), z, range === null];
  });
  pen.fillStyle = pen.strokeStyle = "#d6336c";
  pen.globalAlpha = 0.1;
  pen.beginPath();
  o.path([[...from, z], ...points, [...from, z]]);
  pen.fill();
  pen.globalAlpha = 0.9;
  for (const [x, y, high, isNothing] of points) {
    if (isNothing) continue;
    const [px, py, w] = o.project(x, y, high);
    if (w > 0) pen.fillRect(px - 1, py - 1, 2, 2);
  }
  pen.globalAlpha = 1;
}

/** Degraded parts in red: sonars and bumpers where they are, others by name below the robot. */
export function degraded(o) {
  const { pen, look } = o;
  const byRobot = new Map();
  for (const [row, device, element, , name] of look.devices?.degraded ?? []) {
    if (!byRobot.has(row)) byRobot.set(row, []);
    byRobot.get(row).push([device, element, name]);
  }
  pen.font = "600 11px system-ui, sans-serif";
  pen.textAlign = "center";
  for (const [row, parts] of byRobot) {
    const body = o.scene.body(row);
    if (!body || !o.concerns(row)) continue;
    const [x, y, w] = o.project(body.x, body.y, body.z);
    if (w <= 0) continue;
    for (const [device, element] of parts) mark(o, body, device, element);
    const text = [...new Set(parts.map(([, , name]) => name))].slice(0, 4).join(", ");
    const low = y + Math.max(8, body.radius * o.view.pixels(w)) + 13;
    const half = pen.measureText(text).width / 2 + 6;
    o.plate(x - half, low - 12, 2 * half, 16, RED);
    pen.fillStyle = "#ffffff";
    pen.fillText(text, x, low);
  }
}

function mark(o, body, device, element) {
  const { pen } = o;
  pen.strokeStyle = pen.fillStyle = RED;
  if (device === "sonar") {
    body.kind?.sonars.forEach(({ x, y }, number) => {
      if (element >= 0 && number !== element) return;
      const [cos, sin] = [Math.cos(body.mount), Math.sin(body.mount)];
      const [px, py, w] = o.project(body.x + x * cos - y * sin, body.y + x * sin + y * cos, body.z + body.height * 0.7);
      if (w <= 0) return;
      pen.beginPath();
      pen.arc(px, py, Math.max(3, 0.035 * o.view.pixels(w)), 0, 2 * Math.PI);
      pen.fill();
    });
  } else if (device === "bumper") {
    pen.lineWidth = 3;
    body.kind?.bumpers.forEach(({ bearing, span }, number) => {
      if (element >= 0 && number !== element) return;
      const points = Array.from({ length: 9 }, (_, step) => {
        const angle = body.base + bearing + span * (step / 8 - 0.5);
        return [body.x + body.radius * 1.08 * Math.cos(angle), body.y + body.radius * 1.08 * Math.sin(angle), body.z + 0.08];
      });
      pen.setLineDash([3, 3]);
      pen.beginPath();
      o.path(points);
      pen.stroke();
      pen.setLineDash([]);
    });
  }
}

/** How far the radio of the selected robot reaches, where nothing is in the way. */
export function ranges(o) {
  const { pen, look } = o;
  const body = o.scene.body(look.selected);
  if (!body) return;
  pen.strokeStyle = pen.fillStyle = "#8250df";
  pen.font = "11px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.lineWidth = 1.2;
  for (const { name, range } of look.model.run.world.channels ?? []) {
    pen.setLineDash([7, 6]);
    pen.beginPath();
    o.circle(body.x, body.y, body.z + 0.02, range, 72);
    pen.stroke();
    pen.setLineDash([]);
    const [x, y, w] = o.project(body.x, body.y + range, body.z + 0.02);
    if (w > 0) pen.fillText(`${name}: ${+range.toPrecision(3)} m`, x, y - 4);
  }
}
