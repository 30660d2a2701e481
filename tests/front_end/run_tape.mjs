// Runs tapes for tests in other languages: one JSON request a line on stdin,
//   {"tape": ..., "axes": [...], "inputs": [[...], ...]}
// one line of JSON back: for each input vector {name: flat list of values}, sample-major (see
// tape.js), or {"error": message} for the request. Values that JSON lacks travel as strings.
import { createInterface } from "node:readline";
import { load } from "../../widgets/front_end/tape.js";

const portable = (value) => (Number.isFinite(value) && !Object.is(value, -0) ? value
  : Object.is(value, -0) ? "-0" : String(value));

function answer({ tape, axes, inputs }) {
  const { outputs, run } = load(tape, axes);
  return inputs.map((vector) => {
    run(vector.map(Number));
    return Object.fromEntries(Object.entries(outputs)
      .map(([name, { values }]) => [name, Array.from(values, portable)]));
  });
}

for await (const line of createInterface({ input: process.stdin })) {
  if (!line.trim()) continue;
  let result;
  try {
    result = answer(JSON.parse(line));
  } catch (error) {
    result = { error: error.message };
  }
  process.stdout.write(`${JSON.stringify(result)}\n`);
}
