/**
 * Frames of a run, decoded a block at a time: a block begins with a key frame.
 *
 * @typedef {{time: number, columns: number, rows: number, values: Float32Array}} Frame
 *   values: a column after the other, in metres and radians; NaN for what is not in the world.
 */

const NOWHERE = -(2 ** 31);
const PER_UNIT = 1e4;
const KEPT = 40; // decoded blocks
const TAIL = 240; // frames of a live run that are kept as received

/** @param {string} text @returns {Uint8Array} */
export function fromBase64(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

/** @param {Uint8Array} bytes @returns {string} */
export function toBase64(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}

/** @param {Uint8Array} packed @returns {Promise<Uint8Array>} */
export async function inflate(packed) {
  const stream = new Blob([/** @type {BlobPart} */ (packed)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Decode one frame; docs/recordings.md describes the form.
 * @param {Uint8Array} data
 * @param {Int32Array | null} before the whole numbers of the frame before
 * @param {Int32Array | null} [earlier] those of the frame before that
 * @returns {{whole: Int32Array, columns: number, rows: number}}
 */
export function decodeFrame(data, before, earlier = null) {
  const view = new DataView(data.buffer, data.byteOffset);
  const [kind, columns] = data;
  const rows = view.getUint32(4, true);
  const whole = new Int32Array(columns * rows);
  for (let column = 0; column < columns; column++) {
    const at = 8 + column * 4 * rows;
    for (let row = 0; row < rows; row++) {
      const low = at + row;
      const u =
        data[low] | (data[low + rows] << 8) | (data[low + 2 * rows] << 16) | (data[low + 3 * rows] << 24);
      const index = column * rows + row;
      const value = (u >>> 1) ^ -(u & 1);
      if (kind === 2 && before && earlier) whole[index] = value + 2 * before[index] - earlier[index];
      else whole[index] = kind === 1 && before ? value + before[index] : value;
    }
  }
  return { whole, columns, rows };
}

/** The values of a frame in metres and radians. @param {Int32Array} whole */
function measured(whole) {
  const values = new Float32Array(whole.length); // a loop: Float32Array.from with a function takes ten times as long
  for (let index = 0; index < whole.length; index++) values[index] = whole[index] === NOWHERE ? NaN : whole[index] / PER_UNIT;
  return values;
}

/** @param {Uint8Array} content @returns {Frame[]} */
export function decodeBlock(content) {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const frames = [];
  let [before, earlier] = [null, null];
  for (let at = 0; at < content.length; ) {
    const time = view.getFloat64(at, true);
    const size = view.getUint32(at + 8, true);
    const frame = decodeFrame(content.subarray(at + 12, at + 12 + size), before, earlier);
    [earlier, before] = [before, frame.whole];
    frames.push({ time, columns: frame.columns, rows: frame.rows, values: measured(frame.whole) });
    at += 12 + size;
  }
  return frames;
}

/** Turn from one angle to another by the shorter way. */
function between(from, to, share) {
  const turn = to - from;
  return from + (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI))) * share;
}

/**
 * Blend two frames of the same form.
 * @param {Frame} from @param {Frame} to @param {number} share 0 to 1 @returns {Frame}
 */
export function blend(from, to, share) {
  const values = new Float32Array(from.values.length);
  for (let index = 0; index < values.length; index++) {
    const [a, b] = [from.values[index], to.values[index]];
    const isAngle = index >= 2 * from.rows;
    values[index] = isAngle ? between(a, b, share) : a + (b - a) * share;
  }
  return { ...from, time: from.time + (to.time - from.time) * share, values };
}

export class Frames {
  /**
   * @param {[number, number, any][]} blocks first and last time [s], and bytes or a number
   * @param {number} frameS time between frames while something moves
   * @param {(number: number) => Promise<Uint8Array>} fetch returns a block by its number
   */
  constructor(blocks, frameS, fetch) {
    this.blocks = blocks;
    this.frameS = frameS;
    this.fetch = fetch;
    /** @type {Map<any, Promise<Frame[]>>} */
    this.decoded = new Map();
    /** @type {Frame[]} the latest frames of a live run, as received */
    this.tail = [];
    /** @type {Frame | null} the current frame of the run */
    this.exact = null;
    this.last = null;
  }

  /** Add a frame of a live run. @param {number} time @param {Uint8Array} data */
  add(time, data) {
    const { whole, columns, rows } = decodeFrame(data, data[0] === 1 ? this.last : null);
    this.last = whole;
    const frame = { time, columns, rows, values: measured(whole) };
    this.exact = frame;
    const end = this.tail.at(-1)?.time ?? -1;
    if (time <= end) this.tail = time === end ? this.tail : [];
    this.tail.push(frame);
    if (this.tail.length > TAIL) this.tail.splice(0, TAIL / 4);
  }

  /** Note a block that can be fetched. @param {[number, number, number]} block */
  addBlock([number, begin, end]) {
    this.blocks.push([begin, end, number]);
  }

  /** Show blocks rather than live frames: the run has stopped, and its frames are complete there. */
  clearTail() {
    this.tail = [];
  }

  /** Discard frames after a time. */
  truncate(time, blocks) {
    this.blocks = blocks.map(([number, begin, end]) => [begin, end, number]);
    this.tail = this.tail.filter((frame) => frame.time <= time);
    if (this.exact && this.exact.time > time + 1e-6) this.exact = null;
  }

  /** The poses at a time: between two frames, or the last frame while nothing moved. */
  async at(time) {
    if (this.exact && Math.abs(this.exact.time - time) < 1e-6) return this.exact;
    if (this.tail.length > 1 && time >= this.tail[0].time) return this.between(this.tail, time, null, Infinity);
    if (!this.blocks.length) return this.exact;
    const number = this.blockAt(time);
    const frames = await this.block(number);
    const isLast = number + 1 >= this.blocks.length;
    const isInside = frames.at(-1).time > time || isLast;
    const next = isInside ? (this.tail[0] ?? null) : (await this.block(number + 1))[0];
    return this.between(frames, time, next);
  }

  /** The poses at a time among frames, and the one that follows them; `most` is the longest way. */
  between(frames, time, after, most = 1.5 * this.frameS) {
    let place = frames.length - 1;
    while (place > 0 && frames[place].time > time) place--;
    const [frame, next] = [frames[place], frames[place + 1] ?? after];
    if (!next || next.values.length !== frame.values.length || time <= frame.time) return frame;
    const begin = Math.max(frame.time, next.time - most);
    const share = Math.min(1, Math.max(0, (time - begin) / (next.time - begin)));
    return blend(frame, next, share);
  }

  /** All frames in a span, as far as they are there. @returns {Promise<Frame[]>} */
  async span(begin, end) {
    const found = [];
    if (this.blocks.length) {
      for (let number = this.blockAt(begin); number < this.blocks.length; number++) {
        if (this.blocks[number][0] > end) break;
        found.push(...(await this.block(number)));
      }
    }
    const last = found.at(-1)?.time ?? -1;
    found.push(...this.tail.filter((frame) => frame.time > last));
    return found.filter((frame) => frame.time >= begin && frame.time <= end);
  }

  /** The last block that begins up to a time. */
  blockAt(time) {
    let [low, high] = [0, this.blocks.length - 1];
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.blocks[middle][0] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  block(number) {
    const key = this.blocks[number][2];
    let found = this.decoded.get(key);
    if (!found) {
      const bytes = typeof key === "number" ? this.fetch(key) : Promise.resolve(key);
      found = bytes.then(inflate).then(decodeBlock);
      found.catch(() => this.decoded.delete(key));
      this.decoded.set(key, found);
      if (this.decoded.size > KEPT) this.decoded.delete(this.decoded.keys().next().value);
    }
    return found;
  }
}
