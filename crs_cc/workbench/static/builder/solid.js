/** The world in three dimensions, by the renderer of the viewer, to be looked at while it is edited. */

import { el } from "../dom.js";
import { palette } from "../theme.js";

const CLICK = 5; // pixels that a click may move

export class Solid {
  /** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
  constructor(model, view) {
    /** @type {any} */
    this.camera = null;
    this.model = model;
    this.view = view;
    this.element = el("div.solid", { hidden: true, tabIndex: 0, "aria-label": "The world in three dimensions" });
    this.isOn = false;
    this.isAsking = false;
    for (const kind of ["change", "select"]) model.addEventListener(kind, () => this.renew());
    new ResizeObserver(() => this.draw()).observe(this.element);
    this.listen();
  }

  async toggle() {
    this.isOn = !this.isOn;
    this.element.hidden = !this.isOn;
    this.model.tell("tool");
    if (this.isOn) await this.renew();
    else this.drop();
  }

  drop() {
    this.picture?.dispose();
    this.picture = null;
    this.element.replaceChildren();
  }

  /** Make the picture anew; what comes meanwhile is shown by the next. */
  async renew() {
    this.isStale = true;
    if (!this.isOn || this.isAsking) return;
    this.isAsking = true;
    while (this.isOn && this.isStale) {
      this.isStale = false;
      const world = await this.model.ask("scene");
      if (world && this.isOn) await this.make(world).catch((error) => this.model.say(`no 3-D view: ${error.message}`));
    }
    this.isAsking = false;
  }

  /** @param {any} world as the viewer has it */
  async make(world) {
    const [{ View3D }, { Scene }, { Camera }, { Lighting }] = await Promise.all([import("../view3d.js"), import("../scene.js"), import("../camera.js"), import("../lighting.js")]);
    const colours = palette();
    const names = world.robots.map((robot) => robot.id);
    const scene = new Scene({ world, rosters: [{ t: 0, robots: names, objects: [] }] });
    const starts = world.robots.map((robot) => robot.start);
    scene.place({ time: 0, rows: names.length, columns: 3, values: Float32Array.from([0, 1, 2].flatMap((axis) => starts.map((start) => start[axis]))) });
    for (const each of [...scene.shapes, ...scene.bodies]) if (this.isChosen(each.id)) each.colour = colours.accent;
    this.drop();
    const canvas = el("canvas");
    this.element.append(canvas);
    this.picture = new View3D(scene, canvas);
    this.camera ??= new Camera(scene.area);
    this.look = { colours, show: { grid: true }, heat: null, light: new Lighting() };
    this.draw();
  }

  /** Whether something is selected, or a part of what is. */
  isChosen(id) {
    return [...this.model.selection].some((name) => id === name || id.startsWith(`${name}.`));
  }

  draw() {
    const { clientWidth, clientHeight } = this.element;
    if (!this.picture || !clientWidth || !clientHeight) return;
    if (this.camera.mustFit) this.camera.fit(clientWidth / clientHeight);
    this.picture.draw(this.camera, null, this.look, true);
  }

  listen() {
    const { element } = this;
    /** @type {any} */
    let drag = null;
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      drag = { x: event.clientX, y: event.clientY, way: 0 };
    });
    element.addEventListener("pointermove", (event) => {
      if (!drag || !this.camera) return;
      const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
      drag = { x: event.clientX, y: event.clientY, way: drag.way + Math.abs(dx) + Math.abs(dy) };
      this.camera.drag(dx, dy, event.shiftKey || event.buttons > 1, element.clientWidth, element.clientHeight);
      this.draw();
    });
    element.addEventListener("pointerup", (event) => {
      if (drag && drag.way < CLICK) this.pick(event);
      drag = null;
    });
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.camera?.wheel(event.deltaY);
      this.draw();
    }, { passive: false });
  }

  /** Select what stands at a point of the floor. */
  pick(event) {
    const { clientWidth, clientHeight } = this.element;
    const point = this.picture?.ground(event.offsetX, event.offsetY, this.camera, clientWidth, clientHeight);
    if (!point || this.model.inside) return;
    const name = this.view.at(point);
    this.model.select(name ? [name] : []);
  }
}
