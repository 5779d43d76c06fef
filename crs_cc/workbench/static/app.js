/** The page: a run that goes on, or one that the page holds. */
import { SocketChannel } from "crs/channel.js";
import { button, el, part } from "crs/dom.js";
import { Drawer } from "crs/drawer.js";
import { Instruments } from "crs/instruments.js";
import { listenToKeys } from "crs/keys.js";
import { Layout } from "crs/layout.js";
import { Look } from "crs/look.js";
import { Model } from "crs/model.js";
import { PageChannel } from "crs/page_channel.js";
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
page.timeline = new Timeline(part("time"), model, look);
page.drawer = new Drawer(part("time"), model);
page.instruments = new Instruments(model);
page.layout = new Layout(model, look, page);
listenToKeys(page);

const start = button({ icon: "play", text: "Run", title: "Let the run begin", className: "start", onclick: () => model.ask("play") });
start.hidden = true;
part("world").append(start);

let isFirst = true;
model.on("hello", () => {
  model.scene = new Scene(model.run);
  page.views.setScene(model.scene);
  const wanted = Number(new URLSearchParams(location.hash.slice(1)).get("t"));
  if (isFirst && wanted > 0) page.timeline.seek(wanted);
  isFirst = false;
});
model.on("state", (state) => {
  start.hidden = !(model.can("play") && !state.playing && !state.busy && state.t === 0 && state.halt.reason !== "goto");
});

const held = part("run").textContent.trim();
model.channel = held ? new PageChannel(JSON.parse(held), (message) => model.hear(message)) : new SocketChannel((message) => model.hear(message));

let last = performance.now();
let isBusy = false;
async function tick(now) {
  requestAnimationFrame(tick);
  const elapsed = Math.min(0.25, (now - last) / 1000);
  last = now;
  if (isBusy || !model.frames) return;
  isBusy = true;
  try {
    model.channel.advance?.(elapsed);
    const time = model.clock.advance(elapsed);
    const frame = await model.frames.at(time);
    if (frame) {
      model.scene.place(frame);
      look.time = time;
      look.trails.update(model.scene, model.frames, time);
      page.views.draw(elapsed);
    }
    page.timeline.show(time);
    model.tell("tick", time);
    document.body.dataset.time = time.toFixed(3);
  } catch (error) {
    if (model.isConnected) console.error(error);
  } finally {
    isBusy = false;
  }
}
requestAnimationFrame(tick);
Object.assign(window, { crs: page, el });
