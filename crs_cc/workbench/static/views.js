/** The views of the world, one or several side by side, and the buttons over them. */
import { button, el, fill } from "crs/dom.js";
import { paintViews, saveFile, Video } from "crs/video.js";
import { ViewMenu } from "crs/view_menu.js";
import { Viewport } from "crs/viewport.js";

const MODES = [
  ["orbit", "Orbit", "Look from anywhere: drag to turn, Shift-drag to move, use the wheel to zoom", "1"],
  ["top", "Top", "Look straight down", "2"],
  ["follow", "Follow", "Keep the selected robot in the centre", "3"],
  ["chase", "Chase", "Look over the shoulder of the selected robot", "4"],
  ["board", "On board", "View from the selected robot", "5"],
];

/** What further views show at first. */
const OTHERS = ["chase", "top", "board"];

export class Views {
  /** @param {HTMLElement} root @param {any} model @param {any} look */
  constructor(root, model, look) {
    this.root = root;
    this.model = model;
    this.look = look;
    this.isFlat = new URLSearchParams(location.hash.slice(1)).get("flat") === "1";
    /** @type {Viewport[]} */
    this.all = [];
    this.grid = el("div.views");
    this.bar = el("div.floating.left");
    this.right = el("div.floating.right");
    this.note = el("div.note", { role: "status" });
    this.video = new Video(this);
    this.menu = new ViewMenu(this);
    /** @type {((x: number, y: number) => void) | null} what the next click on the ground does */
    this.onPlace = null;
    root.replaceChildren(this.grid, this.bar, this.right, this.menu.element, this.note);
    model.on("look", () => this.showBar());
    model.on("notice", ({ text, isError }) => this.notify(text, isError));
  }

  /** Show a world again. @param {any} scene */
  setScene(scene) {
    this.scene = scene;
    if (!this.all.length) this.add();
    else for (const view of this.all) view.setScene(scene);
    const saved = new URLSearchParams(location.hash.slice(1)).get("view");
    if (saved && !this.isRestored) this.restore(saved);
    this.isRestored = true;
    this.showBar();
  }

  add() {
    const view = new Viewport(this.scene, this.model, {
      flat: this.isFlat,
      failed: (reason) => {
        this.isFlat = true;
        this.notify(reason, true);
      },
      active: (chosen) => this.activate(chosen),
      placed: (ground) => this.place(ground),
    });
    this.all.push(view);
    this.activate(view);
    this.arrange();
  }

  activate(view) {
    this.active = view;
    for (const each of this.all) each.element.classList.toggle("active", each === view && this.all.length > 1);
    this.showBar();
  }

  arrange() {
    this.grid.dataset.count = String(this.all.length);
    fill(this.grid, ...this.all.map((each) => each.element));
  }

  /** Put something where a click hits the ground, if anything waits for it. */
  place(ground) {
    const act = this.onPlace;
    if (!act) return false;
    const at = ground();
    if (!at) return true;
    this.onPlace = null;
    act(at[0], at[1]);
    return true;
  }

  /** One view, or four: from anywhere, from above, over the shoulder, and on board. */
  split() {
    this.setCount(this.all.length > 1 ? 1 : 4);
  }

  /** @param {number} count of views side by side */
  setCount(count) {
    for (const view of this.all.slice(count)) view.view.dispose?.();
    if (this.all.length > count) this.all.length = count;
    while (this.all.length < count) {
      this.add();
      this.active.camera.setMode(OTHERS[this.all.length - 2] ?? "orbit");
    }
    this.activate(this.all[0]);
    this.arrange();
  }

  /** All cameras, for a link or a saved view. */
  cameras() {
    return this.all.map((view) => view.camera.save()).join("~");
  }

  /** Show views as they were saved. @param {string} text */
  restore(text) {
    const cameras = text.split("~").slice(0, 4);
    this.setCount(cameras.length === 3 ? 4 : cameras.length);
    cameras.forEach((each, number) => this.all[number].camera.restore(each));
    this.showBar();
  }

  setMode(mode) {
    this.active.camera.setMode(mode);
    this.showBar();
  }

  setFlat(isFlat) {
    this.isFlat = isFlat;
    for (const view of this.all) view.setFlat(isFlat);
    this.showBar();
  }

  showBar() {
    if (!this.active) return;
    const mode = this.active.camera.mode;
    const choice = (name, text, title, key) => {
      const made = button({ text, title, key, onclick: () => this.setMode(name) });
      made.setAttribute("aria-pressed", String(name === mode));
      return made;
    };
    const modes = this.isFlat ? MODES.filter(([name]) => name === "orbit" || name === "follow") : MODES;
    fill(this.bar, el("div.segmented", { role: "group", "aria-label": "camera" }, ...modes.map((each) => choice(...each))));
    const pressed = (made, isOn) => {
      made.setAttribute("aria-pressed", String(isOn));
      return made;
    };
    fill(
      this.right,
      pressed(button({ text: this.isFlat ? "3-D" : "2-D", title: this.isFlat ? "Three dimensions" : "A flat map", key: "F", onclick: () => this.setFlat(!this.isFlat) }), false),
      pressed(button({ icon: this.all.length > 1 ? "single" : "split", title: this.all.length > 1 ? "One view" : "Four views", key: "V", onclick: () => this.split() }), false),
      pressed(button({ icon: "heat", title: "Infrared: heat as colour", key: "I", onclick: () => this.look.setInfrared(!this.look.isInfrared) }), this.look.isInfrared),
      pressed(button({ icon: "camera", title: "Save a picture", key: "S", onclick: () => this.picture() }), false),
      pressed(button({ icon: "more", title: "Saved views, light, video, web page", key: "M", className: this.video.isOn ? "recording" : "", onclick: () => this.menu.toggle() }), !this.menu.element.hidden),
    );
  }

  notify(text, isError) {
    this.note.textContent = text;
    this.note.className = `note ${isError ? "error" : ""} ${text ? "shown" : ""}`;
    clearTimeout(this.noteTimer);
    this.noteTimer = setTimeout(() => this.note.classList.remove("shown"), isError ? 7000 : 3000);
  }

  draw(elapsed) {
    for (const view of this.all) view.draw(this.look, elapsed);
    if (this.video.isOn) this.video.paint();
  }

  /** Save the views as a picture. */
  picture() {
    const whole = el("canvas");
    paintViews(this.all, whole, this.look.colours.sky);
    whole.toBlob((blob) => {
      if (!blob) return;
      saveFile(blob, `crs-${this.look.time.toFixed(2)}s.png`);
      this.notify("picture saved");
    });
  }

  /** Save the run, as far as it is known, as one file. */
  async exportPage() {
    const bytes = await this.model.channel.page().catch((error) => this.notify(error.message, true));
    if (!bytes) return;
    saveFile(new Blob([bytes], { type: "text/html" }), "crs-run.html");
    this.notify("page saved: it opens in any browser");
  }

  /** Save the run up to the time that is shown, with its programs, as a recording. */
  async exportRecording() {
    this.notify("running it again, to record it");
    const bytes = await this.model.channel.recording().catch((error) => this.notify(error.message, true));
    if (!bytes) return;
    saveFile(new Blob([bytes], { type: "application/octet-stream" }), "crs-run.mcap");
    this.notify("recording saved: crs debug and crs replay open it");
  }
}
