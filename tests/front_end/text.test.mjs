import assert from "node:assert/strict";
import { test } from "node:test";
import { format, parseLabel, parseNumber, shown, spoken } from "../../widgets/front_end/text.js";

test("a label is read as bases with scripts", () => {
  assert.deepEqual(parseLabel("b_0^1"), [{ base: "b", sub: "0", sup: "1", italic: true }]);
  assert.deepEqual(parseLabel("b_{12}^{10}"), [{ base: "b", sub: "12", sup: "10", italic: true }]);
  assert.deepEqual(parseLabel("c(t)").map(({ base, italic }) => [base, italic]),
    [["c", true], ["(", false], ["t", true], [")", false]]);
});

test("single letters are variables, words and possessives are not", () => {
  const italics = (text) => parseLabel(text).filter(({ italic }) => italic).map(({ base }) => base);
  assert.deepEqual(italics("Divide a leg at t"), ["t"]);
  assert.deepEqual(italics("De Casteljau's points"), []);
  assert.deepEqual(italics("P_a"), ["P"]);
});

test("a label that starts with a script, or is empty, is still a label", () => {
  assert.deepEqual(parseLabel("^2"), [{ base: "", sub: "", sup: "2", italic: false }]);
  assert.deepEqual(parseLabel(""), []);
});

test("labels are spoken without their notation", () => {
  assert.equal(spoken("b_0^1"), "b 0 1");
  assert.equal(spoken("c(t)"), "c(t)");
  assert.equal(spoken("the point c(t) = b_0^3, at last."), "the point c(t) = b 0 3, at last.");
});

test("numbers are short, and never a negative nothing", () => {
  assert.equal(format(0.5), "0.5");
  assert.equal(format(100), "100");
  assert.equal(format(2 / 3), "0.6667");
  assert.equal(format(-0.00001), "0");
  assert.equal(format(0.015625, 6), "0.015625");
  assert.equal(format(NaN), "–");
  assert.equal(format(Infinity), "–");
  assert.equal(format(2.5e7), "2.500e7");
  assert.equal(shown(-0.5), "\u22120.5");
});

test("decimals and fractions are numbers", () => {
  for (const [text, value] of [["0.5", 0.5], [" 3/8 ", 0.375], ["-1/4", -0.25], ["\u22121.5", -1.5], [".5", 0.5],
    ["2.", 2], ["1e-3", 0.001], ["1.5 / 2", 0.75], ["+2", 2]]) {
    assert.equal(parseNumber(text), value, text);
  }
});

test("everything else is not", () => {
  for (const text of ["", " ", "abc", "1/0", "0/0", "1/2/3", "/2", "1,5", "0x10", "NaN", "Infinity", "1e999", "2+2", "--1"]) {
    assert.equal(parseNumber(text), null, text);
  }
});
