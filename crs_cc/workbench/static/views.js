/** The views of the world, one or several side by side, and the buttons over them. */
import { button, el, fill } from "crs/dom.js";
import { Viewport } from "crs/viewport.js";

const MODES = [
  ["orbit", "Orbit", "Look from anywhere: drag turns, shift-drag moves, the wheel zooms", "1"],
  ["top", "Top", "Look straight down", "2"],
  ["follow", "Follow", "Keep the selected robot in the middle", "3"],
  ["chase", "Chase", "Look over the shoulder of the selected robot", "4"],
  ["board", "On board", "Look out of the selected robot", "5"],
];

export class Views {
  /** @param {HTMLElement} root @param {any} model @param {any} look */
  constructor(root, model, look) {
    Object.assign(this, { root, model, look });
    this.isFlat = new URLSearchParams(location.hash.slice(1)).get("flat") === "1";
    /** @type {Viewport[]} */
    this.all = [];
    this.grid = el("div.views");
    this.bar = el("div.floating.left");
    this.right = el("div.floating.right");
    this.note = el("div.note", { role: "status" });
    root.replaceChildren(this.grid, this.bar, this.right, this.note);
    model.on("look", () => this.showBar());
    model.on("say", ({ text, isError }) => this.say(text, isError));
  }

  /** Show a world anew. @param {any} scene */
  setScene(scene) {
    this.scene = scene;
    if (!this.all.length) this.add();
    else for (const view of this.all) view.setScene(scene);
    const saved = new URLSearchParams(location.hash.slice(1)).get("view");
    if (saved) this.all[0].camera.restore(saved);
    this.showBar();
  }

  add() {
    const view = new Viewport(this.scene, this.model, {
      flat: this.isFlat,
      failed: (reason) => {
        this.isFlat = true;
        this.say(reason, true);
      },
      active: (chosen) => this.activate(chosen),
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

  /** One view, or four: from anywhere, from above, over the shoulder, and on board. */
  split() {
    if (this.all.length > 1) {
      for (const view of this.all.slice(1)) view.view.dispose?.();
      this.all.length = 1;
      this.activate(this.all[0]);
      this.arrange();
      return;
    }
    for (const mode of this.isFlat ? ["follow"] : ["top", "chase", "board"]) {
      this.add();
      this.active.camera.setMode(mode);
    }
    this.activate(this.all[0]);
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
      pressed(button({ icon: "heat", title: "Infra-red: heat as colour", key: "I", onclick: () => this.look.setInfrared(!this.look.isInfrared) }), this.look.isInfrared),
      pressed(button({ icon: "camera", title: "Save a picture", key: "S", onclick: () => this.picture() }), false),
    );
  }

  say(text, isError) {
    this.note.textContent = text;
    this.note.className = `note ${isError ? "error" : ""} ${text ? "shown" : ""}`;
    clearTimeout(this.noteTimer);
    this.noteTimer = setTimeout(() => this.note.classList.remove("shown"), isError ? 7000 : 3000);
  }

  draw(elapsed) {
    for (const view of this.all) view.draw(this.look, elapsed);
  }

  /** Save the active view as a picture. */
  picture() {
    const { canvas, over } = this.active;
    const whole = el("canvas", { width: canvas.width, height: canvas.height });
    const pen = whole.getContext("2d");
    pen.drawImage(canvas, 0, 0);
    pen.drawImage(over, 0, 0, canvas.width, canvas.height);
    whole.toBlob((blob) => {
      if (!blob) return;
      const url = URL.createObjectURL(blob);
      el("a", { href: url, download: `crs-${this.look.time.toFixed(2)}s.png` }).click();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
      this.say("picture saved");
    });
  }
}
