/**
 * Bounds of the degrees of a rational expression, read off from how it is written: of a numerator
 * (up) and a denominator (down) in every variable, and of everything that is divided by on the way
 * (holes): where none of these vanishes, the expression has a value.
 */

/** @typedef {Record<string, number>} Degrees */
/** @typedef {{up: Degrees, down: Degrees, holes: Degrees}} Bounds */

/** Beyond this a grid of values would become too large to be waited for. */
export const HIGHEST = 60;

/** Raised where a text is no answer; the message is for the learner. */
export class Unreadable extends Error {}

/** @type {(a: Degrees, b: Degrees, f: (x: number, y: number) => number) => Degrees} */
function merged(a, b, f) {
  const both = Object.fromEntries(Object.keys({ ...a, ...b }).map((name) => [name, f(a[name] ?? 0, b[name] ?? 0)]));
  if (Object.values(both).some((degree) => degree > HIGHEST)) throw new Unreadable(`Expected a degree of at most ${HIGHEST}.`);
  return both;
}

const plus = (/** @type {Degrees} */ a, /** @type {Degrees} */ b) => merged(a, b, (x, y) => x + y);
const most = (/** @type {Degrees} */ a, /** @type {Degrees} */ b) => merged(a, b, Math.max);

/** @type {Bounds} */
export const CONSTANT = { up: {}, down: {}, holes: {} };

/** @returns {Bounds} */
export const variable = (/** @type {string} */ name) => ({ up: { [name]: 1 }, down: {}, holes: {} });

/** @returns {Bounds} */
export const ofSum = (/** @type {Bounds} */ a, /** @type {Bounds} */ b) => ({
  up: most(plus(a.up, b.down), plus(b.up, a.down)), down: plus(a.down, b.down), holes: plus(a.holes, b.holes) });

/** @returns {Bounds} */
export const ofProduct = (/** @type {Bounds} */ a, /** @type {Bounds} */ b) => ({
  up: plus(a.up, b.up), down: plus(a.down, b.down), holes: plus(a.holes, b.holes) });

/** @returns {Bounds} */
export const ofQuotient = (/** @type {Bounds} */ a, /** @type {Bounds} */ b) => ({
  up: plus(a.up, b.down), down: plus(a.down, b.up), holes: plus(plus(a.holes, b.holes), b.up) });

/** @returns {Bounds} */
export function ofPower(/** @type {Bounds} */ a, /** @type {number} */ k) {
  const times = (/** @type {Degrees} */ degrees) => merged(degrees, {}, (x) => x * Math.abs(k));
  return k < 0 ? { up: times(a.down), down: times(a.up), holes: plus(a.holes, a.up) }
    : { up: times(a.up), down: times(a.down), holes: a.holes };
}

/**
 * How many values of a variable decide whether two expressions are equal. With a/b and c/d the
 * product (ad - bc) times all that is divided by has at most one zero less, unless it is zero.
 */
export const enough = (/** @type {string} */ name, /** @type {Bounds} */ a, /** @type {Bounds} */ b) => (
  1 + Math.max((a.up[name] ?? 0) + (b.down[name] ?? 0), (b.up[name] ?? 0) + (a.down[name] ?? 0))
  + (a.holes[name] ?? 0) + (b.holes[name] ?? 0));
