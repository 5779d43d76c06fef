/** Poses that programs ask the user for: a click for the place, another for the direction. */
import { el } from "crs/dom.js";

export class Pointing {
  /** @param {any} model @param {any} views */
  constructor(model, views) {
    this.model = model;
    this.views = views;
    this.note = el("p.pointing", { role: "status" });
    this.note.hidden = true;
    views.root.append(this.note);
    this.robot = -1;
    model.on("state", ({ asks }) => this.show(asks?.[0] ?? -1));
  }

  /** Ask for the pose of a robot, -1 for none. @param {number} robot */
  show(robot) {
    if (robot === this.robot || this.model.run?.role !== "control") return;
    this.robot = robot;
    this.note.hidden = robot < 0;
    this.views.onPlace = null;
    if (robot >= 0) this.askPlace();
  }

  askPlace() {
    const name = this.model.run.world.robots[this.robot].id;
    this.note.textContent = `The program of ${name} asks for a pose: click a position.`;
    this.views.onPlace = (x, y) => this.askDirection(name, x, y);
  }

  askDirection(name, x, y) {
    this.note.textContent = `The program of ${name} asks for a pose: click the direction.`;
    this.views.onPlace = (toX, toY) => {
      const heading = (Math.atan2(toY - y, toX - x) * 180) / Math.PI;
      this.model.request("point", { robot: this.robot, x_m: x, y_m: y, heading_deg: heading });
    };
  }
}
