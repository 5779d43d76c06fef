/** What the user looks at, and how: overlays, colours, sensors; views are drawn by it. */
import { heatColour, maxHeat } from "crs/heat.js";
import { Lighting } from "crs/lighting.js";
import { PARTS } from "crs/overlay.js";
import { RecordedFields } from "crs/recorded_fields.js";
import { palette } from "crs/theme.js";
import { Trails } from "crs/trails.js";

const FLIGHT = 0.7; // how long a message is shown [s]

export class Look {
  /** @param {import("./model.js").Model} model */
  constructor(model) {
    this.model = model;
    this.show = Object.fromEntries(PARTS.map((each) => [each.name, each.on]));
    this.trails = new Trails(() => this.version++);
    this.colours = palette();
    this.isInfrared = false;
    this.isSelectedOnly = false; // what is drawn of other robots is left out
    this.light = new Lighting();
    /** @type {any} the run that this one is compared with, see `compared.js` */
    this.other = null;
    /** @type {{sonar: number, echo: number | null, met: string, robot: number, t: number} | null} the beam that a reading is from */
    this.beam = null;
    this.time = 0;
    this.version = 0; // increases when something must be redrawn
    for (const kind of ["status", "event", "truncate", "hello", "look"]) model.on(kind, () => this.version++);
    for (const kind of ["truncate", "hello"]) model.on(kind, () => (this.trails.isStale = true));
    this.recorded = new RecordedFields([], [], () => {});
    model.on("hello", ({ world, fields }) => (this.recorded = new RecordedFields(world.fields ?? [], fields ?? [], () => this.version++)));
    model.on("block", () => this.trails.refine());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.repaint());
  }

  repaint() {
    this.colours = palette();
    this.version++;
  }

  toggle(name) {
    this.show[name] = !this.show[name];
    this.version++;
    this.model.emit("look");
  }

  setSelectedOnly(isOn) {
    this.isSelectedOnly = isOn;
    this.version++;
  }

  setInfrared(isOn) {
    this.isInfrared = isOn;
    this.version++;
    this.model.emit("look");
  }

  get selected() {
    return this.model.state.robot;
  }

  /** The colour of a heat, or nothing while colours are plain. */
  get heat() {
    if (!this.isInfrared) return null;
    const most = maxHeat(this.model.scene);
    return (heat) => heatColour(heat / most);
  }

  /** The last received sensors of robots, by their rows. */
  get sensors() {
    const { first, sensors } = this.model.status;
    return {
      echoes: (row) => sensors?.echoes?.[row - first],
      bumpers: (row) => sensors?.bumpers?.[row - first],
      believed: (row) => sensors?.believed?.[row - first],
    };
  }

  /** The last received drawings of devices. */
  get devices() {
    return this.model.status.devices;
  }

  /** The displayed pheromone fields: the last received or recorded ones. @returns {import("./field_map.js").FieldMap[]} */
  get fields() {
    return this.show.fields && !this.isInfrared ? (this.devices?.fields ?? this.recorded.at(this.time)) : [];
  }

  /** The events of the last seconds, up to the time that is shown. */
  recent(seconds) {
    const { events } = this.model.run;
    const found = [];
    for (let at = events.length - 1; at >= 0 && events[at][0] > this.time - seconds - 1; at--) {
      if (events[at][0] <= this.time && events[at][0] > this.time - seconds) found.push(events[at]);
    }
    return found;
  }

  /** Messages on their way: from whom to whom. */
  traffic() {
    const names = this.model.run.rosters.at(-1)?.robots ?? [];
    return this.recent(FLIGHT)
      .filter(([, kind]) => kind.startsWith("message"))
      .map(([at, kind, robot, text]) => ({
        from: robot,
        to: names.findIndex((name, row) => row !== robot && text.includes(name)),
        share: (this.time - at) / FLIGHT,
        isLost: kind === "message-lost",
      }))
      .filter(({ to }) => to >= 0);
  }
}
