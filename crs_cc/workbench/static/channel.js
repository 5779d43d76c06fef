/**
 * The channel to the run: it sends commands and receives messages, and reconnects automatically.
 *
 * @typedef {(message: any) => void} OnMessage
 */

const VERSION = 3;
const FIRST_WAIT = 250; // [ms]
const MAX_WAIT = 4000; // [ms]

/** The token in the page's address; it stays known when the page is loaded again. */
function token() {
  const found = new URLSearchParams(location.hash.slice(1)).get("token");
  if (found) sessionStorage.setItem("token", found);
  return found ?? sessionStorage.getItem("token") ?? "";
}

const HEAD = 8; // bytes of a frame before its planes

/** A frame as in a recording, with the planes of zeros that the channel omits. @param {Uint8Array} sent */
export function withZeros(sent) {
  const view = new DataView(sent.buffer, sent.byteOffset);
  const [planes, rows] = [4 * sent[1], view.getUint32(4, true)];
  const present = view.getBigUint64(HEAD, true);
  const frame = new Uint8Array(HEAD + planes * rows);
  frame.set(sent.subarray(0, HEAD));
  let from = HEAD + 8;
  for (let plane = 0; plane < planes; plane++) {
    if (!((present >> BigInt(plane)) & 1n)) continue;
    frame.set(sent.subarray(from, from + rows), HEAD + plane * rows);
    from += rows;
  }
  return frame;
}

export class SocketChannel {
  /** @param {OnMessage} onMessage is called with every message; bytes as `{type: "frame" | "block", ...}` */
  constructor(onMessage) {
    this.onMessage = onMessage;
    this.isLocal = false;
    this.wait = FIRST_WAIT;
    this.number = 0;
    /** @type {Map<number, {resolve: (value: any) => void, reject: (reason: Error) => void}>} */
    this.pending = new Map();
    /** @type {Map<number, (bytes: Uint8Array) => void>} */
    this.blocks = new Map();
    this.connect();
  }

  connect() {
    const socket = new WebSocket(`ws://${location.host}/channel`, ["crs.1", `token.${token()}`]);
    socket.binaryType = "arraybuffer";
    socket.addEventListener("message", (event) => this.receive(event.data));
    socket.addEventListener("close", (event) => this.handleClose(event));
    this.socket = socket;
  }

  handleClose(event) {
    for (const { reject } of this.pending.values()) reject(new Error("connection lost"));
    this.pending.clear();
    this.blocks.clear();
    const isOver = event.code === 1001;
    this.onMessage({ type: "lost", isOver, reason: event.reason, wasOpen: this.wait === FIRST_WAIT });
    setTimeout(() => this.connect(), this.wait);
    this.wait = Math.min(MAX_WAIT, this.wait * 2);
  }

  receive(data) {
    if (data instanceof ArrayBuffer) {
      this.receiveBytes(new Uint8Array(data));
      return;
    }
    const message = JSON.parse(data);
    if (message.type === "answer") {
      const waiting = this.pending.get(message.id);
      this.pending.delete(message.id);
      if (message.error !== undefined) waiting?.reject(new Error(message.error));
      else waiting?.resolve(message.value);
      return;
    }
    if (message.type === "hello") {
      this.wait = FIRST_WAIT;
      message.isOtherVersion = message.version !== VERSION;
    }
    this.onMessage(message);
  }

  receiveBytes(bytes) {
    const view = new DataView(bytes.buffer);
    if (bytes[0] === 0x46) {
      this.onMessage({ type: "frame", time: view.getFloat64(1, true), data: withZeros(bytes.subarray(9)) });
    } else if (bytes[0] === 0x50) {
      this.resolvePage?.(bytes.subarray(1));
    } else if (bytes[0] === 0x52) {
      this.resolveRecording?.(bytes.subarray(1));
    } else {
      const number = view.getUint32(1, true);
      this.blocks.get(number)?.(bytes.subarray(5));
      this.blocks.delete(number);
    }
  }

  /**
   * Execute a command on the server. @param {string} name @param {Record<string, any>} fields
   * @returns {Promise<any>} its answer
   */
  request(name, fields = {}) {
    if (this.socket.readyState !== WebSocket.OPEN) return Promise.reject(new Error("not connected"));
    const id = ++this.number;
    this.socket.send(JSON.stringify({ id, command: name, ...fields }));
    return new Promise((resolve, reject) => this.pending.set(id, { resolve, reject }));
  }

  /** The run as one HTML page. @returns {Promise<Uint8Array>} */
  page() {
    const bytes = new Promise((resolve) => (this.resolvePage = resolve));
    return this.request("page").then(() => bytes);
  }

  /** The run as a recording, up to the time that is shown. @returns {Promise<Uint8Array>} */
  recording() {
    const bytes = new Promise((resolve) => (this.resolveRecording = resolve));
    return this.request("recording").then(() => bytes);
  }

  /** The bytes of a block of frames. @param {number} number @returns {Promise<Uint8Array>} */
  block(number) {
    const bytes = new Promise((resolve) => this.blocks.set(number, resolve));
    return this.request("frames", { block: number }).then(() => bytes);
  }
}
