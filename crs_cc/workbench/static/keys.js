/** The keyboard: every button has a key; `?` shows them. */
import { el } from "crs/dom.js";
import { PANELS } from "crs/panels/index.js";

/**
 * @param {any} page
 * @returns {{keys: string[], text: string, does: () => void}[]}
 */
function table(page) {
  const { timeline, views, layout, look, model } = page;
  const run = (line) => model.can("debug") && page.console(line);
  const robots = () => model.run.rosters.at(-1)?.robots.length ?? 1;
  const mode = (name) => () => views.setMode(name);
  return [
    { keys: [" "], text: "play or pause", does: () => timeline.toggle() },
    { keys: ["ArrowRight"], text: "one timestep forward", does: () => timeline.step(1) },
    { keys: ["ArrowLeft"], text: "one timestep back", does: () => timeline.step(-1) },
    { keys: ["Shift+ArrowRight"], text: "one second forward", does: () => timeline.seek(model.clock.shown + 1) },
    { keys: ["Shift+ArrowLeft"], text: "one second back", does: () => timeline.seek(model.clock.shown - 1) },
    { keys: ["Shift+ArrowDown"], text: "ten seconds back", does: () => timeline.back(10) },
    { keys: ["n"], text: "next event", does: () => timeline.jump(1) },
    { keys: ["p"], text: "previous event", does: () => timeline.jump(-1) },
    { keys: ["Home"], text: "to the start", does: () => timeline.seek(0) },
    { keys: ["End"], text: "to the latest time", does: () => (model.can("seek") ? timeline.seek(model.state.end) : timeline.release()) },
    { keys: ["+", "="], text: "faster", does: () => timeline.faster(1) },
    { keys: ["-"], text: "slower", does: () => timeline.faster(-1) },
    { keys: ["."], text: "go to a time, or by a number of seconds", does: () => timeline.enter() },
    { keys: ["["], text: "repeat from here", does: () => timeline.bound(0) },
    { keys: ["]"], text: "repeat up to here", does: () => timeline.bound(1) },
    { keys: ["l"], text: "repeat the last five seconds", does: () => timeline.loop() },
    { keys: ["1"], text: "camera: orbit", does: mode("orbit") },
    { keys: ["2"], text: "camera: top", does: mode("top") },
    { keys: ["3"], text: "camera: follow", does: mode("follow") },
    { keys: ["4"], text: "camera: chase", does: mode("chase") },
    { keys: ["5"], text: "camera: on board", does: mode("board") },
    { keys: ["0"], text: "camera: reset", does: () => views.active.camera.reset() },
    { keys: ["w"], text: "rotate the camera up", does: () => views.active.drag(0, 20, false) },
    { keys: ["x"], text: "rotate the camera down", does: () => views.active.drag(0, -20, false) },
    { keys: ["a"], text: "rotate the camera left", does: () => views.active.drag(30, 0, false) },
    { keys: ["d"], text: "rotate the camera right", does: () => views.active.drag(-30, 0, false) },
    { keys: ["q"], text: "nearer", does: () => views.active.camera.wheel(-100) },
    { keys: ["e"], text: "farther", does: () => views.active.camera.wheel(100) },
    { keys: ["ArrowDown"], text: "next robot", does: () => model.select((model.state.robot + 1) % robots()) },
    { keys: ["ArrowUp"], text: "previous robot", does: () => model.select((model.state.robot + robots() - 1) % robots()) },
    { keys: ["v"], text: "one view or four", does: () => views.split() },
    { keys: ["f"], text: "2-D or 3-D", does: () => views.setFlat(!views.isFlat) },
    { keys: ["i"], text: "infrared view", does: () => look.setInfrared(!look.isInfrared) },
    { keys: ["m"], text: "menu of the view", does: () => views.menu.toggle() },
    { keys: ["Escape"], text: "close the menu", does: () => views.menu.close() },
    { keys: ["r"], text: "start or stop a video", does: () => views.video.toggle() },
    { keys: ["s"], text: "save a picture", does: () => views.picture() },
    { keys: ["k"], text: "copy a link", does: () => layout.share() },
    { keys: ["t"], text: "light or dark theme", does: () => layout.nextTheme() },
    { keys: ["F5"], text: "continue to a breakpoint", does: () => run("continue") },
    { keys: ["Shift+F5"], text: "continue backward", does: () => run("reverse-continue") },
    { keys: ["F10"], text: "next line", does: () => run("next") },
    { keys: ["F11"], text: "next line, into calls", does: () => run("step") },
    { keys: ["Shift+F10"], text: "previous line", does: () => run("reverse-next") },
    { keys: ["Shift+F11"], text: "previous line, into calls", does: () => run("reverse-step") },
    { keys: ["F8", "Shift+F12"], text: "out of the function", does: () => run("finish") },
    { keys: ["Shift+F8"], text: "back to the call", does: () => run("reverse-finish") },
    { keys: ["F9", "b"], text: "breakpoint at the marked line", does: () => page.code?.toggle() },
    { keys: ["Shift+F9"], text: "its condition, log text, ...", does: () => page.code?.edit() },
    { keys: ["h"], text: "run to the marked line", does: () => page.code?.runTo() },
    { keys: ["o"], text: "next source file", does: () => page.code?.nextFile() },
    { keys: ["u"], text: "frame of the caller", does: () => run("up") },
    { keys: ["j"], text: "frame of the callee", does: () => run("down") },
    { keys: ["z"], text: "widen the code panel", does: () => page.code?.zoom() },
    ...PANELS.filter((panel) => panel.key).map((panel) => ({ keys: [panel.key], text: panel.summary.toLowerCase(), does: () => page.drawer.toggle(panel.id) })),
    { keys: ["6"], text: "the selected robot", does: () => layout.open("robot") },
    { keys: ["7"], text: "faults", does: () => layout.open("faults") },
    { keys: ["8"], text: "changes", does: () => layout.open("changes") },
    { keys: ["c"], text: "focus the console", does: () => { layout.open("console"); page.focusConsole?.(); } },
    { keys: ["?"], text: "show or hide the keys", does: () => page.keys() },
  ];
}

