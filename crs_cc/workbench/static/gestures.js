/**
 * What a mouse or fingers do on a view: one pointer drags or clicks, two fingers move and pinch.
 *
 * @typedef {{
 *   begin: () => void,
 *   drag: (dx: number, dy: number, moves: boolean) => void,
 *   pinch: (scale: number) => void,
 *   click: (x: number, y: number) => void,
 * }} Hands
 *   drag: by so many pixels, to move the world rather than to turn it;
 *   pinch: the fingers are so many times as far apart as before;
 *   click: at a place in the element.
 */

const CLICK = { mouse: 5, touch: 12 }; // pixels that a click may move; a finger is never still

/** @param {HTMLElement} element @param {Hands} hands */
export function listenToHands(element, hands) {
  /** @type {Map<number, {x: number, y: number}>} */
  const pointers = new Map();
  let [moved, hadTwo] = [0, false];
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    if (!pointers.size) [moved, hadTwo] = [0, false];
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    hadTwo ||= pointers.size > 1;
    hands.begin();
  });
  element.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before || !event.buttons) return;
    const now = { x: event.clientX, y: event.clientY };
    pointers.set(event.pointerId, now);
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    moved += Math.abs(dx) + Math.abs(dy);
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (!other) {
      hands.drag(dx, dy, event.shiftKey || event.buttons > 1);
      return;
    }
    const [near, far] = [before, now].map((at) => Math.max(1, Math.hypot(at.x - other.x, at.y - other.y)));
    hands.pinch(far / near);
    hands.drag(dx / 2, dy / 2, true); // the middle between two fingers goes half as far as one
  });
  const end = (event, isOver) => {
    const isClick = isOver && pointers.has(event.pointerId) && !hadTwo && event.button === 0;
    pointers.delete(event.pointerId);
    if (isClick && moved < (event.pointerType === "touch" ? CLICK.touch : CLICK.mouse)) hands.click(event.offsetX, event.offsetY);
  };
  element.addEventListener("pointerup", (event) => end(event, true));
  element.addEventListener("pointercancel", (event) => end(event, false));
}
