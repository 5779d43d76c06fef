/** Messages between robots: what became of each, who talks to whom, and forms that block links. */
import { el, fill } from "crs/dom.js";
import { linkForms } from "crs/link_forms.js";
import { drawGraph, linksOf } from "crs/message_graph.js";
import { oneAtATime } from "crs/one_at_a_time.js";

const MAX = 300; // rows that are shown
const RATE = 10; // rates are of the last seconds [s]
const SENT = 0;
const ARRIVED = new Set([1, 2]);

/** @type {import("./index.js").Panel} */
export const messages = {
  id: "messages",
  title: "Messages",
  summary: "Messages between robots: list, graph, links",
  key: "y",
  side: "below",
  asks: true,
  make(root, model, _look, page) {
    const filter = el("input", { type: "text", placeholder: "find a robot, a channel, a word of the content", "aria-label": "filter", spellcheck: false });
    const lostOnly = el("input", { type: "checkbox" });
    const clear = el("button", { type: "button", onclick: () => follow("", "") }, "Show all");
    const about = el("span.hint", { role: "status" });
    const list = el("div.message-rows", { role: "list", "aria-label": "messages", tabIndex: 0 });
    const graph = el("div.graph-box");
    root.classList.add("messages");
    /** @type {any[]} */
    let rows = [];
    let next = 0;
    let fates = [];
    let [link, one] = ["", ""]; // what is followed: a link, or a message
    let key = "";
    const { shut, send } = linkForms(model);
    const sides = [["Graph", graph], ...(model.can("change") ? [["Block links", shut], ["Send", send]] : [])];
    const show = (chosen) => {
      for (const [, box] of sides) box.hidden = box !== chosen;
      [...choose.children].forEach((each, at) => each.setAttribute("aria-pressed", String(sides[at][1] === chosen)));
      key = "";
    };
    const choose = el("div.segmented", { role: "group", "aria-label": "beside the list" },
      ...sides.map(([title, box]) => el("button", { type: "button", onclick: () => show(box) }, title)));
    root.append(
      el("div.message-list", {}, el("div.bar", {}, filter, el("label.only-lost", {}, lostOnly, "lost only"), clear, about), list),
      el("div.side-box", {}, el("div.bar", {}, choose), ...sides.map(([, box]) => box)));
    show(graph);

    const refresh = oneAtATime(async () => {
      if (!root.offsetParent || !model.isConnected || model.channel.isLocal) return;
      try {
        const since = next;
        const answer = await model.channel.request("traffic", { since });
        if (next !== since) return; // all are asked for again
        if (answer.first > next) rows = [];
        rows.push(...answer.rows);
        next = answer.first + answer.rows.length;
        fates = answer.fates;
        key = answer.rows.length ? "" : key;
        if (next < answer.end) setTimeout(refresh, 0);
      } catch {
        // the next status asks again
      }
    });

    const again = () => {
      [rows, next, key] = [[], 0, ""];
      refresh();
    };

    const names = () => model.run.rosters.at(-1)?.robots ?? [];
    const channel = (number) => model.run.channels?.[number] ?? model.panel?.channels?.[number] ?? String(number);
    const isLost = (fate) => fate !== SENT && !ARRIVED.has(fate);
    const meaning = (fate) => fates[fate]?.[1].replace("lost: ", "") ?? "";
    const to = (row) => (row[4] >= 0 ? names()[row[4]] ?? row[4] : row[5] >= 0 ? `group ${row[5]}` : "all");

    const follow = (newLink, newOne) => {
      [link, one, key] = [newLink, newOne, ""];
      draw();
    };

    const matches = (row) => {
      const [, fate, number, sender, receiver, , , , serial, content] = row;
      if (one) return one === `${sender} ${serial}`;
      if (link && link !== `${sender}>${receiver}` && !(receiver < 0 && link.startsWith(`${sender}>`))) return false;
      if (lostOnly.checked && !isLost(fate)) return false;
      const wanted = filter.value.trim().toLowerCase();
      return !wanted || `${names()[sender]} ${to(row)} ${channel(number)} ${content ?? ""} ${fates[fate]?.[1]}`.toLowerCase().includes(wanted);
    };

    const draw = () => {
      if (!root.offsetParent || !model.run) return;
      const time = model.clock.shown + 1e-6;
      let count = rows.length;
      while (count && rows[count - 1][0] > time) count--;
      const now = `${count} ${filter.value} ${lostOnly.checked} ${link} ${one} ${Math.floor(time)}`;
      if (now === key) return;
      key = now;
      const known = rows.slice(0, count);
      const found = known.filter(matches);
      fill(list, ...(found.length ? found.slice(-MAX).reverse().map(shownRow) : [el("p.hint", {}, known.length ? "No matches." : "No message has been sent.")]));
      const recent = known.filter((row) => row[0] > time - RATE);
      const followed = one ? "one message" : link ? link.split(">").map((each) => names()[Number(each)]).join(" to ") : "";
      about.textContent = followed ? `followed: ${followed}` : countsOf(known.map((row) => row[1]));
      clear.hidden = !followed;
      const links = linksOf(recent, isLost);
      fill(graph, links.length ? drawGraph(links, { names: names(), seconds: Math.min(RATE, time), meaning, selected: link, choose: (chosen) => follow(chosen, "") })
        : el("p.hint", {}, `Nothing was delivered or lost in the last ${RATE} s.`));
    };

    /** What became of messages; each receiver of a message counts. @param {number[]} all their fates */
    const countsOf = (all) => {
      const [sent, lost] = [all.filter((fate) => fate === SENT).length, all.filter(isLost).length];
      return `${sent} sent, ${all.length - sent - lost} arrived, ${lost} lost`;
    };

    const shownRow = (row) => {
      const [time, fate, number, sender, , , kind, size, serial, content] = row;
      const follows = `${sender} ${serial}`;
      return el("button.message", { type: "button", role: "listitem", title: "Follow this message", "aria-pressed": String(one === follows), onclick: () => follow("", one === follows ? "" : follows) },
        el("span.when", { title: "Go there", onclick: (event) => {
          event.stopPropagation();
          page.timeline.seek(time);
        } }, `${time.toFixed(3)} s`),
        el("span", {}, `${names()[sender] ?? sender} → ${to(row)}`),
        el("span.hint", {}, `${channel(number)}, type ${kind}, ${size} B`),
        el("code", {}, content ?? ""),
        el(isLost(fate) ? "span.bad" : fate === SENT ? "span.hint" : "span.good", {}, fate === SENT ? "sent" : isLost(fate) ? meaning(fate) : "arrived" + (fate === 2 ? ", corrupted" : "")));
    };

    filter.addEventListener("input", draw);
    lostOnly.addEventListener("change", draw);
    model.on("status", refresh);
    model.on("look", refresh);
    for (const kind of ["truncate", "hello"]) model.on(kind, again);
    model.on("tick", draw);
  },
};
