/** The menu of the view: how many views, saved ones, light, and what can be saved as a file. */
import { button, el, fill } from "crs/dom.js";
import { SavedViews } from "crs/lighting.js";

export class ViewMenu {
  /** @param {any} views */
  constructor(views) {
    this.views = views;
    this.saved = new SavedViews();
    this.element = el("div.menu", { role: "dialog", "aria-label": "view", hidden: true, onkeydown: (event) => {
      event.stopPropagation();
      if (event.key === "Escape") this.close();
    } });
  }

  toggle() {
    this.element.hidden = !this.element.hidden;
    if (!this.element.hidden) this.draw();
    this.views.showBar();
  }

  close() {
    if (!this.element.hidden) this.toggle();
  }

  draw() {
    const { views } = this;
    const light = views.look.light;
    const choice = (count) => {
      const made = button({ text: String(count), title: count === 1 ? "One view" : `${count} views side by side`, onclick: () => {
        views.setCount(count);
        this.draw();
      } });
      made.setAttribute("aria-pressed", String(views.all.length === count));
      return made;
    };
    const slider = (name, value, [min, max, step], change) =>
      el("label.slider", {}, el("span", {}, name), el("input", { type: "range", min, max, step, value, oninput: (event) => change(Number(event.target.value)) }));
    const name = el("input", { type: "text", placeholder: "name of this view", "aria-label": "name of this view", maxLength: 40 });
    const keep = () => {
      this.saved.keep(name.value.trim() || `at ${views.look.time.toFixed(1)} s`, views.cameras(), light.save());
      this.draw();
    };
    fill(this.element,
      el("h3", {}, "Views"),
      el("div.row", {}, el("div.segmented", {}, ...[1, 2, 4].map(choice))),
      ...this.saved.all().map((each) => el("div.row", {},
        button({ text: each.name, title: "Show this view", className: "saved", onclick: () => {
          views.restore(each.cameras);
          light.restore(each.light);
          this.draw();
        } }),
        button({ text: "×", title: `Delete ${each.name}`, className: "small", onclick: () => {
          this.saved.remove(each.name);
          this.draw();
        } }))),
      el("form.row", { onsubmit: (event) => {
        event.preventDefault();
        keep();
      } }, name, button({ text: "Keep", title: "Save cameras and light under this name", onclick: keep })),
      el("h3", {}, "Light"),
      slider("Day", light.day, [0, 1, 0.05], (day) => light.set({ day })),
      slider("Sun from", light.sun, [-180, 180, 5], (sun) => light.set({ sun })),
      ...light.lamps.map((lamp, number) => el("div.row", {},
        slider(`Lamp ${number + 1}`, lamp.bright, [0, 3, 0.1], (bright) => light.change(number, { bright })),
        button({ text: "Move", title: "Then click its position", onclick: () => this.put((x, y) => light.change(number, { x, y })) }),
        button({ text: "×", title: `Remove lamp ${number + 1}`, className: "small", onclick: () => {
          light.remove(number);
          this.draw();
        } }))),
      el("div.row", {}, button({ text: "Add a lamp", title: "Then click its position", onclick: () => this.put((x, y) => light.add(x, y) || views.notify("no more lamps: eight at most", true)) })),
      el("h3", {}, "Save"),
      el("div.row", {},
        button({ text: "Picture", title: "Save the views as a picture", key: "S", onclick: () => views.picture() }),
        button({ text: views.video.isOn ? "Stop the video" : "Video", title: "Start or stop recording a video of the views", key: "R", onclick: () => {
          views.video.toggle();
          this.draw();
        } }),
        views.model.channel.isLocal ? null : button({ text: "Web page", title: "Save the run as one file that opens in any browser", onclick: () => views.exportPage() }),
        views.model.can("debug") && views.model.run.kind === "live" ? button({ text: "Recording", title: "Save the run up to here, with programs, notes and breakpoints, for crs debug and crs replay", onclick: () => views.exportRecording() }) : null));
  }

  /** Have something put where the user clicks next. */
  put(act) {
    this.views.notify("click the position of the lamp");
    this.views.onPlace = (x, y) => {
      act(x, y);
      this.draw();
    };
  }
}
