/** A video of the views, as they are drawn. */
import { el } from "crs/dom.js";

const RATE = 30; // pictures in a second
const KINDS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/** Let the browser save something. @param {Blob} blob @param {string} name */
export function saveFile(blob, name) {
  const url = URL.createObjectURL(blob);
  el("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 5000);
}

/** Draw views side by side, as they are. @param {any[]} views @param {any} canvas */
export function paintViews(views, canvas, background) {
  const boxes = views.map((view) => view.element.getBoundingClientRect());
  const [left, top] = [Math.min(...boxes.map((box) => box.left)), Math.min(...boxes.map((box) => box.top))];
  const [right, low] = [Math.max(...boxes.map((box) => box.right)), Math.max(...boxes.map((box) => box.bottom))];
  const ratio = views[0].over.width / Math.max(1, boxes[0].width);
  const [width, height] = [right - left, low - top].map((each) => 2 * Math.round((each * ratio) / 2));
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const pen = canvas.getContext("2d");
  pen.fillStyle = background;
  pen.fillRect(0, 0, width, height);
  views.forEach((view, number) => {
    const box = boxes[number];
    const place = [(box.left - left) * ratio, (box.top - top) * ratio, box.width * ratio, box.height * ratio];
    pen.drawImage(view.canvas, ...place);
    pen.drawImage(view.over, ...place);
  });
}

export class Video {
  /** @param {any} views */
  constructor(views) {
    this.views = views;
    this.recorder = null;
    this.size = 0; // bytes so far
  }

  get isOn() {
    return this.recorder !== null;
  }

  /** Begin a video, or end it and save it. */
  toggle() {
    if (this.recorder) {
      this.recorder.stop();
      return;
    }
    const kind = KINDS.find((each) => window.MediaRecorder?.isTypeSupported(each));
    if (!kind) {
      this.views.notify("this browser cannot record videos", true);
      return;
    }
    this.canvas = document.createElement("canvas");
    this.paint();
    const pieces = [];
    this.size = 0;
    this.recorder = new MediaRecorder(this.canvas.captureStream(RATE), { mimeType: kind, videoBitsPerSecond: 6e6 });
    this.recorder.addEventListener("dataavailable", (event) => {
      pieces.push(event.data);
      this.size += event.data.size;
    });
    this.recorder.addEventListener("stop", () => {
      this.recorder = null;
      saveFile(new Blob(pieces, { type: kind }), `crs-video.${kind.includes("mp4") ? "mp4" : "webm"}`);
      this.views.notify("video saved");
      this.views.showBar();
    });
    this.recorder.start(250);
    this.views.notify("recording: press again to end it");
    this.views.showBar();
  }

  /** Take what is shown now, while it is on. */
  paint() {
    if (this.canvas && this.views.all.length) paintViews(this.views.all, this.canvas, this.views.look.colours.sky);
  }
}