const SHOWN = { " ": "Space", ArrowRight: "→", ArrowLeft: "←", ArrowUp: "↑", ArrowDown: "↓" };
const shownKey = (key) => key.split("+").map((word) => SHOWN[word] ?? (word.length === 1 ? word.toUpperCase() : word)).join("+") || key;

/** @param {any} page */
export function listenToKeys(page) {
  const rows = table(page);
  const byKey = new Map(rows.flatMap((row) => row.keys.map((key) => [key, row])));
  const dialog = el("dialog.keys", { "aria-label": "keys" },
    // With the focus at the button below, the browser would scroll there.
    el("h2", { tabIndex: -1, autofocus: true }, "Keys"),
    el("div.rows", {}, ...rows.map((row) => el("div", {}, el("kbd", {}, row.keys[0] === "+" ? "+" : shownKey(row.keys[0])), el("span", {}, row.text)))),
    el("form", { method: "dialog" }, el("button", {}, "Close")));
  document.body.append(dialog);
  page.keys = () => (dialog.open ? dialog.close() : dialog.showModal());
  // A click leaves the focus at its button, where Space would press that again rather than play.
  addEventListener("click", (event) => {
    const isByPointer = event.detail > 0;
    if (isByPointer && event.target instanceof Element) event.target.closest("button")?.blur();
  });
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = /** @type {HTMLElement} */ (event.target);
    if (target.matches("input[type=text], textarea") || (target.matches("select") && event.key.length > 1)) return;
    if (target.matches("button, input, label") && event.key === " ") return;
    const isLetter = event.key.length === 1;
    const name = event.shiftKey && !isLetter ? `Shift+${event.key}` : isLetter ? event.key.toLowerCase() : event.key;
    const row = byKey.get(name);
    if (!row || (dialog.open && event.key !== "?")) return;
    event.preventDefault();
    row.does();
  });
}
