/** The page: a live run, or one that the page contains. */
import { SocketChannel } from "crs/channel.js";
import { Compared } from "crs/compared.js";
import { button, el, part } from "crs/dom.js";
import { Drawer } from "crs/drawer.js";
import { listenToFiles } from "crs/dropped.js";
import { Found } from "crs/found.js";
import { Instruments } from "crs/instruments.js";
import { listenToKeys } from "crs/keys.js";
import { Layout } from "crs/layout.js";
import { Look } from "crs/look.js";
import { Model } from "crs/model.js";
import { PageChannel } from "crs/page_channel.js";
import { Pointing } from "crs/pointing.js";
import { Scene } from "crs/scene.js";
import { restoreTheme } from "crs/theme.js";
import { Timeline } from "crs/timeline.js";
import { Views } from "crs/views.js";

restoreTheme();
const model = new Model();
const look = new Look(model);
/** @type {any} what panels may use of each other */
const page = { model, look };
page.views = new Views(part("world"), model, look);
page.timeline = new Timeline(part("time"), model, look, page);
page.drawer = new Drawer(part("time"), model);
page.instruments = new Instruments(model);
page.found = new Found(model, page);
page.compared = new Compared(model, look, page);
page.layout = new Layout(model, look, page);
listenToKeys(page);
listenToFiles(page);
new Pointing(model, page.views);

/** Go to a place in the run, as answers have it, and select a robot. @param {string} place @param {number} robot */
page.go = (place, robot = -1) => {
  model.clock.held = null;
  if (model.state.busy) model.request("pause");
  return model.request("go", { place, robot });
};
/** Go to a happening: to its place, if it is known, or else to its time. @param {any[]} happening */
page.goTo = ([time, , robot, , , , , place]) => (place && model.can("debug") ? page.go(place, robot) : page.timeline.seek(time));

/** The run that a page holds which was written to a file; empty where a server runs it. */
const held = part("run").textContent.trim();
const start = button({ icon: "play", text: held ? "Play" : "Run", title: held ? "Play the recording" : "Start the run", className: "start", onclick: () => model.request("play") });
start.hidden = true;
part("world").append(start);

/** The time in the address: a shared link, or an editor in whose window this page is. */
const wantedTime = () => Number(new URLSearchParams(location.hash.slice(1)).get("t"));
let isFirst = true;
model.on("hello", () => {
  model.scene = new Scene(model.run);
  page.views.setScene(model.scene);
  if (isFirst && wantedTime() > 0) page.timeline.seek(wantedTime());
  isFirst = false;
});
addEventListener("hashchange", () => wantedTime() > 0 && page.timeline.seek(wantedTime()));
model.on("state", (state) => {
  start.hidden = !(model.can("play") && !state.playing && !state.busy && state.t === 0 && state.halt.reason !== "goto");
});

model.channel = held ? new PageChannel(JSON.parse(held), (message) => model.handle(message)) : new SocketChannel((message) => model.handle(message));

// A picture in which nothing moves is drawn now and then only: software drawing takes a whole core.
const STILL_AFTER_MS = 1500;
const STILL_EVERY_MS = 500;
let movedAt = performance.now();
const wake = () => (movedAt = performance.now());
for (const kind of ["pointermove", "pointerdown", "pointerup", "wheel", "keydown", "resize", "visibilitychange"]) {
  addEventListener(kind, wake, { capture: true, passive: true });
}
for (const kind of ["hello", "state"]) model.on(kind, wake);

let last = performance.now();
let shown = NaN;
let isBusy = false;
async function tick(now) {
  requestAnimationFrame(tick);
  if (model.clock.isPlaying || (model.clock.held ?? model.clock.shown) !== shown) wake();
  else if (now - movedAt > STILL_AFTER_MS && now - last < STILL_EVERY_MS) return;
  const elapsed = Math.min(0.25, (now - last) / 1000);
  last = now;
  if (isBusy || !model.frames) return;
  isBusy = true;
  try {
    model.channel.advance?.(elapsed);
    const time = model.clock.advance(elapsed);
    shown = time;
    const frame = await model.frames.at(time);
    if (frame) {
      model.scene.place(frame);
      await page.compared.place(time);
      look.time = time;
      look.trails.update(model.scene, model.frames, time);
      page.views.draw(elapsed);
    }
    page.timeline.show(time);
    model.emit("tick", time);
    document.body.dataset.time = time.toFixed(3);
  } catch (error) {
    if (model.isConnected) console.error(error);
  } finally {
    isBusy = false;
  }
}
requestAnimationFrame(tick);
Object.assign(window, { crs: page, el });
