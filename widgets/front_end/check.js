/**
 * Whether an answer is right: exactly. Two expressions whose difference has degree at most n in a
 * variable are equal if they agree at n + 1 of its values: a grid of these for several variables.
 */

import { readAnswer } from "./answer.js";
import { enough, Unreadable } from "./degrees.js";
import { loadExact } from "./exact.js";
import { equal, exactly, rational, Undefined, write } from "./rational.js";

/** @typedef {import("./rational.js").Rational} Rational */
/** @typedef {import("./scene.js").Question} Question */
/** @typedef {{right: boolean, message: string}} Verdict */

const MOST_PLACES = 20000; // of a grid: far beyond what a course asks for

/** Whole numbers 0, 1, ... are tried until so many places of the grid have a value on both sides. */
function* grid(/** @type {string[]} */ variables, /** @type {number[]} */ counts) {
  const total = counts.reduce((product, count) => product * count, 1);
  if (total > MOST_PLACES) throw new Unreadable("Expected an answer of lower degree.");
  for (let k = 0; k < total; k++) {
    let rest = k;
    yield Object.fromEntries(variables.map((name, i) => {
      const place = rest % counts[i];
      rest = Math.floor(rest / counts[i]);
      return [name, rational(place)];
    }));
  }
}

/** A value, or null where there is none. */
function attempt(/** @type {() => Rational} */ f) {
  try {
    return f();
  } catch (error) {
    if (error instanceof Undefined) return null;
    throw error;
  }
}

/**
 * Prepare the check of a question.
 * @param {Question} question
 */
export function loadCheck({ tape, variables, mistakes, hint }) {
  const { run, bounds } = loadExact(tape);
  const size = tape.outputs.answer.registers.length;

  /**
   * @param {string} text  what a learner typed
   * @param {Record<string, number>} inputs  the figure's, by name
   * @returns {Verdict}
   */
  return function check(text, inputs) {
    const typed = readAnswer(text, variables);
    if (typed.length !== size) {
      throw new Unreadable(`Expected ${size === 1 ? "one value" : `${size} values, separated by commas`}; `
        + `received ${typed.length}.`);
    }
    const given = Object.fromEntries(Object.entries(inputs).map(([name, value]) => [name, exactly(value)]));
    const counts = (/** @type {string} */ output) => variables.map((name) => Math.max(
      ...bounds(output, variables).map((expected, i) => enough(name, typed[i], expected))));
    const same = (/** @type {string} */ output) => {
      const places = [...grid(variables, counts(output))];
      return typed.every((expression, i) => {
        const pairs = places.map((place) => [attempt(() => expression.value(place)),
          attempt(() => run({ ...given, ...place })(output)[i])]);
        const defined = pairs.filter(([own, other]) => own && other);
        return defined.length > 0 && defined.every(([own, other]) => equal(own, other));
      });
    };
    const places = [...grid(variables, variables.map((name) => 1 + Math.max(...typed.map(({ holes }) => holes[name] ?? 0))))];
    if (typed.some(({ value }) => places.every((place) => !attempt(() => value(place))))) {
      throw new Unreadable("Your answer divides by zero.");
    }
    if (same("answer")) return { right: true, message: proof(variables, counts("answer")) };
    const mistake = mistakes.find(({ output }) => same(output));
    return { right: false, message: mistake ? mistake.message : hint };
  };
}

function proof(/** @type {string[]} */ variables, /** @type {number[]} */ counts) {
  const where = variables.flatMap((name, i) => (counts[i] > 1 ? [`${counts[i]} values of ${name}`] : []));
  if (where.length === 0) return "Right: exactly equal.";
  return `Right: equal at ${where.join(" times ")}, which proves it, by the degrees of both sides.`;
}

/** The exact right answer as a learner would type it, for questions without variables. */
export function solution(/** @type {Question} */ question, /** @type {Record<string, number>} */ inputs) {
  const given = Object.fromEntries(Object.entries(inputs).map(([name, value]) => [name, exactly(value)]));
  const values = loadExact(question.tape).run(given)("answer").map(write);
  return values.length > 1 ? `(${values.join(", ")})` : values[0];
}
