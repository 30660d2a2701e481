/**
 * The life of one view. Everything that outlives a function call (listeners, frames, timers,
 * observers) is started here, so that one `end()` stops it all, and every failure, whenever it
 * happens, reaches the learner as a message instead of a figure that silently stops.
 */

/** @typedef {ReturnType<typeof createLife>} Life */

/** @param {(error: unknown) => void} onError */
export function createLife(onError) {
  const ending = new AbortController();
  const { signal } = ending;

  /**
   * @template {any[]} A
   * @param {(...args: A) => void} action
   * @returns {(...args: A) => void}
   */
  const guarded = (action) => (...args) => {
    if (signal.aborted) return;
    try {
      action(...args);
    } catch (error) {
      onError(error);
    }
  };

  const onEnd = (/** @type {() => void} */ action) => signal.addEventListener("abort", action, { once: true });

  return {
    guarded,
    onEnd,
    end: () => ending.abort(),

    /**
     * @param {EventTarget} target
     * @param {string} type
     * @param {(event: any) => void} handler
     */
    listen(target, type, handler, options = {}) {
      target.addEventListener(type, guarded(handler), { ...options, signal });
    },

    /**
     * A function that asks for `draw` in the next frame; asking twice draws once.
     * @param {() => void} draw
     */
    framed(draw) {
      let request = 0;
      onEnd(() => cancelAnimationFrame(request));
      const frame = () => { request = 0; guarded(draw)(); };
      return () => { request ||= requestAnimationFrame(frame); };
    },

    /** Call `tick(milliseconds since the last call)` every frame until the returned stop is called. */
    everyFrame(/** @type {(elapsed: number) => void} */ tick) {
      let last = performance.now();
      let request = 0;
      const frame = (/** @type {number} */ now) => {
        if (signal.aborted) return;
        request = requestAnimationFrame(frame);
        guarded(tick)(Math.max(0, now - last));
        last = now;
      };
      request = requestAnimationFrame(frame);
      return () => cancelAnimationFrame(request);
    },

    /** Call `tick` every `interval` ms until the returned stop is called. */
    every(/** @type {number} */ interval, /** @type {() => void} */ tick) {
      const timer = setInterval(() => (signal.aborted ? clearInterval(timer) : guarded(tick)()), interval);
      return () => clearInterval(timer);
    },

    /** Report the size of an element now and whenever it changes. */
    onResize(/** @type {Element} */ element, /** @type {(width: number) => void} */ action) {
      const observer = new ResizeObserver(guarded((entries) => action(entries[0].contentRect.width)));
      observer.observe(element);
      onEnd(() => observer.disconnect());
    },
  };
}
