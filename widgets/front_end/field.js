/** A field for one number: decimals and fractions, and a plain message when it is neither. */

import { html } from "./dom.js";
import { format, parseNumber } from "./text.js";

const DIGITS = 6; // finer than any snapping, so that a field shows the value itself
let fields = 0;

/**
 * @param {import("./life.js").Life} life
 * @param {{name: string, low: number, high: number, accept: (value: number) => void}} options
 */
export function createField(life, { name, low, high, accept }) {
  const id = `casteljau-field-${fields += 1}`;
  const message = html("p", { class: "message", id, role: "status" });
  const input = html("input", { class: "number", type: "text", "aria-label": name, "aria-describedby": id,
    autocomplete: "off", spellcheck: "false" });
  let text = "";
  let typing = false;

  function complain(/** @type {string} */ complaint) {
    message.textContent = complaint;
    if (complaint) input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }

  function read() {
    typing = false;
    if (input.value === text) return complain("");
    const value = parseNumber(input.value);
    if (value === null) return complain(`Expected a number such as 0.5 or 3/8; the value stays ${text}.`);
    if (value < low || value > high) {
      return complain(`Expected a number from ${format(low)} to ${format(high)}; the value stays ${text}.`);
    }
    complain("");
    accept(value);
    text = input.value = format(value, DIGITS);
  }

  life.listen(input, "change", read);
  life.listen(input, "keydown", (event) => {
    if (event.key === "Enter") read();
    if (event.key === "Escape" && input.value !== text) {
      input.value = text;
      complain("");
      event.stopPropagation();
    }
  });

  /** Show the value, unless the learner is typing another one. */
  function show(/** @type {number} */ value) {
    const next = format(value, DIGITS);
    if (next === text) return;
    text = next;
    if (typing) return;
    input.value = next;
    complain("");
  }
  life.listen(input, "input", () => { typing = true; });
  life.listen(input, "blur", () => { typing = false; });

  return { input, message, show };
}
