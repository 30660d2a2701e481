import assert from "node:assert/strict";
import { test } from "node:test";
import { readAnswer } from "../../widgets/front_end/answer.js";
import { enough, Unreadable } from "../../widgets/front_end/degrees.js";
import { exactly, rational, write } from "../../widgets/front_end/rational.js";

const at = { t: rational(1, 3), s: rational(-2) };
const values = (text, names = ["t", "s"]) => readAnswer(text, names).map(({ value }) => write(value(at)));

test("numbers are taken exactly", () => {
  assert.deepEqual(values("0.1"), ["1/10"]);
  assert.deepEqual(values(".5"), ["1/2"]);
  assert.deepEqual(values("12/8"), ["3/2"]);
  assert.deepEqual(values("\u22123\u00b72"), ["-6"]);
  assert.equal(write(exactly(0.1)), "3602879701896397/36028797018963968");
  assert.equal(write(exactly(-(2 ** 60))), String(-(2n ** 60n)));
});

test("powers bind tighter than signs, and to the right", () => {
  assert.deepEqual(values("-t^2"), ["-1/9"]);
  assert.deepEqual(values("2^2^3"), ["256"]);
  assert.deepEqual(values("2^-1"), ["1/2"]);
  assert.deepEqual(values("2--1"), ["3"]);
});

test("what stands side by side is multiplied", () => {
  assert.deepEqual(values("3t(1-t)^2"), ["4/9"]);
  assert.deepEqual(values("(1+t)(1-t)"), ["8/9"]);
  assert.deepEqual(values("2t s"), ["-4/3"]);
  assert.deepEqual(values("3tts^2"), ["4/3"]); // the power is that of the last letter
  assert.throws(() => values("tss", ["t"]), Unreadable);
});

test("lists have commas, with or without brackets", () => {
  assert.deepEqual(values("(1/2, 3)"), ["1/2", "3"]);
  assert.deepEqual(values("1,2 , t"), ["1", "2", "1/3"]);
  assert.deepEqual(values("((1,2), (3,4))"), ["1", "2", "3", "4"]);
  assert.deepEqual(values("(1, 2), (3, 2t(1+2)), 5"), ["1", "2", "3", "2", "5"]);
  assert.throws(() => values("(1,2)3"), Unreadable);
  assert.deepEqual(values("(1+t),(1-t)"), ["4/3", "2/3"]);
});

test("bounds of degrees count what is divided by", () => {
  const [{ up, down, holes }] = readAnswer("1/(1/t) + t^3/(1-t)", ["t"]);
  assert.deepEqual([up.t, down.t ?? 0, holes.t], [3, 1, 2]);
  const [a, b] = readAnswer("t^2, 1/(1-t)", ["t"]);
  assert.equal(enough("t", a, b), 1 + 3 + 1);
});

test("what cannot be read is told", () => {
  for (const [text, message] of [["", /Type an answer/], ["1+", /found the end/], ["(1", /Expected \)/],
    ["1 2 )", /Expected the end/], ["x", /"x" is unknown here; use t, s/], ["2^t", /number as exponent/],
    ["t^61", /at most 60/], ["t^(1/2)", /whole exponent/], ["(t^9)^9", /degree of at most 60/],
    ["a;b", /Cannot read ";"/], ["9".repeat(500), /at most 400/], ["(".repeat(60), /fewer brackets/],
    ["constructor", /unknown/], ["\ud83d\ude00", /Cannot read/]]) {
    assert.throws(() => readAnswer(text, ["t", "s"]), (error) => error instanceof Unreadable && message.test(error.message), text);
  }
  assert.throws(() => readAnswer("t", []), /numbers such as 3\/8/);
});
