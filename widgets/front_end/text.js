/**
 * Words and numbers: the labels' small notation, numbers as a learner reads and types them.
 *
 * Notation of labels: `b_0^1` is b with subscript 0 and superscript 1; braces group, `b_{12}^{10}`.
 */

/** @typedef {{base: string, sub: string, sup: string, italic: boolean}} Token */

const PIECE = /([_^])(?:\{([^}]*)\}|(.))|(\p{L}+(?:['’]\p{L}+)*)|([^_^\p{L}]+)/gsu;

/**
 * Split a label or a caption into tokens. A letter is set in italics when it is a variable: it
 * carries a script, or is a lone small letter other than the word "a"; "the letter S" is not.
 * @param {string} text
 * @returns {Token[]}
 */
export function parseLabel(text) {
  /** @type {Token[]} */
  const tokens = [];
  for (const [, script, group, single, word, rest] of text.matchAll(PIECE)) {
    if (!script) {
      const variable = word !== undefined && /^\p{Ll}$/u.test(word) && word !== "a";
      tokens.push({ base: word ?? rest, sub: "", sup: "", italic: variable });
      continue;
    }
    const last = tokens.at(-1) ?? { base: "", sub: "", sup: "", italic: false };
    if (tokens.length === 0) tokens.push(last);
    if (script === "_") last.sub = group ?? single;
    else last.sup = group ?? single;
    last.italic ||= /^\p{L}$/u.test(last.base);
  }
  return tokens;
}

/** A label as a screen reader should say it: `b_0^1` is "b 0 1". */
export function spoken(/** @type {string} */ text) {
  const parts = parseLabel(text).map(({ base, sub, sup }) => (sub || sup ? ` ${base} ${sub} ${sup} ` : base));
  return parts.join("").replace(/\s+/g, " ").replace(/\s+([.,;:)])/g, "$1").trim();
}

/**
 * A number for reading: at most `digits` decimals, no trailing zeros, "–" when there is none.
 * @param {number} value
 */
export function format(value, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size >= 1e6) return value.toExponential(3).replace("e+", "e");
  const text = value.toFixed(digits);
  return (text.includes(".") ? text.replace(/\.?0+$/, "") : text).replace(/^-0$/, "0");
}

/** The same, with a true minus sign: for the eye, not for fields or speech. */
export const shown = (/** @type {number} */ value, digits = 4) => format(value, digits).replace("-", "\u2212");

const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d{1,3})?$/i;

/**
 * The number a learner typed: a decimal or a fraction such as 3/8, else null.
 * @param {string} text
 */
export function parseNumber(text) {
  const parts = text.replace(/\u2212/g, "-").replace(/\s+/g, "").split("/");
  if (parts.length > 2 || !parts.every((part) => DECIMAL.test(part))) return null;
  const value = parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(parts[0]);
  return Number.isFinite(value) ? value : null;
}
