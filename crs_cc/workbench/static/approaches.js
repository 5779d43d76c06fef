/** The close approaches in the known part of the run: requested when it stops, and periodically. */
import { oneAtATime } from "crs/one_at_a_time.js";

const EVERY = 3000; // while the run advances [ms]
const SHARE = 0.03; // of the time of an advancing run

export class Approaches {
  /** @param {any} model */
  constructor(model) {
    this.model = model;
    /** @type {[number, string, number, string, number, number, number][]} like events, and the distance [m]; the closest first */
    this.all = [];
    this.asked = "";
    this.askedAt = 0;
    this.took = 0;
    this.refresh = oneAtATime(() => this.find());
    for (const kind of ["state", "look"]) model.on(kind, () => this.refresh());
    model.on("hello", () => (this.asked = ""));
    model.on("truncate", ({ time_s }) => {
      this.all = this.all.filter(([time]) => time <= time_s + 1e-9);
      this.asked = "";
      model.emit("near");
    });
  }

  /** Those that are not events of the run: contacts are collisions. */
  get events() {
    return this.all.filter((each) => !isContact(each[6]));
  }

  /** The closest one, of a robot or of all. @param {number | null} row */
  closest(row = null) {
    return this.all.find((each) => row === null || each[2] === row) ?? null;
  }

  async find() {
    const { model } = this;
    const { playing, busy, end, robot } = model.state;
    const what = `${end} ${robot}`;
    if (!model.isConnected || model.channel.isLocal || what === this.asked) return;
    if ((playing || busy) && performance.now() - this.askedAt < Math.max(EVERY, this.took / SHARE)) return;
    this.askedAt = performance.now();
    try {
      const { approaches } = await model.channel.request("near", { robot });
      this.took = performance.now() - this.askedAt;
      this.asked = what;
      const names = model.run.rosters.at(-1)?.robots ?? [];
      this.all = approaches.map(([time, row, other, gap, x, y]) =>
        [time, "near", row, `${names[row]} ${isContact(gap) ? "touched" : `came to ${distanceText(gap)} of`} ${other}`, x, y, gap]);
      model.emit("near");
    } catch {
      // the connection is lost, or the robot is no more
    }
  }
}

const isContact = (gap) => gap < 0.0005;
const distanceText = (gap) => (gap < 0.1 ? `${(gap * 100).toFixed(1)} cm` : `${gap.toFixed(2)} m`);
