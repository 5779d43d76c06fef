/** 3-D view of the world, by the renderer of the viewer: looked at, selected and moved while it is edited. */

import { el } from "../dom.js";
import { palette } from "../theme.js";

const CLICK = 5; // pixels that a click may move
const CHOSEN = "#ffd400"; // no robot has it
const FREE = 1e-4; // the step without snapping [m]

export class Solid {
  /** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
  constructor(model, view) {
    /** @type {any} */
    this.camera = null;
    this.model = model;
    this.view = view;
    this.element = el("div.solid", { hidden: true, tabIndex: 0, "aria-label": "3-D view of the world" });
    this.isOn = false;
    this.hint = "Drag to rotate the view, Shift-drag to pan; click an element to select it, then drag it";
    /** @type {any} */
    this.drag = null;
    this.isAsking = false;
    for (const kind of ["change", "select"]) model.addEventListener(kind, () => this.renew());
    new ResizeObserver(() => this.draw()).observe(this.element);
    this.listen();
  }

  async toggle() {
    this.isOn = !this.isOn;
    this.element.hidden = !this.isOn;
    this.model.emit("tool");
    if (this.isOn) await this.renew();
    else {
      this.drag = null;
      this.drop();
    }
  }

  drop() {
    this.picture?.dispose();
    this.picture = null;
    this.element.replaceChildren();
  }

  /** Redraw the picture; changes made in the meantime appear in the next one. */
  async renew() {
    this.isStale = true;
    if (!this.isOn || this.isAsking) return;
    this.isAsking = true;
    while (this.isOn && this.isStale) {
      this.isStale = false;
      const world = await this.model.request("scene");
      if (world && this.isOn) await this.make(world).catch((error) => this.model.notify(`no 3-D view: ${error.message}`, true));
    }
    this.isAsking = false;
  }

  /** @param {any} world as the viewer has it */
  async make(world) {
    const [{ View3D }, { Scene }, { Camera }, { Lighting }] = await Promise.all([import("../view3d.js"), import("../scene.js"), import("../camera.js"), import("../lighting.js")]);
    if (!this.isOn) return; // closed meanwhile
    const colours = palette();
    const names = world.robots.map((robot) => robot.id);
    const scene = new Scene({ world, rosters: [{ t: 0, robots: names, objects: [] }] });
    const starts = world.robots.map((robot) => robot.start);
    scene.place({ time: 0, rows: names.length, columns: 3, values: Float32Array.from([0, 1, 2].flatMap((axis) => starts.map((start) => start[axis]))) });
    for (const each of [...scene.shapes, ...scene.bodies]) if (this.isChosen(each.id)) each.colour = CHOSEN;
    this.drop();
    const canvas = el("canvas");
    this.element.append(canvas);
    this.picture = new View3D(scene, canvas);
    this.camera ??= new Camera(scene.area);
    this.look = { colours, show: { grid: true }, heat: null, fields: [], light: new Lighting() };
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
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("pointerdown", (event) => {
      element.focus();
      element.setPointerCapture(event.pointerId);
      this.drag = { x: event.clientX, y: event.clientY, way: 0, by: [0, 0], grasp: this.grasp(event) };
    });
    element.addEventListener("pointermove", (event) => this.follow(event));
    element.addEventListener("pointerup", (event) => this.release(event));
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.camera?.wheel(event.deltaY);
      this.draw();
    }, { passive: false });
  }

  /** What a press has taken hold of, if it is selected: where, and what else moves with it. */
  grasp(event) {
    const under = event.button === 0 && !event.shiftKey ? this.under(event) : null;
    if (!under || !this.model.selection.has(under.name) || !this.model.mayChange) return null;
    const { scene } = this.picture;
    const moved = [...scene.shapes, ...scene.bodies].filter((each) => this.isChosen(each.id));
    return { ...under, moved: moved.map((each) => ({ each, x: each.x, y: each.y })) };
  }

  follow(event) {
    const { drag, element } = this;
    if (!drag || !this.camera) return;
    const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
    Object.assign(drag, { x: event.clientX, y: event.clientY, way: drag.way + Math.abs(dx) + Math.abs(dy) });
    if (drag.grasp) this.carry(event, drag);
    else this.camera.drag(dx, dy, event.shiftKey || event.buttons > 1, element.clientWidth, element.clientHeight);
    this.draw();
  }

  /** Move what is selected over the floor, at the height at which it was taken. */
  carry(event, drag) {
    const { clientWidth, clientHeight } = this.element;
    const { place, height, moved } = drag.grasp;
    const to = this.picture.ground(event.offsetX, event.offsetY, this.camera, clientWidth, clientHeight, height);
    if (!to) return;
    const step = event.altKey ? FREE : this.view.step();
    drag.by = [0, 1].map((axis) => Math.round((to[axis] - place[axis]) / step) * step);
    for (const { each, x, y } of moved) [each.x, each.y] = [x + drag.by[0], y + drag.by[1]];
  }

  async release(event) {
    const { drag } = this;
    this.drag = null;
    if (!drag) return;
    if (drag.way < CLICK) this.pick(event);
    else if (drag.grasp && (drag.by[0] || drag.by[1])) {
      await this.model.apply("move", { values: { x: drag.by[0], y: drag.by[1] } });
    }
  }

  /** The element under the pointer, and its position: an object, or part of the ground. */
  under(event) {
    const { clientWidth, clientHeight } = this.element;
    if (!this.picture?.lens || this.model.inside) return null;
    const hit = this.picture.object(event.offsetX, event.offsetY, clientWidth, clientHeight);
    const name = hit && this.nameOf(hit.id);
    if (hit && name) return { ...hit, name };
    const place = this.picture.ground(event.offsetX, event.offsetY, this.camera, clientWidth, clientHeight);
    return place && { name: this.view.at(place), place, height: 0 };
  }

  /** The element that a shape belongs to, if the mouse may take it. */
  nameOf(id) {
    const { model } = this;
    const found = model.items.find(({ name }) => id === name || id.startsWith(`${name}.`));
    return found && model.isFree(found.name) ? found.name : "";
  }

  pick(event) {
    const name = this.under(event)?.name;
    const { selection } = this.model;
    if (!event.shiftKey) this.model.select(name ? [name] : []);
    else if (name) this.model.select(selection.has(name) ? [...selection].filter((each) => each !== name) : [...selection, name]);
  }
}
