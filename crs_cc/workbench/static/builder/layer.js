/** A picture of a part of what is shown, drawn once and then moved: so drags stay fast in large worlds. */

export class Layer {
  constructor() {
    this.canvas = document.createElement("canvas");
    this.key = "";
    /** Where the view was when it was drawn. */
    this.centre = [0, 0];
    this.scale = 1;
    this.took = 0; // to draw it [ms]
  }

  /**
   * Draw it if it is not what it should be.
   * @param {import("./view.js").View} view @param {string} key changes with what it shows
   * @param {boolean} isBusy whether the view moves, so that the old picture has to do
   * @param {(pen: CanvasRenderingContext2D) => void} paint
   */
  renew(view, key, isBusy, paint) {
    const { clientWidth, clientHeight } = view.size;
    const isSized = resized(this.canvas, clientWidth, clientHeight, devicePixelRatio || 1);
    const isMoved = this.scale !== view.scale || this.centre[0] !== view.centre[0] || this.centre[1] !== view.centre[1];
    if (key === this.key && !isSized && (!isMoved || isBusy)) return;
    const start = performance.now();
    const pen = penOf(this.canvas, devicePixelRatio || 1);
    pen.clearRect(0, 0, clientWidth, clientHeight);
    paint(pen);
    [this.key, this.centre, this.scale] = [key, [...view.centre], view.scale];
    this.took = performance.now() - start;
  }

  /** Draw it where it is now. @param {((point: number[]) => number[]) | null} motion of what it shows [m] */
  show(pen, view, motion) {
    const { clientWidth, clientHeight } = view.size;
    if (!clientWidth || !clientHeight) return;
    const place = ([px, py]) => {
      const point = [this.centre[0] + (px - clientWidth / 2) / this.scale, this.centre[1] - (py - clientHeight / 2) / this.scale];
      return view.toScreen(motion ? motion(point) : point);
    };
    const [[x, y], [ax, ay], [bx, by]] = [place([0, 0]), place([1, 0]), place([0, 1])];
    pen.save();
    pen.transform(ax - x, ay - y, bx - x, by - y, x, y);
    pen.drawImage(this.canvas, 0, 0, clientWidth, clientHeight);
    pen.restore();
  }
}

/** Make a canvas fit; whether it did not. */
export function resized(canvas, width, height, ratio) {
  const size = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width === size[0] && canvas.height === size[1]) return false;
  [canvas.width, canvas.height] = size;
  return true;
}

/** @returns {CanvasRenderingContext2D} */
export function penOf(canvas, ratio) {
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  return pen;
}
