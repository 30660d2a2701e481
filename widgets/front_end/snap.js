/** Snapping: handles and sliders rest on a grid, so that an exact check of them means something. */

/** Shift makes every move this many times finer. */
export const FINER = 8;

/** Remove the dust of binary multiplication: 3 * 0.1 shall read 0.3. */
const clean = (/** @type {number} */ value) => Number(value.toPrecision(12));

/**
 * The multiple of `step` nearest to `value` that lies in [low, high].
 * @param {number} value
 * @param {number} step
 * @param {number} low
 * @param {number} high
 */
export function snapTo(value, step, low, high) {
  const inside = Math.min(Math.max(value, low), high);
  let count = Math.round(inside / step);
  if (clean(count * step) > high) count -= 1;
  if (clean(count * step) < low) count += 1;
  const snapped = clean(count * step);
  return snapped > high || snapped < low ? inside : snapped;
}

/**
 * One nudge from `value` by `step`, staying in [low, high] or, from outside, not leading farther
 * away; a point placed off the grid by a number field keeps its offset, so that nudging back
 * returns it exactly.
 * @param {number} value
 * @param {number} step  signed
 * @param {number} low
 * @param {number} high
 */
export function nudge(value, step, low, high) {
  return Math.min(Math.max(clean(value + step), Math.min(low, value)), Math.max(high, value));
}

/** The step of something that does not snap: a power of ten near a hundredth of its range. */
export function freeStep(/** @type {number} */ low, /** @type {number} */ high) {
  return 10 ** Math.floor(Math.log10((high - low) / 50));
}
