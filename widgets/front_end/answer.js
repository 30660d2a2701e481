/**
 * What a learner types: numbers, variables, + - * / ^ and brackets. A tiny grammar of our own,
 * read by recursive descent into a tree; nothing is ever evaluated as code.
 *
 *   list   = entry ("," entry)*     entry  = "(" list ")" | sum     sum = product (("+" | "-") product)*
 *   product = power (("*" | "/" | nothing) power)*          power  = ("+" | "-")* base ("^" power)?
 *   base   = number | variable | "(" sum ")"
 */

import { CONSTANT, HIGHEST, ofPower, ofProduct, ofQuotient, ofSum, Unreadable, variable } from "./degrees.js";
import { add, div, mul, neg, pow, rational, sub, write } from "./rational.js";

/** @typedef {import("./rational.js").Rational} Rational */
/** @typedef {import("./degrees.js").Bounds & {value: (at: Record<string, Rational>) => Rational}} Expression */

const LONGEST = 400;
const DEEPEST = 40;
const TOKEN = /\s*(?:(\d+\.?\d*|\.\d+)|(\p{L}[\p{L}\d_]*)|([-+*/^(),\u2212\u00b7]))/uy;
const NORMAL = /** @type {Record<string, string>} */ ({ "\u2212": "-", "\u00b7": "*" });

/** @returns {{kind: string, text: string}[]} */
function tokens(/** @type {string} */ text) {
  if (text.length > LONGEST) throw new Unreadable(`Expected at most ${LONGEST} characters.`);
  const found = [];
  const end = text.trimEnd().length;
  for (TOKEN.lastIndex = 0; TOKEN.lastIndex < end;) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match) throw new Unreadable(`Cannot read "${[...text.slice(at).trimStart()][0]}".`);
    const [, number, name, sign] = match;
    found.push(number ? { kind: "number", text: number } : name ? { kind: "name", text: name }
      : { kind: "sign", text: NORMAL[sign] ?? sign });
  }
  return found;
}

/** A product of letters, uvw or tt, where a word of that name is unknown. */
function letters(/** @type {{kind: string, text: string}} */ token, /** @type {string[]} */ variables) {
  const parts = [...token.text];
  const product = token.kind === "name" && !variables.includes(token.text)
    && parts.every((letter) => variables.includes(letter));
  return product ? parts.map((text) => ({ ...token, text })) : [token];
}

/** A decimal as the fraction it is. */
function decimal(/** @type {string} */ text) {
  const [whole, part = ""] = text.split(".");
  return rational(BigInt(whole + part || "0"), 10n ** BigInt(part.length));
}

/** @type {Record<string, [typeof ofSum, (x: Rational, y: Rational) => Rational]>} */
const BINARY = { "+": [ofSum, add], "-": [ofSum, sub], "*": [ofProduct, mul], "/": [ofQuotient, div] };

/** @returns {Expression} */
function combined(/** @type {string} */ sign, /** @type {Expression} */ a, /** @type {Expression} */ b) {
  const [bounds, compute] = BINARY[sign];
  return { ...bounds(a, b), value: (at) => compute(a.value(at), b.value(at)) };
}

/** @returns {Expression} */
function power(/** @type {Expression} */ base, /** @type {Expression} */ exponent) {
  if (Object.values({ ...exponent.up, ...exponent.down }).some((degree) => degree > 0)) {
    throw new Unreadable("Expected a number as exponent.");
  }
  const k = exponent.value({});
  if (k.d !== 1n || k.n > BigInt(HIGHEST) || k.n < -BigInt(HIGHEST)) {
    throw new Unreadable(`Expected a whole exponent, at most ${HIGHEST}; received ${write(k)}.`);
  }
  return { ...ofPower(base, Number(k.n)), value: (at) => pow(base.value(at), k) };
}

/**
 * Read an answer.
 * @param {string} text
 * @param {string[]} variables  the names that may occur
 * @returns {Expression[]}  one, or those of a list such as (1/2, 3), or of lists of these
 */
export function readAnswer(text, variables) {
  const list = tokens(text).flatMap((token) => letters(token, variables));
  let at = 0;
  let depth = 0;
  const next = (/** @type {string} */ sign) => list[at]?.kind === "sign" && list[at].text === sign;
  const take = (/** @type {string} */ sign) => next(sign) && (at += 1, true);
  const found = () => (list[at] ? `"${list[at].text}"` : "the end");

  /** @returns {Expression} */
  function readSum() {
    let left = readProduct();
    while (next("+") || next("-")) left = combined(list[at++].text, left, readProduct());
    return left;
  }
  /** @returns {Expression} */
  function readProduct() {
    let left = readPower();
    for (;;) {
      const juxtaposed = list[at]?.kind === "name" || list[at]?.kind === "number" || next("(");
      if (next("*") || next("/")) left = combined(list[at++].text, left, readPower());
      else if (juxtaposed) left = combined("*", left, readPower());
      else return left;
    }
  }
  /** @returns {Expression} */
  function readPower() {
    if (depth++ > DEEPEST) throw new Unreadable("Expected fewer brackets and signs.");
    try {
      if (take("+")) return readPower();
      if (take("-")) {
        const inner = readPower();
        return { ...inner, value: (where) => neg(inner.value(where)) };
      }
      const base = readBase();
      return take("^") ? power(base, readPower()) : base;
    } finally { depth -= 1; }
  }
  /** @returns {Expression} */
  function readBase() {
    const token = list[at];
    if (token?.kind === "number") {
      at += 1;
      const value = decimal(token.text);
      return { ...CONSTANT, value: () => value };
    }
    if (token?.kind === "name") {
      at += 1;
      if (!variables.includes(token.text)) {
        throw new Unreadable(variables.length
          ? `"${token.text}" is unknown here; use ${variables.join(", ")} and numbers.`
          : `Expected numbers such as 3/8; received "${token.text}".`);
      }
      return { ...variable(token.text), value: (where) => where[token.text] };
    }
    if (take("(")) {
      const inner = readSum();
      if (!take(")")) throw new Unreadable(`Expected ) but found ${found()}.`);
      return inner;
    }
    throw new Unreadable(`Expected a number${variables.length ? " or variable" : ""} but found ${found()}.`);
  }
  /** @returns {Expression[]} */
  function readList() {
    const entries = [];
    do {
      if (isList(list, at)) {
        at += 1;
        entries.push(...readList());
        if (!take(")")) throw new Unreadable(`Expected ) but found ${found()}.`);
      } else entries.push(readSum());
    } while (take(","));
    return entries;
  }

  if (list.length === 0) throw new Unreadable("Type an answer first.");
  const entries = readList();
  if (at < list.length) throw new Unreadable(`Expected the end but found ${found()}.`);
  return entries;
}

/** Whether a bracket opens here that holds a comma of its own and closes before the next or the end: (1/2, 3). */
function isList(/** @type {{kind: string, text: string}[]} */ list, /** @type {number} */ start) {
  let depth = 0;
  let comma = false;
  for (let i = start; i < list.length; i++) {
    const { text } = list[i];
    if (text === "(") depth += 1;
    if (text === ")") depth -= 1;
    if (text === "," && depth === 1) comma = true;
    if (depth === 0) return comma && [",", ")", undefined].includes(list[i + 1]?.text);
  }
  return false;
}
