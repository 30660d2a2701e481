/** The tape over exact rationals: the same data as `tape.js` runs, and proofs instead of pictures. */

import { CONSTANT, ofPower, ofProduct, ofQuotient, ofSum, variable } from "./degrees.js";
import { add, div, less, mul, neg, pow, rational, sub, Undefined } from "./rational.js";

/** @typedef {import("./rational.js").Rational} Rational */
/** @typedef {import("./degrees.js").Bounds} Bounds */
/** @typedef {import("./scene.js").TapeData} TapeData */

/** @type {Record<string, (a: Rational, b: Rational) => Rational>} */
const OPERATIONS = {
  add, sub, mul, div, neg, pow,
  abs: (a) => (a.n < 0n ? neg(a) : a),
  min: (a, b) => (less(b, a) ? b : a),
  max: (a, b) => (less(a, b) ? b : a),
  step: (a) => rational(a.n >= 0n ? 1 : 0),
  ratio: (a, b) => (b.n === 0n ? b : div(a, b)),
};

/** The operations of a tape with one operand. */
const UNARY = new Set(["neg", "sqrt", "sin", "cos", "tan", "exp", "log", "abs", "step"]);

/** Where the operands of every instruction stand. */
function instructions(/** @type {TapeData} */ { operations, code }) {
  const found = [];
  for (let k = 0; k < code.length;) {
    const name = operations[code[k]];
    const end = k + (UNARY.has(name) ? 2 : 3);
    found.push({ name, operands: code.slice(k + 1, end) });
    k = end;
  }
  return found;
}

/** @type {Record<string, (a: Bounds, b: Bounds) => Bounds>} */
const BOUNDS = { add: ofSum, sub: ofSum, mul: ofProduct, div: ofQuotient, neg: (a) => a };

/**
 * Prepare a tape for exact runs. Only what an output needs is computed.
 * @param {TapeData} tape
 */
export function loadExact(tape) {
  const program = instructions(tape);
  const constants = tape.constants.map((value) => (Array.isArray(value) ? rational(...value)
    : Number.isInteger(value) ? rational(value) : null));
  const first = tape.inputs.length + constants.length;

  function constant(/** @type {number} */ register) {
    const value = constants[register - tape.inputs.length];
    if (!value) throw new Undefined("a number that is not rational");
    return value;
  }

  /**
   * The values of outputs at given inputs; asking for one throws Undefined where it has none.
   * @param {Record<string, Rational>} inputs
   */
  function run(inputs) {
    /** @type {Rational[]} */
    const known = [];
    const value = (/** @type {number} */ register) => (known[register] ??= compute(register));
    function compute(/** @type {number} */ register) {
      if (register < tape.inputs.length) return inputs[tape.inputs[register]];
      if (register < first) return constant(register);
      const { name, operands } = program[register - first];
      if (!Object.hasOwn(OPERATIONS, name)) throw new Undefined(`${name} of a rational number`);
      const [a, b] = operands.map(value);
      return OPERATIONS[name](a, b);
    }
    return (/** @type {string} */ output) => tape.outputs[output].registers.map(value);
  }

  /** Bounds of the degrees of an output's entries in some of the inputs. */
  function bounds(/** @type {string} */ output, /** @type {string[]} */ variables) {
    /** @type {Bounds[]} */
    const known = [];
    const of = (/** @type {number} */ register) => (known[register] ??= compute(register));
    function compute(/** @type {number} */ register) {
      const input = tape.inputs[register];
      if (register < first) return variables.includes(input) ? variable(input) : CONSTANT;
      const { name, operands } = program[register - first];
      const [a, b] = operands.map(of);
      if (name === "pow" && operands[1] >= tape.inputs.length && operands[1] < first) {
        return ofPower(a, Number(constant(operands[1]).n));
      }
      if (Object.hasOwn(BOUNDS, name)) return BOUNDS[name](a, b);
      if (operands.map(of).every(({ up, down }) => Object.keys({ ...up, ...down }).length === 0)) return CONSTANT;
      throw new Undefined(`the degree of ${name}`);
    }
    return tape.outputs[output].registers.map(of);
  }

  return { run, bounds };
}
