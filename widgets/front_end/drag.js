/**
 * Pointers on a drawing: dragging a handle, tapping it, tapping the background. Only handles take
 * the touch gesture; over the rest of the drawing the page scrolls and zooms as everywhere.
 */

import { FINER, snapTo } from "./snap.js";
import { shownRange } from "./transform.js";

/** @typedef {import("./handles.js").Handle} Handle */

/** Pixels a pointer may tremble and still be tapping. */
const TREMBLE = { mouse: 3, touch: 10 };

/**
 * @param {import("./figure.js").Figure} figure
 * @param {import("./handles.js").Drawing} drawing
 * @param {Handle[]} handles
 * @param {{onMoved: (handle: Handle) => void, onTap: (handle: Handle) => void,
 *   onBackground: (place: (handle: Handle) => void) => void}} react
 */
export function listenForDrags({ store, life }, drawing, handles, react) {
  /**
   * The drag under way; dx, dy: from the pointer to the handle's centre, so that it does not jump.
   * @type {{handle: Handle, pointer: number, startX: number, startY: number, dx: number, dy: number,
   *   moved: boolean} | null}
   */
  let drag = null;
  let onHandle = false;

  /** Pixels of an event inside the drawing; a host such as a slide show may have scaled it. */
  function position(/** @type {MouseEvent} */ event) {
    const box = drawing.element.getBoundingClientRect();
    const scale = drawing.map.width / box.width;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  }

  function moveTo(/** @type {Handle} */ handle, /** @type {number} */ px, /** @type {number} */ py,
    /** @type {boolean} */ finer) {
    const { map } = drawing;
    const range = shownRange(map);
    const step = finer ? handle.step / FINER : handle.step;
    store.movePoint(handle.group, handle.index,
      snapTo((px - map.ox) / map.sx, step, ...range.x), snapTo((py - map.oy) / map.sy, step, ...range.y));
  }

  /** Touch areas overlap: the nearest handle is meant. */
  function nearest(/** @type {number} */ px, /** @type {number} */ py) {
    const { map } = drawing;
    const distance = (/** @type {Handle} */ handle) => {
      const [x, y] = store.state.points[handle.group][handle.index];
      return Math.hypot(map.sx * x + map.ox - px, map.sy * y + map.oy - py);
    };
    return handles.filter(({ hidden }) => !hidden).reduce((best, handle) => (distance(handle) <= distance(best) ? handle : best));
  }

  const isOnHandle = (/** @type {Event} */ event) =>
    handles.some(({ element }) => event.composedPath().includes(element));

  function onDown(/** @type {PointerEvent} */ event) {
    const touched = isOnHandle(event);
    if (event.isPrimary) onHandle = touched;
    if (!touched || drag || event.button !== 0) return;
    const [px, py] = position(event);
    const handle = nearest(px, py);
    const [x, y] = store.state.points[handle.group][handle.index];
    const { map } = drawing;
    drag = { handle, pointer: event.pointerId, startX: px, startY: py,
      dx: map.sx * x + map.ox - px, dy: map.sy * y + map.oy - py, moved: false };
    handle.element.setPointerCapture(event.pointerId);
    handle.element.focus({ preventScroll: true });
    store.begin();
  }

  function onMove(/** @type {PointerEvent} */ event) {
    if (!drag || event.pointerId !== drag.pointer) return;
    const [px, py] = position(event);
    if (!drag.moved) {
      const limit = event.pointerType === "mouse" ? TREMBLE.mouse : TREMBLE.touch;
      if (Math.hypot(px - drag.startX, py - drag.startY) < limit) return;
      drag.moved = true;
      drag.handle.element.classList.add("dragged");
    }
    // Browsers report right before a frame, and the figure draws in it: nothing is computed twice.
    moveTo(drag.handle, px + drag.dx, py + drag.dy, event.shiftKey);
  }

  function finish() {
    const { handle, pointer, moved } = /** @type {NonNullable<typeof drag>} */ (drag);
    drag = null;
    handle.element.classList.remove("dragged");
    if (handle.element.hasPointerCapture(pointer)) handle.element.releasePointerCapture(pointer);
    return { handle, moved };
  }

  function onUp(/** @type {PointerEvent} */ event) {
    if (!drag || event.pointerId !== drag.pointer) return;
    if (drag.moved) {
      const [px, py] = position(event);
      moveTo(drag.handle, px + drag.dx, py + drag.dy, event.shiftKey);
    }
    const { handle, moved } = finish();
    store.end();
    if (moved) react.onMoved(handle);
    else react.onTap(handle);
  }

  /** Give up the drag and put the handle back; true when there was one. */
  function cancel() {
    if (!drag) return false;
    const { handle } = finish();
    const [x, y] = store.before().points[handle.group][handle.index];
    store.movePoint(handle.group, handle.index, x, y);
    store.end();
    return true;
  }

  const { element } = drawing;
  life.listen(element, "pointerdown", onDown);
  life.listen(element, "pointermove", onMove);
  life.listen(element, "pointerup", onUp);
  life.listen(element, "pointercancel", (event) => { if (event.pointerId === drag?.pointer) cancel(); });
  // Chromium does not honour touch-action inside an SVG: it would scroll, and cancel the drag.
  life.listen(element, "touchstart", (event) => {
    if (isOnHandle(event)) event.preventDefault();
  }, { passive: false });
  life.listen(element, "mousedown", (event) => {
    if (onHandle) event.preventDefault(); // no text selection, and the focus stays where onDown put it
  });
  life.listen(element, "click", (event) => {
    if (onHandle) return;
    react.onBackground((handle) => {
      const [px, py] = position(event);
      moveTo(handle, px, py, event.shiftKey);
      store.commit();
      react.onMoved(handle);
    });
  });
  life.onEnd(() => { drag = null; });
  return { cancel };
}
