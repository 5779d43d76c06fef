/** Instants that a question has found: marks on the timeline, through which one steps. */

export class Found {
  /** @param {any} model @param {any} page */
  constructor(model, page) {
    this.model = model;
    this.page = page;
    model.on("hello", () => (model.found = { title: "", rows: [] }));
    model.on("truncate", ({ time_s }) => {
      model.found = { ...model.found, rows: model.found.rows.filter(([t]) => t <= time_s + 1e-9) };
    });
  }

  /**
   * Ask when something was so; mark the answer.
   * @param {string} name of the command: `when`, `log_messages`, `hits` @param {Record<string, any>} fields @param {string} title
   * @returns {Promise<string>} the error; empty if there is none
   */
  async search(name, fields, title) {
    const { model, page } = this;
    try {
      const rows = await model.channel.request(name, fields);
      this.set(rows, title);
      page.timeline.jumpTo(rows.length ? "found" : "any");
      model.notify(rows.length ? `${title}: ${rows.length === 1 ? "once" : `${rows.length} times`}. ‹ and › step through them (P, N).` : `${title}: never, in the run so far`);
      return "";
    } catch (error) {
      return error.message;
    }
  }

  /** @param {any[][]} rows time, number, text, place, robot @param {string} title */
  set(rows, title) {
    this.model.found = { title, rows };
    this.model.emit("found");
  }

  clear() {
    this.set([], "");
    this.page.timeline.jumpTo("any");
  }

  /** Go to the next instant, or the one before. @param {number} way 1 or -1 */
  step(way) {
    const { model, page } = this;
    const now = hereOf(model);
    const rows = model.found.rows.filter(([, , , place]) => compared(place.split(".").map(Number), now) * way > 0);
    const next = way > 0 ? rows[0] : rows.at(-1);
    if (next) page.go(next[3], next[4]);
    else model.notify(way > 0 ? "no later one was found" : "no earlier one was found");
  }
}

/** Where the run is: its place, or the start of the timestep that is shown. @returns {number[]} */
function hereOf({ position, state, clock, run }) {
  const time = clock.held ?? state.t;
  if (position && clock.held === null && Math.abs(position.t - time) < 1e-9) return position.place.split(".").map(Number);
  return [Math.round(time / run.timestep_s), 0, -1, 0];
}

/** @param {number[]} one @param {number[]} other */
function compared(one, other) {
  const at = one.findIndex((each, index) => each !== other[index]);
  return at < 0 ? 0 : one[at] - other[at];
}
