/** Copy, cut and paste, by the system's clipboard: so also between worlds, and to a text editor. */

/** @param {import("./model.js").Model} model @param {import("./view.js").View} view */
export class Clipboard {
  constructor(model, view) {
    this.model = model;
    this.view = view;
    document.addEventListener("paste", (event) => this.paste(event));
  }

  /** Copy what is selected. */
  async copy() {
    const clip = await this.model.request("copy", { names: [...this.model.selection] });
    await navigator.clipboard?.writeText(clip ?? "").catch(() => {}); // the builder keeps it too
    return clip;
  }

  async cut() {
    if (await this.copy()) await this.model.apply("remove");
  }

  /** @param {ClipboardEvent} event */
  paste(event) {
    const target = /** @type {HTMLElement} */ (event.target);
    if (["INPUT", "TEXTAREA"].includes(target.tagName)) return;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    const step = this.view.step() * 4;
    this.model.paste(text.trimStart().startsWith("<clip") ? text : "", { x: step, y: -step });
    event.preventDefault();
  }
}
