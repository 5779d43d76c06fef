/** One view of the world: its canvases, its camera, and what the pointer does there. */
import { Camera } from "crs/camera.js";
import { el } from "crs/dom.js";
import { listenToHands } from "crs/gestures.js";
import { Overlay } from "crs/overlay.js";
import { View2D } from "crs/view2d.js";
import { View3D } from "crs/view3d.js";

const STILL = 0.3; // without movement before edges are smooth [s]
const NEAR = 12; // pixels around a robot that still mean it

export class Viewport {
  /**
   * @param {import("./scene.js").Scene} scene
   * @param {any} model
   * @param {{flat: boolean, failed: (reason: string) => void, active: (view: Viewport) => void, placed: (ground: () => any) => boolean}} options
   */
  constructor(scene, model, options) {
    this.model = model;
    this.options = options;
    this.element = el("div.viewport", { tabIndex: 0, role: "application", "aria-label": "view of the world" });
    this.over = el("canvas.over");
    this.overlay = new Overlay(this.over);
    this.isFlat = options.flat;
    this.setScene(scene);
    this.listen();
  }

  setScene(scene) {
    this.scene = scene;
    this.camera = new Camera(scene.area);
    this.setFlat(this.isFlat);
  }

  /** Draw on a plain canvas, or in three dimensions. */
  setFlat(isFlat) {
    this.view?.dispose?.();
    this.canvas = el("canvas.view");
    this.isFlat = isFlat;
    if (!isFlat) {
      try {
        this.view = new View3D(this.scene, this.canvas);
      } catch (error) {
        this.options.failed(`no 3-D view: this browser has no WebGL (${error.message})`);
        this.isFlat = true;
        this.canvas = el("canvas.view");
      }
    }
    if (this.isFlat) this.view = new View2D(this.scene, this.canvas);
    this.element.replaceChildren(this.canvas, this.over);
    this.drawn = "";
  }

  /** Draw if anything has changed. @param {any} look @param {number} elapsed [s] */
  draw(look, elapsed) {
    const body = this.scene.body(look.selected);
    const { clientWidth, clientHeight } = this.element;
    if (!this.isFlat) this.camera.follow(body, elapsed);
    else if (this.camera.mode !== "orbit" && this.camera.mode !== "top" && body) {
      [this.camera.x, this.camera.y] = [body.x, body.y];
    }
    if (this.camera.mustFit && clientHeight) this.camera.fit(clientWidth / clientHeight);
    const key = [this.scene.time, look.version, look.time, look.light.version, this.camera.signature, clientWidth, clientHeight].join();
    if (!clientWidth || !clientHeight) return;
    if (key === this.drawn) {
      this.smooth(body, look, elapsed);
      return;
    }
    this.drawn = key;
    this.stillFor = 0;
    this.view.draw(this.camera, body, look);
    this.overlay.draw(this.view, this.camera, look);
  }

  /** Draw once more with smooth edges when nothing has moved for a while, if the processor draws. */
  smooth(body, look, elapsed) {
    if (!this.view.isSoft || this.stillFor > STILL) return;
    this.stillFor += elapsed;
    if (this.stillFor > STILL) this.view.draw(this.camera, body, look, true);
  }

  listen() {
    const { element } = this;
    listenToHands(element, {
      begin: () => this.options.active(this),
      drag: (dx, dy, moves) => this.drag(dx, dy, moves || this.isFlat),
      pinch: (scale) => this.camera.approach(scale),
      click: (x, y) => this.click(x, y),
    });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("dblclick", () => this.camera.reset());
    element.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.camera.wheel(event.deltaY);
    }, { passive: false });
  }

  drag(dx, dy, moves) {
    const { clientWidth, clientHeight } = this.element;
    if (this.isFlat) {
      const metre = this.camera.metres(clientWidth, clientHeight);
      this.camera.x -= dx * metre;
      this.camera.y += dy * metre;
      if (this.camera.mode !== "top") this.camera.mode = "orbit";
    } else this.camera.drag(dx, dy, moves, clientWidth, clientHeight);
  }

  /** Select the robot under a point. */
  click(px, py) {
    const { clientWidth, clientHeight } = this.element;
    if (this.options.placed?.(() => this.view.ground(px, py, this.camera, clientWidth, clientHeight))) return;
    let [nearest, least] = [-1, Infinity];
    for (const body of this.scene.bodies) {
      const [x, y, w] = this.view.project(body.x, body.y, body.z + body.height / 2);
      if (w <= 0) continue;
      const away = Math.hypot(x - px, y - py);
      const reach = Math.max(NEAR, 1.2 * body.radius * this.view.pixels(w));
      if (away < reach && away < least) [nearest, least] = [body.row, away];
    }
    if (nearest >= 0) this.model.select(nearest);
  }
}
