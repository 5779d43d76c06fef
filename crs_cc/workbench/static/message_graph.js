/** The graph of messages: who talks to whom, how often, and what is lost. */

const TURN = 2 * Math.PI;
const NS = "http://www.w3.org/2000/svg";
const MAX = 40; // robots in a circle

/** Make an element of a drawing. @param {string} name @param {Record<string, any>} attributes */
function svg(name, attributes, ...children) {
  const made = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...children);
  return made;
}

/**
 * Links with their counts, from rows of the log.
 * @param {any[]} rows @param {(fate: number) => boolean} isLost
 */
export function linksOf(rows, isLost) {
  const links = new Map();
  for (const [, fate, , sender, receiver] of rows) {
    if (fate === 0 || receiver < 0) continue;
    const key = `${sender}>${receiver}`;
    const link = links.get(key) ?? { sender, receiver, arrived: 0, lost: 0, reasons: new Map() };
    if (isLost(fate)) {
      link.lost++;
      link.reasons.set(fate, (link.reasons.get(fate) ?? 0) + 1);
    } else link.arrived++;
    links.set(key, link);
  }
  return [...links.values()];
}

/**
 * @param {any[]} links as of `linksOf`
 * @param {{names: string[], seconds: number, meaning: (fate: number) => string, selected: string,
 *   choose: (key: string) => void}} options
 */
export function drawGraph(links, { names, seconds, meaning, selected, choose }) {
  const used = [...new Set(links.flatMap(({ sender, receiver }) => [sender, receiver]))].sort((a, b) => a - b).slice(0, MAX);
  const at = new Map(used.map((number, place) => {
    const angle = -TURN / 4 + (place * TURN) / Math.max(2, used.length);
    return [number, [150 + 100 * Math.cos(angle), 110 + 78 * Math.sin(angle)]];
  }));
  const most = Math.max(1, ...links.map(({ arrived, lost }) => arrived + lost));
  const drawing = svg("svg", { viewBox: "0 0 300 220", class: "graph", role: "img", "aria-label": "graph of messages" });
  for (const link of links) {
    const [from, to] = [at.get(link.sender), at.get(link.receiver)];
    if (from && to) drawing.append(arrow(link, from, to, { most, seconds, meaning, names, selected, choose }));
  }
  for (const number of used) {
    const [x, y] = at.get(number);
    drawing.append(svg("circle", { cx: x, cy: y, r: 9, class: "node" }));
    drawing.append(svg("text", { x, y: y + (y > 110 ? 23 : -14), class: "name" }, names[number] ?? String(number)));
  }
  return drawing;
}

/** @param {any} link @param {number[]} from @param {number[]} to @param {any} options */
function arrow(link, [x0, y0], [x1, y1], { most, seconds, meaning, names, selected, choose }) {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const length = Math.hypot(dx, dy) || 1;
  const [ux, uy] = [dx / length, dy / length];
  const [bx, by] = [-uy * 12, ux * 12]; // to one side, so that both directions are seen
  const [sx, sy] = [x0 + ux * 10, y0 + uy * 10];
  const [ex, ey] = [x1 - ux * 13, y1 - uy * 13];
  const [mx, my] = [(sx + ex) / 2 + bx, (sy + ey) / 2 + by];
  const all = link.arrived + link.lost;
  const key = `${link.sender}>${link.receiver}`;
  const reasons = [...link.reasons].map(([fate, count]) => `${count} ${meaning(fate)}`).join(", ");
  const text = `${names[link.sender]} to ${names[link.receiver]}: ${link.arrived} arrived${reasons ? `, ${reasons}` : ""}`;
  const share = link.lost / all;
  const group = svg("g", { class: `link${share > 0 ? " lossy" : ""}${share > 0.9 ? " dead" : ""}${selected === key ? " chosen" : ""}`,
    tabindex: 0, role: "button", "aria-label": text }, svg("title", {}, text));
  group.append(svg("path", { d: `M${sx} ${sy}Q${mx} ${my} ${ex} ${ey}`, "stroke-width": 1 + (4 * all) / most }));
  const [tx, ty] = [ex - mx, ey - my];
  const tip = Math.hypot(tx, ty) || 1;
  const [hx, hy] = [tx / tip, ty / tip];
  group.append(svg("path", { class: "tip", d: `M${ex} ${ey}l${-8 * hx - 4 * hy} ${-8 * hy + 4 * hx}l${8 * hy} ${-8 * hx}z` }));
  const rate = `${+(all / Math.max(seconds, 0.05)).toPrecision(2)}/s${share > 0 ? `, ${Math.round(100 * share)}% lost` : ""}`;
  group.append(svg("text", { x: (sx + 2 * mx + ex) / 4 + bx * 0.6, y: (sy + 2 * my + ey) / 4 + by * 0.6 + 3, class: "rate" }, rate));
  const pick = () => choose(selected === key ? "" : key);
  group.addEventListener("click", pick);
  group.addEventListener("keydown", (event) => event.key === "Enter" && pick());
  return group;
}
