/**
 * Frames of a recorded run, decoded a block at a time: a block begins with a key frame.
 *
 * @typedef {{time: number, columns: number, rows: number, values: Float32Array}} Frame
 *   values: a column after the other, in metres and radians; NaN for what is not in the world.
 * @typedef {[number, number, string]} Block first and last time [s], frames in base 64
 */

const NOWHERE = -(2 ** 31);
const PER_UNIT = 1e4;
const KEPT = 24; // decoded blocks

/** @param {string} text @returns {Promise<Uint8Array>} */
export async function unpack(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Decode one frame; docs/recordings.md describes the form.
 * @param {Uint8Array} data
 * @param {Int32Array | null} before the whole numbers of the frame before
 * @returns {{whole: Int32Array, columns: number, rows: number}}
 */
export function decodeFrame(data, before) {
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
      whole[index] = kind === 1 && before ? value + before[index] : value;
    }
  }
  return { whole, columns, rows };
}

/** @param {Uint8Array} content @returns {Frame[]} */
export function decodeBlock(content) {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const frames = [];
  let before = null;
  for (let at = 0; at < content.length; ) {
    const time = view.getFloat64(at, true);
    const size = view.getUint32(at + 8, true);
    const frame = decodeFrame(content.subarray(at + 12, at + 12 + size), before);
    before = frame.whole;
    const values = Float32Array.from(before, (each) => (each === NOWHERE ? NaN : each / PER_UNIT));
    frames.push({ time, columns: frame.columns, rows: frame.rows, values });
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
  /** @param {Block[]} blocks @param {number} frameS time between frames while something moves */
  constructor(blocks, frameS) {
    this.blocks = blocks;
    this.frameS = frameS;
    /** @type {Map<number, Promise<Frame[]>>} */
    this.decoded = new Map();
  }

  /** The poses at a time: between two frames, or the last frame while nothing moved. */
  async at(time) {
    const number = this.blockAt(time);
    const frames = await this.block(number);
    let place = frames.length - 1;
    while (place > 0 && frames[place].time > time) place--;
    let next = frames[place + 1];
    if (!next && number + 1 < this.blocks.length) [next] = await this.block(number + 1);
    const frame = frames[place];
    if (!next || next.values.length !== frame.values.length || time <= frame.time) return frame;
    const begin = Math.max(frame.time, next.time - 1.5 * this.frameS);
    const share = Math.min(1, Math.max(0, (time - begin) / (next.time - begin)));
    return blend(frame, next, share);
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
    let found = this.decoded.get(number);
    if (!found) {
      found = unpack(this.blocks[number][2]).then(decodeBlock);
      this.decoded.set(number, found);
      if (this.decoded.size > KEPT) this.decoded.delete(this.decoded.keys().next().value);
    }
    return found;
  }
}
