/** Light in the view: day and night, and lamps of the user's own. The run knows nothing of it. */

const MAX = 8; // lamps: each costs time for every picture
const KEY = "crs-light";

export class Lighting {
  constructor() {
    this.day = 1; // 0 is night
    this.sun = -125; // direction of the sun [degrees from the x axis]
    /** @type {{x: number, y: number, z: number, bright: number}[]} */
    this.lamps = [];
    this.version = 0;
  }

  /** @param {{day?: number, sun?: number}} changes */
  set(changes) {
    Object.assign(this, changes);
    this.version++;
  }

  /** Add a lamp; @returns whether there was room for it. */
  add(x, y) {
    if (this.lamps.length >= MAX) return false;
    this.lamps.push({ x, y, z: 1.2, bright: 1 });
    this.version++;
    return true;
  }

  change(number, changes) {
    Object.assign(this.lamps[number], changes);
    this.version++;
  }

  remove(number) {
    this.lamps.splice(number, 1);
    this.version++;
  }

  save() {
    const { day, sun, lamps } = this;
    return { day, sun, lamps: lamps.map((lamp) => ({ ...lamp })) };
  }

  restore(saved) {
    if (!saved) return;
    this.day = Math.min(1, Math.max(0, Number(saved.day ?? 1)));
    this.sun = Number(saved.sun ?? -125);
    this.lamps = (saved.lamps ?? []).slice(0, MAX);
    this.version++;
  }
}

/** Views that are kept by name in this browser: cameras and light. */
export class SavedViews {
  /** @returns {{name: string, cameras: string, light: any}[]} */
  all() {
    try {
      return JSON.parse(localStorage.getItem(KEY) ?? "[]");
    } catch {
      return [];
    }
  }

  keep(name, cameras, light) {
    const others = this.all().filter((each) => each.name !== name);
    this.write([...others, { name, cameras, light }].slice(-20));
  }

  remove(name) {
    this.write(this.all().filter((each) => each.name !== name));
  }

  write(list) {
    try {
      localStorage.setItem(KEY, JSON.stringify(list));
    } catch {
      // a page from disk may have no storage
    }
  }
}
