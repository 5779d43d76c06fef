/** The page around the view: its head, its panels at the sides, tabs. */
import { button, el, fill, part } from "crs/dom.js";
import { PANELS } from "crs/panels/index.js";
import { setTheme, theme } from "crs/theme.js";

const STATES = { playing: "running", waits: "waiting", busy: "working", end: "ended", error: "stopped by an error", start: "ready", lost: "not connected", breakpoint: "at a breakpoint", watchpoint: "a value has changed", catchpoint: "at an event", exit: "a program has ended", step: "paused" };

export class Layout {
  /** @param {any} model @param {any} look @param {any} page what panels may use of each other */
  constructor(model, look, page) {
    this.model = model;
    this.look = look;
    this.page = page;
    this.chip = el("span.chip.state", { role: "status" });
    this.title = el("h1", { id: "title" });
    this.note = el("span.note-text", { id: "note" });
    /** The name of a world that is tried from the builder: its file here is a copy of another name. */
    this.trial = new URLSearchParams(location.hash.slice(1)).get("trial");
    const edit = this.trial ? [button({ text: "Edit", title: "Edit: back to the world builder", onclick: () => history.back() })] : [];
    fill(part("head"), ...edit, this.title, this.chip, this.note, el("span.spacer"),
      button({ icon: "share", title: "Copy a link to this view and time", key: "K", onclick: () => this.share() }),
      button({ icon: "theme", title: "Light, dark, or system theme", key: "T", onclick: () => this.nextTheme() }),
      button({ icon: "help", title: "Keys", key: "?", onclick: () => this.page.keys() }));
    model.on("hello", () => this.build());
    for (const kind of ["state", "link", "hello"]) model.on(kind, () => this.show());
  }

  /** Put the panels in their places that this run can fill. */
  build() {
    const { model, look, page } = this;
    const { run } = model;
    const names = run.programs ? [el("b", {}, run.programs), " in ", el("b", {}, this.trial ?? run.world_name)] : [run.title];
    fill(this.title, ...names);
    document.title = `${this.title.textContent} · crs`;
    if (this.isBuilt) return;
    this.isBuilt = true;
    const panels = PANELS.filter((panel) => (!panel.needs || model.run.can.includes(panel.needs)) && !(panel.asks && model.channel.isLocal && !panel.isHeld?.(run)));
    const left = el("aside.left", { "aria-label": "robots" });
    const right = el("aside.right", { "aria-label": "program" });
    const tabs = el("div.tabs", { role: "tablist" });
    right.append(tabs);
    for (const panel of panels) {
      const root = el("section.panel", { id: `panel-${panel.id}` });
      if (panel.side === "below" || panel.side === "under") page.drawer.add(panel, root);
      else if (panel.side === "left") left.append(el("h2", {}, panel.title), root);
      else {
        root.setAttribute("role", "tabpanel");
        root.hidden = true;
        tabs.append(el("button", { type: "button", role: "tab", id: `tab-${panel.id}`, onclick: () => this.open(panel.id) }, panel.title));
        right.append(root);
      }
      panel.make(root, model, look, page);
    }
    part("sides").replaceChildren(left, right);
    this.open(panels.find((panel) => panel.side === "right")?.id);
    if (run.role === "view") document.body.classList.add("view-only");
  }

  open(id) {
    for (const panel of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("aside.right > section"))) panel.hidden = panel.id !== `panel-${id}`;
    for (const tab of document.querySelectorAll("[role=tab]")) tab.setAttribute("aria-selected", String(tab.id === `tab-${id}`));
    this.model.emit("look");
  }

  show() {
    const { state, run, isConnected } = this.model;
    const reason = !isConnected ? "lost" : state.waits ? "waits" : state.playing ? "playing" : state.busy ? "busy" : state.halt.reason;
    this.chip.dataset.state = reason;
    this.chip.textContent = STATES[reason] ?? (reason === "paused" ? "paused" : `stopped: ${reason}`);
    if (!isConnected && this.model.lost) {
      const { isOver, wasOpen } = this.model.lost;
      this.note.textContent = isOver ? "the run has ended: restart it, and open the address that crs prints"
        : wasOpen ? "reconnecting ..." : "no response from a run: restart it, or open the address that crs printed";
    } else if (run) {
      const robots = run.rosters.at(-1)?.robots.length ?? 0;
      const count = `${robots} robot${robots === 1 ? "" : "s"}`;
      const looks = run.role === "view" ? " · view only" : "";
      this.note.textContent = state.waits ? `waiting for a host of ${state.waits}` : run.note ?? `seed ${run.seed} · ${count}${looks}`;
    }
    document.body.classList.toggle("disconnected", !isConnected);
  }

  nextTheme() {
    const order = ["auto", "light", "dark"];
    setTheme(order[(order.indexOf(theme()) + 1) % order.length]);
    this.model.notify(`theme: ${theme() === "auto" ? "system" : theme()}`);
    this.look.repaint();
    this.model.emit("look");
  }

  share() {
    const words = new URLSearchParams(location.hash.slice(1));
    const { clock } = this.model; // while it is stopped, the displayed time may still be approaching it
    words.set("t", (clock.isPlaying ? clock.shown : (clock.held ?? clock.target)).toFixed(3));
    words.set("view", this.page.views.cameras());
    history.replaceState(null, "", `#${words}`);
    navigator.clipboard?.writeText(location.href).then(() => this.model.notify("link copied"), () => this.model.notify("the link is in the address bar"));
  }
}
