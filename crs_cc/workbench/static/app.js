/** The page of a recorded run. */
import { Frames } from "crs/frames.js";
import { Scene } from "crs/scene.js";
import { Timeline } from "crs/timeline.js";
import { View2D } from "crs/view2d.js";
import { View3D } from "crs/view3d.js";

const SHOWN_LINES = 200;
const part = (id) => document.getElementById(id);
const run = JSON.parse(part("run").textContent);
const scene = new Scene(run);
const frames = new Frames(run.blocks, run.frame_s);
const timeline = new Timeline(run.end_s, run.events, {
  slider: part("slider"),
  marks: part("marks"),
  play: part("play"),
  speed: part("speed"),
  clock: part("clock"),
});
const views = { flat: new View2D(scene, part("flat")), solid: null };
let current = "flat";

part("title").textContent = run.title;
part("note").textContent = run.note;
for (const id of ["", ...run.rosters.at(-1).robots.slice(0, 500)]) {
  const option = document.createElement("option");
  [option.value, option.textContent] = [id, id || "nobody"];
  part("follow").append(option);
}

function show(name) {
  if (name === "solid" && !views.solid) {
    try {
      views.solid = new View3D(scene, part("solid"));
    } catch (error) {
      part("note").textContent = `no 3-D view: this browser has no WebGL (${error.message})`;
      return;
    }
  }
  current = name;
  for (const id of ["flat", "solid"]) part(id).hidden = id !== name;
  part("flat-button").disabled = name === "flat";
  part("solid-button").disabled = name === "solid";
}

function follow() {
  const wanted = part("follow").value;
  const body = wanted && scene.bodies.find((each) => each.id === wanted);
  if (body) [views[current].camera.x, views[current].camera.y] = [body.x, body.y];
}

let printed = -1;
function print(time) {
  let count = 0;
  while (count < run.output.length && run.output[count][0] <= time) count++;
  if (count === printed) return;
  printed = count;
  const several = run.rosters.at(-1).robots.length > 1;
  const lines = run.output.slice(Math.max(0, count - SHOWN_LINES), count);
  part("output").textContent = lines.map(([, robot, , text]) => (several ? `[${robot}] ${text}` : text)).join("");
  part("output").scrollTop = part("output").scrollHeight;
}

let last = performance.now();
let isBusy = false;
async function tick(now) {
  timeline.advance(Math.min(0.25, (now - last) / 1000));
  last = now;
  if (!isBusy) {
    isBusy = true;
    try {
      scene.place(await frames.at(timeline.time));
      follow();
      views[current].draw(timeline.time);
      print(timeline.time);
      document.body.dataset.time = timeline.time.toFixed(3);
    } finally {
      isBusy = false;
    }
  }
  requestAnimationFrame(tick);
}

for (const id of ["flat", "solid"]) {
  const canvas = part(id);
  part(`${id}-button`).addEventListener("click", () => show(id));
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons) views[id].camera.drag(event.movementX, event.movementY, views[id].scale);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    views[id].camera.wheel(event.deltaY);
  });
  canvas.addEventListener("dblclick", () => views[id].camera.reset());
}
addEventListener("keydown", (event) => {
  if (event.key === " ") timeline.toggle();
  else if (event.key === "ArrowRight") timeline.seek(timeline.time + run.frame_s);
  else if (event.key === "ArrowLeft") timeline.seek(timeline.time - run.frame_s);
  else if (event.key === "n") timeline.jump(1);
  else if (event.key === "p") timeline.jump(-1);
  else return;
  event.preventDefault();
});
addEventListener("resize", () => timeline.drawMarks());
show("flat");
requestAnimationFrame(tick);
