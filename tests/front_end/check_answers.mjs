// Checks answers for tests in other languages: one JSON request a line on stdin,
//   {"question": ..., "text": ..., "inputs": {name: number}}
// one line of JSON back: {"right": ..., "message": ...} or {"error": message, "kind": class name}.
import { createInterface } from "node:readline";
import { loadCheck, solution } from "../../widgets/front_end/check.js";

for await (const line of createInterface({ input: process.stdin })) {
  let result;
  try {
    const { question, text, inputs } = JSON.parse(line);
    result = text === null ? { solution: solution(question, inputs) } : loadCheck(question)(text, inputs);
  } catch (error) {
    result = { error: error.message, kind: error.constructor.name };
  }
  process.stdout.write(`${JSON.stringify(result)}\n`);
}
