/** Where a value came from: a tree of writes, back to what was measured; a click goes to when it was. */
import { entry } from "crs/change.js";
import { button, el, fill } from "crs/dom.js";

const MAX = 12; // questions that are kept
const CUT = "..."; // what the engine says of a node at which its tree ends

/**
 * A node, as sent by the server.
 * @typedef {{text: string, how: string, expression: string, t: number, place: string, robot: number,
 *   file: string, line: number, beam: {sonar: number, echo: number | null, met: string} | null, causes: Node[]}} Node
 * @typedef {{expression: string, robot: string, t: number, tree: Node, folded: Set<Node>}} Question
 */

/** @type {import("./index.js").Panel} */
export const why = {
  id: "why",
  title: "Why",
  summary: "Where a value came from",
  key: ",",
  side: "below",
  needs: "debug",
  make(root, model, look, page) {
    const input = entry({ placeholder: "speed, State[17], path[3] ...", title: "An expression in the selected program, at its current line", "aria-label": "expression whose value is explained" });
    const ask = button({ text: "Why?", title: "Show where its value came from", className: "primary", onclick: () => form.requestSubmit() });
    const wrong = el("span.wrong", { role: "alert" });
    const about = el("span.hint", { role: "status" });
    const before = el("select", { title: "Earlier questions", "aria-label": "earlier questions", onchange: () => choose(Number(before.value)) });
    const form = el("form.bar", { onsubmit: (event) => {
      event.preventDefault();
      question(input.value.trim());
    } }, input, ask, before, about, wrong);
    const tree = el("div.why-tree", { role: "tree", "aria-label": "where the value came from" });
    root.classList.add("why");
    root.append(form, tree);
    /** @type {Question[]} */
    let asked = [];
    /** @type {Question | null} */
    let shown = null;
    /** @type {Node | null} the node that the keyboard is at */
    let current = null;

    /** Ask why an expression has its value; show the answer. @param {string} expression */
    const question = async (expression) => {
      if (!expression) return;
      wrong.textContent = "";
      about.textContent = "asking ...";
      const [robot, t] = [model.selected.id, model.state.t];
      try {
        const answer = await model.channel.request("why", { expression });
        shown = { expression, robot, t, tree: answer, folded: new Set() };
        asked = [shown, ...asked.filter((each) => each.expression !== expression || each.t !== t || each.robot !== robot)].slice(0, MAX);
        current = answer;
        input.value = expression;
        draw();
        if (document.activeElement === input || document.activeElement === document.body) focus();
      } catch (error) {
        wrong.textContent = error.message;
        describe();
      }
    };

    page.why = (expression) => {
      page.drawer.open("why");
      return question(expression);
    };

    const choose = (at) => {
      shown = asked[at];
      current = shown.tree;
      draw();
    };

    const describe = () => {
      about.textContent = shown ? `${shown.expression} of ${shown.robot} at ${shown.t.toFixed(3)} s` : "";
    };

    /** Go to the instant of a node: its line, and its beam in the view. @param {Node} node */
    const go = async (node) => {
      if (!node.place) return;
      look.beam = node.beam ? { ...node.beam, robot: node.robot, t: node.t } : null;
      look.version++;
      if (node.line) page.layout.open("code");
      await page.go(node.place, node.robot);
    };

    /** Continue where the engine has cut the tree: ask again at the time above. @param {Node} node @param {Node} above */
    const continueAt = async (node, above) => {
      await go(above);
      question(node.expression);
    };

    /** The nodes that are seen, with their levels and the nodes above them. @returns {[Node, number, Node | null][]} */
    const rows = () => {
      const found = /** @type {[Node, number, Node | null][]} */ ([]);
      const walk = (node, level, above) => {
        found.push([node, level, above]);
        if (!shown?.folded.has(node)) for (const each of node.causes) walk(each, level + 1, node);
      };
      if (shown) walk(shown.tree, 1, null);
      return found;
    };

    const row = ([node, level, above]) => {
      const isOpen = !shown?.folded.has(node);
      const names = model.run.rosters.at(-1)?.robots ?? [];
      const isOther = names.length > 1 && node.robot >= 0 && node.robot !== (above?.robot ?? -1);
      const twist = node.causes.length ? el("button.fold", { type: "button", tabIndex: -1, "aria-label": isOpen ? "fold" : "unfold", onclick: (event) => {
        event.stopPropagation();
        fold(node, !isOpen);
      } }, isOpen ? "▾" : "▸") : el("span.fold");
      const [name, ...rest] = node.expression ? node.text.split(" = ") : node.beam ? node.text.split(": ") : [node.text];
      const fact = node.beam ? rest.splice(0).join(": ") : "";
      const what = el("span.what", {}, twist, isOther ? el("span.of", {}, names[node.robot]) : null,
        el(node.expression ? "code" : "span", { title: node.text }, name, rest.length ? el("b", {}, ` = ${rest.join(" = ")}`) : null));
      const how = node.how === CUT && above ? button({ text: "Continue", title: "Go to the time above, and ask there", className: "link", onclick: (event) => {
        event.stopPropagation();
        continueAt(node, above);
      } }) : el(fact ? "span.fact" : "code", { title: fact || node.how }, fact || node.how);
      const here = model.position?.place; // several may have it: a statement that calls and then writes
      const isHere = Boolean(node.place) && node.place === here && (current?.place !== here || node === current);
      const made = el("div.why-row", { role: "treeitem", "aria-level": level, "aria-current": isHere ? "true" : undefined, tabIndex: node === current ? 0 : -1, title: node.place ? "Go there" : "", onclick: () => {
        current = node;
        go(node);
      }, onfocus: () => (current = node) },
        what,
        el("span.when", {}, node.place ? `${node.t.toFixed(3)} s` : ""),
        el("span.at", {}, node.line ? `${node.file.split("/").at(-1)}:${node.line}` : ""),
        how);
      made.style.setProperty("--level", String(level - 1));
      if (node.causes.length) made.setAttribute("aria-expanded", String(isOpen));
      made.classList.toggle("there", Boolean(node.place));
      made.classList.toggle("about", !node.expression);
      made.classList.toggle("measured", Boolean(node.beam));
      return made;
    };

    const draw = () => {
      const hadFocus = tree.contains(document.activeElement);
      describe();
      before.hidden = asked.length < 2;
      fill(before, ...asked.map((each, at) => el("option", { value: String(at) }, `${each.expression} of ${each.robot} at ${each.t.toFixed(3)} s`)));
      before.value = String(asked.indexOf(/** @type {any} */ (shown)));
      fill(tree, ...(shown ? rows().map(row) : [el("p.hint", {}, "Ask where a value came from: here, with the button of a variable in Code, or by double-clicking a name in the source. Click a line of the answer to go to that point in time.")]));
      if (hadFocus) focus();
    };

    const focus = () => {
      const at = rows().findIndex(([node]) => node === current);
      /** @type {HTMLElement | undefined} */ (tree.children[Math.max(0, at)])?.focus();
    };

    /** @param {Node} node @param {boolean} isFolded */
    const fold = (node, isFolded) => {
      if (isFolded) shown?.folded.add(node);
      else shown?.folded.delete(node);
      draw();
    };

    /** @param {Node | null | undefined} node */
    const moveTo = (node) => {
      if (!node) return;
      current = node;
      for (const [at, [each]] of rows().entries()) /** @type {HTMLElement} */ (tree.children[at]).tabIndex = each === current ? 0 : -1;
      focus();
    };

    tree.addEventListener("keydown", (event) => {
      if (!shown || !current || event.target.closest("button")) return;
      const all = rows();
      const at = all.findIndex(([node]) => node === current);
      const [node, , above] = all[at] ?? all[0];
      const isOpen = node.causes.length > 0 && !shown.folded.has(node);
      const actions = {
        ArrowDown: () => moveTo(all[at + 1]?.[0]),
        ArrowUp: () => moveTo(all[at - 1]?.[0]),
        Home: () => moveTo(all[0][0]),
        End: () => moveTo(all.at(-1)?.[0]),
        ArrowRight: () => (isOpen ? moveTo(node.causes[0]) : node.causes.length && fold(node, false)),
        ArrowLeft: () => (isOpen ? fold(node, true) : moveTo(above)),
        Enter: () => (node.how === CUT && above ? continueAt(node, above) : go(node)),
        g: () => node.expression && page.plot(node.expression),
      };
      if (!actions[event.key]) return;
      event.preventDefault();
      event.stopPropagation();
      actions[event.key]();
    });
    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Escape") input.blur();
      if (event.key === "ArrowDown" && shown) focus();
    });
    model.on("hello", () => {
      [asked, shown, current] = [[], null, null];
      draw();
    });
    model.on("position", () => root.offsetParent && draw());
    model.on("look", () => root.offsetParent && draw());
    draw();
  },
};
