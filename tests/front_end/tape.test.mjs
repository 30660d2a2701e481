import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "../../widgets/front_end/tape.js";

/** A tape by hand: registers are inputs, then constants, then one for every instruction. */
function tape({ inputs = [], constants = [], operations = [], code = [], outputs = {} }) {
  return { inputs, constants, operations, code, outputs };
}

const scalar = (register) => ({ shape: [], registers: [register] });

function evaluate(operation, ...values) {
  const inputs = values.map((_, i) => `x${i}`);
  const { outputs, run } = load(tape({ inputs, operations: [operation],
    code: [0, ...inputs.keys()], outputs: { y: scalar(values.length) } }), []);
  run(values);
  return outputs.y.values[0];
}

test("every operation computes its value", () => {
  assert.equal(evaluate("add", 2, 3), 5);
  assert.equal(evaluate("sub", 2, 3), -1);
  assert.equal(evaluate("mul", 2, 3), 6);
  assert.equal(evaluate("div", 2, 4), 0.5);
  assert.equal(evaluate("neg", 2), -2);
  assert.equal(evaluate("sqrt", 9), 3);
  assert.equal(evaluate("sin", 0), 0);
  assert.equal(evaluate("cos", 0), 1);
  assert.equal(evaluate("tan", 0), 0);
  assert.equal(evaluate("exp", 0), 1);
  assert.equal(evaluate("log", 1), 0);
  assert.equal(evaluate("abs", -2), 2);
  assert.equal(evaluate("pow", 2, 10), 1024);
  assert.equal(evaluate("atan2", 1, 0), Math.PI / 2);
  assert.equal(evaluate("min", 2, 3), 2);
  assert.equal(evaluate("max", 2, 3), 3);
});

test("values that are not finite pass through, and powers of one are C's", () => {
  assert.equal(evaluate("div", 1, 0), Infinity);
  assert.equal(evaluate("div", 0, 0), NaN);
  assert.equal(evaluate("sqrt", -1), NaN);
  assert.equal(evaluate("pow", 1, NaN), 1);
  assert.equal(evaluate("pow", -1, Infinity), 1);
  assert.equal(evaluate("pow", NaN, 0), 1);
});

test("arithmetic of scalars with samples agrees in every combination", () => {
  for (const [name, f] of Object.entries({ add: (a, b) => a + b, sub: (a, b) => a - b,
    mul: (a, b) => a * b, div: (a, b) => a / b, pow: (a, b) => a ** b })) {
    const { outputs, run } = load(tape({ inputs: ["a", "u"], operations: [name],
      code: [0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1],
      outputs: { ss: scalar(2), sv: scalar(3), vs: scalar(4), vv: scalar(5) } }),
    [{ low: 1, high: 2, count: 3 }]);
    run([3]);
    const u = [1, 1.5, 2];
    assert.deepEqual([...outputs.ss.values], [f(3, 3)], name);
    assert.deepEqual([...outputs.sv.values], u.map((x) => f(3, x)), name);
    assert.deepEqual([...outputs.vs.values], u.map((x) => f(x, 3)), name);
    assert.deepEqual([...outputs.vv.values], u.map((x) => f(x, x)), name);
  }
});

test("an output along an axis is sample-major, and scalars in it are repeated", () => {
  const { outputs, run } = load(tape({ inputs: ["a", "u"], constants: [[1, 3]],
    outputs: { m: { shape: [1, 3], registers: [1, 0, 2] } } }), [{ low: 0, high: 1, count: 2 }]);
  run([7]);
  assert.deepEqual([...outputs.m.values], [0, 7, 1 / 3, 1, 7, 1 / 3]);
  assert.deepEqual([outputs.m.axis, outputs.m.count, outputs.m.size], [0, 2, 3]);
});

test("samples are those of numpy.linspace, both ends exact", () => {
  const { outputs, run } = load(tape({ inputs: ["u", "v"], outputs: { u: scalar(0), v: scalar(1) } }),
    [{ low: 0.1, high: 0.7, count: 4 }, { low: 5, high: 9, count: 1 }]);
  run([]);
  const step = (0.7 - 0.1) / 3;
  assert.deepEqual([...outputs.u.values], [0.1, 0.1 + step, 0.1 + 2 * step, 0.7]);
  assert.deepEqual([...outputs.v.values], [5]);
});

test("what depends on no input is computed once, and stays right when inputs change", () => {
  const { outputs, run } = load(tape({ inputs: ["a", "u"], operations: ["mul", "add"],
    code: [0, 1, 1, 1, 2, 0], outputs: { y: scalar(3) } }), [{ low: 0, high: 2, count: 3 }]);
  run([1]);
  assert.deepEqual([...outputs.y.values], [1, 2, 5]);
  run([10]);
  assert.deepEqual([...outputs.y.values], [10, 11, 14]);
});

test("a value of two axes is refused, in an instruction and in an output", () => {
  const axes = [{ low: 0, high: 1, count: 2 }, { low: 0, high: 1, count: 3 }];
  const product = tape({ inputs: ["u", "v"], operations: ["mul"], code: [0, 0, 1] });
  assert.throws(() => load(product, axes), /one sampled axis at most/);
  const pair = tape({ inputs: ["u", "v"], outputs: { m: { shape: [2], registers: [0, 1] } } });
  assert.throws(() => load(pair, axes), /output "m".*one sampled axis at most/);
});

test("an unknown operation says that figure and front end differ", () => {
  assert.throws(() => load(tape({ operations: ["fma"] }), []), /"fma".*different versions/);
  assert.throws(() => load(tape({ operations: ["constructor"] }), []), /different versions/);
});

test("the number of inputs is checked", () => {
  const { run } = load(tape({ inputs: ["a", "b"] }), []);
  assert.throws(() => run([1]), /Expected 2 input values.*received 1/);
});
