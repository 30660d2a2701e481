/** The keyboard on handles: arrows nudge by the snapping step, with Shift finer. */

import { FINER, nudge } from "./snap.js";
import { shownRange } from "./transform.js";

/** @typedef {import("./handles.js").Handle} Handle */

/** Where each arrow key leads in the plane. */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

/**
 * @param {import("./figure.js").Figure} figure
 * @param {import("./handles.js").Drawing} drawing
 * @param {(event: Event) => Handle | undefined} find  the handle an event comes from
 * @param {(handle: Handle) => void} onMoved
 */
export function listenForNudges({ root, store, life }, drawing, find, onMoved) {
  // From the first press until the key is up: a held key is one move in the history.
  let moving = /** @type {Handle | null} */ (null);

  function onKey(/** @type {KeyboardEvent} */ event) {
    const handle = find(event);
    const arrow = ARROWS[/** @type {keyof typeof ARROWS} */ (event.key)];
    if (!handle || !arrow || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (!moving) store.begin();
    moving = handle;
    const range = shownRange(drawing.map);
    const step = event.shiftKey ? handle.step / FINER : handle.step;
    const [x, y] = store.state.points[handle.group][handle.index];
    store.movePoint(handle.group, handle.index,
      nudge(x, arrow[0] * step, ...range.x), nudge(y, arrow[1] * step, ...range.y));
  }

  function onEnd() {
    if (!moving) return;
    const handle = moving;
    moving = null;
    store.end();
    onMoved(handle);
  }

  life.listen(root, "keydown", onKey);
  life.listen(root, "keyup", onEnd);
  life.listen(root, "focusout", onEnd);
}
