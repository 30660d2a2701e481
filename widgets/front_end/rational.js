/** Exact rational numbers: two BigInts without a common divisor, the denominator above zero. */

/** @typedef {{n: bigint, d: bigint}} Rational */

const abs = (/** @type {bigint} */ a) => (a < 0n ? -a : a);

function divisor(/** @type {bigint} */ a, /** @type {bigint} */ b) {
  while (b !== 0n) [a, b] = [b, a % b];
  return a;
}

/** Raised where an exact value is asked for that does not exist, such as 1/0. */
export class Undefined extends Error {}

/** @returns {Rational} */
export function rational(/** @type {bigint | number} */ n, /** @type {bigint | number} */ d = 1n) {
  [n, d] = [BigInt(n), BigInt(d)];
  if (d === 0n) throw new Undefined("division by zero");
  const common = (d < 0n ? -1n : 1n) * divisor(abs(n), abs(d));
  return { n: n / common, d: d / common };
}

/** The rational that a float is: p / 2^k. */
export function exactly(/** @type {number} */ value) {
  if (!Number.isFinite(value)) throw new Undefined("not a finite number");
  let d = 1n;
  while (!Number.isInteger(value)) [value, d] = [value * 2, d * 2n];
  return rational(BigInt(value), d);
}

export const add = (/** @type {Rational} */ a, /** @type {Rational} */ b) => rational(a.n * b.d + b.n * a.d, a.d * b.d);
export const sub = (/** @type {Rational} */ a, /** @type {Rational} */ b) => rational(a.n * b.d - b.n * a.d, a.d * b.d);
export const mul = (/** @type {Rational} */ a, /** @type {Rational} */ b) => rational(a.n * b.n, a.d * b.d);
export const div = (/** @type {Rational} */ a, /** @type {Rational} */ b) => rational(a.n * b.d, a.d * b.n);
export const neg = (/** @type {Rational} */ a) => ({ n: -a.n, d: a.d });
export const equal = (/** @type {Rational} */ a, /** @type {Rational} */ b) => a.n === b.n && a.d === b.d;
export const less = (/** @type {Rational} */ a, /** @type {Rational} */ b) => a.n * b.d < b.n * a.d;
export const isZero = (/** @type {Rational} */ a) => a.n === 0n;

/** To a whole power. */
export function pow(/** @type {Rational} */ a, /** @type {Rational} */ b) {
  if (b.d !== 1n || abs(b.n) > 1000n) throw new Undefined(`not an exact power: ^${write(b)}`);
  return b.n < 0n ? rational(a.d ** -b.n, a.n ** -b.n) : { n: a.n ** b.n, d: a.d ** b.n };
}

/** As a learner would write it: 3, -1/2. */
export const write = (/** @type {Rational} */ a) => (a.d === 1n ? `${a.n}` : `${a.n}/${a.d}`);
